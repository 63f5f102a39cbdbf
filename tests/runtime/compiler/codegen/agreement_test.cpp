// Generated code against the evaluator: both tiers must give the bits that library::evaluate and types::convert give.
#include "tests/runtime/compiler/codegen/tree_builder.h"

#include "runtime/types/conversion.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace plc::test {

using image::FaultCode;
using library::Intrinsic;
using types::Family;
using types::Value;

namespace {

const TypeKind kNumbers[] = {TypeKind::Bool, TypeKind::Byte,  TypeKind::Word,  TypeKind::Dword, TypeKind::Lword,
                             TypeKind::Sint, TypeKind::Int,   TypeKind::Dint,  TypeKind::Lint,  TypeKind::Usint,
                             TypeKind::Uint, TypeKind::Udint, TypeKind::Ulint, TypeKind::Real,  TypeKind::Lreal};
const TypeKind kAll[] = {TypeKind::Bool, TypeKind::Byte,  TypeKind::Word,  TypeKind::Dword, TypeKind::Lword,
                         TypeKind::Sint, TypeKind::Int,   TypeKind::Dint,  TypeKind::Lint,  TypeKind::Usint,
                         TypeKind::Uint, TypeKind::Udint, TypeKind::Ulint, TypeKind::Real,  TypeKind::Lreal,
                         TypeKind::Time, TypeKind::Ltime, TypeKind::Date,  TypeKind::Ldate, TypeKind::Tod,
                         TypeKind::Ltod, TypeKind::Dt,    TypeKind::Ldt,   TypeKind::Char,  TypeKind::Wchar};

std::vector<Value> samples(TypeKind kind) {
    const TypeId type = of(kind);
    std::vector<Value> values;
    if (familyOf(kind) == Family::Real) {
        const double numbers[] = {0.0,
                                  -0.0,
                                  0.5,
                                  1.5,
                                  2.5,
                                  -0.5,
                                  -1.5,
                                  -2.5,
                                  1.0,
                                  -1.0,
                                  3.7,
                                  -3.7,
                                  127.5,
                                  255.5,
                                  32767.5,
                                  65535.5,
                                  2147483647.0,
                                  -2147483648.0,
                                  4294967296.0,
                                  9.3e18,
                                  -9.3e18,
                                  1.9e19,
                                  1e30,
                                  -1e30,
                                  16777217.0,
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN(),
                                  1e-40,
                                  0.1};
        for (const double n : numbers)
            values.push_back({type, kind == TypeKind::Real ? static_cast<double>(static_cast<float>(n)) : n});
        return values;
    }
    const int64_t numbers[] = {0,
                               1,
                               -1,
                               2,
                               7,
                               -7,
                               100,
                               127,
                               128,
                               -128,
                               255,
                               256,
                               32767,
                               -32768,
                               65535,
                               65536,
                               2147483647,
                               -2147483648ll,
                               4294967295ll,
                               86'399'999'999'999ll,
                               946'684'800'123'456'789ll,
                               INT64_MAX,
                               INT64_MIN,
                               0x1234567890abcdefll,
                               1'500'000,
                               -1'500'000};
    for (const int64_t n : numbers) {
        const int64_t wrapped = types::wrapInteger(kind, n);
        const Value value{type, kind == TypeKind::Bool ? int64_t(n != 0) : wrapped};
        if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
    }
    return values;
}

/// One compiled program that computes many expressions of loaded operands, checked against the evaluator.
class Comparison {
public:
    Expr* input(const Value& value) {
        const uint32_t at = t.global(value.type);
        m_inputs.push_back({at, value});
        return t.load(t.at(at, value.type));
    }
    void expect(Expr* computed, const Value& wanted, std::string what) {
        const uint32_t at = t.global(wanted.type);
        m_body.push_back(t.assign(t.at(at, wanted.type), computed));
        m_wanted.push_back({at, wanted, std::move(what)});
    }
    void check() {
        const uint32_t main = t.function("Main");
        uint32_t part = 0;
        for (size_t n = 0; n < m_body.size(); ++n) { // in parts: one body of thousands of statements is no test of time
            if (n % 100 == 0) {
                part = t.function("Part");
                t.add(main, t.statement(tree::StmtKind::Evaluate, t.call(part)));
            }
            t.add(part, m_body[n]);
        }
        for (const codegen::Tier tier : {codegen::Tier::Quick, codegen::Tier::Optimised}) {
            t.makeFresh();
            for (const auto& [at, value] : m_inputs) types::writeValue(t.types, value.type, value, {t.image() + at, 8});
            ASSERT_EQ(FaultCode::None, t.run(main, tier, false));
            int failures = 0;
            for (const auto& [at, value, what] : m_wanted) {
                std::byte bytes[16] = {};
                types::writeValue(t.types, value.type, value, bytes);
                const uint32_t size = t.types[value.type].size;
                if (std::memcmp(bytes, t.image() + at, size) == 0) continue;
                const Value seen = types::readValue(t.types, value.type, {t.image() + at, size});
                const bool bothNan =
                    std::holds_alternative<double>(seen.data) && std::isnan(seen.real()) && std::isnan(value.real());
                if (bothNan || ++failures > 20) continue;
                ADD_FAILURE() << (tier == codegen::Tier::Quick ? "quick " : "optimised ") << what << " gives "
                              << toText(t.types, seen) << ", the evaluator " << toText(t.types, value);
            }
        }
    }
    [[nodiscard]] std::string text(const Value& value) const {
        return t.types[value.type].name + " " + toText(t.types, value);
    }
    Bench t;

private:
    struct Wanted {
        uint32_t at;
        Value value;
        std::string what;
    };
    std::vector<std::pair<uint32_t, Value>> m_inputs;
    std::vector<Wanted> m_wanted;
    std::vector<Stmt*> m_body;
};

bool isInteger(TypeKind kind) { return types::isInteger(types::familyOf(kind)); }

/// Any bits of the type, often with a small exponent or few digits: what programs compute with.
class RandomValues {
public:
    explicit RandomValues(unsigned seed) : m_dice(seed) {}

