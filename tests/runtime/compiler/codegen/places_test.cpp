#include "tests/runtime/compiler/codegen/tree_builder.h"

namespace plc::test {

using image::FaultCode;
using library::Intrinsic;
using tree::ArgumentMode;
using tree::LocalKind;
using tree::StmtKind;
using types::Field;
using types::FieldSection;

namespace {
Expr* index(Bench& t, int64_t value) { return t.constant(of(TypeKind::Lint), value); }
} // namespace

TEST(Places, BitsOfVariablesInTheImageAndInRegisters) {
    Bench t;
    const auto word = of(TypeKind::Word), boolean = of(TypeKind::Bool);
    const uint32_t w = t.global(word), v = t.global(word), seen = t.global(boolean);
    const uint32_t main = t.function("Main");
    const uint32_t x = t.local(main, word, LocalKind::Local);
    t.add(main, t.assign(t.bitOf(t.at(w, word), 11), t.constant(boolean, 1)));
    t.add(main, t.assign(t.bitOf(t.local(x, word), 3), t.constant(boolean, 1)));
    t.add(main, t.assign(t.bitOf(t.local(x, word), 15), t.load(t.bitOf(t.at(w, word), 11))));
    t.add(main, t.assign(t.at(v, word), t.load(t.local(x, word))));
    t.add(main, t.assign(t.at(seen, boolean), t.load(t.bitOf(t.local(x, word), 2))));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(0x0800, t.get<uint16_t>(w));
    EXPECT_EQ(0x8008, t.get<uint16_t>(v));
    EXPECT_EQ(0, t.get<uint8_t>(seen));
}

TEST(Places, AnyBitPatternIsABoolean) {
    Bench t;
    const auto boolean = of(TypeKind::Bool), dint = of(TypeKind::Dint);
    const uint32_t a = t.global(boolean), n = t.global(dint);
    t.set<uint8_t>(a, 0xA4);
    const uint32_t main = t.function("Main");
    Stmt* s = t.statement(StmtKind::If, t.load(t.at(a, boolean)));
    s->body = {t.assign(t.at(n, dint), t.convert(t.load(t.at(a, boolean)), dint))};
    t.add(main, s);
    t.add(main, t.assign(t.at(a, boolean), t.unary(library::UnaryOp::Not, t.load(t.at(a, boolean)))));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(1, t.get<int32_t>(n));
    EXPECT_EQ(0, t.get<uint8_t>(a));
}

TEST(Places, PointersReachVariablesAndNothingElse) {
    struct Row {
        int64_t offset; // relative to x; or absolute
        bool isAbsolute;
        FaultCode wanted;
    };
    for (const Row& row :
         {Row{0, false, FaultCode::None}, Row{0, true, FaultCode::NullReference},
          Row{8, true, FaultCode::ForeignReference}, Row{-8, true, FaultCode::ForeignReference},
          Row{INT64_MIN, true, FaultCode::ForeignReference}, Row{1 << 20, true, FaultCode::ForeignReference}}) {
        Bench t;
        const auto dint = of(TypeKind::Dint);
        const TypeId pointer = t.types.pointer(dint);
        const uint32_t p = t.global(pointer), x = t.global(dint);
        t.set<int64_t>(p, row.isAbsolute ? row.offset : x + row.offset);
        const uint32_t main = t.function("Main");
        t.add(main, t.assign(t.deref(t.load(t.at(p, pointer)), dint), t.constant(dint, 5)));
        EXPECT_EQ(row.wanted, t.runBoth(main)) << row.offset;
        EXPECT_EQ(row.wanted == FaultCode::None ? 5 : 0, t.get<int32_t>(x));
    }
}

TEST(Places, APointerToALocalLivesAsLongAsItsFrame) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const TypeId pointer = t.types.pointer(dint);
    const uint32_t p = t.global(pointer), n = t.global(dint);
    const uint32_t f = t.function("Leak");
    const uint32_t x = t.local(f, dint, LocalKind::Local);
    t.add(f, t.assign(t.at(p, pointer), t.addressOf(t.local(x, dint), pointer)));
    t.add(f, t.assign(t.deref(t.load(t.at(p, pointer)), dint), t.constant(dint, 3)));
    t.add(f, t.assign(t.at(n, dint), t.load(t.local(x, dint))));
    const uint32_t main = t.function("Main");
    t.add(main, t.statement(StmtKind::Evaluate, t.call(f)));
    t.add(main, t.assign(t.deref(t.load(t.at(p, pointer)), dint), t.constant(dint, 4)));
    EXPECT_EQ(FaultCode::ForeignReference, t.run(main, codegen::Tier::Quick));
    EXPECT_EQ(3, t.get<int32_t>(n));
    EXPECT_EQ(FaultCode::ForeignReference, t.run(main, codegen::Tier::Optimised));
    EXPECT_EQ(3, t.get<int32_t>(n));
}

