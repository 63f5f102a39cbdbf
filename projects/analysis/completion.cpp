// Completion and parameter help of CodeModel: what may stand at the cursor, from the last good check, while the text is
// being typed.
#include "projects/analysis/code_model.h"

#include "projects/analysis/instruction_lists.h"
#include "runtime/base/text.h"
#include "runtime/library/signatures.h"

#include <algorithm>
#include <set>

namespace plc::analysis {

using lex::TokenKind;
using sema::Symbol;
using sema::SymbolKind;

namespace {

bool isWordByte(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

ItemKind itemKindOf(SymbolKind kind) {
    switch (kind) {
    case SymbolKind::Constant:
        return ItemKind::Constant;
    case SymbolKind::Enumerator:
        return ItemKind::EnumValue;
    case SymbolKind::Type:
    case SymbolKind::Interface:
        return ItemKind::Type;
    case SymbolKind::Function:
    case SymbolKind::StandardFunction:
        return ItemKind::Function;
    case SymbolKind::FunctionBlock:
        return ItemKind::Block;
    case SymbolKind::Program:
    case SymbolKind::Action:
        return ItemKind::Program;
    case SymbolKind::Method:
        return ItemKind::Method;
    case SymbolKind::Property:
        return ItemKind::Property;
    case SymbolKind::Namespace:
    case SymbolKind::GlobalList:
        return ItemKind::Namespace;
    default:
        return ItemKind::Variable;
    }
}

/// Inside a comment or string literal: nothing is offered.
bool isInsideText(std::string_view text, uint32_t offset) {
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(size_t(0)), text.substr(0, offset), sink);
    for (const lex::Comment& comment : list.comments)
        if (comment.end >= offset && comment.begin < offset) return true;
    if (list.tokens.size() < 2) return false;
    const lex::Token& last = list.tokens[list.tokens.size() - 2];
    if (text[last.begin] == '{' && last.end >= offset && (last.end - last.begin == 1 || text[last.end - 1] != '}'))
        return true; // a pragma that is being typed
    return (last.kind == TokenKind::StringLiteral || last.kind == TokenKind::WstringLiteral ||
            last.kind == TokenKind::Error) &&
           last.end >= offset && (text[last.begin] == '\'' || text[last.begin] == '"') &&
           (last.end - last.begin == 1 || text[last.end - 1] != text[last.begin]);
}

/// The names before the cursor joined by dots, innermost last: "Main.pid." → {Main, pid}; indices are skipped.
std::vector<std::string> chainBefore(std::string_view text, uint32_t at) {
    std::vector<std::string> names;
    while (at > 0 && text[at - 1] == '.') {
        --at;
        while (at > 0 && (text[at - 1] == ']' || text[at - 1] == '^' || text[at - 1] == ' ')) {
            if (text[at - 1] != ']') {
                --at;
                continue;
            }
            for (int depth = 0; at > 0;) {
                --at;
                if (text[at] == ']') ++depth;
                if (text[at] == '[' && --depth == 0) break;
            }
        }
        uint32_t begin = at;
        while (begin > 0 && isWordByte(text[begin - 1])) --begin;
        if (begin == at) return {};
        names.insert(names.begin(), std::string(text.substr(begin, at - begin)));
        at = begin;
    }
    return names;
}

struct Snippet {
    std::string_view word, text, detail;
};
constexpr Snippet kSnippets[] = {
    {"IF", "IF | THEN\n    \nEND_IF", "branch"},
    {"FOR", "FOR | := 1 TO 10 DO\n    \nEND_FOR", "counted loop"},
    {"WHILE", "WHILE | DO\n    \nEND_WHILE", "loop"},
    {"REPEAT", "REPEAT\n    |\nUNTIL TRUE\nEND_REPEAT", "loop"},
    {"CASE", "CASE | OF\n    0: ;\nELSE\n    ;\nEND_CASE", "selection"},
    {"VAR", "VAR\n    |\nEND_VAR", "variables"},
    {"VAR_INPUT", "VAR_INPUT\n    |\nEND_VAR", "inputs"},
    {"VAR_OUTPUT", "VAR_OUTPUT\n    |\nEND_VAR", "outputs"},
    {"PROGRAM", "PROGRAM |\nVAR\nEND_VAR\n\nEND_PROGRAM", "program"},
    {"FUNCTION_BLOCK", "FUNCTION_BLOCK |\nVAR_INPUT\nEND_VAR\nVAR_OUTPUT\nEND_VAR\nVAR\nEND_VAR\n\nEND_FUNCTION_BLOCK",
     "block"},
    {"FUNCTION", "FUNCTION | : INT\nVAR_INPUT\nEND_VAR\n\nEND_FUNCTION", "function"},
    {"METHOD", "METHOD | : BOOL\n\nEND_METHOD", "method"},
    {"TYPE", "TYPE | :\nSTRUCT\nEND_STRUCT\nEND_TYPE", "type"},
};

} // namespace

const Symbol* CodeModel::findVisible(std::string_view name, const std::string& pou) const {
    const auto it = m_byName.find(foldCase(name));
    if (it == m_byName.end()) return nullptr;
    const Symbol* best = nullptr;
    int bestRank = 100;
    const std::string block = pou.substr(0, pou.find('.'));
    for (const uint32_t index : it->second) {
        const Symbol& symbol = m_checked.analysis->symbols[index];
        const int rank = equalsIgnoringCase(symbol.owner, pou)                               ? 0
                         : equalsIgnoringCase(symbol.owner, block)                           ? 1
                         : symbol.owner.empty()                                              ? 2
                         : symbol.kind == SymbolKind::Variable && symbol.path == symbol.name ? 9
                                                                                             : 5;
        if (rank < bestRank) {
            best = &symbol;
            bestRank = rank;
        }
    }
    // Rank 9 is a variable of some other unit: not visible here, and its type would complete the wrong members.
    return bestRank < 9 ? best : nullptr;
}

std::optional<types::TypeId> CodeModel::typeOfChain(const std::vector<std::string>& names,
                                                    const std::string& pou) const {
    const auto& program = m_checked.analysis->program;
    if (!program || names.empty()) return std::nullopt;
    const types::TypeTable& types = *program->types;
    types::TypeId type;
    if (equalsIgnoringCase(names[0], "THIS")) {
        const Symbol* block = findVisible(pou.substr(0, pou.find('.')), "");
        if (!block) return std::nullopt;
        type = block->type;
    } else if (const Symbol* first = findVisible(names[0], pou)) {
        type = first->type;
    } else { // an instance of a program is no symbol
        const auto root =
            std::find_if(program->layout.roots.begin(), program->layout.roots.end(), [&](const image::Root& each) {
                return each.list.empty() && equalsIgnoringCase(each.name, names[0]);
            });
        if (root == program->layout.roots.end()) return std::nullopt;
        type = root->type;
    }
    for (size_t i = 1;; ++i) {
        for (int guard = 0; guard < 16; ++guard) { // members are those of the element or of what is pointed to
            const types::Type& t = types[type];
            if (t.kind != types::TypeKind::Array && t.kind != types::TypeKind::OpenArray &&
                t.kind != types::TypeKind::Pointer && t.kind != types::TypeKind::Reference)
                break;
            type = t.element;
        }
        if (i == names.size()) return type;
        const types::Field* field = types[type].findField(names[i]);
        if (!field) return std::nullopt;
        type = field->type;
    }
}

void CodeModel::addMembers(types::TypeId type, std::vector<CompletionItem>& items) const {
    const types::TypeTable& types = *m_checked.analysis->program->types;
    const types::Type& t = types[type];
    for (const types::Field& field : t.fields)
        if (!field.isPrivate)
            items.push_back({field.name, types[field.type].name, field.comment, ItemKind::Variable,
                             field.section == types::FieldSection::Local ? 2 : 1});
    for (const types::Enumerator& value : t.enumerators)
        items.push_back(
            {value.name, t.name + " = " + std::to_string(value.value), value.comment, ItemKind::EnumValue, 1});
    for (types::TypeId owner = type; owner.isValid(); owner = types[owner].base) {
        const auto it = m_byOwner.find(foldCase(types[owner].name));
        if (it == m_byOwner.end()) continue;
        for (const uint32_t index : it->second) {
            const Symbol& symbol = m_checked.analysis->symbols[index];
            if (symbol.kind == SymbolKind::Method || symbol.kind == SymbolKind::Property ||
                symbol.kind == SymbolKind::Action || symbol.kind == SymbolKind::Step)
                items.push_back({symbol.name, symbol.type.isValid() ? types[symbol.type].name : "", symbol.comment,
                                 itemKindOf(symbol.kind), 1});
        }
    }
    // word.3 is a bit; last in the list, since after a point a name is meant nearly always.
    const unsigned bits = types::isInteger(types.family(type)) ? types::bitsOf(types.storageKind(type)) : 0;
    for (unsigned bit = 0; bit < bits && bits <= 64; ++bit)
        items.push_back({std::to_string(bit), "BOOL", "", ItemKind::Variable, 9});
}

void CodeModel::addScope(const std::string& pou, std::vector<CompletionItem>& items) const {
    const auto& program = m_checked.analysis->program;
    const auto add = [&](const std::string& owner, int rank) {
        const auto it = m_byOwner.find(foldCase(owner));
        if (it == m_byOwner.end()) return;
        for (const uint32_t index : it->second) {
            if (m_isHidden[index]) continue;
            const Symbol& symbol = m_checked.analysis->symbols[index];
            if (symbol.name.starts_with("__")) continue; // the compiler's own
            const std::string type =
                program && symbol.type.isValid() ? (*program->types)[symbol.type].name : std::string();
            items.push_back(
                {symbol.name, type == symbol.name ? "" : type, symbol.comment, itemKindOf(symbol.kind), rank});
        }
    };
    add(pou, 1);
    if (const size_t dot = pou.find('.'); dot != std::string::npos) add(pou.substr(0, dot), 2);
    add("", 3);
    if (program)
        for (const image::Root& root : program->layout.roots)
            if (!root.list.empty() && !root.isHidden)
                items.push_back({root.list, "global list", "", ItemKind::Namespace, 4});
    for (const library::Signature& signature : library::signatures()) {
        std::string detail = "(";
        for (size_t i = 0; i < signature.parameters.size(); ++i)
            detail += (i ? ", " : "") + std::string(signature.parameters[i].name);
        items.push_back(
            {std::string(signature.name), detail + ")", std::string(signature.summary), ItemKind::Function, 6});
    }
}

void CodeModel::addWords(std::vector<CompletionItem>& items) const {
    static constexpr std::string_view words[] = {
#define PLC_KEYWORD(Name, Spelling) Spelling,
#include "runtime/compiler/lex/tokens.def"
    };
    for (const std::string_view word : words) items.push_back({std::string(word), "", "", ItemKind::Keyword, 7});
    for (uint32_t kind = 0; kind <= static_cast<uint32_t>(types::TypeKind::Wchar); ++kind)
        items.push_back({std::string(types::spelling(static_cast<types::TypeKind>(kind))), "elementary type", "",
                         ItemKind::Type, 6});
    for (const char* word : {"STRING", "WSTRING", "POINTER TO", "REFERENCE TO", "RETAIN", "PERSISTENT", "CONSTANT"})
        items.push_back({word, "", "", ItemKind::Keyword, 7});
    for (const Snippet& snippet : kSnippets)
        items.push_back({std::string(snippet.text), std::string(snippet.word) + " …", std::string(snippet.detail),
                         ItemKind::Snippet, 8});
}

/// In a test: its statements, and the instances of programs.
void CodeModel::addTestWords(const std::string& pou, std::vector<CompletionItem>& items) const {
    if (pou.empty()) {
        items.push_back({"TEST '|'\n    \nEND_TEST", "TEST …", "a test", ItemKind::Snippet, 0});
        return;
    }
    for (const auto& [word, summary] :
         {std::pair("RUN", "lets time pass: RUN T#1s; RUN 3 SCANS; RUN UNTIL a FOR T#5s"),
          std::pair("ASSERT", "must be TRUE: ASSERT a = b, 'why'"),
          std::pair("FORCE", "holds a value: FORCE a := TRUE"), std::pair("RELEASE", "ends a FORCE"),
          std::pair("COMPARE", "with a recording: COMPARE 'name'"),
          std::pair("POWER_OFF", "the controller's power fails, the plant goes on: POWER_OFF T#5s")})
        items.push_back({word, "", summary, ItemKind::Keyword, 1});
    const auto& program = m_checked.analysis->program;
    if (!program) return;
    for (const image::Root& root : program->layout.roots)
        if (!root.isHidden && root.space.empty() && root.list.empty() && root.area == image::Area::Program)
            items.push_back({root.name, (*program->types)[root.type].name, root.comment, ItemKind::Program, 1});
}

namespace {
/// Keeps what begins with, or holds in order, the typed letters; each text once, the best rank.
void filterAndSort(std::vector<CompletionItem>& items, std::string_view typed) {
    const std::string wanted = foldCase(typed);
    const auto quality = [&](const std::string& text) {
        const std::string folded = foldCase(text);
        if (wanted.empty() || folded.starts_with(wanted)) return 0;
        if (folded.find(wanted) != std::string::npos) return 10;
        size_t at = 0;
        for (const char c : folded)
            if (at < wanted.size() && c == wanted[at]) ++at;
        return at == wanted.size() && wanted.size() > 1 ? 20 : -1;
    };
    std::vector<CompletionItem> kept;
    for (CompletionItem& item : items) {
        const int q = quality(item.kind == ItemKind::Snippet ? item.detail : item.text);
        if (q < 0) continue;
        item.rank += q;
        kept.push_back(std::move(item));
    }
    // Stable: of equal rank and letters what is declared nearer was added first, and stays when doubles leave.
    std::stable_sort(kept.begin(), kept.end(), [](const CompletionItem& a, const CompletionItem& b) {
        return a.rank != b.rank ? a.rank < b.rank : foldCase(a.text) < foldCase(b.text);
    });
    std::set<std::string> seen;
    std::erase_if(kept, [&](const CompletionItem& item) { return !seen.insert(foldCase(item.text)).second; });
    items = std::move(kept);
}
} // namespace

Completion CodeModel::complete(FileId file, std::string_view text, uint32_t offset) const {
    Completion out;
    offset = std::min<uint32_t>(offset, static_cast<uint32_t>(text.size()));
    out.replaceEnd = offset;
    out.replaceBegin = offset;
    while (out.replaceBegin > 0 && isWordByte(text[out.replaceBegin - 1])) --out.replaceBegin;
    if (isInsideText(text, offset)) return out;
    const std::string_view typed = text.substr(out.replaceBegin, offset - out.replaceBegin);
    // A number is being typed, and a list that opens would take the Enter behind it.
    if (!typed.empty() && std::isdigit(static_cast<unsigned char>(typed[0])) &&
        (out.replaceBegin == 0 || text[out.replaceBegin - 1] != '.'))
        return out;
    const std::string pou = pouAt(file, offset);
    const std::vector<std::string> chain = chainBefore(text, out.replaceBegin);
    if (!chain.empty()) {
        if (const auto type = typeOfChain(chain, pou)) addMembers(*type, out.items);
        if (out.items.empty() && m_checked.analysis->program) // GVL. or Namespace.
            for (const image::Root& root : m_checked.analysis->program->layout.roots)
                if (equalsIgnoringCase(root.list, chain.back()) || equalsIgnoringCase(root.space, chain.back()))
                    out.items.push_back({root.name, (*m_checked.analysis->program->types)[root.type].name, root.comment,
                                         ItemKind::Variable, 1});
    } else if (const auto list = listContextAt(text, out.replaceBegin)) {
        if (list->place == ListPlace::Operator)
            for (const ListOperator& op : listOperators())
                out.items.push_back({std::string(op.name), std::string(op.summary), "", ItemKind::Keyword, 0});
        if (list->place == ListPlace::Label)
            for (const std::string& label : list->labels)
                out.items.push_back({label, "label", "", ItemKind::Constant, 0});
        if (list->place != ListPlace::Label) {
            if (const auto help = parameterHelp(file, text, out.replaceBegin))
                for (const ParameterHelp::Parameter& parameter : help->parameters)
                    if (!parameter.isGiven)
                        out.items.push_back(
                            {parameter.name + (parameter.section == types::FieldSection::Output ? " => " : " := "),
                             parameter.type, parameter.comment, ItemKind::Parameter, 0});
            std::vector<CompletionItem> scope;
            addScope(pou, scope);
            const auto isInstance = [&](const CompletionItem& item) {
                const Symbol* symbol = findVisible(item.text, pou);
                const auto& program = m_checked.analysis->program;
                return symbol && program && symbol->kind == SymbolKind::Variable && symbol->type.isValid() &&
                       program->types->kind(symbol->type) == types::TypeKind::Block;
            };
            for (CompletionItem& item : scope) {
                if (list->place == ListPlace::Operator && item.kind != ItemKind::Function)
                    continue; // a function takes the current result
                if (list->place == ListPlace::Operand && item.kind == ItemKind::Function) continue;
                if (list->place == ListPlace::Instance && item.kind != ItemKind::Function && !isInstance(item))
                    continue;
                out.items.push_back(std::move(item));
            }
        }
    } else {
        if (const auto help = parameterHelp(file, text, out.replaceBegin))
            for (const ParameterHelp::Parameter& parameter : help->parameters)
                if (!parameter.isGiven)
                    out.items.push_back(
                        {parameter.name + (parameter.section == types::FieldSection::Output ? " => " : " := "),
                         parameter.type, parameter.comment, ItemKind::Parameter, 0});
        addScope(pou, out.items);
        addWords(out.items);
        if (sources()[file].path().starts_with("tests/")) addTestWords(pou, out.items);
    }
    filterAndSort(out.items, typed);
    return out;
}

Completion CodeModel::completePath(std::string_view text, uint32_t offset) const {
    Completion out;
    offset = std::min<uint32_t>(offset, static_cast<uint32_t>(text.size()));
    out.replaceBegin = out.replaceEnd = offset;
    while (out.replaceBegin > 0 && isWordByte(text[out.replaceBegin - 1])) --out.replaceBegin;
    const auto& program = m_checked.analysis->program;
    if (!program) return out;
    const std::vector<std::string> chain = chainBefore(text, out.replaceBegin);
    if (chain.empty()) {
        for (const image::Root& root : program->layout.roots)
            if (!root.isHidden && root.space.empty())
                out.items.push_back({root.list.empty() ? root.name : root.list + "." + root.name,
                                     (*program->types)[root.type].name, root.comment, ItemKind::Variable,
                                     root.area == image::Area::Program ? 1 : 2});
        for (const library::Signature& signature : library::signatures())
            out.items.push_back(
                {std::string(signature.name), "", std::string(signature.summary), ItemKind::Function, 6});
    } else if (const auto type = typeOfChain(chain, "")) {
        addMembers(*type, out.items);
    } else {
        for (const image::Root& root : program->layout.roots)
            if (equalsIgnoringCase(root.list, chain.back()))
                out.items.push_back(
                    {root.name, (*program->types)[root.type].name, root.comment, ItemKind::Variable, 1});
    }
    filterAndSort(out.items, text.substr(out.replaceBegin, offset - out.replaceBegin));
    return out;
}

std::optional<ParameterHelp> CodeModel::parameterHelp(FileId file, std::string_view text, uint32_t offset) const {
    if (isInsideText(text, offset)) return std::nullopt;
    diagnostics::Sink sink;
    const uint32_t from = offset > 4000 ? offset - 4000 : 0; // a call does not reach back further
    const std::string_view part = text.substr(from, offset - from);
    const lex::TokenList list = lex::tokenize(FileId(size_t(0)), part, sink);
    // The innermost open parenthesis with a name before it.
    int depth = 0;
    size_t open = list.tokens.size();
    size_t commas = 0;
    for (size_t i = list.tokens.size(); i-- > 0;) {
        const TokenKind kind = list.tokens[i].kind;
        if (kind == TokenKind::RightParen || kind == TokenKind::RightBracket) ++depth;
        if (kind == TokenKind::LeftBracket) --depth;
        if (kind == TokenKind::Semicolon || depth < 0) return std::nullopt;
        if (kind == TokenKind::Comma && depth == 0) ++commas;
        if (kind != TokenKind::LeftParen || depth-- != 0) continue;
        if (i == 0 || list.tokens[i - 1].kind == TokenKind::Identifier) {
            open = i;
            break;
        }
        depth = 0; // (a + b) groups: the call is further out
        commas = 0;
    }
    if (open == list.tokens.size() || open == 0 || list.tokens[open - 1].kind != TokenKind::Identifier)
        return std::nullopt;
    const auto spelled = [&](const lex::Token& token) {
        return std::string(part.substr(token.begin, token.end - token.begin));
    };
    std::vector<std::string> chain = chainBefore(part, list.tokens[open - 1].begin);
    const std::string name = spelled(list.tokens[open - 1]);
    ParameterHelp help;
    help.callee = name;
    help.current = commas;
    const std::string pou = pouAt(file, offset);
    const auto& program = m_checked.analysis->program;
    const auto fromFields = [&](types::TypeId block) {
        for (const types::Field& field : (*program->types)[block].fields)
            if (field.section == types::FieldSection::Input || field.section == types::FieldSection::Output ||
                field.section == types::FieldSection::InOut)
                help.parameters.push_back(
                    {field.name, (*program->types)[field.type].name, field.comment, field.section, false});
    };
    const auto fromOwner = [&](const std::string& owner) {
        if (const auto it = m_byOwner.find(foldCase(owner)); it != m_byOwner.end())
            for (const uint32_t index : it->second) {
                const Symbol& symbol = m_checked.analysis->symbols[index];
                if (symbol.section == types::FieldSection::Input || symbol.section == types::FieldSection::Output ||
                    symbol.section == types::FieldSection::InOut)
                    help.parameters.push_back({symbol.name, program ? (*program->types)[symbol.type].name : "",
                                               symbol.comment, symbol.section, false});
            }
    };
    if (const library::Signature* signature = chain.empty() ? library::findSignature(name) : nullptr) {
        for (const library::Parameter& parameter : signature->parameters)
            help.parameters.push_back({std::string(parameter.name), "", "",
                                       parameter.isOutput ? types::FieldSection::Output : types::FieldSection::Input,
                                       false});
    } else if (program) {
        chain.push_back(name);
        const auto type = typeOfChain(chain, pou);
        if (type && program->types->kind(*type) == types::TypeKind::Block)
            fromFields(*type);
        else if (const Symbol* callee = findVisible(name, pou))
            fromOwner(callee->owner.empty() ? callee->name : callee->owner + "." + callee->name);
    }
    if (help.parameters.empty()) return std::nullopt;
    // A parameter that is named is the current one wherever it stands.
    depth = 0;
    size_t argument = open + 1;
    for (size_t i = open + 1; i < list.tokens.size(); ++i) {
        const TokenKind kind = list.tokens[i].kind;
        depth += kind == TokenKind::LeftParen || kind == TokenKind::LeftBracket;
        depth -= kind == TokenKind::RightParen || kind == TokenKind::RightBracket;
        if (kind == TokenKind::Comma && depth == 0) argument = i + 1;
    }
    if (argument + 1 < list.tokens.size() && list.tokens[argument].kind == TokenKind::Identifier &&
        (list.tokens[argument + 1].kind == TokenKind::Assign || list.tokens[argument + 1].kind == TokenKind::Output))
        for (size_t i = 0; i < help.parameters.size(); ++i)
            if (equalsIgnoringCase(help.parameters[i].name, spelled(list.tokens[argument]))) help.current = i;
    for (size_t i = open + 1; i + 1 < list.tokens.size(); ++i)
        if (list.tokens[i].kind == TokenKind::Identifier &&
            (list.tokens[i + 1].kind == TokenKind::Assign || list.tokens[i + 1].kind == TokenKind::Output))
            for (ParameterHelp::Parameter& parameter : help.parameters)
                if (equalsIgnoringCase(parameter.name, spelled(list.tokens[i]))) parameter.isGiven = true;
    return help;
}

} // namespace plc::analysis