    Value of(TypeKind kind) {
        const TypeId type = test::of(kind);
        const uint64_t bits = m_dice();
        if (familyOf(kind) != Family::Real) {
            const auto number = static_cast<int64_t>(bits >> (m_dice() % 64));
            const int64_t value = types::wrapInteger(kind, m_dice() % 2 ? number : -number);
            return {type, kind == TypeKind::Bool ? int64_t(value != 0) : value};
        }
        double number = 0;
        if (m_dice() % 4 == 0)
            std::memcpy(&number, &bits, sizeof number);
        else
            number = std::ldexp(static_cast<double>(static_cast<int64_t>(bits)), -58 - static_cast<int>(m_dice() % 8));
        return {type, kind == TypeKind::Real ? static_cast<double>(static_cast<float>(number)) : number};
    }

private:
    std::mt19937_64 m_dice;
};

std::string_view nameOf(Intrinsic intrinsic) {
    switch (intrinsic) {
#define PLC_INTRINSIC(Name)                                                                                            \
    case Intrinsic::Name:                                                                                              \
        return #Name;
#include "runtime/library/intrinsics.def"
    }
    return {};
}

/// What the intrinsics take and give, where that is more than their names say.
struct Shape {
    Intrinsic intrinsic;
    std::vector<TypeKind> operands;
    TypeKind result;
};

void addReal(std::vector<Shape>& out, TypeKind kind) {
#define PLC_MATH1(Name, function) out.push_back({Intrinsic::Name, {kind}, kind});
#define PLC_MATH2(Name, function) out.push_back({Intrinsic::Name, {kind, kind}, kind});
#include "runtime/library/intrinsic_meanings.def"
    for (const Intrinsic f : {Intrinsic::Abs, Intrinsic::Sqrt, Intrinsic::Square, Intrinsic::DegToRad,
                              Intrinsic::RadToDeg, Intrinsic::TruncReal, Intrinsic::Floor, Intrinsic::Ceil,
                              Intrinsic::RoundReal, Intrinsic::Frac, Intrinsic::Move})
        out.push_back({f, {kind}, kind});
    out.push_back({Intrinsic::IsValid, {kind}, TypeKind::Bool});
    for (const TypeKind whole : {TypeKind::Sint, TypeKind::Uint, TypeKind::Dint, TypeKind::Lint, TypeKind::Ulint})
        for (const Intrinsic f : {Intrinsic::Trunc, Intrinsic::Floor, Intrinsic::Ceil})
            out.push_back({f, {kind}, whole});
    for (const Intrinsic f : {Intrinsic::MulDuration, Intrinsic::DivDuration})
        out.push_back({f, {TypeKind::Time, kind}, TypeKind::Time});
}

void addWhole(std::vector<Shape>& out, TypeKind kind) {
    for (const Intrinsic f : {Intrinsic::Abs, Intrinsic::Square, Intrinsic::SwapBytes, Intrinsic::Move})
        out.push_back({f, {kind}, kind});
    for (const Intrinsic f : {Intrinsic::Shl, Intrinsic::Shr, Intrinsic::Rol, Intrinsic::Ror, Intrinsic::ExptInt})
        for (const TypeKind count : {TypeKind::Sint, TypeKind::Dint, TypeKind::Ulint})
            out.push_back({f, {kind, count}, kind});
    for (const TypeKind bits : {TypeKind::Byte, TypeKind::Dword, TypeKind::Lword}) {
        out.push_back({Intrinsic::ToBcd, {kind}, bits});
        out.push_back({Intrinsic::BcdTo, {bits}, kind});
    }
    out.push_back({Intrinsic::MulDuration, {TypeKind::Time, kind}, TypeKind::Time});
    out.push_back({Intrinsic::DivDuration, {TypeKind::Ltime, kind}, TypeKind::Ltime});
}

void addAny(std::vector<Shape>& out, TypeKind kind) {
    out.push_back({Intrinsic::Sel, {TypeKind::Bool, kind, kind}, kind});
    out.push_back({Intrinsic::Mux, {TypeKind::Sint, kind, kind, kind}, kind});
    for (const Intrinsic f : {Intrinsic::Max, Intrinsic::Min, Intrinsic::Limit})
        out.push_back({f, {kind, kind, kind}, kind});
}

unsigned seedOfRun() {
    const char* given = std::getenv("STEPWISE_SEED");
    return given ? static_cast<unsigned>(std::atoi(given)) : 20;
}

} // namespace