TEST(Places, OpenArraysBringTheirBounds) {
    Bench t;
    const auto dint = of(TypeKind::Dint), lint = of(TypeKind::Lint);
    const TypeId array = t.types.array({{-1, 2}, {3, 5}}, dint), open = t.types.openArray(2, dint);
    const uint32_t a = t.global(array), sum = t.global(dint), low = t.global(lint), high = t.global(lint),
                   last = t.global(lint);
    t.set<int64_t>(last, 5);
    const uint32_t f = t.function("Sum", dint);
    const uint32_t io = t.local(f, open, LocalKind::InOut), i = t.local(f, lint, LocalKind::Input),
                   k = t.local(f, lint, LocalKind::Input);
    t.add(f, t.assign(t.element(t.local(io, open), {t.load(t.local(i, lint)), t.load(t.local(k, lint))}),
                      t.constant(dint, 12)));
    Expr* lower = t.constant(lint, 0);
    lower->kind = tree::ExprKind::Bound;
    lower->place = t.local(io, open);
    lower->selector = 0;
    Expr* upper = t.constant(lint, 0);
    *upper = *lower;
    upper->selector = 1;
    upper->isUpper = true;
    t.add(f, t.assign(t.at(low, lint), lower));
    t.add(f, t.assign(t.at(high, lint), upper));
    const uint32_t main = t.function("Main");
    const auto sumCall = [&](int64_t first, Expr* second) {
        return t.statement(StmtKind::Evaluate, t.call(f, {{io, ArgumentMode::InOut, nullptr, t.at(a, array)},
                                                          {i, ArgumentMode::Input, t.constant(lint, first), nullptr},
                                                          {k, ArgumentMode::Input, second, nullptr}}));
    };
    t.add(main, sumCall(2, t.constant(lint, 5)));
    t.add(main, t.assign(t.at(last, lint), t.constant(lint, 6)));
    t.add(main, t.assign(t.at(sum, dint), t.constant(dint, 1)));
    t.add(main, sumCall(0, t.load(t.at(last, lint))));
    EXPECT_EQ(FaultCode::IndexOutOfRange, t.runBoth(main));
    EXPECT_EQ(12, t.get<int32_t>(a + 11 * 4));
    EXPECT_EQ(-1, t.get<int64_t>(low));
    EXPECT_EQ(5, t.get<int64_t>(high));
    EXPECT_EQ(6, t.context.faultDetail[0]);
    EXPECT_EQ(3, t.context.faultDetail[1]);
    EXPECT_EQ(5, t.context.faultDetail[2]);
    EXPECT_EQ(1, t.get<int32_t>(sum));
}

/// A block with an IN_OUT and a body that counts it up by its input.
struct CounterBlock {
    explicit CounterBlock(Bench& t, TypeId inOut) {
        type = t.types.declare(TypeKind::Block, "Counter");
        types::Type& block = t.types.edit(type);
        Field in, io, out;
        in.name = "by";
        in.type = of(TypeKind::Dint);
        in.section = FieldSection::Input;
        io.name = "io";
        io.type = inOut;
        io.section = FieldSection::InOut;
        out.name = "done";
        out.type = of(TypeKind::Dint);
        out.section = FieldSection::Output;
        block.fields = {in, io, out};
        t.types.layoutFields(type);
        by = t.types[type].fields[0].offset;
        slot = t.types[type].fields[1].offset;
        done = t.types[type].fields[2].offset;
    }
    TypeId type;
    uint32_t by = 0, slot = 0, done = 0;
};

