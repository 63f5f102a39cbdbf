#include "tests/runtime/compiler/codegen/tree_builder.h"

namespace plc::test {

using image::FaultCode;
using tree::ArgumentMode;
using tree::LocalKind;
using tree::StmtKind;

TEST(Codegen, AssignsTheSumOfTwoVariables) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t a = t.global(dint), c = t.global(dint);
    t.set<int32_t>(a, 40);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(c, dint), t.binary(BinaryOp::Add, t.load(t.at(a, dint)), t.constant(dint, 2))));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(42, t.get<int32_t>(c));
}

TEST(Codegen, DivisionByZeroFaultsAtItsStatement) {
    Bench t;
    const auto i = of(TypeKind::Int);
    const uint32_t a = t.global(i), c = t.global(i);
    t.set<int16_t>(a, 7);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(a, i), t.constant(i, 5)));
    t.add(main, t.assign(t.at(a, i), t.binary(BinaryOp::Divide, t.load(t.at(a, i)), t.load(t.at(c, i)))));
    EXPECT_EQ(FaultCode::DivisionByZero, t.runBoth(main));
    EXPECT_EQ(2u, t.context.faultSite);
    EXPECT_EQ(5, t.get<int16_t>(a));
}

TEST(Codegen, SmallestByMinusOneDoesNotTrap) {
    for (const TypeKind kind : {TypeKind::Sint, TypeKind::Int, TypeKind::Dint, TypeKind::Lint}) {
        Bench t;
        const uint32_t a = t.global(of(kind)), c = t.global(of(kind)), q = t.global(of(kind)), r = t.global(of(kind));
        const int64_t smallest = TypeTable::integerRange(kind).first;
        const uint32_t main = t.function("Main");
        t.add(main, t.assign(t.at(a, of(kind)), t.constant(of(kind), smallest)));
        t.add(main, t.assign(t.at(c, of(kind)), t.constant(of(kind), -1)));
        t.add(main, t.assign(t.at(q, of(kind)),
                             t.binary(BinaryOp::Divide, t.load(t.at(a, of(kind))), t.load(t.at(c, of(kind))))));
        t.add(main, t.assign(t.at(r, of(kind)),
                             t.binary(BinaryOp::Modulo, t.load(t.at(a, of(kind))), t.load(t.at(c, of(kind))))));
        EXPECT_EQ(FaultCode::None, t.runBoth(main));
        EXPECT_EQ(0, std::memcmp(t.image() + a, t.image() + q, types::bitsOf(kind) / 8));
        EXPECT_EQ(0, t.get<int8_t>(r));
    }
}

TEST(Codegen, CallsAFunctionWithInputOutputAndInOut) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t x = t.global(dint), y = t.global(dint), z = t.global(dint);
    t.set<int32_t>(y, 100);
    const uint32_t f = t.function("Twice", dint);
    const uint32_t in = t.local(f, dint, LocalKind::Input), io = t.local(f, dint, LocalKind::InOut),
                   out = t.local(f, dint, LocalKind::Output);
    t.add(f, t.assign(t.local(0, dint), t.binary(BinaryOp::Multiply, t.load(t.local(in, dint)), t.constant(dint, 2))));
    t.add(f, t.assign(t.local(io, dint), t.binary(BinaryOp::Add, t.load(t.local(io, dint)), t.constant(dint, 1))));
    t.add(f, t.assign(t.local(out, dint), t.constant(dint, -7)));
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(x, dint), t.call(f, {{in, ArgumentMode::Input, t.constant(dint, 21), nullptr},
                                                   {io, ArgumentMode::InOut, nullptr, t.at(y, dint)},
                                                   {out, ArgumentMode::Output, nullptr, t.at(z, dint)}})));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(42, t.get<int32_t>(x));
    EXPECT_EQ(101, t.get<int32_t>(y));
    EXPECT_EQ(-7, t.get<int32_t>(z));
}

TEST(Codegen, AMissingInOutFaultsWhereItIsUsed) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t x = t.global(dint);
    const uint32_t f = t.function("Use", dint);
    const uint32_t io = t.local(f, dint, LocalKind::InOut);
    t.add(f, t.assign(t.at(x, dint), t.constant(dint, 1)));
    t.add(f, t.assign(t.local(0, dint), t.load(t.local(io, dint))));
    const uint32_t main = t.function("Main");
    t.add(main, t.statement(StmtKind::Evaluate, t.call(f)));
    EXPECT_EQ(FaultCode::MissingInOut, t.runBoth(main));
    EXPECT_EQ(2u, t.context.faultSite);
    ASSERT_EQ(2u, t.context.depth);
    EXPECT_EQ(main, t.context.calls[0].function);
    EXPECT_EQ(f, t.context.calls[1].function);
    EXPECT_EQ(3u, t.context.calls[1].site);
}