TEST(Agreement, ConversionsBetweenAllElementaryTypes) {
    for (const TypeKind from : kAll) {
        Comparison c;
        for (const Value& value : samples(from)) {
            for (const TypeKind to : kAll)
                c.expect(c.t.convert(c.input(value), of(to)), types::convert(c.t.types, value, of(to)),
                         c.text(value) + " to " + std::string(types::spelling(to)));
        }
        c.check();
    }
}

TEST(Agreement, OperatorsOnAllNumbers) {
    const BinaryOp operators[] = {BinaryOp::Add,     BinaryOp::Subtract,    BinaryOp::Multiply, BinaryOp::Divide,
                                  BinaryOp::Modulo,  BinaryOp::And,         BinaryOp::Or,       BinaryOp::Xor,
                                  BinaryOp::Equal,   BinaryOp::NotEqual,    BinaryOp::Less,     BinaryOp::LessEqual,
                                  BinaryOp::Greater, BinaryOp::GreaterEqual};
    for (const TypeKind kind : kNumbers) {
        Comparison c;
        const std::vector<Value> values = samples(kind);
        for (const Value& a : values)
            for (size_t n = 0; n < values.size(); n += 5) {
                const Value& d = values[n];
                Expr *x = c.input(a), *y = c.input(d);
                for (const BinaryOp op : operators) {
                    const bool isLogic = op == BinaryOp::And || op == BinaryOp::Or || op == BinaryOp::Xor;
                    if (isLogic && familyOf(kind) == Family::Real) continue;
                    if (kind == TypeKind::Bool && op < BinaryOp::And) continue;
                    const library::Evaluated e = library::evaluateBinary(c.t.types, op, of(kind), a, d);
                    if (e.error != library::EvaluationError::None) continue;
                    c.expect(c.t.binary(op, x, y), e.value,
                             c.text(a) + " op" + std::to_string(static_cast<int>(op)) + " " + c.text(d));
                }
            }
        for (const Value& a : values)
            for (const library::UnaryOp op : {library::UnaryOp::Negate, library::UnaryOp::Not}) {
                const library::Evaluated e = library::evaluateUnary(c.t.types, op, of(kind), a);
                if (e.error == library::EvaluationError::None &&
                    !(kind == TypeKind::Bool && op == library::UnaryOp::Negate))
                    c.expect(c.t.unary(op, c.input(a)), e.value, "unary " + c.text(a));
            }
        c.check();
    }
}

