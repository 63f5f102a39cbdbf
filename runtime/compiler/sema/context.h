// Checks expressions and statements of one scope and makes their tree. Short-lived: one for a body, a constant, an
// initial value or a watch expression. Reads the World and adds to what is gathered; one thread (one World may serve
// several contexts at once, each with its own gathering).
#pragma once
#include "runtime/compiler/sema/world_builder.h"

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

struct Match {
    const syntax::Argument* argument = nullptr;
    Variable* parameter = nullptr;
};

struct Matched {
    std::vector<Match> matches; // one for each parameter, as written; then the omitted, their argument null
    const syntax::Argument* en = nullptr;
    const syntax::Argument* eno = nullptr;
    bool isFormal = false;
    bool isGood = true;
};

struct StandardArguments {
    std::vector<const syntax::Argument*> inputs;
    const syntax::Argument* en = nullptr;
    const syntax::Argument* eno = nullptr;
    bool isGood = true;
};

// Flow of the body being checked.
struct Flow {
    bool isReachable = true;
    bool isResultSet = false;
};

struct Loop {
    bool hasExit = false;
    bool resultSetAtExit = true;
    bool isLeft = false; // by RETURN or JMP
};

struct Label {
    tree::LabelId id;
    SourceRange range;
    bool isUsed = false;
    SymbolId symbol;
};

/// What every check works with. `builder` is there only while declarations are being completed; a body and a watch
/// expression have none, so that nothing they ask for can change what is declared.
struct Check {
    Check(WorldBuilder& theBuilder) : world(theBuilder), gathered(theBuilder), builder(&theBuilder) {}
    Check(const World& theWorld, Gathered& theGathered) : world(theWorld), gathered(theGathered) {}

    diagnostics::Diagnostic& emit(SourceRange range, diagnostics::Finding finding) const {
        return gathered.emit(range, std::move(finding));
    }

    const World& world;
    Gathered& gathered;
    WorldBuilder* builder = nullptr;
};

struct Context : Check {
    Context(const Check& check, Scope scope, diagnostics::Sink& sink, Arena& arena);

    diagnostics::Diagnostic& emit(SourceRange range, diagnostics::Finding finding) {
        return sink.emit(range, std::move(finding));
    }
    /// A name that no declaration has is no name.
    [[nodiscard]] NameId key(std::string_view spelling) const { return world.names.find(spelling); }
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

    Flow flow;
    std::vector<Loop> loops;
    bool insideUnreachable = false; // said already
    std::vector<const Variable*> loopVariables;
    std::map<std::string, Label> labels; // by folded name
    std::unordered_map<const Variable*, uint32_t> temporaries;
    std::vector<tree::Stmt*>* pending = nullptr; // statements an expression needs before it stands in the body
    bool returnsSet = true;                      // every RETURN so far had the result set
};

} // namespace plc::sema
