#include "projects/analysis/code_model.h"

#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/compiler/sema/tests.h"

#include <algorithm>

#include <set>
namespace plc::analysis {

using lex::TokenKind;
using sema::Symbol;
using sema::SymbolKind;

namespace {
/// The names of a library's units that are its own business: {attribute 'hide'} above them.
void collectHidden(const std::vector<syntax::Decl*>& declarations, std::set<std::pair<FileId, uint32_t>>& out) {
    const auto isHidden = [](const auto& pragmas) {
        return std::any_of(pragmas.begin(), pragmas.end(), [](const syntax::Pragma& each) {
            return each.isAttribute && equalsIgnoringCase(each.key, "hide");
        });
    };
    for (const syntax::Decl* each : declarations) {
        if (each->kind == syntax::DeclKind::Pou && isHidden(each->pou->pragmas))
            out.emplace(each->pou->name.range.file, each->pou->name.range.begin);
        if (each->kind == syntax::DeclKind::Type && isHidden(each->type->pragmas))
            out.emplace(each->type->name.range.file, each->type->name.range.begin);
        if (each->kind == syntax::DeclKind::Namespace) collectHidden(each->space->declarations, out);
    }
}
} // namespace

std::shared_ptr<const CodeModel> CodeModel::make(const driver::BuildInput& input, uint64_t revision) {
    driver::KeptFiles kept;
    return make(input, revision, kept);
}

std::shared_ptr<const CodeModel> CodeModel::make(const driver::BuildInput& input, uint64_t revision,
                                                 driver::KeptFiles& kept) {
    auto model = std::make_shared<CodeModel>();
    model->m_revision = revision;
    model->m_checked = driver::check(input, kept);
    const sema::Analysis& analysis = *model->m_checked.analysis;
    model->m_referencesOf.resize(analysis.symbols.size());
    model->m_byName.reserve(analysis.symbols.size());
    std::vector<uint32_t>* ofOwner = nullptr;
    for (uint32_t i = 0; i < analysis.symbols.size(); ++i) {
        const Symbol& symbol = analysis.symbols[i];
        // those of one owner are declared in a row: its name is folded and looked up once
        if (!ofOwner || symbol.owner != analysis.symbols[i - 1].owner)
            ofOwner = &model->m_byOwner[foldCase(symbol.owner)];
        ofOwner->push_back(i);
        model->m_byName[foldCase(symbol.name)].push_back(i);
    }
    std::set<std::pair<FileId, uint32_t>> hidden;
    for (size_t i = 0; i < analysis.files.size(); ++i)
        if (model->sources()[FileId(i)].path().starts_with("library/"))
            collectHidden(analysis.files[i]->declarations, hidden);
    model->m_isHidden.resize(analysis.symbols.size());
    for (uint32_t i = 0; i < analysis.symbols.size(); ++i)
        model->m_isHidden[i] =
            hidden.contains({analysis.symbols[i].declaration.file, analysis.symbols[i].declaration.begin});
    for (uint32_t i = 0; i < analysis.references.size(); ++i)
        if (analysis.references[i].symbol.isValid())
            model->m_referencesOf[analysis.references[i].symbol.index()].push_back(i);
    return model;
}

std::optional<FileId> CodeModel::fileOf(std::string_view path) const {
    const auto& files = m_checked.sources->files;
    for (size_t i = 0; i < files.size(); ++i)
        if (files[i].path() == path) return FileId(i);
    return std::nullopt;
}

namespace {

TokenClass classOf(const Symbol& symbol) {
    switch (symbol.kind) {
    case SymbolKind::Constant:
        return TokenClass::Constant;
    case SymbolKind::Enumerator:
        return TokenClass::EnumValue;
    case SymbolKind::Type:
    case SymbolKind::FunctionBlock:
    case SymbolKind::Interface:
    case SymbolKind::Namespace:
        return TokenClass::Type;
    case SymbolKind::Function:
    case SymbolKind::StandardFunction:
    case SymbolKind::Method:
    case SymbolKind::Program:
    case SymbolKind::Action:
        return TokenClass::Function;
    case SymbolKind::Label:
    case SymbolKind::Task:
        return TokenClass::Label;
    case SymbolKind::Step:
        return TokenClass::Step;
    case SymbolKind::GlobalList:
        return TokenClass::Global;
    case SymbolKind::Property:
        return TokenClass::Local;
    case SymbolKind::Variable:
        break;
    }
    if (symbol.isConstant) return TokenClass::Constant;
    switch (symbol.section) {
    case types::FieldSection::Input:
        return TokenClass::Input;
    case types::FieldSection::Output:
        return TokenClass::Output;
    case types::FieldSection::InOut:
        return TokenClass::InOut;
    case types::FieldSection::External:
        return TokenClass::Global;
    default:
        return symbol.owner.empty() ? TokenClass::Global : TokenClass::Local;
    }
}

TokenClass classOf(const lex::Token& token) {
    switch (token.kind) {
    case TokenKind::IntegerLiteral:
    case TokenKind::RealLiteral:
    case TokenKind::DurationLiteral:
    case TokenKind::DateLiteral:
    case TokenKind::TimeOfDayLiteral:
    case TokenKind::DateTimeLiteral:
        return TokenClass::Number;
    case TokenKind::True:
    case TokenKind::False:
        return TokenClass::Constant;
    case TokenKind::StringLiteral:
    case TokenKind::WstringLiteral:
        return TokenClass::Text;
    case TokenKind::TypedPrefix:
        return TokenClass::Type;
    case TokenKind::DirectAddress:
        return TokenClass::Address;
    case TokenKind::Pragma:
        return TokenClass::Pragma;
    case TokenKind::Error:
        return TokenClass::Error;
    case TokenKind::Identifier:
    case TokenKind::EndOfFile:
        return TokenClass::Plain;
    default:
        return lex::isKeyword(token.kind) ? TokenClass::Keyword : TokenClass::Operator;
    }
}

/// Soft words that are always words of the language where nothing was declared under that name.
bool isElementaryTypeName(std::string_view text) {
    const std::string folded = foldCase(text);
    for (uint32_t kind = 0; kind <= static_cast<uint32_t>(types::TypeKind::Wchar); ++kind)
        if (folded == foldCase(types::spelling(static_cast<types::TypeKind>(kind)))) return true;
    return folded == "string" || folded == "wstring" || folded == "time_of_day" || folded == "date_and_time" ||
           folded == "pointer" || folded == "reference" || folded == "ref_to";
}

} // namespace

std::vector<AccumulatorPlace> CodeModel::accumulators(FileId file) const {
    const auto& files = m_checked.analysis->files;
    return file.index() < files.size() ? accumulatorPlaces(*files[file.index()]) : std::vector<AccumulatorPlace>();
}

std::vector<ColouredToken> CodeModel::colours(FileId file) const {
    std::vector<ColouredToken> out;
    const sema::Analysis& analysis = *m_checked.analysis;
    if (file.index() >= analysis.files.size()) return out;
    const syntax::SyntaxFile& tree = *analysis.files[file.index()];
    const std::vector<uint32_t> operators = operatorPlaces(tree);
    const std::string_view text = (*m_checked.sources)[file].text();
    auto reference = std::lower_bound(analysis.references.begin(), analysis.references.end(), file,
                                      [](const sema::Reference& r, FileId f) { return r.range.file < f; });
    for (const lex::Token& token : tree.tokens.tokens) {
        ColouredToken coloured{token.begin, token.end, classOf(token)};
        if (token.kind == TokenKind::Identifier) {
            // Both lists are in order of place: one walk, where a search for each name would be the most of it.
            while (reference != analysis.references.end() && reference->range.file == file &&
                   reference->range.begin < token.begin)
                ++reference;
            if (reference != analysis.references.end() && reference->range.file == file &&
                reference->range.begin == token.begin && reference->symbol.isValid()) {
                const Symbol& symbol = analysis.symbols[reference->symbol.index()];
                coloured.kind = classOf(symbol);
                if (symbol.kind == SymbolKind::Variable && analysis.program &&
                    analysis.program->types->kind(symbol.type) == types::TypeKind::Block)
                    coloured.kind = TokenClass::Instance;
            } else if (isElementaryTypeName(text.substr(token.begin, token.end - token.begin))) {
                coloured.kind = TokenClass::Type;
            } else if (token.soft != lex::SoftWord::None) {
                coloured.kind = TokenClass::Keyword;
            }
        }
        if (std::binary_search(operators.begin(), operators.end(), token.begin)) coloured.kind = TokenClass::Keyword;
        if (token.kind != TokenKind::EndOfFile) out.push_back(coloured);
    }
    for (const lex::Comment& comment : tree.tokens.comments)
        out.push_back({comment.begin, comment.end, TokenClass::Comment});
    std::sort(out.begin(), out.end(), [](const ColouredToken& a, const ColouredToken& b) { return a.begin < b.begin; });
    return out;
}

std::optional<sema::SymbolId> CodeModel::symbolAt(FileId file, uint32_t offset, SourceRange* range) const {
    const sema::Analysis& analysis = *m_checked.analysis;
    for (const sema::Reference& reference : analysis.references)
        if (reference.range.file == file && offset >= reference.range.begin && offset <= reference.range.end &&
            reference.symbol.isValid()) {
            if (range) *range = reference.range;
            return reference.symbol;
        }
    for (uint32_t i = 0; i < analysis.symbols.size(); ++i) {
        const SourceRange& declared = analysis.symbols[i].declaration;
        if (declared.file == file && offset >= declared.begin && offset <= declared.end && declared.length() > 0) {
            if (range) *range = declared;
            return sema::SymbolId(i);
        }
    }
    return std::nullopt;
}

std::string CodeModel::pouAt(FileId file, uint32_t offset) const {
    const sema::Analysis& analysis = *m_checked.analysis;
    if (file.index() >= analysis.files.size()) return {};
    std::string found;
    const auto inPou = [&](const syntax::Pou& pou) {
        if (offset < pou.range.begin || offset > pou.range.end) return;
        found = std::string(pou.name.text);
        for (const syntax::Pou* method : pou.methods)
            if (offset >= method->range.begin && offset <= method->range.end)
                found += "." + std::string(method->name.text);
    };
    const auto walk = [&](auto&& self, const std::vector<syntax::Decl*>& declarations) -> void {
        for (const syntax::Decl* declaration : declarations) {
            if (declaration->kind == syntax::DeclKind::Pou && declaration->pou) inPou(*declaration->pou);
            if (declaration->test && offset >= declaration->test->range.begin && offset <= declaration->test->range.end)
                found = sema::testUnitName(*declaration->test);
            if (declaration->kind == syntax::DeclKind::Namespace && declaration->space)
                self(self, declaration->space->declarations);
        }
    };
    walk(walk, analysis.files[file.index()]->declarations);
    return found;
}

namespace {
std::string sectionWord(const Symbol& symbol) {
    switch (symbol.section) {
    case types::FieldSection::Input:
        return "VAR_INPUT ";
    case types::FieldSection::Output:
        return "VAR_OUTPUT ";
    case types::FieldSection::InOut:
        return "VAR_IN_OUT ";
    default:
        return symbol.owner.empty() ? "VAR_GLOBAL " : "";
    }
}
std::string kindWord(SymbolKind kind) {
    switch (kind) {
    case SymbolKind::Type:
        return "TYPE";
    case SymbolKind::Function:
    case SymbolKind::StandardFunction:
        return "FUNCTION";
    case SymbolKind::FunctionBlock:
        return "FUNCTION_BLOCK";
    case SymbolKind::Program:
        return "PROGRAM";
    case SymbolKind::Method:
        return "METHOD";
    case SymbolKind::Property:
        return "PROPERTY";
    case SymbolKind::Action:
        return "ACTION";
    case SymbolKind::Interface:
        return "INTERFACE";
    case SymbolKind::Namespace:
        return "NAMESPACE";
    case SymbolKind::Task:
        return "TASK";
    case SymbolKind::Label:
        return "label";
    case SymbolKind::Step:
        return "STEP";
    case SymbolKind::GlobalList:
        return "VAR_GLOBAL list";
    case SymbolKind::Enumerator:
        return "value of";
    case SymbolKind::Constant:
        return "CONSTANT";
    case SymbolKind::Variable:
        return "";
    }
    return "";
}
} // namespace

std::optional<Hover> CodeModel::hover(FileId file, uint32_t offset) const {
    Hover hover;
    const auto id = symbolAt(file, offset, &hover.range);
    if (!id) return std::nullopt;
    const Symbol& found = symbol(*id);
    const auto& program = m_checked.analysis->program;
    const std::string type = program && found.type.isValid() ? (*program->types)[found.type].name : std::string();
    const std::string word = kindWord(found.kind);
    if (found.kind == SymbolKind::Variable || found.kind == SymbolKind::Constant || found.kind == SymbolKind::Property)
        hover.declaration =
            (word.empty() ? sectionWord(found) : word + " ") + found.name + (type.empty() ? "" : " : " + type);
    else if (found.kind == SymbolKind::Enumerator)
        hover.declaration = found.name + " : " + type;
    else
        hover.declaration =
            word + " " + found.name + (type.empty() || type == found.name || type == "(no value)" ? "" : " : " + type);
    // What is called shows its pins; a structure its fields.
    if (found.kind == SymbolKind::FunctionBlock || found.kind == SymbolKind::Function ||
        found.kind == SymbolKind::Method || found.kind == SymbolKind::Type ||
        (found.kind == SymbolKind::Variable && program && found.type.isValid() &&
         program->types->kind(found.type) == types::TypeKind::Block)) {
        size_t shown = 0;
        const auto pin = [&](types::FieldSection section, const std::string& name, const std::string& of) {
            const char* arrow = section == types::FieldSection::Input    ? "→ "
                                : section == types::FieldSection::Output ? "← "
                                : section == types::FieldSection::InOut  ? "↔ "
                                                                         : "  ";
            const bool isPin = section == types::FieldSection::Input || section == types::FieldSection::Output ||
                               section == types::FieldSection::InOut;
            if (!isPin && !(section == types::FieldSection::Member && found.kind == SymbolKind::Type)) return;
            if (++shown <= 24) hover.declaration += "\n" + (arrow + name) + " : " + of;
            if (shown == 25) hover.declaration += "\n…";
        };
        const bool isRoutine = found.kind == SymbolKind::Function || found.kind == SymbolKind::Method;
        if (program && found.type.isValid() && !isRoutine) {
            for (const types::Field& field : (*program->types)[found.type].fields)
                if (!field.name.starts_with("__")) pin(field.section, field.name, (*program->types)[field.type].name);
        } else if (isRoutine) {
            const std::string owner = found.owner.empty() ? found.name : found.owner + "." + found.name;
            if (const auto it = m_byOwner.find(foldCase(owner)); it != m_byOwner.end())
                for (const uint32_t index : it->second) {
                    const Symbol& each = m_checked.analysis->symbols[index];
                    if (each.type.isValid())
                        pin(each.section, each.name, program ? (*program->types)[each.type].name : "");
                }
        }
    }
    hover.comment = found.comment;
    hover.path = found.path;
    hover.pou = pouAt(file, offset);
    hover.isRelative = !found.owner.empty() && equalsIgnoringCase(found.path, found.name);
    return hover;
}

std::optional<SourceRange> CodeModel::definition(FileId file, uint32_t offset) const {
    const auto id = symbolAt(file, offset);
    if (!id || !symbol(*id).declaration.file.isValid()) return std::nullopt;
    return symbol(*id).declaration;
}

std::vector<Use> CodeModel::uses(FileId file, uint32_t offset) const {
    std::vector<Use> out;
    const auto id = symbolAt(file, offset);
    if (!id) return out;
    const SourceRange declared = symbol(*id).declaration;
    if (declared.file.isValid()) out.push_back({declared, false, false, true});
    for (const uint32_t index : m_referencesOf[id->index()]) {
        const sema::Reference& reference = m_checked.analysis->references[index];
        if (!(reference.range == declared))
            out.push_back({reference.range, reference.isWrite, reference.isRead, false});
    }
    std::sort(out.begin(), out.end(), [](const Use& a, const Use& b) {
        return std::pair(a.range.file, a.range.begin) < std::pair(b.range.file, b.range.begin);
    });
    return out;
}

Result<std::vector<FileEdits>> CodeModel::rename(FileId file, uint32_t offset, std::string_view newName) const {
    const auto id = symbolAt(file, offset);
    if (!id) return Error{errors::NothingToRename(), ""};
    const Symbol& renamed = symbol(*id);
    const auto isLibrary = [&](FileId each) { return !m_checked.analysis->files[each.index()]->library.empty(); };
    if (!renamed.declaration.file.isValid() || isLibrary(renamed.declaration.file))
        return Error{errors::LibraryKeepsName(renamed.name), ""};
    diagnostics::Sink sink;
    const lex::TokenList tokens = lex::tokenize(FileId(size_t(0)), newName, sink);
    if (tokens.tokens.size() != 2 || tokens.tokens[0].kind != TokenKind::Identifier || sink.hasErrors())
        return Error{errors::NotAName(newName), ""};
    if (!equalsIgnoringCase(newName, renamed.name))
        if (const auto same = m_byOwner.find(foldCase(renamed.owner)); same != m_byOwner.end())
            for (const uint32_t other : same->second)
                if (equalsIgnoringCase(m_checked.analysis->symbols[other].name, newName))
                    return Error{renamed.owner.empty() ? errors::NameExistsInProject(newName)
                                                       : errors::NameExistsIn(newName, renamed.owner),
                                 ""};
    std::vector<FileEdits> out;
    for (const Use& use : uses(file, offset)) {
        if (isLibrary(use.range.file)) continue;
        if (!equalsIgnoringCase((*m_checked.sources)[use.range.file].slice(use.range), renamed.name))
            continue; // an alias, a quoted or prefixed form keeps its spelling
        if (out.empty() || out.back().file != use.range.file) out.push_back({use.range.file, {}});
        auto& edits = out.back().edits;
        if (edits.empty() || edits.back().range.begin != use.range.begin)
            edits.push_back({use.range, std::string(newName)});
    }
    return out;
}

namespace {

OutlineItem itemOf(const syntax::Pou& pou) {
    static constexpr SymbolKind kinds[] = {SymbolKind::Program,  SymbolKind::Function, SymbolKind::FunctionBlock,
                                           SymbolKind::Method,   SymbolKind::Property, SymbolKind::Property,
                                           SymbolKind::Interface};
    OutlineItem item;
    item.name = std::string(pou.name.text);
    item.kind = kinds[static_cast<size_t>(pou.kind)];
    item.range = pou.range;
    item.nameRange = pou.name.range;
    for (const syntax::Pragma& pragma : pou.pragmas)
        item.isSimulation = item.isSimulation || equalsIgnoringCase(pragma.key, "simulation"),
        item.isHidden = item.isHidden || equalsIgnoringCase(pragma.key, "hide");
    item.comment = std::string(pou.comment);
    const auto child = [&](const syntax::Name& name, SymbolKind kind, SourceRange range) {
        OutlineItem inner;
        inner.name = std::string(name.text);
        inner.kind = kind;
        inner.range = range;
        inner.nameRange = name.range;
        item.children.push_back(inner);
    };
    for (const syntax::Pou* method : pou.methods) child(method->name, SymbolKind::Method, method->range);
    for (const syntax::Property* property : pou.properties)
        child(property->name, SymbolKind::Property, property->range);
    for (const syntax::ActionDecl* action : pou.actions) child(action->name, SymbolKind::Action, action->range);
    if (pou.body.chart) {
        for (const syntax::StepDecl* step : pou.body.chart->steps) child(step->name, SymbolKind::Step, step->range);
        for (const syntax::ActionDecl* action : pou.body.chart->actions)
            child(action->name, SymbolKind::Action, action->range);
    }
    return item;
}

void collect(const std::vector<syntax::Decl*>& declarations, std::vector<OutlineItem>& out) {
    for (const syntax::Decl* declaration : declarations) {
        OutlineItem item;
        item.range = declaration->range;
        item.nameRange = declaration->range;
        switch (declaration->kind) {
        case syntax::DeclKind::Pou:
            item = itemOf(*declaration->pou);
            break;
        case syntax::DeclKind::Type:
            item.name = std::string(declaration->type->name.text);
            item.kind = SymbolKind::Type;
            item.nameRange = declaration->type->name.range;
            item.comment = std::string(declaration->type->comment);
            for (const syntax::Pragma& pragma : declaration->type->pragmas)
                item.isHidden = item.isHidden || equalsIgnoringCase(pragma.key, "hide");
            break;
        case syntax::DeclKind::Globals:
            item.name = declaration->globals->name.empty() ? "VAR_GLOBAL" : std::string(declaration->globals->name);
            item.kind = SymbolKind::GlobalList;
            break;
        case syntax::DeclKind::Configuration:
            item.name = std::string(declaration->configuration->name.text);
            item.kind = SymbolKind::Task;
            item.detail = "CONFIGURATION";
            for (const syntax::ResourceDecl* resource : declaration->configuration->resources)
                for (const syntax::TaskDecl* task : resource->tasks) {
                    OutlineItem inner;
                    inner.name = std::string(task->name.text);
                    inner.kind = SymbolKind::Task;
                    inner.range = task->range;
                    inner.nameRange = task->name.range;
                    item.children.push_back(inner);
                }
            break;
        case syntax::DeclKind::Test:
            item.name = std::string(declaration->test->title);
            item.isTest = true;
            item.nameRange = declaration->test->titleRange;
            break;
        case syntax::DeclKind::Namespace:
            for (const syntax::Name& part : declaration->space->path)
                item.name += (item.name.empty() ? "" : ".") + std::string(part.text);
            item.kind = SymbolKind::Namespace;
            collect(declaration->space->declarations, item.children);
            break;
        case syntax::DeclKind::Using:
            continue;
        }
        out.push_back(std::move(item));
    }
}

} // namespace

std::vector<OutlineItem> CodeModel::outline(FileId file) const {
    std::vector<OutlineItem> out;
    if (file.index() < m_checked.analysis->files.size())
        collect(m_checked.analysis->files[file.index()]->declarations, out);
    return out;
}

} // namespace plc::analysis