TEST(Codegen, IndexOutOfRangeTellsIndexAndBounds) {
    Bench t;
    const auto dint = of(TypeKind::Dint), lint = of(TypeKind::Lint);
    const TypeId array = t.types.array({{1, 5}, {0, 2}}, dint);
    const uint32_t a = t.global(array), i = t.global(lint);
    t.set<int64_t>(i, 3);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.element(t.at(a, array), {t.constant(lint, 5), t.constant(lint, 2)}), t.constant(dint, 9)));
    t.add(main, t.assign(t.element(t.at(a, array), {t.constant(lint, 2), t.load(t.at(i, lint))}), t.constant(dint, 8)));
    EXPECT_EQ(FaultCode::IndexOutOfRange, t.runBoth(main));
    EXPECT_EQ(9, t.get<int32_t>(a + 14 * 4));
    EXPECT_EQ(3, t.context.faultDetail[0]);
    EXPECT_EQ(0, t.context.faultDetail[1]);
    EXPECT_EQ(2, t.context.faultDetail[2]);
}

struct ForRow {
    TypeKind kind;
    int64_t first, last, step;
    int64_t passes, after;
};

TEST(Codegen, ForLoopsRunAsOftenAsTheyShouldAndEndOnePastTheLimit) {
    const ForRow rows[] = {
        {TypeKind::Int, 5, 5, 1, 1, 6},
        {TypeKind::Int, 1, 10, 1, 10, 11},
        {TypeKind::Int, 10, 1, 1, 0, 10},
        {TypeKind::Int, 10, 1, -3, 4, -2},
        {TypeKind::Int, 0, 32767, 1, 32768, 32767},
        {TypeKind::Usint, 250, 255, 1, 6, 255},
        {TypeKind::Usint, 5, 0, -1, 6, 0},
        {TypeKind::Dint, 1, 200'000, 1, 200'000, 200'001},
        {TypeKind::Lint, INT64_MAX - 2, INT64_MAX, 1, 3, INT64_MAX},
        {TypeKind::Ulint, 1, 7, 3, 3, 10},
        {TypeKind::Sint, -128, 127, 100, 3, 72},
        {TypeKind::Int, 1, 10, 0, 0, 1},
        {TypeKind::Sint, 127, -128, -1, 256, -128},
    };
    for (const ForRow& row : rows) {
        for (const bool isWritten : {false, true}) {
            Bench t;
            const auto type = of(row.kind), dint = of(TypeKind::Dint);
            const uint32_t i = t.global(type), n = t.global(dint), limit = t.global(type);
            const uint32_t main = t.function("Main");
            std::vector<Stmt*> body{
                t.assign(t.at(n, dint), t.binary(BinaryOp::Add, t.load(t.at(n, dint)), t.constant(dint, 1)))};
            if (isWritten) body.push_back(t.assign(t.at(i, type), t.load(t.at(i, type)))); // no longer counted
            t.add(main, t.assign(t.at(limit, type), t.constant(type, row.last)));
            t.add(main, t.forLoop(t.at(i, type), t.constant(type, row.first), t.load(t.at(limit, type)),
                                  t.constant(type, row.step), body));
            EXPECT_EQ(FaultCode::None, t.runBoth(main));
            EXPECT_EQ(row.passes, t.get<int32_t>(n)) << row.first << " to " << row.last << " by " << row.step;
            int64_t after = 0;
            std::memcpy(&after, t.image() + i, types::bitsOf(row.kind) / 8);
            const int64_t mask = types::bitsOf(row.kind) == 64 ? -1 : (int64_t(1) << types::bitsOf(row.kind)) - 1;
            EXPECT_EQ(row.after & mask, after & mask) << row.first << " to " << row.last << " by " << row.step;
            EXPECT_EQ(t.budget - row.passes, t.context.loopBudget);
        }
    }
}

TEST(Codegen, AForCountsDownAnUnsignedVariableToALimitBelowItsType) {
    for (const bool isWritten : {false, true}) {
        Bench t;
        const auto usint = of(TypeKind::Usint), integer = of(TypeKind::Int), dint = of(TypeKind::Dint);
        const uint32_t i = t.global(usint), n = t.global(dint), limit = t.global(integer);
        t.set<int16_t>(limit, -1);
        const uint32_t main = t.function("Main");
        std::vector<Stmt*> body{
            t.assign(t.at(n, dint), t.binary(BinaryOp::Add, t.load(t.at(n, dint)), t.constant(dint, 1)))};
        if (isWritten) body.push_back(t.assign(t.at(i, usint), t.load(t.at(i, usint))));
        Stmt* loop = t.forLoop(t.at(i, usint), t.constant(integer, 10), t.load(t.at(limit, integer)),
                               t.constant(integer, -1), body);
        loop->operandType = integer;
        t.add(main, loop);
        EXPECT_EQ(FaultCode::None, t.runBoth(main));
        EXPECT_EQ(11, t.get<int32_t>(n));
        EXPECT_EQ(0, t.get<uint8_t>(i));
    }
}

TEST(Codegen, AJumpIntoALoopStaysWithinBoundsAndEnds) {
    Bench t;
    const auto dint = of(TypeKind::Dint), lint = of(TypeKind::Lint);
    const TypeId array = t.types.array({{1, 10}}, dint);
    const uint32_t guard = t.global(lint), a = t.global(array), i = t.global(lint);
    t.set<int64_t>(guard, -1);
    const uint32_t main = t.function("Main");
    t.fn(main).labelCount = 1;
    Stmt* jump = t.statement(StmtKind::Jump);
    jump->label = tree::LabelId(0);
    t.add(main, jump);
    Stmt* label = t.statement(StmtKind::Label);
    label->label = tree::LabelId(0);
    t.add(main, t.forLoop(t.at(i, lint), t.constant(lint, 1), t.constant(lint, 10), t.constant(lint, 1),
                          {label, t.assign(t.element(t.at(a, array), {t.load(t.at(i, lint))}), t.constant(dint, 7))}));
    EXPECT_EQ(FaultCode::IndexOutOfRange, t.runBoth(main)); // i is 0, not 1
    EXPECT_EQ(-1, t.get<int64_t>(guard));
}

TEST(Codegen, AnEndlessLoopIsStoppedByTheBudget) {
    Bench t;
    const auto boolean = of(TypeKind::Bool);
    const uint32_t main = t.function("Main");
    t.add(main, t.statement(StmtKind::While, t.constant(boolean, 1)));
    EXPECT_EQ(FaultCode::Watchdog, t.run(main, codegen::Tier::Quick));
    EXPECT_EQ(FaultCode::Watchdog, t.run(main, codegen::Tier::Optimised));
    EXPECT_EQ(1u, t.context.faultSite);
}

TEST(Codegen, RecursionWithoutEndIsAStackOverflow) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t f = t.function("Deeper", dint);
    const uint32_t in = t.local(f, dint, LocalKind::Input);
    t.fn(f).mayRecurse = true;
    t.add(f,
          t.assign(t.local(0, dint),
                   t.binary(BinaryOp::Add, t.call(f, {{in, ArgumentMode::Input, t.load(t.local(in, dint)), nullptr}}),
                            t.constant(dint, 1))));
    const uint32_t main = t.function("Main");
    t.add(main, t.statement(StmtKind::Evaluate, t.call(f, {{in, ArgumentMode::Input, t.constant(dint, 1), nullptr}})));
    EXPECT_EQ(FaultCode::StackOverflow, t.runBoth(main));
}

