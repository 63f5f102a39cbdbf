#include "tests/runtime/compiler/parse/outline.h"

namespace plc::parse::testing {

using namespace syntax;

namespace {

std::string text(std::string_view view) { return std::string(view); }

std::string path(const Path& names) {
    std::string out;
    for (const Name& name : names) out += (out.empty() ? "" : ".") + text(name.text);
    return out;
}

std::string arguments(const std::vector<Argument>& list) {
    std::string out;
    for (const Argument& argument : list) {
        if (!out.empty()) out += ", ";
        if (argument.negated) out += "NOT ";
        if (argument.kind == ArgumentKind::Input) out += text(argument.name.text) + " := ";
        if (argument.kind == ArgumentKind::Output) out += text(argument.name.text) + " => ";
        out += argument.value ? outline(argument.value) : "_";
    }
    return out;
}

std::string instruction(const IlInstruction& il) {
    std::string out;
    if (il.label.isValid()) out += text(il.label.text) + ": ";
    out += text(il.op.text);
    if (il.negate) out += "!";
    if (il.conditional) out += "?";
    if (il.opensParenthesis) out += "(";
    if (il.operand) out += " " + outline(il.operand);
    if (!il.arguments.empty()) out += " [" + arguments(il.arguments) + "]";
    if (il.opensParenthesis) out += " {" + outline(il.body) + "})";
    return out;
}

std::string statement(const Stmt& s) {
    switch (s.kind) {
    case StmtKind::Empty:
        return ";";
    case StmtKind::Assign:
        return outline(s.target) + " " + text(lex::spelling(s.op)) + " " + outline(s.value);
    case StmtKind::Call:
        return outline(s.value);
    case StmtKind::If: {
        std::string out = "IF";
        for (const IfBranch& branch : s.branches)
            out += (branch.condition ? " " + outline(branch.condition) : " else") + " {" + outline(branch.body) + "}";
        return out;
    }
    case StmtKind::Case: {
        std::string out = "CASE " + outline(s.value);
        for (const CaseArm& arm : s.arms) {
            out += " ";
            for (const CaseLabel& label : arm.labels)
                out += (&label == &arm.labels[0] ? "" : ",") + outline(label.low) +
                       (label.high ? ".." + outline(label.high) : "");
            out += ": {" + outline(arm.body) + "}";
        }
        return out + (s.hasElse ? " else {" + outline(s.elseBody) + "}" : "");
    }
    case StmtKind::For:
        return "FOR " + outline(s.target) + " " + outline(s.from) + " " + outline(s.to) +
               (s.by ? " by " + outline(s.by) : "") + " {" + outline(s.body) + "}";
    case StmtKind::While:
        return "WHILE " + outline(s.value) + " {" + outline(s.body) + "}";
    case StmtKind::Repeat:
        return "REPEAT {" + outline(s.body) + "} " + outline(s.value);
    case StmtKind::Try: {
        std::string out = "TRY {" + outline(s.branches.front().body) + "}";
        for (size_t i = 1; i < s.branches.size(); ++i)
            out += " catch " + outline(s.branches[i].condition) + " {" + outline(s.branches[i].body) + "}";
        return out + (s.hasElse ? " finally {" + outline(s.elseBody) + "}" : "");
    }
    case StmtKind::Exit:
        return "EXIT";
    case StmtKind::Continue:
        return "CONTINUE";
    case StmtKind::Return:
        return s.value ? "RETURN " + outline(s.value) : "RETURN";
    case StmtKind::Label:
        return text(s.name.text) + ":";
    case StmtKind::Jump:
        return "JMP " + text(s.name.text) + (s.value ? " if " + outline(s.value) : "");
    case StmtKind::Block:
        return "{" + outline(s.body) + "}";
    case StmtKind::Il:
        return instruction(*s.il);
    case StmtKind::Run:
        return "RUN " + (s.value ? "until " + outline(s.value) + " for " : std::string()) + outline(s.to) +
               (s.countsScans ? " scans" : "");
    case StmtKind::Assert:
        return "ASSERT " + outline(s.value) + (s.to ? ", " + outline(s.to) : "");
    case StmtKind::PowerOff:
        return "POWER_OFF " + outline(s.to);
    case StmtKind::Force:
        return "FORCE " + outline(s.target) + " := " + outline(s.value);
    case StmtKind::Release:
        return "RELEASE " + outline(s.target);
    case StmtKind::Compare:
        return "COMPARE " + outline(s.value) + (s.to ? ", " + outline(s.to) : "");
    }
    return "?";
}

std::string names(const std::vector<Name>& list) {
    std::string out;
    for (const Name& name : list) out += (out.empty() ? "" : ",") + text(name.text);
    return out;
}

std::string variable(const VarDecl& decl) {
    std::string out = names(decl.names);
    if (!decl.configPath.empty()) out += (out.empty() ? "" : " = ") + path(decl.configPath);
    if (!decl.address.empty()) out += "@" + text(decl.address);
    if (decl.type) out += ":" + outline(*decl.type);
    if (decl.edge == VarEdge::Rising) out += " rising";
    if (decl.edge == VarEdge::Falling) out += " falling";
    if (decl.initial) out += "=" + outline(decl.initial);
    if (decl.isReadOnly) out += " read only";
    return out;
}

std::string body(const Body& b) {
    switch (b.language) {
    case BodyLanguage::None:
        return "";
    case BodyLanguage::St:
        return " ST{" + outline(b.statements) + "}";
    case BodyLanguage::Il:
        return " IL{" + outline(b.statements) + "}";
    case BodyLanguage::Sfc:
        return " SFC{" + outline(*b.chart) + "}";
    }
    return "";
}

std::string access(Access a) {
    switch (a) {
    case Access::Default:
        return "";
    case Access::Public:
        return "public ";
    case Access::Private:
        return "private ";
    case Access::Protected:
        return "protected ";
    case Access::Internal:
        return "internal ";
    }
    return "";
}

std::string unit(const Pou& pou) {
    static const char* words[] = {"PROGRAM", "FUNCTION", "FB", "METHOD", "GET", "SET", "INTERFACE"};
    std::string out = words[static_cast<int>(pou.kind)];
    out += " " + access(pou.access);
    if (pou.isAbstract) out += "abstract ";
    if (pou.isFinal) out += "final ";
    if (pou.isOverride) out += "override ";
    out += text(pou.name.text);
    if (pou.result) out += ":" + outline(*pou.result);
    for (const Path& p : pou.extends) out += " extends " + path(p);
    for (const Path& p : pou.implements) out += " implements " + path(p);
    for (const VarSection* section : pou.sections) out += " " + outline(*section);
    out += body(pou.body);
    for (const Pou* method : pou.methods) out += " <" + unit(*method) + ">";
    for (const Property* property : pou.properties) {
        out += " <PROPERTY " + access(property->access) + text(property->name.text) +
               (property->type ? ":" + outline(*property->type) : "");
        if (property->get) out += " " + unit(*property->get);
        if (property->set) out += " " + unit(*property->set);
        out += ">";
    }
    for (const ActionDecl* action : pou.actions)
        out += " <ACTION " + text(action->name.text) + body(action->body) + ">";
    return out;
}

} // namespace

std::string outline(const Expr* e) {
    if (!e) return "null";
    switch (e->kind) {
    case ExprKind::Error:
        return "error";
    case ExprKind::Literal:
        return (e->prefix.isValid() ? text(e->prefix.text) + "#" : "") + text(e->text);
    case ExprKind::TypedName:
        return text(e->prefix.text) + "#" + text(e->name.text);
    case ExprKind::NameRef:
        return text(e->name.text);
    case ExprKind::Address:
        return text(e->text);
    case ExprKind::Member:
        return outline(e->base) + "." + text(e->name.text);
    case ExprKind::Bit:
        return outline(e->base) + ".:" + text(e->text);
    case ExprKind::Index:
        return outline(e->base) + "[" + arguments(e->arguments) + "]";
    case ExprKind::Deref:
        return outline(e->base) + "^";
    case ExprKind::Call:
        return outline(e->base) + "(" + arguments(e->arguments) + ")";
    case ExprKind::Unary:
        return "(" + text(lex::spelling(e->op)) + " " + outline(e->base) + ")";
    case ExprKind::Binary:
        return "(" + outline(e->base) + " " + text(lex::spelling(e->op)) + " " + outline(e->right) + ")";
    case ExprKind::AssignChain:
        return "(" + outline(e->base) + " " + text(lex::spelling(e->op)) + " " + outline(e->right) + ")";
    case ExprKind::ArrayInit:
        return "[" + arguments(e->arguments) + "]";
    case ExprKind::StructInit:
        return "{" + arguments(e->arguments) + "}";
    case ExprKind::Repeat:
        return outline(e->base) + "*(" + arguments(e->arguments) + ")";
    case ExprKind::This:
        return "THIS";
    case ExprKind::Super:
        return "SUPER";
    }
    return "?";
}

std::string outline(const TypeSpec& spec) {
    const auto bounds = [&] {
        std::string out;
        for (const Bounds& b : spec.bounds)
            out += (out.empty() ? "" : ", ") + (b.low ? outline(b.low) + ".." + outline(b.high) : "*");
        return out;
    };
    switch (spec.kind) {
    case TypeSpecKind::Error:
        return "error";
    case TypeSpecKind::Named:
        return path(spec.path) + (spec.constructor.empty() ? "" : "(" + arguments(spec.constructor) + ")");
    case TypeSpecKind::String:
        return path(spec.path) + (spec.length ? "(" + outline(spec.length) + ")" : "");
    case TypeSpecKind::Array:
    case TypeSpecKind::OpenArray:
        return "array[" + bounds() + "] " + outline(*spec.element);
    case TypeSpecKind::Pointer:
        return "pointer " + outline(*spec.element);
    case TypeSpecKind::RefTo:
        return "ref_to " + outline(*spec.element);
    case TypeSpecKind::Reference:
        return "reference " + outline(*spec.element);
    case TypeSpecKind::Enum: {
        std::string out = "enum(";
        for (const EnumeratorDecl& e : spec.enumerators)
            out +=
                (&e == &spec.enumerators[0] ? "" : ",") + text(e.name.text) + (e.value ? "=" + outline(e.value) : "");
        return out + ")" + (spec.element ? outline(*spec.element) : "");
    }
    case TypeSpecKind::Struct:
    case TypeSpecKind::Union: {
        std::string out = spec.kind == TypeSpecKind::Struct ? "struct" : "union";
        if (spec.extends) out += " extends " + outline(*spec.extends);
        out += "{";
        for (const VarDecl* field : spec.fields) out += (field == spec.fields[0] ? "" : "; ") + variable(*field);
        return out + "}";
    }
    case TypeSpecKind::Subrange:
        return path(spec.path) + "(" + bounds() + ")";
    case TypeSpecKind::Inferred:
        return "inferred " + outline(spec.inferredFrom);
    }
    return "?";
}

std::string outline(const VarSection& section) {
    static const char* words[] = {"VAR",  "IN",     "OUT",      "IN_OUT", "TEMP",  "STAT",
                                  "INST", "GLOBAL", "EXTERNAL", "ACCESS", "CONFIG"};
    std::string out = words[static_cast<int>(section.kind)];
    if (section.constant) out += " constant";
    if (section.retain) out += " retain";
    if (section.persistent) out += " persistent";
    out += "(";
    for (const VarDecl* decl : section.declarations)
        out += (decl == section.declarations[0] ? "" : "; ") + variable(*decl);
    return out + ")";
}

std::string outline(const Block& block) {
    std::string out;
    for (const Stmt* s : block) out += (out.empty() ? "" : "; ") + statement(*s);
    return out;
}

std::string outline(const SfcBody& chart) {
    std::string out;
    for (const StepDecl* step : chart.steps) {
        out += (step->isInitial ? "initial " : "step ") + text(step->name.text);
        for (const ActionAssociation& a : step->actions) {
            out += " " + text(a.action.text) + "(" + text(a.qualifier.text) + (a.time ? "," + outline(a.time) : "") +
                   (a.indicators.empty() ? "" : "," + names(a.indicators)) + ")";
        }
        for (const Pragma& p : step->pragmas) out += " {" + text(p.key) + "=" + text(p.value) + "}";
        out += "; ";
    }
    for (const TransitionDecl* t : chart.transitions) {
        out += "from " + names(t->from) + " to " + names(t->to) + (t->priority ? " prio " + outline(t->priority) : "") +
               " when " + (t->condition ? outline(t->condition) : "IL " + outline(t->ilCondition)) + "; ";
    }
    for (const ActionDecl* a : chart.actions) out += "action " + text(a->name.text) + body(a->body) + "; ";
    if (!out.empty()) out.resize(out.size() - 2);
    return out;
}

std::string outline(const Decl& decl) {
    switch (decl.kind) {
    case DeclKind::Pou:
        return unit(*decl.pou);
    case DeclKind::Type:
        return "TYPE " + access(decl.type->access) + text(decl.type->name.text) + ":" + outline(*decl.type->spec) +
               (decl.type->initial ? "=" + outline(decl.type->initial) : "");
    case DeclKind::Globals:
        return "GVL " + text(decl.globals->name) + " " + outline(*decl.globals->section);
    case DeclKind::Configuration: {
        const ConfigurationDecl& c = *decl.configuration;
        std::string out = "CONFIGURATION " + text(c.name.text);
        for (const VarSection* s : c.sections) out += " " + outline(*s);
        for (const ResourceDecl* r : c.resources) {
            out += " RESOURCE(" + text(r->name.text) + " on " + text(r->on.text);
            for (const VarSection* s : r->sections) out += " " + outline(*s);
            for (const TaskDecl* t : r->tasks) {
                out += " TASK " + text(t->name.text);
                if (t->interval) out += " every " + outline(t->interval);
                if (t->single) out += " at " + outline(t->single);
                if (t->priority) out += " prio " + outline(t->priority);
                out += arguments(t->others);
            }
            for (const ProgramInstance* p : r->programs) {
                out += " PROGRAM " + text(p->name.text) + (p->task.isValid() ? " with " + text(p->task.text) : "") +
                       ":" + path(p->type) + "(" + arguments(p->connections) + ")";
                for (const Argument& a : p->blockTasks) out += " " + text(a.name.text) + " with " + outline(a.value);
            }
            out += ")";
        }
        return out;
    }
    case DeclKind::Test: {
        std::string out = "TEST " + text(decl.test->title);
        for (const VarSection* s : decl.test->sections) out += " " + outline(*s);
        return out + " {" + outline(decl.test->body) + "}";
    }
    case DeclKind::Namespace: {
        std::string out = "NAMESPACE " + path(decl.space->path) + " {";
        for (const Decl* d : decl.space->declarations)
            out += (d == decl.space->declarations[0] ? "" : " | ") + outline(*d);
        return out + "}";
    }
    case DeclKind::Using: {
        std::string out = "USING";
        for (const Path& p : decl.usings) out += " " + path(p);
        return out;
    }
    }
    return "?";
}

std::string outline(const SyntaxFile& file) {
    std::string out;
    for (const Decl* decl : file.declarations) out += (out.empty() ? "" : " | ") + outline(*decl);
    return out;
}

Parsed::Parsed(std::string source) {
    const FileId id = sources.add("test.st", std::move(source));
    diagnostics::Sink sink;
    file = parseFile(id, sources[id].text(), sink);
    sink.sort();
    diagnostics = sink.take();
}

std::string Parsed::codes() const {
    std::string out;
    for (const auto& d : diagnostics) {
        const LineColumn at = sources[d.range.file].lineColumn(d.range.begin);
        out += (out.empty() ? "" : " ") + std::string(diagnostics::codeOf(d.kind)) + "@" + std::to_string(at.line) +
               ":" + std::to_string(at.column);
    }
    return out;
}

size_t Parsed::errors() const {
    size_t count = 0;
    for (const auto& d : diagnostics) count += d.severity == diagnostics::Severity::Error;
    return count;
}

std::string expressionOutline(std::string source) {
    SourceSet sources;
    const FileId id = sources.add("expression", std::move(source));
    SyntaxFile file;
    file.file = id;
    diagnostics::Sink sink;
    const Expr* e = parseExpression(file, sources[id].text(), sink);
    return outline(e) + (sink.hasErrors() ? " !" : "");
}

std::string statementsOutline(const std::string& source) {
    const Parsed parsed("PROGRAM p\n" + source + "\nEND_PROGRAM\n");
    std::string out = outline(parsed.file->declarations.at(0)->pou->body.statements);
    if (parsed.errors() != 0) out += " ! " + parsed.codes();
    return out;
}

} // namespace plc::parse::testing
