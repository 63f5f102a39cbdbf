#include "runtime/compiler/lower/instruction_list.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace plc::lower {

using syntax::ArgumentKind;
using syntax::IlInstruction;

namespace {

enum class Op : uint8_t { None, Load, Store, Set, Reset, Not, Binary, Jump, Call, Return, Function, Input };

struct BinaryOp {
    std::string_view name;
    TokenKind op;
};
constexpr std::array<BinaryOp, 15> kBinary = {{
    {"AND", TokenKind::And},
    {"&", TokenKind::And},
    {"OR", TokenKind::Or},
    {"XOR", TokenKind::Xor},
    {"ADD", TokenKind::Plus},
    {"SUB", TokenKind::Minus},
    {"MUL", TokenKind::Star},
    {"DIV", TokenKind::Slash},
    {"MOD", TokenKind::Mod},
    {"GT", TokenKind::Greater},
    {"GE", TokenKind::GreaterEqual},
    {"EQ", TokenKind::Equal},
    {"NE", TokenKind::NotEqual},
    {"LE", TokenKind::LessEqual},
    {"LT", TokenKind::Less},
}};

/// Input operators of the standard blocks (table 53).
constexpr std::array<std::string_view, 10> kInputs = {"S1", "R1", "S", "R", "CLK", "CU", "CD", "PV", "IN", "PT"};
constexpr std::array<std::string_view, 12> kBlocks = {"SR",   "RS", "R_TRIG", "F_TRIG", "CTU",  "CTD",
                                                      "CTUD", "TP", "TON",    "TOF",    "SEMA", "RTC"};

bool isWord(std::string_view a, std::string_view b) { return a.size() == b.size() && equalsIgnoringCase(a, b); }

class Lowering {
public:
    explicit Lowering(const ListContext& context)
        : m_builder(context.builder), m_section(context.section), m_counter(context.counter), m_sink(context.sink),
          m_keep(context.keep), m_functionName(context.functionName) {
        const std::vector<std::string>& blockTypes = context.blockTypes;
        for (const syntax::VarSection* s : context.sections)
            for (const syntax::VarDecl* decl : s->declarations)
                for (const Name& name : decl->names) {
                    std::string type = decl->type && !decl->type->path.empty() ? foldCase(decl->type->path.back().text)
                                                                               : std::string();
                    const bool block =
                        std::any_of(kBlocks.begin(), kBlocks.end(),
                                    [&](std::string_view b) {
                                        return foldCase(b) == type || type.starts_with(foldCase(b) + "_");
                                    }) ||
                        std::find(blockTypes.begin(), blockTypes.end(), type) != blockTypes.end();
                    m_variables[foldCase(name.text)] = block;
                }
    }

    LoweredList run(const Block& instructions, bool wantsResult) {
        index(instructions);
        const bool isFunction = m_functionName.isValid() && !stores(instructions);
        findLiveness(instructions, wantsResult || isFunction);
        declareLabels(instructions);
        Expr* result = lower(instructions, nullptr, true);
        if (wantsResult && !result && m_reported == 0)
            report(instructions.empty() ? SourceRange{} : instructions.back()->range, "END_TRANSITION");
        if (isFunction && result && !instructions.empty())
            emit(m_builder.assign(m_builder.nameRef(m_functionName), result, instructions.back()->range,
                                  instructions.back()));
        return {std::move(m_out), result};
    }

private:
    /// An instruction stores under the function's name.
    [[nodiscard]] bool stores(const Block& instructions) const {
        return std::any_of(instructions.begin(), instructions.end(), [&](const Stmt* s) {
            const IlInstruction& il = *s->il;
            return stores(il.body) || (il.operand && il.operand->kind == ExprKind::NameRef &&
                                       isWord(il.operand->name.text, m_functionName.text) && kindOf(il) != Op::Load &&
                                       kindOf(il) != Op::Call);
        });
    }