TEST(Places, ABlocksInOutIsBoundFollowedAndChecked) {
    const auto dint = of(TypeKind::Dint);
    for (const int what : {0, 1, 2}) { // bound, unbound, corrupted
        Bench t;
        CounterBlock block(t, dint);
        const uint32_t fb = t.global(block.type), x = t.global(dint);
        const uint32_t body = t.function("Counter", of(TypeKind::Void), block.type);
        Place* io = t.slot(block.slot, dint);
        io->base = t.instance(0, block.type);
        t.add(body, t.assign(io, t.binary(BinaryOp::Add, t.load(io), t.load(t.instance(block.by, dint)))));
        t.add(body, t.assign(t.instance(block.done, dint), t.load(io)));
        const uint32_t main = t.function("Main");
        t.add(main, t.assign(t.field(t.at(fb, block.type), block.by, dint), t.constant(dint, 5)));
        Stmt* bind = t.statement(StmtKind::Bind);
        bind->place = t.slot(block.slot, dint);
        bind->place->base = t.at(fb, block.type);
        bind->target = what == 0 ? t.at(x, dint) : nullptr;
        if (what < 2)
            t.add(main, bind);
        else
            t.set<int64_t>(fb + block.slot, 1'000'000'000'000);
        for (int n = 0; n < 2; ++n)
            t.add(main, t.statement(StmtKind::Evaluate, t.call(body, {}, t.at(fb, block.type))));
        const FaultCode wanted[] = {FaultCode::None, FaultCode::MissingInOut, FaultCode::ForeignReference};
        EXPECT_EQ(wanted[what], t.runBoth(main));
        if (what == 0) {
            EXPECT_EQ(10, t.get<int32_t>(x));
            EXPECT_EQ(10, t.get<int32_t>(fb + block.done));
        }
    }
}

TEST(Places, AggregatesAreCopiedPassedAndReturned) {
    Bench t;
    const auto dint = of(TypeKind::Dint);
    const TypeId array = t.types.array({{0, 3}}, dint);
    const uint32_t a = t.global(array), c = t.global(array), e = t.global(dint), kept = t.global(dint);
    for (int32_t n = 0; n < 4; ++n) t.set<int32_t>(a + 4 * static_cast<uint32_t>(n), n + 1);
    const uint32_t f = t.function("Doubled", array);
    const uint32_t in = t.local(f, array, LocalKind::Input), out = t.local(f, array, LocalKind::Output),
                   i = t.local(f, of(TypeKind::Lint), LocalKind::Local);
    const auto lint = of(TypeKind::Lint);
    t.add(f, t.forLoop(t.local(i, lint), t.constant(lint, 0), t.constant(lint, 3), t.constant(lint, 1),
                       {t.assign(t.element(t.local(0, array), {t.load(t.local(i, lint))}),
                                 t.binary(BinaryOp::Multiply,
                                          t.load(t.element(t.local(in, array), {t.load(t.local(i, lint))})),
                                          t.constant(dint, 2)))}));
    t.add(f, t.assign(t.local(out, array), t.load(t.local(in, array))));
    t.add(f, t.assign(t.element(t.local(in, array), {index(t, 0)}), t.constant(dint, 99))); // the caller's stays
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(c, array), t.call(f, {{in, ArgumentMode::Input, t.load(t.at(a, array)), nullptr},
                                                    {out, ArgumentMode::Output, nullptr, t.at(a, array)}})));
    Place* temporary = t.at(0, array);
    temporary->kind = tree::PlaceKind::Temporary;
    temporary->value = t.call(f, {{in, ArgumentMode::Input,
                                   t.call(f, {{in, ArgumentMode::Input, t.load(t.at(a, array)), nullptr}}), nullptr}});
    t.add(main, t.assign(t.at(e, dint), t.load(t.element(temporary, {index(t, 3)}))));
    t.add(main, t.assign(t.at(kept, dint), t.load(t.element(t.at(a, array), {index(t, 0)}))));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    for (int32_t n = 0; n < 4; ++n) EXPECT_EQ(2 * (n + 1), t.get<int32_t>(c + 4 * static_cast<uint32_t>(n)));
    EXPECT_EQ(16, t.get<int32_t>(e));
    EXPECT_EQ(1, t.get<int32_t>(kept));
}

TEST(Places, UnionMembersShareTheirBytesInOptimisedCodeToo) {
    Bench t;
    const auto real = of(TypeKind::Real), dword = of(TypeKind::Dword);
    const TypeId both = t.types.declare(TypeKind::Union, "Both");
    Field a, c;
    a.name = "r";
    a.type = real;
    c.name = "w";
    c.type = dword;
    t.types.edit(both).fields = {a, c};
    t.types.layoutFields(both);
    const uint32_t u = t.global(both), w = t.global(dword);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.field(t.at(u, both), 0, dword), t.constant(dword, 7)));
    t.add(main, t.assign(t.field(t.at(u, both), 0, real), t.real(real, 1.0)));
    t.add(main, t.assign(t.at(w, dword), t.load(t.field(t.at(u, both), 0, dword))));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(0x3f800000u, t.get<uint32_t>(w));
}

