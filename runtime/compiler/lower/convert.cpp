#include "runtime/compiler/lower/convert.h"
#include "runtime/base/messages.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lower/instruction_list.h"
#include "runtime/compiler/lower/print.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>

namespace plc::lower {

using syntax::ArgumentKind;
using syntax::Body;
using syntax::Pou;

namespace {

bool isComparison(TokenKind op) {
    switch (op) {
    case TokenKind::Equal:
    case TokenKind::NotEqual:
    case TokenKind::Less:
    case TokenKind::LessEqual:
    case TokenKind::Greater:
    case TokenKind::GreaterEqual:
        return true;
    default:
        return false;
    }
}

/// What can be said of a type from the unit's own declarations.
class LocalTypes {
public:
    explicit LocalTypes(const Pou& pou) {
        for (const syntax::VarSection* section : pou.sections) add(*section);
    }
    void add(const syntax::VarSection& section) {
        for (const syntax::VarDecl* decl : section.declarations)
            for (const Name& name : decl->names) m_types[foldCase(name.text)] = decl->type;
    }
    std::string of(const Expr& e) const {
        switch (e.kind) {
        case ExprKind::Literal:
            if (e.prefix.isValid()) return std::string(e.prefix.text);
            switch (e.op) {
            case TokenKind::True:
            case TokenKind::False:
                return "BOOL";
            case TokenKind::DurationLiteral:
                return "TIME";
            case TokenKind::RealLiteral:
                return "REAL";
            default:
                return {};
            }
        case ExprKind::NameRef: {
            const auto it = m_types.find(foldCase(e.name.text));
            if (it == m_types.end() || !it->second) return {};
            return it->second->kind == syntax::TypeSpecKind::Inferred ? of(*it->second->inferredFrom)
                                                                      : print(*it->second);
        }
        case ExprKind::Index: {
            if (e.base->kind != ExprKind::NameRef) return {};
            const auto it = m_types.find(foldCase(e.base->name.text));
            return it != m_types.end() && it->second && it->second->element ? print(*it->second->element)
                                                                            : std::string();
        }
        case ExprKind::Bit:
            return "BOOL";
        case ExprKind::Member:
            return isOutputFlag(e.name.text) ? "BOOL" : std::string();
        case ExprKind::Unary:
            return of(*e.base);
        case ExprKind::Binary: {
            if (isComparison(e.op)) return "BOOL";
            const std::string left = of(*e.base);
            return left.empty() || e.base->kind == ExprKind::Literal ? (of(*e.right).empty() ? left : of(*e.right))
                                                                     : left;
        }
        case ExprKind::Call: {
            if (e.base->kind != ExprKind::NameRef) return {};
            const std::string name = foldCase(e.base->name.text);
            const size_t to = name.rfind("_to_");
            if (to != std::string::npos) return std::string(e.base->name.text.substr(to + 4));
            for (const char* same :
                 {"limit", "min", "max", "abs", "add",  "sub",  "mul", "div", "mod", "shl", "shr", "rol", "ror",
                  "and",   "or",  "xor", "not", "move", "sqrt", "sin", "cos", "tan", "ln",  "log", "exp"})
                if (name == same)
                    for (const Argument& a : e.arguments)
                        if (a.value && !of(*a.value).empty()) return of(*a.value);
            return {};
        }
        default:
            return {};
        }
    }

private:
    static bool isOutputFlag(std::string_view name) {
        return equalsIgnoringCase(name, "Q") || equalsIgnoringCase(name, "Q1") || equalsIgnoringCase(name, "QU") ||
               equalsIgnoringCase(name, "QD") || equalsIgnoringCase(name, "X");
    }
    std::map<std::string, const syntax::TypeSpec*> m_types;
};

/// __il0 → result0, __at_out_1 → at_out: names a reader meets.
void rename(Expr* e, const std::map<std::string, std::string_view>& names) {
    if (!e) return;
    if (e->kind == ExprKind::NameRef) {
        const auto it = names.find(std::string(e->name.text));
        if (it != names.end()) e->name.text = it->second;
    }
    rename(e->base, names);
    rename(e->right, names);
    for (Argument& a : e->arguments) rename(a.value, names);
}
void rename(Block& block, const std::map<std::string, std::string_view>& names) {
    for (Stmt* s : block) {
        rename(s->target, names);
        rename(s->value, names);
        for (syntax::IfBranch& branch : s->branches) {
            rename(branch.condition, names);
            rename(branch.body, names);
        }
    }
}

} // namespace

namespace {

/// The comments of a body, given out in order of place.
class Comments {
public:
    Comments(const syntax::SyntaxFile& file, const Body& body, std::string_view text) : m_text(text) {
        if (text.empty()) return;
        for (const lex::Comment& comment : file.tokens.comments)
            if (comment.begin >= body.range.begin && comment.end <= body.range.end) m_all.push_back(comment);
    }
    /// Those that begin before the end of the line of `at`, one a line.
    std::string upToLineOf(uint32_t at) {
        if (m_all.empty()) return {};
        while (at < m_text.size() && m_text[at] != '\n') ++at;
        return before(at);
    }
    std::string before(uint32_t at) {
        std::string out;
        for (; m_next < m_all.size() && m_all[m_next].begin < at; ++m_next)
            out += std::string(m_text.substr(m_all[m_next].begin, m_all[m_next].end - m_all[m_next].begin)) + "\n";
        return out;
    }
    std::string rest() { return before(UINT32_MAX); }

private:
    std::string_view m_text;
    std::vector<lex::Comment> m_all;
    size_t m_next = 0;
};

} // namespace

Result<ConvertedBody> instructionListAsSt(syntax::SyntaxFile& file, const Pou& pou, const Body& body,
                                          const TypeNamer& typeOf, std::string_view text) {
    if (body.language != syntax::BodyLanguage::Il) return Error{errors::NotAnInstructionList(), {}};
    Builder builder(file);
    syntax::VarSection section;
    int counter = 0;
    diagnostics::Sink sink;
    const std::vector<std::string> blocks = [&] {
        std::vector<std::string> out;
        for (const syntax::Decl* decl : file.declarations)
            if (decl->pou && decl->pou->kind == syntax::PouKind::FunctionBlock)
                out.push_back(foldCase(decl->pou->name.text));
        return out;
    }();
    LoweredList list = lowerInstructions(body.statements,
                                         {builder, pou.sections, blocks, section, counter, sink, Keep::Needed}, false);
    if (sink.hasErrors()) return Error{sink.all().front().message, {}};
    LocalTypes types(pou);
    types.add(section);
    ConvertedBody out;
    std::map<std::string, std::string_view> names;
    std::set<std::string> taken;
    for (const syntax::VarSection* s : pou.sections)
        for (const syntax::VarDecl* decl : s->declarations)
            for (const Name& name : decl->names) taken.insert(foldCase(name.text));
    int number = 0;
    std::map<std::pair<uint32_t, uint32_t>, size_t> kept;
    for (const syntax::VarDecl* decl : section.declarations) {
        const Expr& source = *decl->type->inferredFrom;
        std::string type = typeOf ? typeOf(decl->range, kept[{decl->range.begin, decl->range.end}]++) : std::string();
        if (type.empty()) type = types.of(source);
        if (type.empty()) return Error{errors::TypeUnknownHere(print(source)), {}};
        while (taken.contains("result" + std::to_string(++number))) {
        }
        const std::string_view name = builder.keep("result" + std::to_string(number));
        names[std::string(decl->names[0].text)] = name;
        out.declarations += std::string(name) + " : " + type + ";\n";
    }
    rename(list.statements, names);
    Comments comments(file, body, text);
    for (Stmt* statement : list.statements) {
        if (statement->origin) out.body += comments.upToLineOf(statement->origin->range.end);
        out.body += print(Block{statement}, 0);
    }
    out.body += comments.rest();
    return out;
}

namespace {

/// ST to instructions. An error leaves a reason and stops.
class ListWriter {
public:
    explicit ListWriter(Comments comments) : m_comments(std::move(comments)) {}