    Op kindOf(const IlInstruction& il) const {
        const std::string_view op = il.op.text;
        if (op.empty()) return Op::None;
        const bool onBlock = il.operand && il.operand->kind == ExprKind::NameRef && isBlock(il.operand->name.text);
        if (onBlock && std::any_of(kInputs.begin(), kInputs.end(), [&](std::string_view i) { return isWord(op, i); }))
            return Op::Input;
        if (isWord(op, "LD")) return Op::Load;
        if (isWord(op, "ST")) return Op::Store;
        if (isWord(op, "S")) return Op::Set;
        if (isWord(op, "R")) return Op::Reset;
        if (isWord(op, "NOT")) return Op::Not;
        if (isWord(op, "JMP")) return Op::Jump;
        if (isWord(op, "CAL")) return Op::Call;
        if (isWord(op, "RET")) return Op::Return;
        if (binaryOf(op) != TokenKind::Error) return Op::Binary;
        // an input of a block of the user
        if (onBlock && il.arguments.empty()) return Op::Input;
        return Op::Function;
    }
    static TokenKind binaryOf(std::string_view op) {
        for (const BinaryOp& row : kBinary)
            if (isWord(op, row.name)) return row.op;
        return TokenKind::Error;
    }
    bool isBlock(std::string_view name) const {
        const auto it = m_variables.find(foldCase(name));
        return it != m_variables.end() && it->second;
    }
    /// CAL of what is no variable of the unit: a function, whose value becomes the current result.
    bool isFunctionCall(const IlInstruction& il) const {
        return kindOf(il) == Op::Call && il.operand && il.operand->kind == ExprKind::NameRef &&
               !m_variables.contains(foldCase(il.operand->name.text));
    }
    static bool hasNames(const std::vector<Argument>& arguments) {
        return std::any_of(arguments.begin(), arguments.end(),
                           [](const Argument& a) { return a.kind != ArgumentKind::Positional; });
    }
    /// A function with its whole list in parentheses does not take the current result.
    static bool isWholeCall(const IlInstruction& il) { return !il.operand && !il.arguments.empty(); }

    // ------------------------------------------------------------ liveness of the current result

    void index(const Block& instructions) {
        for (size_t i = 0; i < instructions.size(); ++i) {
            const IlInstruction& il = *instructions[i]->il;
            if (!il.label.isValid()) continue;
            if (!m_labels.emplace(foldCase(il.label.text), i).second)
                m_sink.emit(il.label.range, findings::DuplicateName(il.label.text));
        }
    }
    bool uses(const IlInstruction& il) const {
        switch (kindOf(il)) {
        case Op::None:
        case Op::Load:
            return false;
        case Op::Jump:
        case Op::Call:
        case Op::Return:
            return il.conditional;
        case Op::Function:
            return !isWholeCall(il);
        case Op::Store:
        case Op::Set:
        case Op::Reset:
        case Op::Not:
        case Op::Binary:
        case Op::Input:
            return true;
        }
        return true;
    }
    bool defines(const IlInstruction& il) const {
        const Op op = kindOf(il);
        return op == Op::Load || op == Op::Not || op == Op::Binary || op == Op::Function ||
               (isFunctionCall(il) && !il.conditional);
    }
    void findLiveness(const Block& instructions, bool wantsResult) {
        const size_t n = instructions.size();
        m_liveIn.assign(n + 1, false);
        m_liveIn[n] = wantsResult;
        m_liveOut.assign(n, false);
        // Backward until nothing changes: a jump back makes a result live in instructions that were done already.
        for (bool changed = true; changed;) {
            changed = false;
            for (size_t i = n; i-- > 0;) {
                const IlInstruction& il = *instructions[i]->il;
                const Op op = kindOf(il);
                bool out = false;
                const bool ends = (op == Op::Jump || op == Op::Return) && !il.conditional;
                if (!ends) out = m_liveIn[i + 1];
                if (op == Op::Jump) {
                    const auto target = targetOf(il);
                    if (target != m_labels.end()) out = out || m_liveIn[target->second];
                }
                const bool in = uses(il) || (out && !defines(il));
                changed |= in != m_liveIn[i] || out != m_liveOut[i];
                m_liveIn[i] = in;
                m_liveOut[i] = out;
            }
        }
    }
    std::map<std::string, size_t>::const_iterator targetOf(const IlInstruction& il) const {
        return il.operand && il.operand->kind == ExprKind::NameRef ? m_labels.find(foldCase(il.operand->name.text))
                                                                   : m_labels.end();
    }
    void declareLabels(const Block& instructions) {
        for (const auto& [label, at] : m_labels)
            if (m_liveIn[at])
                m_labelVariables[label] = {m_builder.name("__at_" + std::string(instructions[at]->il->label.text) +
                                                              "_" + std::to_string(m_counter++),
                                                          instructions[at]->il->label.range),
                                           nullptr};
    }

