// Checks expressions and statements of one scope and makes their tree. Short-lived: one for a body, a constant, an
// initial value or a watch expression. Uses the World it belongs to; one thread (a frozen World may serve several
// checkers at once).
#pragma once
#include "runtime/compiler/sema/world.h"

namespace plc::sema {

[[nodiscard]] std::optional<TypeKind> elementaryNamed(std::string_view name);
[[nodiscard]] bool isFoldable(const types::TypeTable& types, TypeId type);

/// The value of an expression. `isFlexible`: made of literals without a type, so it takes the type of its surroundings.
struct Operand {
    tree::Expr* expr = nullptr;
    const types::TypeTable* types = nullptr;
    bool isFlexible = false;
    bool isDivided = false; // flexible result of an integer division
    [[nodiscard]] TypeId type() const { return expr->type; }
    [[nodiscard]] bool isUnknown() const { return !expr || types->kind(expr->type) == TypeKind::Unknown; }
    [[nodiscard]] bool isConstant() const {
        return expr && expr->kind == tree::ExprKind::Constant && expr->value.hasValue();
    }
};

enum class Access : uint8_t { Read, Write, ReadWrite, Address, Call };

/// What a name, member or other postfix expression stands for.
struct Denoted {
    enum class Kind : uint8_t { Nothing, Place, Value, Unit, Property, Type, List, Space, Standard };
    Kind kind = Kind::Nothing; // Nothing: reported already
    tree::Place* place = nullptr;
    Operand value;
    Unit* unit = nullptr;            // function, method, action, program, block type
    tree::Place* instance = nullptr; // of a method, action or property
    tree::Expr* interface = nullptr;
    bool isSuper = false; // direct call, no dispatch
    bool isExact = false; // the instance's type is known exactly
    Property* property = nullptr;
    DeclaredType* declaredType = nullptr;
    TypeId type;
    GlobalsList* list = nullptr;
    Space* space = nullptr;
    std::string_view name;        // Standard
    Variable* variable = nullptr; // the variable a place begins with
    bool isReadOnly = false;
    messages::Thing whyReadOnly = std::string();
};
[[nodiscard]] inline Denoted placeOf(tree::Place* place) {
    Denoted out;
    out.kind = Denoted::Kind::Place;
    out.place = place;
    return out;
}
[[nodiscard]] inline Denoted valueOf(Operand value) {
    Denoted out;
    out.kind = Denoted::Kind::Value;
    out.value = value;
    return out;
}

class Checker {
public:
    Checker(World& world, Scope scope, diagnostics::Sink& sink, Arena& arena);

    // expressions.cpp
    Operand durationExpression(const syntax::Expr& e);
    Operand anyExpression(const syntax::Expr& e, TypeId hint);
    Operand expression(const syntax::Expr& e, TypeId hint = {});
    Operand value(Denoted denoted, const syntax::Expr& e, TypeId hint);
    Operand load(tree::Place* place, SourceRange range);
    Operand unknown(SourceRange range);
    Operand constant(types::Value value, SourceRange range, bool isFlexible = false);
    Operand settled(Operand operand, TypeId hint = {}); // a flexible value gets its own type
    tree::Expr* condition(const syntax::Expr& e);
    Operand aggregate(const syntax::Expr& e, TypeId hint);

    // literals.cpp
    Operand literal(const syntax::Expr& e, TypeId hint);
    Operand typedName(const syntax::Expr& e);
    std::optional<Operand> quotedName(const syntax::Expr& e, TypeId hint);
    Operand enumerator(const EnumeratorRef& ref, SourceRange range);

    // names.cpp
    Denoted denote(const syntax::Expr& e, Access access, TypeId hint = {});
    tree::Place* place(const syntax::Expr& e, Access access); // null: reported
    Denoted denoteName(const syntax::Expr& e, Access access, TypeId hint);
    Denoted denoteMember(const syntax::Expr& e, Access access, TypeId hint);
    Denoted denoteIndex(const syntax::Expr& e, Access access);
    Denoted denoteBit(const syntax::Expr& e, Access access);
    Denoted denoteDeref(const syntax::Expr& e, Access access);
    Denoted denoteAddress(const syntax::Expr& e);
    Denoted found(const World::Found& found, const syntax::Name& name, Access access, TypeId hint);
    Denoted ofVariable(Variable& variable, tree::Place* instance, SourceRange range, Access access);
    bool hasMembers(Variable& variable, std::string_view name);
    Denoted memberOf(tree::Place* base, Denoted from, const syntax::Name& name, SourceRange range, Access access);
    tree::Place* thisPlace(SourceRange range);
    tree::Place* fieldPlace(tree::Place* base, uint32_t offset, TypeId type, int16_t bit, SourceRange range);
    tree::Place* absolutePlace(uint32_t offset, TypeId type, int16_t bit, SourceRange range);
    tree::Place* localPlace(uint32_t local, TypeId type, SourceRange range);
    tree::Place* dereferenced(tree::Place* reference, SourceRange range);
    tree::Place* temporary(const Operand& operand);
    uint32_t newLocal(std::string name, TypeId type, bool isInOut = false);
    uint32_t temporaryOf(Variable& variable);
    void takeAddress(tree::Place* place);
    [[nodiscard]] bool hasAddress(const tree::Place* place) const;
    [[nodiscard]] static tree::Place* rootOf(tree::Place* place);

