#include "runtime/compiler/lower/print.h"

#include "runtime/compiler/lower/builder.h"

namespace plc::lower {

using syntax::ArgumentKind;
using syntax::TypeSpecKind;

namespace {

int level(const Expr& e) {
    if (e.kind == ExprKind::Unary) return 9;
    if (e.kind == ExprKind::AssignChain) return 0;
    if (e.kind != ExprKind::Binary) return 10;
    return lex::precedenceOf(e.op);
}

std::string inside(const Expr& e, int least) { return level(e) < least ? "(" + print(e) + ")" : print(e); }

std::string pathOf(const syntax::Path& path) {
    std::string out;
    for (const Name& name : path) out += (out.empty() ? "" : ".") + spelled(name.text);
    return out;
}

class StatementPrinter {
public:
    std::string text;

    void block(const Block& list, int indent) {
        for (const Stmt* s : list) statement(*s, indent);
    }

private:
    void line(int indent, const std::string& code) {
        text += std::string(static_cast<size_t>(indent), ' ') + code + "\n";
    }

    void statement(const Stmt& s, int indent) {
        switch (s.kind) {
        case StmtKind::Empty:
            return line(indent, ";");
        case StmtKind::Assign:
            return line(indent,
                        print(*s.target) + " " + std::string(lex::spelling(s.op)) + " " + print(*s.value) + ";");
        case StmtKind::Call:
            return line(indent, print(*s.value) + ";");
        case StmtKind::If: {
            bool first = true;
            for (const syntax::IfBranch& branch : s.branches) {
                line(indent,
                     branch.condition ? (first ? "IF " : "ELSIF ") + print(*branch.condition) + " THEN" : "ELSE");
                block(branch.body, indent + 4);
                first = false;
            }
            return line(indent, "END_IF");
        }
        case StmtKind::Case:
            line(indent, "CASE " + print(*s.value) + " OF");
            for (const syntax::CaseArm& arm : s.arms) {
                std::string labels;
                for (const syntax::CaseLabel& label : arm.labels)
                    labels += (labels.empty() ? "" : ", ") + print(*label.low) +
                              (label.high ? ".." + print(*label.high) : "");
                line(indent + 4, labels + ":");
                block(arm.body, indent + 8);
            }
            if (s.hasElse) {
                line(indent, "ELSE");
                block(s.elseBody, indent + 4);
            }
            return line(indent, "END_CASE");
        case StmtKind::For:
            line(indent, "FOR " + print(*s.target) + " := " + print(*s.from) + " TO " + print(*s.to) +
                             (s.by ? " BY " + print(*s.by) : "") + " DO");
            block(s.body, indent + 4);
            return line(indent, "END_FOR");
        case StmtKind::While:
            line(indent, "WHILE " + print(*s.value) + " DO");
            block(s.body, indent + 4);
            return line(indent, "END_WHILE");
        case StmtKind::Repeat:
            line(indent, "REPEAT");
            block(s.body, indent + 4);
            line(indent, "UNTIL " + print(*s.value));
            return line(indent, "END_REPEAT");
        case StmtKind::Try:
            line(indent, "__TRY");
            block(s.branches.front().body, indent + 4);
            for (size_t i = 1; i < s.branches.size(); ++i) {
                line(indent, "__CATCH(" + print(*s.branches[i].condition) + ")");
                block(s.branches[i].body, indent + 4);
            }
            if (s.hasElse) {
                line(indent, "__FINALLY");
                block(s.elseBody, indent + 4);
            }
            return line(indent, "__ENDTRY");
        case StmtKind::Exit:
            return line(indent, "EXIT;");
        case StmtKind::Continue:
            return line(indent, "CONTINUE;");
        case StmtKind::Return:
            return line(indent, s.value ? "RETURN " + print(*s.value) + ";" : "RETURN;");
        case StmtKind::Label:
            return line(indent, spelled(s.name.text) + ":");
        case StmtKind::Jump:
            if (!s.value) return line(indent, "JMP " + spelled(s.name.text) + ";");
            line(indent, "IF " + print(*s.value) + " THEN");
            line(indent + 4, "JMP " + spelled(s.name.text) + ";");
            return line(indent, "END_IF");
        case StmtKind::Block:
            return block(s.body, indent);
        case StmtKind::Il:
        case StmtKind::Run:
        case StmtKind::Assert:
        case StmtKind::Force:
        case StmtKind::Release:
        case StmtKind::Compare:
        case StmtKind::PowerOff:
            return; // not of ST bodies
        }
    }
};

} // namespace

std::string print(const Expr& e) {
    switch (e.kind) {
    case ExprKind::Error:
        return "?";
    case ExprKind::Literal:
        return (e.prefix.isValid() ? std::string(e.prefix.text) + "#" : std::string()) + std::string(e.text);
    case ExprKind::TypedName:
        return std::string(e.prefix.text) + "#" + std::string(e.name.text);
    case ExprKind::NameRef:
        return spelled(e.name.text);
    case ExprKind::Address:
        return std::string(e.text);
    case ExprKind::Member:
        return inside(*e.base, 10) + "." + spelled(e.name.text);
    case ExprKind::Bit:
        return inside(*e.base, 10) + "." + std::string(e.text);
    case ExprKind::Index:
        return inside(*e.base, 10) + "[" + printArguments(e.arguments) + "]";
    case ExprKind::Deref:
        return inside(*e.base, 10) + "^";
    case ExprKind::Call:
        return inside(*e.base, 10) + "(" + printArguments(e.arguments) + ")";
    case ExprKind::Unary: {
        const std::string operand = inside(*e.base, 9);
        if (e.op == TokenKind::Not) return "NOT " + operand;
        return std::string(lex::spelling(e.op)) +
               (e.base->kind == ExprKind::Unary && e.base->op != TokenKind::Not ? "(" + operand + ")" : operand);
    }
    case ExprKind::Binary: {
        const int own = level(e);
        return inside(*e.base, own) + " " + std::string(lex::spelling(e.op)) + " " + inside(*e.right, own + 1);
    }
    case ExprKind::AssignChain:
        return print(*e.base) + " " + std::string(lex::spelling(e.op)) + " " + print(*e.right);
    case ExprKind::ArrayInit:
        return "[" + printArguments(e.arguments) + "]";
    case ExprKind::StructInit:
        return "(" + printArguments(e.arguments) + ")";
    case ExprKind::Repeat:
        return print(*e.base) + "(" + printArguments(e.arguments) + ")";
    case ExprKind::This:
        return "THIS";
    case ExprKind::Super:
        return "SUPER";
    }
    return "?";
}

std::string print(const Block& block, int indent) {
    StatementPrinter printer;
    printer.block(block, indent);
    return printer.text;
}

std::string print(const syntax::TypeSpec& spec) {
    switch (spec.kind) {
    case TypeSpecKind::Named:
    case TypeSpecKind::String:
        return pathOf(spec.path) + (spec.length ? "(" + print(*spec.length) + ")" : "");
    case TypeSpecKind::Pointer:
        return "POINTER TO " + print(*spec.element);
    case TypeSpecKind::RefTo:
        return "REF_TO " + print(*spec.element);
    case TypeSpecKind::Reference:
        return "REFERENCE TO " + print(*spec.element);
    case TypeSpecKind::Subrange:
        return pathOf(spec.path) + "(" + print(*spec.bounds[0].low) + ".." + print(*spec.bounds[0].high) + ")";
    case TypeSpecKind::Array: {
        std::string out;
        for (const syntax::Bounds& b : spec.bounds)
            out += (out.empty() ? "" : ", ") + print(*b.low) + ".." + print(*b.high);
        return "ARRAY[" + out + "] OF " + print(*spec.element);
    }
    case TypeSpecKind::OpenArray:
    case TypeSpecKind::Enum:
    case TypeSpecKind::Struct:
    case TypeSpecKind::Union:
    case TypeSpecKind::Inferred:
    case TypeSpecKind::Error:
        break;
    }
    return "?";
}

std::string printArguments(const std::vector<Argument>& list) {
    std::string out;
    for (const Argument& a : list) {
        if (!out.empty()) out += ", ";
        if (a.negated) out += "NOT ";
        if (a.kind != ArgumentKind::Positional)
            out += spelled(a.name.text) + (a.kind == ArgumentKind::Input ? " := " : " => ");
        if (a.value) out += print(*a.value);
    }
    return out;
}

} // namespace plc::lower
