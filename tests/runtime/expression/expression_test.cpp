#include "runtime/expression/code.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace plc;
using namespace plc::expression;
using library::BinaryOp;
using library::Intrinsic;
using types::TypeId;
using types::TypeKind;

namespace {

/// A hand-made image: a few variables behind the header.
struct Fixture : testing::Test {
    std::shared_ptr<types::TypeTable> table = std::make_shared<types::TypeTable>();
    std::vector<std::byte> image = std::vector<std::byte>(512);
    CodeBuilder code;
    TypeId boolean = of(TypeKind::Bool), integer = of(TypeKind::Int), dint = of(TypeKind::Dint),
           lint = of(TypeKind::Lint), real = of(TypeKind::Real);

    static TypeId of(TypeKind kind) { return types::TypeTable::of(kind); }
    template <class T> void put(uint32_t offset, T value) { std::memcpy(image.data() + offset, &value, sizeof value); }
    void constant(TypeId type, int64_t value) { code.constant(*table, {type, value}); }
    void load(TypeId type, uint32_t offset, int bit = -1) {
        code.load(*table, {type, offset, static_cast<int16_t>(bit)});
    }
    Expression finish(TypeId type) { return Expression("test", table, code.finish(), type); }
    std::string shown(TypeId type) {
        const Outcome outcome = finish(type).evaluate(image);
        return outcome.hasValue() ? types::toText(*table, outcome.value) : outcome.reason.english();
    }
};

} // namespace

TEST_F(Fixture, ComparesVariablesWithoutAllocating) {
    put<int16_t>(64, 7);
    load(integer, 64);
    constant(integer, 5);
    code.binary(*table, BinaryOp::Greater, integer);
    const Expression expression = finish(boolean);
    EXPECT_TRUE(expression.isTrue(image));
    EXPECT_EQ(expression.number(image), 1.0);
    put<int16_t>(64, 3);
    EXPECT_FALSE(expression.isTrue(image));
    EXPECT_EQ(types::toText(*table, expression.evaluate(image).value), "FALSE");
}

