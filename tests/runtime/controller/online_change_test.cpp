#include "runtime/controller/controller.h"
#include "runtime/controller/retain.h"
#include "tests/runtime/hand_made_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace plc::controller {
namespace {

using namespace std::chrono_literals;
using image::Area;
using plc::testing::at;
using plc::testing::HandMade;
using plc::testing::RuntimeContext;
using types::Dimension;
using types::Enumerator;
using types::Field;
using types::FieldSection;
using types::TypeId;
using types::TypeKind;
using types::TypeTable;
using types::Value;
using Paths = std::vector<std::string>;

void nothing(RuntimeContext*, std::byte*, uint32_t) {}

/// One version of a program: `declare` adds its variables.
std::shared_ptr<image::CompiledProgram> version(const std::function<void(HandMade&)>& declare) {
    HandMade made;
    declare(made);
    made.task("main", made.function("Main", &nothing), 10ms);
    return made.finish();
}
Value number(TypeKind kind, int64_t value) { return {TypeTable::of(kind), value}; }
TypeId ints(HandMade& made, int64_t low, int64_t high) {
    return made.types().array({Dimension{low, high}}, TypeTable::of(TypeKind::Int));
}
TypeId enumeration(HandMade& made, const std::string& name, std::vector<std::string> names) {
    const TypeId id = made.types().declare(TypeKind::Enum, name);
    types::Type& type = made.types().edit(id);
    type.element = TypeTable::of(TypeKind::Int);
    type.size = type.align = 2;
    for (size_t i = 0; i < names.size(); ++i) type.enumerators.push_back({names[i], int64_t(i), {}, {}});
    return id;
}

class OnlineChange : public ::testing::Test {
protected:
    void begin(const std::function<void(HandMade&)>& declare) { plc = std::make_unique<Controller>(version(declare)); }
    void set(const std::string& path, int64_t value) {
        const Result<void> done = plc->write(path, Value{{}, value});
        ASSERT_TRUE(done) << done.error().english();
    }
    /// A reference cannot be written from outside; programs do it.
    void refer(const std::string& path, const std::string& target) {
        const auto from = plc->program().layout.find(path);
        const auto to = plc->program().layout.find(target);
        ASSERT_TRUE(from && to);
        const uint64_t offset = to->offset;
        std::memcpy(const_cast<std::byte*>(plc->image().data()) + from->offset, &offset, 8);
    }
    uint64_t offsetOf(const std::string& path) { return plc->program().layout.find(path)->offset; }
    int64_t value(const std::string& path) {
        const Result<Value> read = plc->read(path);
        EXPECT_TRUE(read) << path;
        return read ? read->integer() : -999;
    }
    const OnlineChangeReport& change(const std::function<void(HandMade&)>& declare) {
        plc->start();
        (void)plc->scan();
        return report = plc->changeProgram(version(declare));
    }
    std::unique_ptr<Controller> plc;
    OnlineChangeReport report;
};

TEST_F(OnlineChange, KeepsWhatHasTheSamePathAndTypeAndReportsTheRest) {
    begin([](HandMade& m) {
        m.add("same", TypeKind::Int);
        m.add("retyped", TypeKind::Int);
        m.add("gone", TypeKind::Int);
        m.add("moved", TypeKind::Lreal);
    });
    for (const char* path : {"same", "retyped", "gone"}) set(path, 7);
    set("moved", 8);
    change([](HandMade& m) {
        m.add("fresh", m.types().subrange(TypeTable::of(TypeKind::Int), 3, 9));
        m.add("moved", TypeKind::Lreal);
        m.add("retyped", TypeKind::Real);
        m.add("SAME", TypeKind::Int); // names ignore case
    });
    EXPECT_EQ(value("same"), 7);
    EXPECT_EQ(plc->read("moved")->real(), 8.0);
    EXPECT_EQ(plc->read("retyped")->real(), 0.0);
    EXPECT_EQ(value("fresh"), 3);
    EXPECT_EQ(report.kept, (Paths{"moved", "SAME"}));
    EXPECT_EQ(report.initialised, (Paths{"fresh", "retyped"}));
    EXPECT_EQ(report.lost, (Paths{"retyped", "gone"}));
    EXPECT_EQ(plc->state(), State::Running);
    EXPECT_EQ(plc->nextScan(), 1u);
    EXPECT_EQ(plc->nextDue(), 10ms);
}

TEST_F(OnlineChange, ArraysKeepTheIndicesBothHave) {
    begin([](HandMade& m) {
        m.add("a", ints(m, 1, 5));
        m.add("grid", m.types().array({Dimension{0, 1}, Dimension{0, 2}}, TypeTable::of(TypeKind::Int)));
        m.add("rank", ints(m, 0, 3));
        m.add("apart", ints(m, 0, 3));
    });
    for (int i = 1; i <= 5; ++i) set("a[" + std::to_string(i) + "]", 10 + i);
    for (int r = 0; r < 2; ++r)
        for (int c = 0; c < 3; ++c) set("grid[" + std::to_string(r) + "," + std::to_string(c) + "]", 100 * r + c + 1);
    change([](HandMade& m) {
        m.add("grid", m.types().array({Dimension{0, 3}, Dimension{1, 3}}, TypeTable::of(TypeKind::Int)));
        m.add("a", ints(m, 3, 8));
        m.add("rank", m.types().array({Dimension{0, 1}, Dimension{0, 1}}, TypeTable::of(TypeKind::Int)));
        m.add("apart", ints(m, 10, 12));
    });
    EXPECT_EQ(value("a[3]"), 13);
    EXPECT_EQ(value("a[5]"), 15);
    EXPECT_EQ(value("a[6]"), 0);
    EXPECT_EQ(value("grid[0,1]"), 2);
    EXPECT_EQ(value("grid[1,2]"), 103);
    EXPECT_EQ(value("grid[1,3]"), 0);
    EXPECT_EQ(value("grid[2,1]"), 0);
    EXPECT_EQ(report.kept, (Paths{"a[3..5]"}));
    EXPECT_EQ(report.initialised, (Paths{"grid", "a[6..8]", "rank", "apart"}));
    EXPECT_EQ(report.lost, (Paths{"a[1..2]", "rank", "apart"}));
}

TEST_F(OnlineChange, NewMembersInTheMiddleOfABlockAndRenamedOnesAreSafe) {
    const auto declare = [](bool isNew) {
        return [isNew](HandMade& m) {
            const TypeId timer = m.structure(
                "TON", {HandMade::field("Q", TypeKind::Bool), HandMade::field("ET", TypeKind::Time)}, TypeKind::Block);
            const TypeId other = m.structure(
                "TOF", {HandMade::field("Q", TypeKind::Bool), HandMade::field("ET", TypeKind::Time)}, TypeKind::Block);
            std::vector<Field> fields{HandMade::field("speed", TypeKind::Int)};
            if (isNew) fields.push_back(HandMade::field("extra", timer));
            fields.push_back(HandMade::field("delay", timer));
            fields.push_back(HandMade::field("swapped", isNew ? other : timer));
            fields.push_back(HandMade::field(isNew ? "renamed" : "name", TypeKind::Int));
            const TypeId motor = m.structure("Motor", fields, TypeKind::Block);
            m.add("motors", m.types().array({Dimension{1, 2}}, motor));
        };
    };
    begin(declare(false));
    set("motors[2].speed", 50);
    ASSERT_TRUE(plc->write("motors[2].delay.ET", number(TypeKind::Time, 12345)));
    ASSERT_TRUE(plc->write("motors[2].swapped.ET", number(TypeKind::Time, 999)));
    set("motors[1].name", 4);
    change(declare(true));
    EXPECT_EQ(value("motors[2].speed"), 50);
    EXPECT_EQ(value("motors[2].delay.ET"), 12345);
    EXPECT_EQ(value("motors[2].extra.ET"), 0);
    EXPECT_EQ(value("motors[2].swapped.ET"), 0); // another block's state means nothing
    EXPECT_EQ(value("motors[1].renamed"), 0);
    EXPECT_EQ(report.kept, (Paths{"motors[1].speed", "motors[1].delay", "motors[2].speed", "motors[2].delay"}));
    EXPECT_EQ(report.lost, (Paths{"motors[1].swapped", "motors[1].name", "motors[2].swapped", "motors[2].name"}));
    EXPECT_EQ(report.initialised, (Paths{"motors[1].extra", "motors[1].swapped", "motors[1].renamed", "motors[2].extra",
                                         "motors[2].swapped", "motors[2].renamed"}));
}

TEST_F(OnlineChange, EnumsGoByNameTextsAndSubrangesByWhatFits) {
    begin([](HandMade& m) {
        const TypeId colour = enumeration(m, "Colour", {"Red", "Green", "Blue"});
        m.add("a", colour);
        m.add("b", colour);
        m.add("text", m.types().string(20));
        m.add("long", m.types().string(20));
        m.add("range", m.types().subrange(TypeTable::of(TypeKind::Int), 0, 100));
        m.add("wide", m.types().subrange(TypeTable::of(TypeKind::Int), 0, 100));
    });
    set("a", 2);
    set("b", 1);
    set("range", 50);
    set("wide", 90);
    ASSERT_TRUE(plc->write("text", Value{{}, std::string("abc")}));
    ASSERT_TRUE(plc->write("long", Value{{}, std::string("abcdefghij")}));
    change([](HandMade& m) {
        const TypeId colour = enumeration(m, "Colour", {"Black", "Red", "Blue", "White"});
        m.add("a", colour);
        m.add("b", colour);
        m.add("text", m.types().string(5));
        m.add("long", m.types().string(5));
        m.add("range", m.types().subrange(TypeTable::of(TypeKind::Int), 0, 60));
        m.add("wide", m.types().subrange(TypeTable::of(TypeKind::Int), 0, 60));
    });
    EXPECT_EQ(value("a"), 2); // Blue has another number
    EXPECT_EQ(value("b"), 0); // Green is gone
    EXPECT_EQ(plc->read("text")->data, Value({}, std::string("abc")).data);
    EXPECT_EQ(plc->read("long")->data, Value({}, std::string()).data);
    EXPECT_EQ(value("range"), 50);
    EXPECT_EQ(value("wide"), 0);
    EXPECT_EQ(report.lost, (Paths{"b", "long", "wide"}));
}

TEST_F(OnlineChange, ReferencesFollowWhatTheyPointedToOrBecomeNull) {
    const auto declare = [](bool isNew) {
        return [isNew](HandMade& m) {
            const TypeId running = m.types().declare(TypeKind::Interface, "IRunning");
            Field slot = HandMade::field("io", TypeKind::Int);
            slot.section = FieldSection::InOut;
            const TypeId motor =
                m.structure("Motor", {HandMade::field("speed", TypeKind::Int), slot}, TypeKind::Block, 8);
            m.types().edit(motor).interfaces = {running};
            m.types().edit(motor).blockNumber = isNew ? 5 : 3;
            if (isNew) m.add("before", ints(m, 0, 99));
            m.add("motors", m.types().array({Dimension{1, isNew ? 2 : 3}}, motor));
            if (!isNew) m.add("gone", TypeKind::Int);
            m.add("toElement", m.types().pointer(motor));
            m.add("toLost", m.types().pointer(motor));
            m.add("toGone", m.types().pointer(TypeTable::of(TypeKind::Int)));
            m.add("toSpeed", m.types().reference(TypeTable::of(TypeKind::Int)));
            m.add("any", running);
            m.add("bytes", m.types().pointer(TypeTable::of(TypeKind::Byte)));
            m.add("none", m.types().pointer(motor));
            m.add("wild", m.types().pointer(motor));
            for (int i = 1; i <= (isNew ? 2 : 3); ++i)
                m.initial<uint32_t>(m.layout().roots[isNew ? 1 : 0].offset + uint32_t(i - 1) * m.types()[motor].size,
                                    isNew ? 5 : 3);
        };
    };
    begin(declare(false));
    set("motors[2].speed", 77);
    refer("toElement", "motors[2]");
    refer("toLost", "motors[3]");
    refer("toGone", "gone");
    refer("toSpeed", "motors[2].speed");
    refer("any", "motors[1]");
    refer("bytes", "motors[2].speed");
    const uint64_t nowhere = 1u << 30;
    std::memcpy(const_cast<std::byte*>(plc->image().data()) + offsetOf("wild"), &nowhere, 8);
    const uint64_t speed = offsetOf("motors[1].speed");
    std::memcpy(const_cast<std::byte*>(plc->image().data()) + offsetOf("motors[2]") + 16, &speed, 8); // motors[2].io
    change(declare(true));
    EXPECT_EQ(static_cast<uint64_t>(value("toElement")), offsetOf("motors[2]"));
    EXPECT_EQ(value("toLost"), 0);
    EXPECT_EQ(value("toGone"), 0);
    EXPECT_EQ(static_cast<uint64_t>(value("toSpeed")), offsetOf("motors[2].speed"));
    EXPECT_EQ(static_cast<uint64_t>(value("any")), offsetOf("motors[1]"));
    EXPECT_EQ(static_cast<uint64_t>(value("bytes")), offsetOf("motors[2].speed"));
    EXPECT_EQ(value("none"), 0);
    EXPECT_EQ(value("wild"), 0);
    EXPECT_EQ(value("motors[2].speed"), 77);
    EXPECT_EQ(plc::testing::valueAt<uint64_t>(plc->image(), static_cast<uint32_t>(offsetOf("motors[2]")) + 16),
              offsetOf("motors[1].speed"));
    EXPECT_EQ(plc::testing::valueAt<uint32_t>(plc->image(), static_cast<uint32_t>(offsetOf("motors[2]"))),
              5u); // the new block number
    EXPECT_EQ(report.nulled, (Paths{"toLost", "toGone", "wild"}));
}

TEST_F(OnlineChange, AddressesForcesConstantsAndHiddenVariablesComeAlong) {
    const auto declare = [](bool isNew) {
        return [isNew](HandMade& m) {
            m.locate("in", TypeKind::Bool, "%IX0.3", 64, 3, Area::Input);
            m.locate("auto", TypeKind::Bool, isNew ? "%QX1.1" : "%QX1.0", 81, isNew ? 1 : 0, Area::Output);
            image::Root& limit = m.add("limit", TypeKind::Int);
            limit.constant = true;
            m.initial<int16_t>(limit.offset, isNew ? 20 : 10);
            m.add("hidden", TypeKind::Int).isHidden = true;
            m.add("forced", TypeKind::Int);
            if (!isNew) m.add("forcedToo", TypeKind::Int);
        };
    };
    begin(declare(false));
    for (const char* path : {"in", "auto", "%QX2.5", "%MB3", "hidden"}) set(path, 1);
    ASSERT_TRUE(plc->force("forced", Value{{}, int64_t(5)}));
    ASSERT_TRUE(plc->force("forcedToo", Value{{}, int64_t(5)}));
    change(declare(true));
    for (const char* path : {"in", "%IX0.3", "auto", "%QX2.5", "%MB3", "hidden"}) EXPECT_EQ(value(path), 1) << path;
    EXPECT_EQ(value("limit"), 20);
    EXPECT_EQ(value("forced"), 5);
    EXPECT_EQ(plc->forces().size(), 1u);
    EXPECT_EQ(report.lost, (Paths{"forcedToo"}));
    EXPECT_EQ(report.lostForces, (Paths{"forcedToo"}));
    for (const std::string& path : report.kept) EXPECT_NE(path, "hidden");
}

void faulty(RuntimeContext* context, std::byte*, uint32_t) {
    context->fault = image::FaultCode::DivisionByZero;
    runtimeSymbols().fault(context);
}

TEST_F(OnlineChange, AProgramWhoseInitialValuesFaultIsRefusedAndTheOldOneGoesOn) {
    begin([](HandMade& m) { m.add("x", TypeKind::Int); });
    set("x", 3);
    const auto bad = [](HandMade& m) {
        m.add("y", TypeKind::Int);
        m.program().initializer = m.function("init", &faulty);
    };
    change(bad);
    EXPECT_NE(report.refusal.english().find("division by zero"), std::string::npos);
    EXPECT_EQ(value("x"), 3);
    EXPECT_TRUE(plc->scan());
    EXPECT_EQ(plc->state(), State::Running);
    EXPECT_EQ(plc->nextScan(), 2u);
}

// Random layouts: what both versions have under one path and type is kept, bit for bit.
TEST_F(OnlineChange, RandomChangesKeepEveryValueOfSamePathAndType) {
    const char* given = std::getenv("STEPWISE_SEED");
    const unsigned start = given ? static_cast<unsigned>(std::atoi(given)) : std::random_device()();
    const TypeKind kinds[] = {TypeKind::Bool, TypeKind::Sint, TypeKind::Int, TypeKind::Dint,
                              TypeKind::Lint, TypeKind::Word, TypeKind::Time};
    for (unsigned run = 0; run < 60; ++run) {
        SCOPED_TRACE("seed " + std::to_string(start) + " run " + std::to_string(run));
        std::mt19937 dice(start + run);
        const auto declare = [&](HandMade& m) {
            for (int b = 0; b < 4; ++b) {
                std::vector<Field> fields;
                for (int f = 0; f < 6; ++f) {
                    if (dice() % 4 == 0) continue;
                    Field field = HandMade::field("f" + std::to_string(f), kinds[dice() % 7]);
                    if (dice() % 3 == 0)
                        field.type =
                            m.types().array({Dimension{int64_t(dice() % 3), int64_t(3 + dice() % 3)}}, field.type);
                    fields.push_back(field);
                }
                std::shuffle(fields.begin(), fields.end(), dice);
                if (fields.empty()) continue;
                const TypeId block = m.structure("B" + std::to_string(b), fields, TypeKind::Block);
                m.add("v" + std::to_string(b),
                      dice() % 2 ? block : m.types().array({Dimension{1, int64_t(1 + dice() % 3)}}, block));
            }
        };
        begin(declare);
        std::map<std::string, std::pair<TypeKind, int64_t>> values;
        const auto leaves = [&](auto visit) {
            const image::Layout& layout = plc->program().layout;
            for (const image::Root& root : layout.roots)
                layout.forEachLeaf(image::Layout::pathOf(root), {root.type, root.offset, root.bit},
                                   [&](const std::string& path, const image::Place& place) {
                                       visit(path, layout.types->kind(place.type));
                                       return true;
                                   });
        };
        leaves([&](const std::string& path, TypeKind kind) {
            const int64_t number = kind == TypeKind::Bool ? dice() % 2 : dice() % 127;
            ASSERT_TRUE(plc->write(path, Value{TypeTable::of(kind), number}));
            values[path] = {kind, number};
        });
        change(declare);
        leaves([&](const std::string& path, TypeKind kind) {
            const auto before = values.find(path);
            const bool isKept = before != values.end() && before->second.first == kind;
            EXPECT_EQ(value(path), isKept ? before->second.second : 0) << path;
        });
    }
}

// ---------------------------------------------------------------- the retain file

class RetainFile : public OnlineChange {
protected:
    RetainFile()
        : file((std::filesystem::temp_directory_path() / ("retain_test_" + std::to_string(::getpid()))).string()) {}
    ~RetainFile() override { std::filesystem::remove(file); }
    static std::function<void(HandMade&)> declare(bool isNew) {
        return [isNew](HandMade& m) {
            m.add("kept", TypeKind::Lreal).retain = true;
            m.add("plain", TypeKind::Int);
            m.add("retyped", isNew ? TypeKind::Dint : TypeKind::Int).retain = true;
            m.add("text", m.types().string(10)).persistent = true;
            m.add("colour", enumeration(m, "Colour",
                                        isNew ? std::vector<std::string>{"Green", "Red"}
                                              : std::vector<std::string>{"Red", "Green"}))
                .retain = true;
            m.add("list", ints(m, 1, isNew ? 3 : 2)).retain = true;
            if (!isNew) m.add("gone", TypeKind::Int).retain = true;
        };
    }
    std::string file;
};

TEST_F(RetainFile, GivesBackByPathAndTypeWhatStillFits) {
    begin(declare(false));
    ASSERT_TRUE(plc->write("kept", Value{TypeTable::of(TypeKind::Lreal), 0.1}));
    for (const char* path : {"plain", "retyped", "colour", "list[1]", "list[2]", "gone"}) set(path, 1);
    ASSERT_TRUE(plc->write("text", Value{{}, std::string("a\tb\n\xe4")}));
    ASSERT_TRUE(saveRetain(file, retainedLeaves(plc->program().layout, plc->image())));
    const auto leaves = loadRetain(file);
    ASSERT_TRUE(leaves);
    for (const bool isNew : {false, true}) {
        begin(declare(isNew));
        const RetainOutcome outcome = restoreRetained(*plc, *leaves);
        EXPECT_EQ(plc->read("kept")->real(), 0.1);
        EXPECT_EQ(value("plain"), 0);
        EXPECT_EQ(value("retyped"), isNew ? 0 : 1);
        EXPECT_EQ(plc->read("text")->data, Value({}, std::string("a\tb\n\xe4")).data);
        EXPECT_EQ(value("colour"), isNew ? 0 : 1); // Green has another number now
        EXPECT_EQ(value("list[2]"), 1);
        EXPECT_EQ(outcome.restored, isNew ? 5u : 7u);
        EXPECT_EQ(outcome.lost, isNew ? (Paths{"retyped", "gone"}) : Paths{});
    }
}

TEST_F(RetainFile, IsWrittenWholeOrNotAtAllAndADamagedOneIsRefused) {
    begin(declare(false));
    EXPECT_TRUE(loadRetain(file) && loadRetain(file)->empty()); // no file yet
    ASSERT_TRUE(saveRetain(file, retainedLeaves(plc->program().layout, plc->image())));
    EXPECT_FALSE(std::filesystem::exists(file + ".new"));
    std::ifstream in(file, std::ios::binary);
    const std::string good((std::istreambuf_iterator<char>(in)), {});
    for (size_t i = 0; i < good.size() - 1; i += 3) {
        std::string bad = good;
        bad[i] ^= 0x11;
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bad;
        EXPECT_FALSE(loadRetain(file)) << "byte " << i;
        std::ofstream(file, std::ios::binary | std::ios::trunc) << good.substr(0, i);
        EXPECT_FALSE(loadRetain(file)) << "cut at " << i;
    }
    EXPECT_FALSE(saveRetain("/nonexistent/retain", {}));
}

} // namespace
} // namespace plc::controller