    Message reason;
    std::string text;

    void block(const Block& list) {
        for (const Stmt* s : list) {
            if (!reason.isEmpty()) return;
            const bool simple = s->branches.empty() && s->arms.empty() && s->body.empty();
            text += simple ? m_comments.upToLineOf(s->range.end) : m_comments.before(s->range.begin);
            statement(*s);
        }
    }
    void finish() {
        if (!m_label.empty()) line("RET", "");
        text += m_comments.rest();
    }

private:
    void fail(messages::Thing what) {
        if (reason.isEmpty()) reason = errors::NoEquivalentInIl(std::move(what));
    }
    void line(std::string_view op, const std::string& operand) {
        std::string out = m_label.empty() ? std::string() : m_label + ":";
        m_label.clear();
        out.resize(std::max<size_t>(out.size() + (out.empty() ? 0 : 1), 10), ' ');
        out += op;
        if (!operand.empty()) {
            out.resize(std::max<size_t>(out.size() + 1, 18), ' ');
            out += operand;
        }
        text += out + "\n";
    }
    std::string freshLabel() { return "l" + std::to_string(++m_labels); }
    void label(const std::string& name) {
        if (!m_label.empty()) text += m_label + ":\n";
        m_label = name;
    }

    static bool isOperand(const Expr& e) {
        switch (e.kind) {
        case ExprKind::Literal:
        case ExprKind::TypedName:
        case ExprKind::NameRef:
        case ExprKind::Address:
        case ExprKind::Member:
        case ExprKind::Bit:
        case ExprKind::Index:
        case ExprKind::Deref:
            return true;
        case ExprKind::Unary:
            return e.op == TokenKind::Minus && e.base->kind == ExprKind::Literal;
        default:
            return false;
        }
    }
    static std::string operatorOf(TokenKind op) {
        switch (op) {
        case TokenKind::And:
            return "AND";
        case TokenKind::Or:
            return "OR";
        case TokenKind::Xor:
            return "XOR";
        case TokenKind::Plus:
            return "ADD";
        case TokenKind::Minus:
            return "SUB";
        case TokenKind::Star:
            return "MUL";
        case TokenKind::Slash:
            return "DIV";
        case TokenKind::Mod:
            return "MOD";
        case TokenKind::Greater:
            return "GT";
        case TokenKind::GreaterEqual:
            return "GE";
        case TokenKind::Equal:
            return "EQ";
        case TokenKind::NotEqual:
            return "NE";
        case TokenKind::LessEqual:
            return "LE";
        case TokenKind::Less:
            return "LT";
        default:
            return {};
        }
    }