TEST(Agreement, MathematicalFunctions) {
    const Intrinsic one[] = {Intrinsic::Abs,      Intrinsic::Sqrt,      Intrinsic::Ln,        Intrinsic::Log,
                             Intrinsic::Exp,      Intrinsic::Sin,       Intrinsic::Cos,       Intrinsic::Tan,
                             Intrinsic::Asin,     Intrinsic::Acos,      Intrinsic::Atan,      Intrinsic::Sinh,
                             Intrinsic::Cosh,     Intrinsic::Tanh,      Intrinsic::TruncReal, Intrinsic::Floor,
                             Intrinsic::Ceil,     Intrinsic::RoundReal, Intrinsic::Frac,      Intrinsic::Square,
                             Intrinsic::DegToRad, Intrinsic::RadToDeg};
    for (const TypeKind kind : {TypeKind::Real, TypeKind::Lreal}) {
        Comparison c;
        const std::vector<Value> values = samples(kind);
        for (const Value& a : values) {
            Expr* x = c.input(a);
            const Value operands[] = {a};
            for (const Intrinsic f : one)
                c.expect(c.t.intrinsic(f, of(kind), {x}),
                         library::evaluateIntrinsic(c.t.types, f, of(kind), operands, nullptr).value,
                         "f" + std::to_string(static_cast<int>(f)) + " " + c.text(a));
            c.expect(
                c.t.intrinsic(Intrinsic::IsValid, of(TypeKind::Bool), {x}),
                library::evaluateIntrinsic(c.t.types, Intrinsic::IsValid, of(TypeKind::Bool), operands, nullptr).value,
                "IsValid " + c.text(a));
            for (const TypeKind to : kNumbers) {
                if (!isInteger(to)) continue;
                for (const Intrinsic f : {Intrinsic::Trunc, Intrinsic::Floor, Intrinsic::Ceil})
                    c.expect(c.t.intrinsic(f, of(to), {x}),
                             library::evaluateIntrinsic(c.t.types, f, of(to), operands, nullptr).value,
                             "f" + std::to_string(static_cast<int>(f)) + " " + c.text(a) + " to " +
                                 std::string(types::spelling(to)));
            }
            for (const Value& d : values) {
                const Value two[] = {a, d};
                Expr* y = c.input(d);
                for (const Intrinsic f : {Intrinsic::Expt, Intrinsic::Atan2})
                    c.expect(c.t.intrinsic(f, of(kind), {x, y}),
                             library::evaluateIntrinsic(c.t.types, f, of(kind), two, nullptr).value,
                             "f2 " + c.text(a) + " " + c.text(d));
            }
        }
        c.check();
    }
}

