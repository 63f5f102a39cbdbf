// Programs with a large image mark what they write, and the recording looks at nothing else: every recorded image must
// still be the image.
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <gtest/gtest.h>

namespace plc::session {
namespace {

const char* const kProgram = R"(
TYPE Item : STRUCT id : DINT; name : STRING(30); wide : WSTRING(12); values : ARRAY[0..9] OF LREAL; END_STRUCT; END_TYPE
FUNCTION Fill : DINT
VAR_IN_OUT data : ARRAY[*] OF INT; END_VAR
VAR_INPUT value : INT; END_VAR
VAR i : DINT; END_VAR
  FOR i := LOWER_BOUND(data, 1) TO UPPER_BOUND(data, 1) DO data[i] := value + DINT_TO_INT(i); END_FOR
  Fill := i;
END_FUNCTION
FUNCTION_BLOCK Worker
VAR_INPUT n : DINT; END_VAR
VAR_IN_OUT item : Item; END_VAR
VAR_OUTPUT done : BOOL; END_VAR
VAR pad : ARRAY[0..999] OF BYTE; copy : Item; text : STRING(200); p : REF_TO DINT; END_VAR
  item.id := n;
  item.name := CONCAT('item ', DINT_TO_STRING(n));
  item.values[n MOD 10] := DINT_TO_LREAL(n) * 1.5;
  IF n MOD 7 = 0 THEN copy := item; END_IF
  text := REPLACE(text, item.name, 3, 2);
  IF LEN(text) > 150 THEN text := ''; END_IF
  p := REF(item.id);
  p^ := p^ + 1;
  pad[n MOD 1000].3 := NOT pad[n MOD 1000].3;
  done := n MOD 2 = 0;
END_FUNCTION_BLOCK
PROGRAM Main
VAR
  table : ARRAY[0..49999] OF INT; items : ARRAY[1..300] OF Item; workers : ARRAY[1..20] OF Worker;
  matrix : ARRAY[0..99, 0..99] OF REAL; big : ARRAY[0..20000] OF BOOL; other : ARRAY[0..20000] OF BOOL; n : DINT; i : DINT; ws : WSTRING(5000); t : ARRAY[1..50] OF TON;
  lamp AT %QX0.0 : BOOL;
END_VAR
  n := n + 1;
  table[(n * 7919) MOD 50000] := DINT_TO_INT(n);
  IF n MOD 50 = 0 THEN Fill(data := table, value := DINT_TO_INT(n)); END_IF
  FOR i := 1 TO 20 DO workers[i](n := n + i, item := items[(n * 31 + i * 17) MOD 300 + 1]); END_FOR
  FOR i := 0 TO 99 DO matrix[n MOD 100, i] := DINT_TO_REAL(n + i) / 3.0; END_FOR
  IF n MOD 20 = 0 THEN other := big; END_IF
  IF n MOD 33 = 0 THEN FOR i := 0 TO 20000 DO big[i] := FALSE; END_FOR END_IF
  big[(n * 13) MOD 20001] := TRUE;
  ws := CONCAT(ws, "x");
  t[n MOD 50 + 1](IN := TRUE, PT := T#1s);
  lamp := NOT lamp;
  items[300] := items[n MOD 299 + 1];
END_PROGRAM
)";

driver::Built build() {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back({"main.st", kProgram});
    driver::Built built = driver::build(input);
    std::string messages;
    for (const auto& d : built.checked.analysis->diagnostics) messages += d.message.english() + "\n";
    EXPECT_TRUE(built.program) << messages << built.failure.english();
    return built;
}

TEST(LargeImages, EveryRecordedImageIsTheImageInBothTiers) {
    for (const bool isOptimised : {false, true}) {
        Session session(build());
        ASSERT_TRUE(session.program());
        EXPECT_GT(session.program()->layout.dataEnd, 250'000u);
        EXPECT_TRUE(session.program()->quick->marksWrites);
        if (isOptimised) {
            ASSERT_TRUE(driver::optimise(session.built()));
        }
        controller::Controller& plc = session.controller();
        plc.start();
        const uint32_t dataEnd = session.program()->layout.dataEnd;
        for (int scan = 0; scan < 400; ++scan) {
            if (scan == 100) {
                ASSERT_TRUE(plc.force("Main.table[49999]", types::Value{{}, int64_t(5)}));
            }
            if (scan == 150) {
                ASSERT_TRUE(plc.release("Main.table[49999]"));
            }
            if (scan % 37 == 5) {
                ASSERT_TRUE(plc.write("Main.matrix[50,50]",
                                      types::Value{types::TypeTable::of(types::TypeKind::Lreal), scan * 0.5}));
            }
            if (scan == 200) {
                plc.stop();
                plc.start();
            }
            if (scan == 250) plc.reset(controller::ResetKind::Warm), plc.start();
            ASSERT_TRUE(plc.scan()) << plc.fault()->message.english();
            const std::vector<std::byte> recorded = session.history().seek(session.history().statistics().end - 1);
            ASSERT_EQ(recorded.size(), plc.image().size());
            for (uint32_t at = 0; at < dataEnd; ++at)
                ASSERT_EQ(recorded[at], plc.image()[at]) << session.program()->layout.pathAt(at) << " in scan " << scan
                                                         << (isOptimised ? ", optimised" : ", quick");
        }
        EXPECT_FALSE(plc.dirtyPages().empty());
        EXPECT_GT(plc.read("Main.n")->integer(), 100);
    }
}

} // namespace
} // namespace plc::session
