// After a fault the text selects what an engineer asks about first, so that Why? asks just that.
#include "app/pages/fault_cause.h"
#include "tests/app/studio_fixture.h"

#include <QAction>

namespace plc::app {
namespace {

using image::FaultCode;

TEST(FaultCause, IsTheOnlyOperandThatMayBeMeant) {
    struct Row {
        FaultCode code;
        const char *statement, *cause;
    };
    for (const Row& row : {
             Row{FaultCode::DivisionByZero, "a := 10 / b;", "b"},
             Row{FaultCode::DivisionByZero, "a := b MOD c.d[i + 1].e + 2;", "c.d[i + 1].e"},
             Row{FaultCode::DivisionByZero, "a := 1 / (b - c);", "(b - c)"},
             Row{FaultCode::DivisionByZero, "a := 1 / F(b) / 2;", "F(b)"},
             Row{FaultCode::DivisionByZero, "a := 1 / p^.b;", "p^.b"},
             Row{FaultCode::DivisionByZero, "a := b / c / d;", ""},
             Row{FaultCode::DivisionByZero, "a := b / 2;", ""},
             Row{FaultCode::DivisionByZero, "a := b;", ""},
             Row{FaultCode::DivisionByZero, "a := b /", ""},
             Row{FaultCode::DivisionByZero, "a := b / (c", "(c"},
             Row{FaultCode::DivisionByZero, "// x / y\na := b / c;", "c"},
             Row{FaultCode::IndexOutOfRange, "a[i] := 3;", "i"},
             Row{FaultCode::IndexOutOfRange, "a[2] := b[i + 1];", "i + 1"},
             Row{FaultCode::IndexOutOfRange, "a[i] := a[i] + 1;", "i"},
             Row{FaultCode::IndexOutOfRange, "m[1, row.at[3]] := 0;", "row.at[3]"},
             Row{FaultCode::IndexOutOfRange, "m[F(1, 2), 4] := 0;", "F(1, 2)"},
             Row{FaultCode::IndexOutOfRange, "m[i, j] := 0;", ""},
             Row{FaultCode::IndexOutOfRange, "a[b[i]] := 0;", ""},
             Row{FaultCode::IndexOutOfRange, "p^[n] := [1, x, 2];", "n"},
             Row{FaultCode::IndexOutOfRange, "a[-1] := 0;", ""},
             Row{FaultCode::StringIndex, "c := s[n * 10];", "n * 10"},
             Row{FaultCode::NullReference, "p^ := 3;", "p"},
             Row{FaultCode::NullReference, "x := a.list[2].next^.value;", "a.list[2].next"},
             Row{FaultCode::NullReference, "x := p^.next^.value;", ""},
             Row{FaultCode::NullReference, "a[i^] := p;", "i"},
             Row{FaultCode::NullReference, "x := y;", ""},
             Row{FaultCode::ForeignReference, "p^.value := q;", "p"},
             Row{FaultCode::ValueOutOfRange, "r := i;", "i"},
             Row{FaultCode::ValueOutOfRange, "r := F(i, 2) + 1;", "F(i, 2) + 1"},
             Row{FaultCode::ValueOutOfRange, "pump(speed := i + 1, run := TRUE);", "i + 1"},
             Row{FaultCode::ValueOutOfRange, "pump(speed := i, slow := j);", ""},
             Row{FaultCode::ValueOutOfRange, "FOR r := 0 TO n", ""},
             Row{FaultCode::Watchdog, "WHILE go", "go"},
             Row{FaultCode::Watchdog, "WHILE NOT pump.done DO x := 1;", "pump.done"},
             Row{FaultCode::Watchdog, "WHILE a < b OR c", "a < b OR c"},
             Row{FaultCode::Watchdog, "UNTIL i > 10", "i"},
             Row{FaultCode::Watchdog, "FOR k := 0 TO n BY 2", "n"},
             Row{FaultCode::Watchdog, "x := F(y);", ""},
             Row{FaultCode::StackOverflow, "x := F(y);", ""},
         }) {
        const std::string_view text = row.statement;
        const auto found = causeOfFault(row.code, text);
        EXPECT_EQ(found ? text.substr(found->first, found->second) : "", row.cause) << text;
    }
}

TEST(FaultCause, NamesThatAreFollowedWithoutACaretAreReferences) {
    for (const auto& [statement, cause] :
         {std::pair{"q := 3;", "q"}, std::pair{"x := a.q + 1;", "a.q"}, std::pair{"q.Run(x := 1);", "q"},
          std::pair{"q REF= x;", ""}, std::pair{"x := q + q;", "q"}, std::pair{"x := q + a.q;", ""}}) {
        const std::string_view text = statement;
        const auto found = causeOfFault(FaultCode::NullReference, text, [&](uint32_t begin, uint32_t end) {
            return text.substr(begin, end - begin) == "q";
        });
        EXPECT_EQ(found ? text.substr(found->first, found->second) : "", cause) << text;
    }
}

struct FaultRow {
    const char* name;
    const char* declarations; // in front of the program
    const char* variables;
    const char* statement;
    const char* cause;
};

const FaultRow kFaultRows[] = {
    {"Index", "", "a : ARRAY[1..3] OF INT; n : INT := 3;", "n := n + 1; a[n] := 1;", "n"},
    {"Character", "", "s : STRING := 'abc'; c : BYTE; n : INT := 2;", "n := n + 1; c := s[n];", "n"},
    {"Pointer", "", "p : POINTER TO INT;", "p^ := 1;", "p"},
    {"Reference", "", "r : REFERENCE TO INT;", "r := 1;", "r"},
    {"Interface",
     "INTERFACE IPump METHOD Run END_METHOD END_INTERFACE FUNCTION_BLOCK Pump IMPLEMENTS IPump METHOD Run END_METHOD "
     "END_FUNCTION_BLOCK",
     "pump : IPump; p : Pump;", "pump.Run();", "pump"},
    {"Subrange", "TYPE Percent : INT(0..100); END_TYPE", "n : INT := 100; p : Percent;", "n := n + 1; p := n;", "n"},
};

class FaultCauseTest : public StudioTest, public ::testing::WithParamInterface<FaultRow> {};

TEST_P(FaultCauseTest, IsSelectedSoThatWhyAsksAboutIt) {
    const FaultRow& row = GetParam();
    const std::string text = std::string(row.declarations) + "\nPROGRAM Main\nVAR\n" + row.variables + "\nEND_VAR\n" +
                             row.statement + "\nEND_PROGRAM\n";
    editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, text}});
    analysed();
    window->action("file.save")->trigger();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Fault; }));
    ASSERT_TRUE(waitFor([&] { return editor().selectedText() == row.cause; }))
        << editor().selectedText().toStdString() << " " << window->control().status().fault->message.english();
    const auto asked = editor().askedAbout();
    ASSERT_TRUE(asked);
    EXPECT_EQ(asked->name, row.cause);
}

INSTANTIATE_TEST_SUITE_P(All, FaultCauseTest, ::testing::ValuesIn(kFaultRows),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace
} // namespace plc::app