    void load(const Expr& e) {
        if (isOperand(e)) return line("LD", print(e));
        if (e.kind == ExprKind::Unary && e.op == TokenKind::Not) {
            if (isOperand(*e.base)) return line("LDN", print(*e.base));
            load(*e.base);
            return line("NOT", "");
        }
        if (e.kind == ExprKind::Binary) {
            const std::string op = operatorOf(e.op);
            if (op.empty()) return e.op == TokenKind::Power ? power(e) : fail(lex::spelling(e.op));
            load(*e.base);
            const bool logic = op == "AND" || op == "OR" || op == "XOR";
            if (isOperand(*e.right)) return line(op, print(*e.right));
            if (logic && e.right->kind == ExprKind::Unary && e.right->op == TokenKind::Not && isOperand(*e.right->base))
                return line(op + "N", print(*e.right->base));
            line(op + "(", "");
            load(*e.right);
            return line(")", "");
        }
        if (e.kind == ExprKind::Call) return call(e);
        fail(print(e));
    }
    void power(const Expr& e) {
        if (!isOperand(*e.right)) return fail(phrases::APowerOfAComputedNumber());
        load(*e.base);
        line("EXPT", print(*e.right));
    }
    void call(const Expr& e) {
        if (e.base->kind != ExprKind::NameRef) return fail(phrases::ACallOf(print(*e.base)));
        const bool named = std::any_of(e.arguments.begin(), e.arguments.end(),
                                       [](const Argument& a) { return a.kind != ArgumentKind::Positional; });
        if (named || e.arguments.empty())
            return named ? line(spelled(e.base->name.text) + "(" + printArguments(e.arguments) + ")", "")
                         : fail(phrases::ACallWithoutArguments());
        std::string rest;
        for (size_t i = 1; i < e.arguments.size(); ++i) {
            if (!e.arguments[i].value || !isOperand(*e.arguments[i].value))
                return fail(phrases::AComputedSecondArgument(print(*e.base)));
            rest += (rest.empty() ? "" : ", ") + print(*e.arguments[i].value);
        }
        load(*e.arguments[0].value);
        line(spelled(e.base->name.text), rest);
    }