TEST(Agreement, ShiftsSelectionsAndExtremes) {
    for (const TypeKind kind : kAll) {
        if (kind == TypeKind::Bool) continue;
        Comparison c;
        const std::vector<Value> values = samples(kind);
        const TypeId lint = of(TypeKind::Lint);
        for (const Value& a : values) {
            Expr* x = c.input(a);
            if (isInteger(kind)) {
                for (const int64_t n : {int64_t(0), int64_t(1), int64_t(7), int64_t(8), int64_t(31), int64_t(32),
                                        int64_t(64), int64_t(-9), INT64_MIN}) {
                    const Value count{lint, n};
                    const Value operands[] = {a, count};
                    Expr* y = c.input(count);
                    for (const Intrinsic f : {Intrinsic::Shl, Intrinsic::Shr, Intrinsic::Rol, Intrinsic::Ror})
                        c.expect(c.t.intrinsic(f, of(kind), {x, y}),
                                 library::evaluateIntrinsic(c.t.types, f, of(kind), operands, nullptr).value,
                                 "shift" + std::to_string(static_cast<int>(f)) + " " + c.text(a) + " by " +
                                     std::to_string(n));
                    c.expect(
                        c.t.intrinsic(Intrinsic::ExptInt, of(kind), {x, y}),
                        library::evaluateIntrinsic(c.t.types, Intrinsic::ExptInt, of(kind), operands, nullptr).value,
                        "power " + c.text(a) + " " + std::to_string(n));
                }
                const Value operands[] = {a};
                c.expect(c.t.intrinsic(Intrinsic::Abs, of(kind), {x}),
                         library::evaluateIntrinsic(c.t.types, Intrinsic::Abs, of(kind), operands, nullptr).value,
                         "abs " + c.text(a));
                c.expect(c.t.intrinsic(Intrinsic::SwapBytes, of(kind), {x}),
                         library::evaluateIntrinsic(c.t.types, Intrinsic::SwapBytes, of(kind), operands, nullptr).value,
                         "swap " + c.text(a));
                c.expect(c.t.intrinsic(Intrinsic::BcdTo, of(TypeKind::Dint), {x}),
                         library::evaluateIntrinsic(c.t.types, Intrinsic::BcdTo, of(TypeKind::Dint), operands, nullptr)
                             .value,
                         "from bcd " + c.text(a));
                c.expect(c.t.intrinsic(Intrinsic::ToBcd, of(TypeKind::Dword), {x}),
                         library::evaluateIntrinsic(c.t.types, Intrinsic::ToBcd, of(TypeKind::Dword), operands, nullptr)
                             .value,
                         "to bcd " + c.text(a));
            }
            for (size_t n = 0; n < values.size(); n += 9) {
                const Value& d = values[n];
                const Value& e = values[(n * 7 + 3) % values.size()];
                Expr *y = c.input(d), *z = c.input(e);
                const Value three[] = {a, d, e};
                for (const Intrinsic f : {Intrinsic::Max, Intrinsic::Min, Intrinsic::Limit})
                    c.expect(c.t.intrinsic(f, of(kind), {x, y, z}),
                             library::evaluateIntrinsic(c.t.types, f, of(kind), three, nullptr).value,
                             "f" + std::to_string(static_cast<int>(f)) + " " + c.text(a) + " " + c.text(d) + " " +
                                 c.text(e));
                const Value k{lint, static_cast<int64_t>(n) - 3};
                const Value mux[] = {k, a, d, e};
                c.expect(c.t.intrinsic(Intrinsic::Mux, of(kind), {c.input(k), x, y, z}),
                         library::evaluateIntrinsic(c.t.types, Intrinsic::Mux, of(kind), mux, nullptr).value, "mux");
            }
        }
        c.check();
    }
}