    // ------------------------------------------------------------ the statements

    void report(SourceRange range, std::string_view op) {
        ++m_reported;
        m_sink.emit(range, findings::IlNoAccumulator(op));
    }
    void emit(Stmt* stmt) { m_out.push_back(stmt); }

    static bool isSimple(const Expr* e) {
        return e->kind == ExprKind::Literal || e->kind == ExprKind::TypedName ||
               (e->kind == ExprKind::NameRef && e->name.text.starts_with("__"));
    }
    static bool isConstant(const Expr* e) {
        if (e->kind == ExprKind::Literal || e->kind == ExprKind::TypedName) return true;
        if (e->kind == ExprKind::Unary) return isConstant(e->base);
        if (e->kind == ExprKind::Binary) return isConstant(e->base) && isConstant(e->right);
        return false;
    }
    /// Keeps the current result in a variable, so that it can be used again whatever happens to its operands.
    Expr* capture(Expr* value, Stmt* origin) {
        if (isSimple(value) || isConstant(value)) return value;
        const Name variable = m_builder.name("__il" + std::to_string(m_counter++), origin->range);
        m_builder.declare(m_section, variable, {}, m_builder.clone(value));
        emit(m_builder.assign(m_builder.nameRef(variable), value, origin->range, origin));
        return m_builder.nameRef(variable);
    }
    void storeAtLabel(const std::string& label, Expr* value, Stmt* origin) {
        const auto it = m_labelVariables.find(label);
        if (it == m_labelVariables.end() || !value) return;
        LabelVariable& variable = it->second;
        if (!variable.declared)
            variable.declared = m_builder.declare(m_section, variable.name, {}, m_builder.clone(value));
        // a literal has no type of its own: the first other value gives it
        else if (isConstant(variable.declared->type->inferredFrom) && !isConstant(value))
            variable.declared->type->inferredFrom = m_builder.clone(value);
        emit(m_builder.assign(m_builder.nameRef(variable.name), m_builder.clone(value), origin->range, origin));
    }

    Expr* lower(const Block& instructions, Expr* acc, bool outermost) {
        for (size_t i = 0; i < instructions.size(); ++i) {
            Stmt* origin = instructions[i];
            const IlInstruction& il = *origin->il;
            const bool live = outermost ? m_liveOut[i] : true;
            if (il.label.isValid()) {
                if (!outermost) {
                    m_sink.emit(il.label.range, findings::NotAllowedHere(phrases::ALabel(), phrases::InAParenthesis()));
                } else {
                    const std::string label = foldCase(il.label.text);
                    storeAtLabel(label, acc, origin);
                    Stmt* stmt = m_builder.statement(StmtKind::Label, il.label.range, origin);
                    stmt->name = il.label;
                    emit(stmt);
                    const auto variable = m_labelVariables.find(label);
                    acc = variable == m_labelVariables.end()
                              ? nullptr
                              : m_builder.nameRef({variable->second.name.text, il.label.range});
                }
            }
            acc = instruction(il, acc, origin, live, outermost);
            // For online values: what a line leaves must be somewhere in the image, also when the next line uses it up.
            if (acc && m_keep == Keep::Every && defines(il)) acc = capture(acc, origin);
            origin->il->result = acc && (isSimple(acc) || isConstant(acc)) ? m_builder.clone(acc) : nullptr;
        }
        return acc;
    }