    void statement(const Stmt& s) {
        switch (s.kind) {
        case StmtKind::Empty:
            return;
        case StmtKind::Assign:
            return assign(s);
        case StmtKind::Call:
            if (s.value->kind != ExprKind::Call) return fail(print(*s.value));
            return line("CAL", print(*s.value->base) +
                                   (s.value->arguments.empty() ? "" : "(" + printArguments(s.value->arguments) + ")"));
        case StmtKind::If: {
            const std::string end = freshLabel();
            for (size_t i = 0; i < s.branches.size() && reason.isEmpty(); ++i) {
                const syntax::IfBranch& branch = s.branches[i];
                const bool last = i + 1 == s.branches.size();
                const std::string next = last ? end : freshLabel();
                if (branch.condition) {
                    load(*branch.condition);
                    line("JMPCN", next);
                }
                block(branch.body);
                if (!last) {
                    line("JMP", end);
                    label(next);
                }
            }
            return label(end);
        }
        case StmtKind::While: {
            const std::string again = freshLabel(), end = freshLabel();
            label(again);
            load(*s.value);
            line("JMPCN", end);
            loop(s.body, again, end);
            line("JMP", again);
            return label(end);
        }
        case StmtKind::Repeat: {
            const std::string again = freshLabel(), test = freshLabel(), end = freshLabel();
            label(again);
            loop(s.body, test, end);
            label(test);
            load(*s.value);
            line("JMPCN", again);
            return label(end);
        }
        case StmtKind::Case:
            return choose(s);
        case StmtKind::Exit:
            return m_ends.empty() ? fail(phrases::OutsideALoop(Verbatim("EXIT"))) : line("JMP", m_ends.back());
        case StmtKind::Continue:
            return m_agains.empty() ? fail(phrases::OutsideALoop(Verbatim("CONTINUE"))) : line("JMP", m_agains.back());
        case StmtKind::Return:
            return s.value ? fail(phrases::ReturnWithValue()) : line("RET", "");
        case StmtKind::Label:
            return label(std::string(s.name.text));
        case StmtKind::Jump:
            return line("JMP", std::string(s.name.text));
        case StmtKind::Block:
            return block(s.body);
        case StmtKind::For:
            return count(s);
        case StmtKind::Il:
        case StmtKind::Try:
        case StmtKind::Run:
        case StmtKind::Assert:
        case StmtKind::Force:
        case StmtKind::Release:
        case StmtKind::Compare:
        case StmtKind::PowerOff:
            return fail(phrases::ThisStatement());
        }
    }
    /// A constant from -127 to 127: what every integer type that can count holds, or nearly.
    static std::optional<int> smallConstant(const Expr* e) {
        if (!e) return 1;
        const bool negative = e->kind == ExprKind::Unary && e->op == TokenKind::Minus;
        const Expr* literal = negative ? e->base : e;
        if (literal->kind != ExprKind::Literal || literal->op != TokenKind::IntegerLiteral || literal->text.size() > 3)
            return std::nullopt;
        int value = 0;
        for (const char c : literal->text) {
            if (c < '0' || c > '9') return std::nullopt;
            value = value * 10 + (c - '0');
        }
        if (value > 127) return std::nullopt;
        return negative ? -value : value;
    }
    /// A counted loop whose end and step are constants, so that nothing has to be kept and the count cannot run over
    /// its type.
    void count(const Stmt& s) {
        const auto to = smallConstant(s.to), by = smallConstant(s.by);
        if (!to || !by || *by == 0 || *to + *by < 0 || *to + *by > 127) return fail(phrases::ForWithThisEndOrStep());
        const std::string again = freshLabel(), next = freshLabel(), end = freshLabel();
        load(*s.from);
        line("ST", print(*s.target));
        label(again);
        line("LD", print(*s.target));
        line(*by > 0 ? "GT" : "LT", print(*s.to));
        line("JMPC", end);
        loop(s.body, next, end);
        label(next);
        line("LD", print(*s.target));
        line(*by > 0 ? "ADD" : "SUB", std::to_string(std::abs(*by)));
        line("ST", print(*s.target));
        line("JMP", again);
        label(end);
    }
    void loop(const Block& body, const std::string& again, const std::string& end) {
        m_agains.push_back(again);
        m_ends.push_back(end);
        block(body);
        m_agains.pop_back();
        m_ends.pop_back();
    }
    void assign(const Stmt& s) {
        if (s.value->kind == ExprKind::AssignChain) return fail(phrases::AnAssignmentOfSeveral());
        if (s.op != TokenKind::Assign && s.op != TokenKind::SetAssign && s.op != TokenKind::ResetAssign)
            return fail(lex::spelling(s.op));
        if (s.op == TokenKind::Assign && s.value->kind == ExprKind::Unary && s.value->op == TokenKind::Not &&
            !isOperand(*s.value->base)) {
            load(*s.value->base);
            return line("STN", print(*s.target));
        }
        load(*s.value);
        line(s.op == TokenKind::Assign ? "ST" : s.op == TokenKind::SetAssign ? "S" : "R", print(*s.target));
    }
    void choose(const Stmt& s) {
        if (!isOperand(*s.value)) return fail(phrases::CaseOfAComputedValue());
        const std::string end = freshLabel();
        for (const syntax::CaseArm& arm : s.arms) {
            if (!reason.isEmpty()) return;
            const std::string next = freshLabel(), here = freshLabel();
            for (const syntax::CaseLabel& l : arm.labels) {
                line("LD", print(*s.value));
                if (!l.high)
                    line("EQ", print(*l.low));
                else {
                    line("GE", print(*l.low));
                    line("AND(", print(*s.value));
                    line("LE", print(*l.high));
                    line(")", "");
                }
                line("JMPC", here);
            }
            line("JMP", next);
            label(here);
            block(arm.body);
            line("JMP", end);
            label(next);
        }
        block(s.elseBody);
        label(end);
    }

    Comments m_comments;
    std::string m_label;
    int m_labels = 0;
    std::vector<std::string> m_agains, m_ends;
};

} // namespace

Result<ConvertedBody> stAsInstructionList(const syntax::SyntaxFile& file, const Body& body, std::string_view text) {
    if (body.language != syntax::BodyLanguage::St) return Error{errors::NotSt(), {}};
    ListWriter writer(Comments(file, body, text));
    writer.block(body.statements);
    writer.finish();
    if (!writer.reason.isEmpty()) return Error{writer.reason, {}};
    return ConvertedBody{{}, writer.text};
}

} // namespace plc::lower