// ---------------------------------------------------------------- texts

TEST(Texts, AreCutToTheCapacityOfTheirVariable) {
    Bench t;
    const TypeId s5 = t.types.string(5), s20 = t.types.string(20);
    const uint32_t a = t.global(s5), guard = t.global(of(TypeKind::Lword)), c = t.global(s20),
                   n = t.global(of(TypeKind::Int));
    t.set<uint64_t>(guard, UINT64_MAX);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(c, s20), t.textConstant("Structured Text")));
    t.add(main, t.assign(t.at(a, s5), t.load(t.at(c, s20))));
    t.add(main,
          t.assign(t.at(n, of(TypeKind::Int)), t.intrinsic(Intrinsic::Len, of(TypeKind::Int), {t.load(t.at(a, s5))})));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ("Struc", t.text(a));
    EXPECT_EQ(5, t.get<int16_t>(n));
    EXPECT_EQ(UINT64_MAX, t.get<uint64_t>(guard));
}

TEST(Texts, ConcatIntoAnOperandOfItsOwn) {
    Bench t;
    const TypeId s = t.types.string(20);
    const uint32_t a = t.global(s), c = t.global(s), d = t.global(s);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(a, s), t.textConstant("ab")));
    t.add(main, t.assign(t.at(a, s), t.intrinsic(Intrinsic::Concat, s,
                                                 {t.load(t.at(a, s)), t.textConstant("-"), t.textConstant("c")})));
    t.add(main, t.assign(t.at(c, s), t.textConstant("x")));
    t.add(main, t.assign(t.at(c, s), t.intrinsic(Intrinsic::Concat, s,
                                                 {t.textConstant("<"), t.load(t.at(c, s)), t.load(t.at(c, s))})));
    t.add(main,
          t.assign(t.at(d, s), t.intrinsic(Intrinsic::Mid, s,
                                           {t.intrinsic(Intrinsic::Concat, s, {t.load(t.at(a, s)), t.load(t.at(c, s))}),
                                            t.constant(of(TypeKind::Int), 3), t.constant(of(TypeKind::Int), 4)})));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ("ab-c", t.text(a));
    EXPECT_EQ("<xx", t.text(c));
    EXPECT_EQ("c<x", t.text(d));
}

TEST(Texts, ConvertToNumbersAndBackWithEno) {
    Bench t;
    const TypeId s = t.types.string(20);
    const auto dint = of(TypeKind::Dint), boolean = of(TypeKind::Bool), real = of(TypeKind::Real);
    const uint32_t n = t.global(dint), good = t.global(boolean), bad = t.global(boolean), x = t.global(s),
                   y = t.global(s), m = t.global(dint);
    t.set<uint8_t>(bad, 1);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(n, dint), t.convert(t.textConstant("1234"), dint, t.at(good, boolean))));
    t.add(main, t.assign(t.at(m, dint), t.convert(t.textConstant("abc"), dint, t.at(bad, boolean))));
    t.add(main, t.assign(t.at(x, s), t.convert(t.load(t.at(n, dint)), s)));
    t.add(main, t.assign(t.at(y, s), t.convert(t.real(real, 0.1), s)));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(1234, t.get<int32_t>(n));
    EXPECT_EQ(0, t.get<int32_t>(m));
    EXPECT_EQ(1, t.get<uint8_t>(good));
    EXPECT_EQ(0, t.get<uint8_t>(bad));
    EXPECT_EQ("1234", t.text(x));
    EXPECT_EQ("0.1", t.text(y));
}

TEST(Texts, AnElementOutsideTheTextFaults) {
    Bench t;
    const TypeId s = t.types.string(10);
    const auto character = of(TypeKind::Char);
    const uint32_t a = t.global(s), c = t.global(character), i = t.global(of(TypeKind::Lint));
    t.set<int64_t>(i, 4);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(a, s), t.textConstant("abc")));
    t.add(main, t.assign(t.character(t.at(a, s), index(t, 2)), t.constant(character, 'X')));
    t.add(main, t.assign(t.at(c, character), t.load(t.character(t.at(a, s), index(t, 0)))));
    t.add(main, t.assign(t.at(c, character), t.load(t.character(t.at(a, s), t.load(t.at(i, of(TypeKind::Lint)))))));
    EXPECT_EQ(FaultCode::StringIndex, t.runBoth(main));
    EXPECT_EQ("abX", t.text(a));
    EXPECT_EQ('a', t.get<char>(c));
    EXPECT_EQ(4, t.context.faultDetail[0]);
    EXPECT_EQ(3, t.context.faultDetail[2]);
}