    // operators.cpp
    Operand unary(const syntax::Expr& e, TypeId hint);
    Operand binary(const syntax::Expr& e, TypeId hint);
    Operand combine(library::BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                    SourceRange operatorRange, TypeId hint);
    Operand compare(library::BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                    SourceRange operatorRange);
    Operand arithmeticOnTimes(library::BinaryOp op, std::string_view spelling, Operand a, Operand b, SourceRange range,
                              SourceRange operatorRange);
    Operand negated(Operand operand, SourceRange range);
    Operand inverted(Operand operand, SourceRange range);
    Operand makeBinary(library::BinaryOp op, TypeId operandType, Operand a, Operand b, SourceRange range);
    Operand foldFlexible(library::BinaryOp op, Operand a, Operand b, SourceRange range);
    Operand logical(const syntax::Expr& e, TypeId hint);
    Operand intrinsic(library::Intrinsic code, TypeId result, std::vector<Operand> operands, SourceRange range,
                      int64_t selector = -1);

    // conversions.cpp
    /// Implicit conversion with its diagnostics, at the operand's own range.
    Operand converted(Operand operand, TypeId to);
    std::optional<Operand> convertedConstant(Operand& operand, TypeId to);
    std::optional<Operand> convertedCharacter(const Operand& operand, TypeId to);
    std::optional<Operand> convertedObject(const Operand& operand, TypeId to);
    Operand convertedByType(const Operand& operand, TypeId to);
    bool tellEarlyOperation(const Operand& operand, TypeId to);
    bool tellNarrowing(const Operand& operand, TypeId to);
    Operand convertNode(Operand operand, TypeId to); // written conversion, no questions
    Operand sameBits(Operand operand, TypeId to);
    [[nodiscard]] TypeId commonType(const Operand& a, const Operand& b) const; // none: they do not combine
    [[nodiscard]] TypeId smallestType(const Operand& flexible) const;
    [[nodiscard]] bool fits(const types::Value& value, TypeId type) const;
    void mismatch(SourceRange range, TypeId from, TypeId to);
    void strictMismatch(SourceRange range, std::string what, TypeId to);
    bool isStrict(const Operand& operand); // reports a calculation with a strict enumeration
    Operand convertedText(Operand operand, TypeId to);

    // calls.cpp
    Operand call(const syntax::Expr& e, TypeId hint);
    struct Match {
        const syntax::Argument* argument = nullptr;
        Variable* parameter = nullptr;
    };
    struct Matched {
        std::vector<Match> matches; // by parameter, in order of the parameters; argument null: omitted
        const syntax::Argument* en = nullptr;
        const syntax::Argument* eno = nullptr;
        bool isFormal = false;
        bool isGood = true;
    };
    Matched match(const syntax::Expr& call, const std::string& name, const std::vector<Variable*>& parameters);
    Operand callUnit(const Denoted& callee, const syntax::Expr& e);
    Operand withEnable(Operand value, const Matched& matched, SourceRange range);
    bool addArgument(tree::Call& call, Variable& parameter, const syntax::Argument* argument, const std::string& callee,
                     SourceRange at, bool isFormal);
    tree::Place* inOutTarget(Variable& parameter, const syntax::Argument& argument, std::vector<tree::Stmt*>& before,
                             std::vector<tree::Stmt*>& after);
    tree::Expr* defaultOf(Variable& parameter);
    void prepareCall(tree::Call& call, const Denoted& callee, SourceRange range);
    Operand propertyValue(const Denoted& denoted, SourceRange range);
    void recordCall(tree::FunctionId to, bool isDispatched, SourceRange range);
    bool checkAccess(syntax::Access access, const Unit* owner, const std::string& name, SourceRange range);

    // call_statements.cpp
    void callStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void instanceCall(tree::Place* instance, Unit& unit, const syntax::Expr& e, const Denoted& callee,
                      std::vector<tree::Stmt*>& out, SourceRange range);

    // standard_calls.cpp
    Operand standardCall(std::string_view name, const syntax::Expr& e, TypeId hint);
    Operand signatureCall(const library::Signature& signature, const syntax::Expr& e, TypeId hint);
    Operand operatorCall(const library::Signature& signature, std::vector<Operand> operands, const syntax::Expr& e,
                         TypeId hint);
    bool suitsConversion(const Operand& literal, TypeId from) const;
    Operand conversionCall(const library::Conversion& conversion, std::string_view name, const syntax::Expr& e,
                           TypeId hint);
    Operand specialCall(const library::Signature& signature, const syntax::Expr& e, TypeId hint);
    struct StandardArguments {
        std::vector<const syntax::Argument*> inputs;
        const syntax::Argument* en = nullptr;
        const syntax::Argument* eno = nullptr;
        bool isGood = true;
    };
    StandardArguments standardArguments(const library::Signature& signature, const syntax::Expr& e);
    Operand withEnable(Operand value, const StandardArguments& arguments, SourceRange range);
    Operand makeCommon(std::vector<Operand>& operands, size_t first, const library::Signature& signature, TypeId hint);
    bool accepts(const library::Parameter& parameter, const Operand& operand, std::string_view function);