TEST(Codegen, AFrameThatDoesNotFitIsAStackOverflow) {
    Bench t;
    const auto byte = of(TypeKind::Byte);
    const TypeId array = t.types.array({{0, 20'000}}, byte);
    const uint32_t f = t.function("Deeper");
    t.local(f, array, LocalKind::Local);
    t.add(f, t.statement(StmtKind::Evaluate, t.call(f)));
    EXPECT_EQ(FaultCode::StackOverflow, t.runBoth(f));
    EXPECT_EQ(4u, t.context.depth); // 64 KiB hold three such frames; the fourth call finds no room
}

TEST(Codegen, CaseTakesTheArmOfItsRange) {
    Bench t;
    const auto dint = of(TypeKind::Dint), lint = of(TypeKind::Lint);
    const TypeId array = t.types.array({{0, 9}}, dint);
    const uint32_t out = t.global(array), i = t.global(lint);
    const int64_t values[] = {-5, 0, 3, 4, 10, 500, 100'000, 7, 8, 9};
    const uint32_t main = t.function("Main");
    for (int64_t n = 0; n < 10; ++n) {
        t.add(main, t.assign(t.at(i, lint), t.constant(lint, values[n])));
        Stmt* s = t.statement(StmtKind::Case, t.load(t.at(i, lint)));
        const auto put = [&](int64_t v) {
            return t.assign(t.element(t.at(out, array), {t.constant(lint, n)}), t.constant(dint, v));
        };
        s->arms.push_back({{{-10, -1}}, {put(1)}});
        s->arms.push_back({{{0, 0}, {4, 4}}, {put(2)}});
        s->arms.push_back({{{100, 90'000}}, {put(3)}});
        s->arms.push_back({{{8, 9}}, {put(4)}});
        s->elseBody = {put(5)};
        t.add(main, s);
    }
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    const int32_t wanted[] = {1, 2, 5, 2, 5, 3, 5, 5, 4, 4};
    for (uint32_t n = 0; n < 10; ++n) EXPECT_EQ(wanted[n], t.get<int32_t>(out + 4 * n)) << n;
}

TEST(Codegen, TheQuickTierStopsAtFlaggedSites) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t a = t.global(dint);
    const uint32_t main = t.function("Main");
    for (int n = 0; n < 3; ++n) t.add(main, t.assign(t.at(a, dint), t.constant(dint, n)));
    t.code(codegen::Tier::Quick);
    t.flags[2] = 1;
    EXPECT_EQ(FaultCode::None, t.run(main, codegen::Tier::Quick));
    ASSERT_EQ(1u, t.stops.size());
    EXPECT_EQ(2u, t.stops[0].first);
    EXPECT_EQ(3u, t.context.currentSite);
}

TEST(Codegen, ABlockCallIsOneSiteThatStopsBeforeItsInputsAreAssigned) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t a = t.global(dint), c = t.global(dint);
    const uint32_t body = t.function("Body");
    t.add(body, t.assign(t.at(c, dint), t.load(t.at(a, dint))));
    const uint32_t main = t.function("Main");
    Stmt* block = t.statement(StmtKind::Block);
    Stmt* input = t.assign(t.at(a, dint), t.binary(BinaryOp::Divide, t.constant(dint, 1), t.load(t.at(a, dint))));
    input->range = {};
    Stmt* call = t.statement(StmtKind::Evaluate, t.call(body));
    call->range = block->range;
    block->body = {input, call};
    t.add(main, t.assign(t.at(c, dint), t.constant(dint, 3)));
    t.add(main, block);
    EXPECT_EQ(FaultCode::DivisionByZero, t.runBoth(main)); // in the input: shown at the call
    ASSERT_EQ(4u, t.debug.sites.size());
    EXPECT_EQ(3u, t.context.faultSite);
    EXPECT_EQ(block->range, t.debug.sites[3].range);
    t.flags[3] = 1;
    EXPECT_EQ(FaultCode::DivisionByZero, t.run(main, codegen::Tier::Quick));
    EXPECT_EQ(1u, t.stops.size());
}

TEST(Codegen, QuickLocalsLieWhereTheDebugMapSays) {
    Bench t;
    const auto dint = of(TypeKind::Dint), real = of(TypeKind::Real);
    const uint32_t main = t.function("Main");
    const uint32_t x = t.local(main, dint, LocalKind::Local), y = t.local(main, real, LocalKind::Local);
    t.add(main, t.assign(t.local(x, dint), t.constant(dint, 77)));
    t.add(main, t.assign(t.local(y, real), t.real(real, 1.5)));
    EXPECT_EQ(FaultCode::None, t.run(main, codegen::Tier::Quick));
    const image::FunctionInfo& info = t.debug.functions[main];
    EXPECT_EQ(77, t.get<int32_t>(t.program.layout.frameBegin + info.locals[x].frameOffset));
    EXPECT_EQ(1.5f, t.get<float>(t.program.layout.frameBegin + info.locals[y].frameOffset));
}

TEST(Codegen, JumpsBackwardsArePaidFor) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const uint32_t a = t.global(dint);
    const uint32_t main = t.function("Main");
    t.fn(main).labelCount = 1;
    Stmt* label = t.statement(StmtKind::Label);
    label->label = tree::LabelId(0);
    t.add(main, label);
    t.add(main, t.assign(t.at(a, dint), t.binary(BinaryOp::Add, t.load(t.at(a, dint)), t.constant(dint, 1))));
    Stmt* jump = t.statement(StmtKind::Jump, t.binary(BinaryOp::Less, t.load(t.at(a, dint)), t.constant(dint, 10)));
    jump->label = tree::LabelId(0);
    t.add(main, jump);
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(10, t.get<int32_t>(a));
    EXPECT_EQ(t.budget - 9, t.context.loopBudget);
}

} // namespace plc::test