TEST(Texts, TheEndMarkIsReadAndNotWritten) {
    Bench t;
    const TypeId s = t.types.string(10);
    const auto character = of(TypeKind::Char);
    const uint32_t a = t.global(s), c = t.global(character);
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(a, s), t.textConstant("abc")));
    t.add(main, t.assign(t.at(c, character), t.constant(character, 'X')));
    t.add(main, t.assign(t.at(c, character), t.load(t.character(t.at(a, s), index(t, 3)))));
    t.add(main, t.assign(t.character(t.at(a, s), index(t, 3)), t.constant(character, 'X')));
    EXPECT_EQ(FaultCode::StringIndex, t.runBoth(main));
    EXPECT_EQ("abc", t.text(a));
    EXPECT_EQ(0, t.get<char>(c));
    EXPECT_EQ(2, t.context.faultDetail[2]);
}

TEST(Texts, AreParametersAndResults) {
    Bench t;
    const TypeId s = t.types.string(10), s80 = t.types.string(80);
    const uint32_t a = t.global(s), same = t.global(of(TypeKind::Bool));
    const uint32_t f = t.function("Framed", s80);
    const uint32_t in = t.local(f, s, LocalKind::Input);
    t.add(f,
          t.assign(t.local(0, s80), t.intrinsic(Intrinsic::Concat, s80,
                                                {t.textConstant("["), t.load(t.local(in, s)), t.textConstant("]")})));
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(a, s), t.call(f, {{in, ArgumentMode::Input,
                                                 t.call(f, {{in, ArgumentMode::Input, t.textConstant("abc"), nullptr}}),
                                                 nullptr}})));
    t.add(main, t.assign(t.at(same, of(TypeKind::Bool)),
                         t.binary(BinaryOp::Equal, t.load(t.at(a, s)), t.textConstant("[[abc]]"))));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ("[[abc]]", t.text(a));
    EXPECT_EQ(1, t.get<uint8_t>(same));
}

// ---------------------------------------------------------------- objects

/// Shape (area: abstract) ← Square, Circle; both answer their number × 100.
struct Shapes {
    explicit Shapes(Bench& t) {
        shape = declare(t, "Shape", 1, {});
        square = declare(t, "Square", 2, shape);
        circle = declare(t, "Circle", 3, shape);
        interface = t.types.declare(TypeKind::Interface, "HasArea");
        t.types.edit(interface).size = t.types.edit(interface).align = 8;
        for (const TypeId type : {shape, square, circle}) t.types.edit(type).interfaces = {interface};
        abstract = method(t, "Shape.Area", shape, 0);
        t.fn(abstract).isAbstract = true;
        squareArea = method(t, "Square.Area", square, 200);
        circleArea = method(t, "Circle.Area", circle, 300);
        declared = method(t, "HasArea.Area", interface, 0);
        t.fn(declared).isAbstract = true;
        t.program.dispatch = {
            {}, {tree::FunctionId(abstract)}, {tree::FunctionId(squareArea)}, {tree::FunctionId(circleArea)}};
    }
    static TypeId declare(Bench& t, const std::string& name, uint32_t number, TypeId base) {
        const TypeId id = t.types.declare(TypeKind::Block, name);
        t.types.edit(id).blockNumber = number;
        t.types.edit(id).base = base;
        Field tag, size;
        tag.name = "tag";
        tag.type = of(TypeKind::Udint);
        size.name = "size";
        size.type = of(TypeKind::Dint);
        t.types.edit(id).fields = {tag, size};
        t.types.layoutFields(id);
        t.types.edit(id).initial.resize(t.types[id].size);
        std::memcpy(t.types.edit(id).initial.data(), &number, 4);
        return id;
    }
    uint32_t method(Bench& t, const std::string& name, TypeId owner, int64_t factor) {
        const auto dint = of(TypeKind::Dint);
        const uint32_t f = t.function(name, dint, owner);
        t.fn(f).methodSlot = 0;
        if (factor != 0)
            t.add(f, t.assign(t.local(0, dint),
                              t.binary(BinaryOp::Multiply, t.load(t.instance(4, dint)), t.constant(dint, factor))));
        return f;
    }
    TypeId shape, square, circle, interface;
    uint32_t abstract = 0, squareArea = 0, circleArea = 0, declared = 0;
};