    // special_calls.cpp
    Operand boundCall(const syntax::Expr& e, bool isUpper);
    Operand sizeCall(const syntax::Expr& e, TypeKind result);
    Operand addressCall(const syntax::Expr& e, bool isReference);
    Operand exptCall(Operand base, Operand exponent, SourceRange range, SourceRange operatorRange, TypeId hint);
    Operand queryCall(const syntax::Expr& e);
    Operand addressOf(tree::Place* place, TypeId pointer, SourceRange range);
    Operand isNull(Operand pointer, SourceRange range);

    // statements.cpp
    void statements(const syntax::Block& block, std::vector<tree::Stmt*>& out);
    void statement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    bool isAssociable(const syntax::Stmt& stmt);
    void testStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out); // tests.cpp
    void assignment(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void assignTo(const Denoted& target, Operand value, SourceRange range, std::vector<tree::Stmt*>& out,
                  bool isHidden = false);
    void assignReference(const Denoted& target, const syntax::Expr& value, SourceRange range,
                         std::vector<tree::Stmt*>& out);
    void assignAggregate(tree::Place* target, const syntax::Expr& value, SourceRange range,
                         std::vector<tree::Stmt*>& out);
    void bindReference(tree::Place* target, const syntax::Expr& value, SourceRange range,
                       std::vector<tree::Stmt*>& out);
    Denoted target(const syntax::Expr& e, TypeId* type = nullptr);
    void ifStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void refuseSelector(const syntax::Stmt& stmt, TypeId type);
    void caseStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void forStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void whileStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void repeatStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void returnStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void labelStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void jumpStatement(const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
    void declareLabels(const syntax::Block& block);
    tree::Stmt* newStmt(tree::StmtKind kind, SourceRange range);
    tree::Stmt* assignStmt(tree::Place* place, tree::Expr* value, SourceRange range);
    void noteResultSet(const Denoted& target);

    diagnostics::Diagnostic& emit(SourceRange range, diagnostics::Finding finding) {
        return sink.emit(range, std::move(finding));
    }
    [[nodiscard]] const std::string& nameOf(TypeId type) const { return types[type].name; }
    [[nodiscard]] std::string textOf(SourceRange range) const {
        if (isExpression && !range.file.isValid())
            return range.end <= expressionText.size() && range.begin <= range.end
                       ? std::string(expressionText.substr(range.begin, range.end - range.begin))
                       : std::string();
        return std::string(world.textOf(range));
    }
    [[nodiscard]] TypeId elementary(TypeKind kind) const { return types::TypeTable::of(kind); }
    [[nodiscard]] bool isKind(TypeId type, TypeKind kind) const { return types.kind(type) == kind; }
    [[nodiscard]] TypeId textType(size_t length, bool isWide);
    [[nodiscard]] bool isNumeric(TypeId type) const;
    void refer(SourceRange range, SymbolId symbol, Access access);

    World& world;
    types::TypeTable& types;
    Scope scope;
    diagnostics::Sink& sink;
    Arena& arena;
    tree::Function* function = nullptr; // null: constants and expressions
    tree::FunctionId functionId;
    bool isMuted = false;                 // no references, no counting
    bool isExpression = false;            // D7: no side effects; instance-relative places become absolute
    bool isTest = false;                  // the body of a TEST: sees and writes everything, as a watch does
    bool isInitialiser = false;           // places are allowed although there is no function yet
    std::optional<uint32_t> instanceBase; // of THIS, in an expression
    std::string_view expressionText;      // for messages about it

    // Flow of the body being checked.
    struct Flow {
        bool isReachable = true;
        bool isResultSet = false;
    };
    Flow flow;
    struct Loop {
        bool hasExit = false;
        bool resultSetAtExit = true;
        bool isLeft = false; // by RETURN or JMP
    };
    std::vector<Loop> loops;
    bool insideUnreachable = false; // said already
    std::vector<const Variable*> loopVariables;
    struct Label {
        tree::LabelId id;
        SourceRange range;
        bool isUsed = false;
        SymbolId symbol;
    };
    std::unordered_map<NameId, Label> labels;
    std::unordered_map<const Variable*, uint32_t> temporaries;
    std::vector<tree::Stmt*>* pending = nullptr; // statements an expression needs before it stands in the body
    bool returnsSet = true;                      // every RETURN so far had the result set
};

} // namespace plc::sema