TEST_F(Fixture, EveryScalarIsRead) {
    put<uint64_t>(64, 0xFFFF'FFFF'FFFF'FFFFull);
    struct Row {
        TypeKind kind;
        double expected;
    };
    for (const auto& [kind, expected] :
         {Row{TypeKind::Sint, -1}, Row{TypeKind::Usint, 255}, Row{TypeKind::Int, -1}, Row{TypeKind::Uint, 65535},
          Row{TypeKind::Dint, -1}, Row{TypeKind::Udint, 4294967295.0}, Row{TypeKind::Lint, -1},
          Row{TypeKind::Ulint, 18446744073709551616.0}, Row{TypeKind::Bool, 1}, Row{TypeKind::Byte, 255},
          Row{TypeKind::Time, -1}, Row{TypeKind::Wchar, 65535}}) {
        code = {};
        load(of(kind), 64);
        EXPECT_EQ(finish(of(kind)).number(image), expected) << types::spelling(kind);
    }
    put<float>(64, 1.5f);
    code = {};
    load(real, 64);
    EXPECT_EQ(finish(real).number(image), 1.5);
    put<uint8_t>(64, 0b100);
    code = {};
    load(boolean, 64, 2);
    EXPECT_EQ(finish(boolean).number(image), 1.0);
}

TEST_F(Fixture, ArithmeticIsThatOfItsType) {
    struct Row {
        BinaryOp op;
        int16_t a, b;
        const char* expected;
    };
    for (const auto& [op, a, b, expected] :
         {Row{BinaryOp::Add, 32767, 1, "-32768"}, Row{BinaryOp::Multiply, 300, 300, "24464"},
          Row{BinaryOp::Divide, -7, 2, "-3"}, Row{BinaryOp::Modulo, -7, 2, "-1"},
          Row{BinaryOp::Divide, 1, 0, "division by zero; check the divisor first"}, Row{BinaryOp::And, 6, 3, "2"}}) {
        code = {};
        constant(integer, a);
        constant(integer, b);
        code.binary(*table, op, integer);
        EXPECT_EQ(shown(integer), expected);
    }
    code = {};
    code.constant(*table, {real, static_cast<double>(0.1f)});
    code.constant(*table, {real, static_cast<double>(0.2f)});
    code.binary(*table, BinaryOp::Add, real);
    EXPECT_EQ(shown(real), "0.3");
    code = {};
    constant(of(TypeKind::Ulint), -1);
    constant(of(TypeKind::Ulint), 1);
    code.binary(*table, BinaryOp::Greater, of(TypeKind::Ulint));
    EXPECT_EQ(shown(boolean), "TRUE");
}

TEST_F(Fixture, AnIndexIsGuarded) {
    // ARRAY[1..2, 0..2] OF INT at 64, index variables at 100 and 102
    for (int16_t i = 0; i < 6; ++i) put<int16_t>(64 + 2 * static_cast<uint32_t>(i), static_cast<int16_t>(10 + i));
    const auto element = [&](int16_t i, int16_t k) {
        put<int16_t>(100, i);
        put<int16_t>(102, k);
        code = {};
        code.offset(64);
        load(integer, 100);
        code.index({1, 2, 6});
        load(integer, 102);
        code.index({0, 2, 2});
        code.loadAt(*table, integer, -1);
        return shown(integer);
    };
    EXPECT_EQ(element(1, 0), "10");
    EXPECT_EQ(element(2, 2), "15");
    EXPECT_EQ(element(3, 0), "index 3 is outside 1..2; use an index in this range or enlarge the array");
    EXPECT_EQ(element(1, -1), "index -1 is outside 0..2; use an index in this range or enlarge the array");
}

TEST_F(Fixture, AReferenceIsChecked) {
    put<int16_t>(200, 42);
    const TypeId pointer = table->pointer(integer);
    const auto follow = [&](int64_t offset) {
        put<int64_t>(64, offset);
        code = {};
        load(pointer, 64);
        code.dereference(integer);
        code.loadAt(*table, integer, -1);
        code.readsAnything();
        return shown(integer);
    };
    EXPECT_EQ(follow(200), "42");
    EXPECT_EQ(follow(0), "the reference is NULL; assign a variable to it, or compare it with NULL first");
    EXPECT_EQ(follow(8), "the reference does not point to a variable of its type; assign one to it")
        << "the header is no variable";
    EXPECT_EQ(follow(511), "the reference does not point to a variable of its type; assign one to it");
    EXPECT_EQ(follow(-1), "the reference does not point to a variable of its type; assign one to it");
    EXPECT_EQ(follow(INT64_MAX), "the reference does not point to a variable of its type; assign one to it");
}

TEST_F(Fixture, AnInOutIsFollowed) {
    put<int16_t>(200, 42);
    const auto follow = [&](int64_t offset) {
        put<int64_t>(64, offset);
        code = {};
        code.offset(64);
        code.followInOut(integer);
        code.loadAt(*table, integer, -1);
        return shown(integer);
    };
    EXPECT_EQ(follow(200), "42");
    EXPECT_EQ(follow(0), "a VAR_IN_OUT is not connected to a variable; connect it in the call");
}

TEST_F(Fixture, AnArrayOfOpenLengthBringsItsBounds) {
    for (int16_t i = 0; i < 6; ++i) put<int16_t>(200 + 2 * static_cast<uint32_t>(i), static_cast<int16_t>(10 + i));
    for (const auto& [offset, value] : {std::pair{64u, 200}, {72u, 1}, {80u, 2}, {88u, 0}, {96u, 2}})
        put<int64_t>(offset, value);
    const auto element = [&](int64_t i, int64_t k) {
        code = {};
        code.offset(64);
        constant(lint, i);
        constant(lint, k);
        code.openIndex(2, 2);
        code.loadAt(*table, integer, -1);
        return shown(integer);
    };
    EXPECT_EQ(element(1, 0), "10");
    EXPECT_EQ(element(2, 1), "14");
    EXPECT_EQ(element(2, 3), "index 3 is outside 0..2; use an index in this range or enlarge the array");
    EXPECT_EQ(element(0, 0), "index 0 is outside 1..2; use an index in this range or enlarge the array");
    put<int64_t>(64, 0);
    EXPECT_EQ(element(1, 0), "a VAR_IN_OUT is not connected to a variable; connect it in the call");
    put<int64_t>(64, 200);
    put<int64_t>(80, int64_t{1} << 40);
    EXPECT_EQ(element(int64_t{1} << 40, 0), "the reference does not point to a variable of its type; assign one to it")
        << "broken bounds must not lead out of the image";
}

TEST_F(Fixture, TextsCompareAndJoin) {
    const TypeId text = table->string(10);
    std::memcpy(image.data() + 64, "abc", 4);
    load(text, 64);
    code.constant(*table, {table->string(3), std::string("abd")});
    code.binary(*table, BinaryOp::Less, text);
    EXPECT_EQ(shown(boolean), "TRUE");
    code = {};
    load(text, 64);
    code.constant(*table, {text, std::string("-x")});
    code.intrinsic({Intrinsic::Concat, text, {text, text}, -1});
    EXPECT_EQ(shown(text), "'abc-x'");
    EXPECT_EQ(Expression("t", table, code.finish(), text).number(image), std::nullopt);
}

TEST_F(Fixture, ACharacterOfATextIsGuarded) {
    const TypeId text = table->string(10), byte = of(TypeKind::Byte);
    std::memcpy(image.data() + 64, "abc", 4);
    const auto at = [&](int64_t index) {
        code = {};
        code.offset(64);
        constant(lint, index);
        code.character(text);
        return shown(byte);
    };
    EXPECT_EQ(at(0), "97");
    EXPECT_EQ(at(2), "99");
    EXPECT_EQ(at(3), "0") << "the end mark";
    EXPECT_EQ(at(4), "character 4 is outside 0..3 of the string; use an index in this range");
    EXPECT_EQ(at(-1), "character -1 is outside 0..3 of the string; use an index in this range");
}

TEST_F(Fixture, TheSecondOperandWaitsForTheFirst) {
    const auto andThen = [&](int64_t first) {
        code = {};
        constant(boolean, first);
        const size_t end = code.jump(Op::JumpKeepFalse);
        constant(integer, 1);
        constant(integer, 0);
        code.binary(*table, BinaryOp::Divide, integer);
        constant(integer, 1);
        code.binary(*table, BinaryOp::Equal, integer);
        code.land(end);
        return shown(boolean);
    };
    EXPECT_EQ(andThen(0), "FALSE");
    EXPECT_EQ(andThen(1), "division by zero; check the divisor first");
}

TEST_F(Fixture, OneOfTwoWaysIsTaken) {
    const auto choose = [&](int64_t which) {
        code = {};
        constant(boolean, which);
        const size_t otherwise = code.jump(Op::JumpIfFalse);
        constant(integer, 1);
        const size_t end = code.jump(Op::Jump);
        code.land(otherwise);
        code.otherWay();
        constant(integer, 2);
        code.land(end);
        return shown(integer);
    };
    EXPECT_EQ(choose(1), "1");
    EXPECT_EQ(choose(0), "2");
}

TEST_F(Fixture, ConversionsAndIntrinsicsAreTheReferences) {
    code.constant(*table, {real, 2.5});
    code.convert(real, integer);
    EXPECT_EQ(shown(integer), "2");
    code = {};
    constant(integer, 0);
    constant(integer, 50);
    constant(integer, 10);
    code.intrinsic({Intrinsic::Limit, integer, {integer, integer, integer}, -1});
    EXPECT_EQ(shown(integer), "10");
    code = {};
    constant(dint, 70000);
    code.convert(dint, integer);
    EXPECT_EQ(shown(integer), "4464");
}

TEST_F(Fixture, TheClockIsThatOfTheImage) {
    image::ImageHeader header;
    header.timeNs = 5'000'000'000;
    put(0, header);
    code.intrinsic({Intrinsic::Time, of(TypeKind::Time), {}, -1});
    const Expression expression = finish(of(TypeKind::Time));
    EXPECT_EQ(types::toText(*table, expression.evaluate(image).value), "T#5s");
    EXPECT_EQ(expression.reads().ranges.at(0).size, 64u);
}

TEST_F(Fixture, KnowsWhatItReads) {
    load(integer, 100);
    load(dint, 64);
    code.convert(dint, integer);
    code.binary(*table, BinaryOp::Add, integer);
    load(integer, 68);
    code.binary(*table, BinaryOp::Add, integer);
    const ReadSet reads = finish(integer).reads();
    EXPECT_TRUE(reads.isComplete);
    ASSERT_EQ(reads.ranges.size(), 2u);
    EXPECT_EQ(reads.ranges[0].begin, 64u);
    EXPECT_EQ(reads.ranges[0].size, 6u) << "neighbours are one range";
    EXPECT_EQ(reads.ranges[1].begin, 100u);
}

TEST_F(Fixture, AnImageThatIsTooSmallGivesAReason) {
    load(dint, 400);
    const Expression expression = finish(dint);
    const std::span<const std::byte> small(image.data(), 402);
    EXPECT_EQ(expression.evaluate(small).reason.english(),
              "the program of this scan does not have it; choose a later scan");
    EXPECT_EQ(expression.number(small), std::nullopt);
    EXPECT_EQ(expression.number(image), 0.0);
}

TEST_F(Fixture, AnEmptyExpressionHasNoValue) {
    const Expression expression;
    EXPECT_FALSE(expression.isValid());
    EXPECT_FALSE(expression.evaluate(image).hasValue());
    EXPECT_EQ(expression.number(image), std::nullopt);
    EXPECT_FALSE(expression.isTrue(image));
    EXPECT_FALSE(expression.place());
}