TEST(Objects, DispatchThroughAnInterfaceFindsTheImplementation) {
    const auto dint = of(TypeKind::Dint);
    for (const int what : {0, 1, 2, 3, 4}) { // square, circle, null, no object, abstract
        Bench t;
        Shapes shapes(t);
        const uint32_t square = t.global(shapes.square), circle = t.global(shapes.circle),
                       plain = t.global(shapes.shape);
        const uint32_t i = t.global(shapes.interface), x = t.global(dint), n = t.global(dint);
        t.set<int32_t>(square + 4, 3);
        t.set<int32_t>(circle + 4, 5);
        t.set<int32_t>(n, 9999);
        const uint32_t places[] = {square, circle, 0, n, plain};
        t.set<int64_t>(i, places[what]);
        const uint32_t main = t.function("Main");
        Expr* area = t.call(shapes.declared);
        area->call->dispatch = tree::Call::Dispatch::Interface;
        area->call->interface = t.load(t.at(i, shapes.interface));
        t.add(main, t.assign(t.at(x, dint), area));
        const FaultCode wanted[] = {FaultCode::None, FaultCode::None, FaultCode::NullReference,
                                    FaultCode::ForeignReference, FaultCode::AbstractCall};
        EXPECT_EQ(wanted[what], t.runBoth(main)) << what;
        const int32_t values[] = {600, 1500, 0, 0, 0};
        EXPECT_EQ(values[what], t.get<int32_t>(x));
    }
}

TEST(Objects, AVirtualCallUsesTheInstancesOwnMethod) {
    const auto dint = of(TypeKind::Dint);
    Bench t;
    Shapes shapes(t);
    const uint32_t square = t.global(shapes.square), circle = t.global(shapes.circle), x = t.global(dint),
                   y = t.global(dint);
    t.set<int32_t>(square + 4, 3);
    t.set<int32_t>(circle + 4, 5);
    const uint32_t f = t.function("AreaOf", dint);
    const uint32_t io = t.local(f, shapes.shape, LocalKind::InOut);
    Expr* area = t.call(shapes.abstract, {}, t.local(io, shapes.shape));
    area->call->dispatch = tree::Call::Dispatch::Virtual;
    t.add(f, t.assign(t.local(0, dint), area));
    const uint32_t main = t.function("Main");
    t.add(main, t.assign(t.at(x, dint), t.call(f, {{io, ArgumentMode::InOut, nullptr, t.at(square, shapes.square)}})));
    t.add(main, t.assign(t.at(y, dint), t.call(f, {{io, ArgumentMode::InOut, nullptr, t.at(circle, shapes.circle)}})));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(600, t.get<int32_t>(x));
    EXPECT_EQ(1500, t.get<int32_t>(y));
}

TEST(Objects, AQueryGivesNullForWhatDoesNotImplementIt) {
    const auto lword = of(TypeKind::Lword);
    Bench t;
    Shapes shapes(t);
    const uint32_t square = t.global(shapes.square), circle = t.global(shapes.circle), a = t.global(lword),
                   c = t.global(lword), n = t.global(lword);
    t.set<uint64_t>(n, 77);
    const TypeId pointer = t.types.pointer(shapes.circle);
    const uint32_t main = t.function("Main");
    const auto query = [&](int64_t offset) {
        Expr* e = t.constant(pointer, 0);
        e->kind = tree::ExprKind::TryCast;
        e->a = t.constant(lword, offset);
        return e;
    };
    t.add(main, t.assign(t.at(a, lword), query(square)));
    t.add(main, t.assign(t.at(c, lword), query(circle)));
    t.add(main, t.assign(t.at(n, lword), query(1'000'000'000)));
    EXPECT_EQ(FaultCode::None, t.runBoth(main));
    EXPECT_EQ(0u, t.get<uint64_t>(a));
    EXPECT_EQ(circle, t.get<uint64_t>(c));
    EXPECT_EQ(0u, t.get<uint64_t>(n));
}

} // namespace plc::test