TEST(Agreement, IntrinsicsOnRandomArguments) {
    const unsigned seed = seedOfRun();
    SCOPED_TRACE("seed " + std::to_string(seed) + " (STEPWISE_SEED sets it)");
    RandomValues random(seed);
    for (const TypeKind kind : kNumbers) {
        std::vector<Shape> shapes;
        if (familyOf(kind) == Family::Real) addReal(shapes, kind);
        if (isInteger(kind)) addWhole(shapes, kind);
        addAny(shapes, kind);
        Comparison c;
        for (const Shape& shape : shapes)
            for (int round = 0; round < 25; ++round) {
                std::vector<Value> operands;
                for (const TypeKind operand : shape.operands) operands.push_back(random.of(operand));
                const library::Evaluated e =
                    library::evaluateIntrinsic(c.t.types, shape.intrinsic, of(shape.result), operands, nullptr);
                if (e.error != library::EvaluationError::None) continue; // a division by zero faults instead
                std::vector<Expr*> inputs;
                std::string what(nameOf(shape.intrinsic));
                for (const Value& operand : operands) {
                    inputs.push_back(c.input(operand));
                    what += " " + c.text(operand);
                }
                c.expect(c.t.intrinsic(shape.intrinsic, of(shape.result), inputs), e.value, what);
            }
        c.check();
    }
}

TEST(Agreement, DurationsAndDates) {
    Comparison c;
    const TypeId time = of(TypeKind::Time), lint = of(TypeKind::Lint), lreal = of(TypeKind::Lreal),
                 dt = of(TypeKind::Dt), integer = of(TypeKind::Int);
    for (const Value& a : samples(TypeKind::Time)) {
        Expr* x = c.input(a);
        for (const Value& factor : samples(TypeKind::Lint)) {
            const Value operands[] = {a, factor};
            c.expect(c.t.intrinsic(Intrinsic::MulDuration, time, {x, c.input(factor)}),
                     library::evaluateIntrinsic(c.t.types, Intrinsic::MulDuration, time, operands, nullptr).value,
                     "mul");
            if (factor.integer() != 0)
                c.expect(c.t.intrinsic(Intrinsic::DivDuration, time, {x, c.input(factor)}),
                         library::evaluateIntrinsic(c.t.types, Intrinsic::DivDuration, time, operands, nullptr).value,
                         "div");
        }
        for (const Value& factor : samples(TypeKind::Lreal)) {
            const Value operands[] = {a, factor};
            for (const Intrinsic f : {Intrinsic::MulDuration, Intrinsic::DivDuration})
                c.expect(c.t.intrinsic(f, time, {x, c.input(factor)}),
                         library::evaluateIntrinsic(c.t.types, f, time, operands, nullptr).value, "real factor");
        }
    }
    for (const Value& a : samples(TypeKind::Dt)) {
        const Value operands[] = {a};
        for (int64_t which = 0; which < 4; ++which)
            for (const Intrinsic f : {Intrinsic::DatePart, Intrinsic::TimePart})
                c.expect(c.t.intrinsic(f, integer, {c.input(a)}, which),
                         library::evaluateIntrinsic(c.t.types, f, integer, operands, nullptr, which).value, "part");
    }
    for (const int64_t year : {2024, 1970, 1600, 9999})
        for (const int64_t day : {0, 1, 29, 30, 32}) {
            const Value operands[] = {{lint, year}, {lint, 2},  {lint, day}, {lint, 23},
                                      {lint, 59},   {lint, 58}, {lint, 999}};
            std::vector<Expr*> inputs;
            for (const Value& v : operands) inputs.push_back(c.input(v));
            c.expect(c.t.intrinsic(Intrinsic::ConcatDt, dt, inputs),
                     library::evaluateIntrinsic(c.t.types, Intrinsic::ConcatDt, dt, operands, nullptr).value,
                     "concat dt");
        }
    const Value bits{lreal, 1.1};
    const Value operands[] = {bits};
    c.expect(c.t.intrinsic(Intrinsic::SameBits, of(TypeKind::Lword), {c.input(bits)}),
             library::evaluateIntrinsic(c.t.types, Intrinsic::SameBits, of(TypeKind::Lword), operands, nullptr).value,
             "same bits");
    c.check();
}

} // namespace plc::test