    Expr* instruction(const IlInstruction& il, Expr* acc, Stmt* origin, bool live, bool outermost) {
        const Op op = kindOf(il);
        const SourceRange range = origin->range;
        const bool isFirstCall = op == Op::Function && !acc && (il.operand || il.arguments.empty());
        if (uses(il) && !acc && !isFirstCall) {
            if (il.op.isValid()) report(il.op.range, il.op.text);
            // Reported; an expression that is no value keeps the rest of the list from reporting the same.
            acc = m_builder.make<Expr>();
            acc->range = range;
        }
        const auto negated = [&](Expr* e) { return il.negate ? m_builder.unary(TokenKind::Not, e, range) : e; };
        const auto operand = [&]() -> Expr* {
            if (il.operand) return m_builder.clone(il.operand);
            m_sink.emit(il.op.range, findings::Expected(phrases::AnOperand(), phrases::TheEndOfTheLine()));
            Expr* e = m_builder.make<Expr>();
            e->range = range;
            return e;
        };
        switch (op) {
        case Op::None:
            return acc;
        case Op::Load:
            return negated(operand());
        case Op::Not:
            return il.operand ? m_builder.unary(TokenKind::Not, operand(), range)
                              : m_builder.unary(TokenKind::Not, acc, range);
        case Op::Store: {
            if (live) acc = capture(acc, origin);
            emit(m_builder.assign(operand(), negated(live ? m_builder.clone(acc) : acc), range, origin));
            return acc;
        }
        case Op::Set:
        case Op::Reset:
            if (live) acc = capture(acc, origin);
            emit(m_builder.assign(operand(), live ? m_builder.clone(acc) : acc, range, origin,
                                  op == Op::Set ? TokenKind::SetAssign : TokenKind::ResetAssign));
            return acc;
        case Op::Binary:
            return binary(il, acc, origin);
        case Op::Jump:
            return jump(il, acc, origin, live, outermost);
        case Op::Return: {
            Stmt* stmt = m_builder.statement(StmtKind::Return, range, origin);
            if (!il.conditional) {
                emit(stmt);
                return nullptr;
            }
            if (live) acc = capture(acc, origin);
            emit(m_builder.ifThen(negated(m_builder.clone(acc)), {stmt}, range, origin));
            return acc;
        }
        case Op::Call:
            return callBlock(il, acc, origin, live);
        case Op::Function:
            return function(il, acc, origin);
        case Op::Input: {
            if (live) acc = capture(acc, origin);
            Argument argument;
            argument.kind = ArgumentKind::Input;
            argument.name = il.op;
            argument.value = m_builder.clone(acc);
            argument.range = range;
            Stmt* stmt = m_builder.statement(StmtKind::Call, range, origin);
            stmt->value = m_builder.call(operand(), {argument}, range);
            emit(stmt);
            return acc;
        }
        }
        return acc;
    }

    Expr* binary(const IlInstruction& il, Expr* acc, Stmt* origin) {
        Expr* right = il.operand ? m_builder.clone(il.operand) : nullptr;
        if (il.opensParenthesis) {
            // what happens inside may change the operands of what stands before
            if (std::any_of(il.body.begin(), il.body.end(), [&](const Stmt* s) {
                    const Op o = kindOf(*s->il);
                    return o == Op::Store || o == Op::Set || o == Op::Reset || o == Op::Call || o == Op::Input;
                }))
                acc = capture(acc, origin);
            right = lower(il.body, right, false);
            if (!right) {
                report(il.op.range, il.op.text);
                return acc;
            }
        }
        if (!right) {
            m_sink.emit(il.op.range, findings::Expected(phrases::AnOperand(), phrases::TheEndOfTheLine()));
            return acc;
        }
        if (il.negate) right = m_builder.unary(TokenKind::Not, right, origin->range);
        Expr* e = m_builder.binary(binaryOf(il.op.text), acc, right, origin->range);
        e->operatorRange = il.op.range;
        return e->height > 400 ? capture(e, origin) : e;
    }

    Expr* jump(const IlInstruction& il, Expr* acc, Stmt* origin, bool live, bool outermost) {
        if (!outermost) {
            m_sink.emit(il.op.range, findings::NotAllowedHere(Verbatim("JMP"), phrases::InAParenthesis()));
            return acc;
        }
        const auto target = targetOf(il);
        if (target == m_labels.end()) {
            m_sink.emit(il.operand ? il.operand->range : il.op.range,
                        findings::UnknownLabel(il.operand && il.operand->kind == ExprKind::NameRef
                                                   ? il.operand->name.text
                                                   : std::string_view()));
            return il.conditional ? acc : nullptr;
        }
        if (il.conditional && live) acc = capture(acc, origin);
        storeAtLabel(target->first, acc, origin);
        Stmt* stmt = m_builder.statement(StmtKind::Jump, origin->range, origin);
        stmt->name = il.operand->name;
        if (il.conditional) {
            stmt->value = m_builder.clone(acc);
            if (il.negate) stmt->value = m_builder.unary(TokenKind::Not, stmt->value, origin->range);
        }
        emit(stmt);
        return il.conditional ? acc : nullptr;
    }

    std::vector<Argument> cloned(const std::vector<Argument>& arguments) {
        std::vector<Argument> out = arguments;
        for (Argument& argument : out) {
            argument.value =
                argument.instructions ? lower(*argument.instructions, nullptr, false) : m_builder.clone(argument.value);
            argument.instructions = nullptr;
        }
        return out;
    }

    Expr* callBlock(const IlInstruction& il, Expr* acc, Stmt* origin, bool live) {
        if (!il.operand) return acc;
        // instructions among the arguments come before the call
        if (acc && live &&
            std::any_of(il.arguments.begin(), il.arguments.end(), [](const Argument& a) { return a.instructions; }))
            acc = capture(acc, origin);
        Expr* call = m_builder.call(m_builder.clone(il.operand), cloned(il.arguments), origin->range);
        if (isFunctionCall(il) && !il.conditional && live) return call;
        Stmt* stmt = m_builder.statement(StmtKind::Call, origin->range, origin);
        stmt->value = call;
        if (acc && live) acc = capture(acc, origin);
        if (!il.conditional) {
            emit(stmt);
            return acc;
        }
        Expr* condition = m_builder.clone(acc);
        if (il.negate) condition = m_builder.unary(TokenKind::Not, condition, origin->range);
        emit(m_builder.ifThen(condition, {stmt}, origin->range, origin));
        return acc;
    }

    /// LIMIT b, c: the current result is the first argument; LIMIT(MN := …) stands for itself.
    Expr* function(const IlInstruction& il, Expr* acc, Stmt* origin) {
        std::vector<Argument> arguments;
        if (!isWholeCall(il)) {
            if (acc) arguments.push_back({.value = acc, .range = origin->range}); // none yet: the operands are all
            if (il.operand) arguments.push_back({.value = m_builder.clone(il.operand), .range = il.operand->range});
        }
        for (Argument& argument : cloned(il.arguments)) arguments.push_back(std::move(argument));
        Expr* call = m_builder.call(m_builder.nameRef(il.op), std::move(arguments), origin->range);
        return capture(call, origin); // called once, here
    }

    struct LabelVariable {
        Name name;
        syntax::VarDecl* declared = nullptr;
    };

    Builder& m_builder;
    syntax::VarSection& m_section;
    int& m_counter;
    diagnostics::Sink& m_sink;
    Keep m_keep;
    Name m_functionName;
    std::map<std::string, bool> m_variables; // of the unit; true: a block instance
    std::map<std::string, size_t> m_labels;
    std::map<std::string, LabelVariable> m_labelVariables;
    std::vector<bool> m_liveIn, m_liveOut;
    Block m_out;
    int m_reported = 0;
};

} // namespace

LoweredList lowerInstructions(const Block& instructions, const ListContext& context, bool wantsResult) {
    return Lowering(context).run(instructions, wantsResult);
}

} // namespace plc::lower
