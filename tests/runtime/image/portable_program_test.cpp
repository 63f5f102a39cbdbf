// A compiled program as bytes: nothing is lost on the way, and bytes that are no program are refused.
#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "runtime/image/portable_program.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

namespace plc {
namespace {

const char* const kSource = "TYPE Colour : (Red, Green := 5) INT; END_TYPE\n"
                            "TYPE Pair : STRUCT a : INT := 3; b : ARRAY[1..2, 0..3] OF REAL; END_STRUCT END_TYPE\n"
                            "TYPE Small : INT(1..9); END_TYPE\n"
                            "FUNCTION_BLOCK Motor\nVAR_INPUT go : BOOL; END_VAR\nVAR_OUTPUT n : DINT; END_VAR\n"
                            "IF go THEN n := n + 1; END_IF;\nEND_FUNCTION_BLOCK\n"
                            "PROGRAM Main\nVAR\n    c : Colour := Green;\n    p : Pair;\n    s : STRING(12) := 'abc';\n"
                            "    w : WSTRING := \"ü\";\n    m : Motor;\n    k : Small := 4;\n    r : REF_TO Motor;\n"
                            "    out AT %QX0.3 : BOOL;\nEND_VAR\nVAR RETAIN kept : LREAL := 1.5; END_VAR\n"
                            "r := REF(m);\nm(go := TRUE);\nout := m.n > 3;\nEND_PROGRAM\n";

image::PortableProgram portable() {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back({"main.st", kSource});
    const driver::Built built = driver::build(input);
    EXPECT_TRUE(built.program);
    return {built.program, "Ünit", 123, {{"main.st", kSource}}, {"util", "#Define"}, {{"util/x.st", "text"}}};
}

TEST(PortableProgram, HasEverythingButTheCode) {
    const image::PortableProgram before = portable();
    const std::string bytes = image::toBytes(before);
    const auto after = image::fromBytes(bytes);
    ASSERT_TRUE(after);
    EXPECT_EQ(image::toBytes(*after), bytes);
    EXPECT_EQ(after->name, before.name);
    EXPECT_EQ(after->calendarStartNs, before.calendarStartNs);
    EXPECT_EQ(after->sources, before.sources);
    EXPECT_EQ(after->libraries, before.libraries);
    EXPECT_EQ(after->libraryTexts, before.libraryTexts);
    EXPECT_EQ(after->program->initialImage, before.program->initialImage);
    EXPECT_EQ(after->program->version, before.program->version);
    EXPECT_EQ(after->program->tasks.size(), before.program->tasks.size());
    EXPECT_FALSE(after->program->quick);
}

TEST(PortableProgram, ItsVariablesAreFoundAndShownAsBefore) {
    const image::PortableProgram before = portable();
    const auto after = image::fromBytes(image::toBytes(before));
    ASSERT_TRUE(after);
    const image::Layout &a = before.program->layout, &b = after->program->layout;
    for (const char* path : {"Main.c", "Main.p", "Main.p.b[2,3]", "Main.s", "Main.w", "Main.m.n", "Main.k", "Main.r",
                             "Main.kept", "%QX0.3", "main.OUT"}) {
        const auto here = a.find(path), there = b.find(path);
        ASSERT_TRUE(here && there) << path;
        EXPECT_EQ(*here, *there) << path;
        const auto shown = [&](const image::PortableProgram& p, const image::Place& place) {
            const std::span<const std::byte> image(p.program->initialImage);
            return types::toText(*p.program->layout.types, types::readValue(*p.program->layout.types, place.type,
                                                                            image.subspan(place.offset), place.bit));
        };
        EXPECT_EQ(shown(before, *here), shown(*after, *there)) << path;
    }
    EXPECT_EQ(a.types->referenceText(a.find("Main.r")->type, a.find("Main.m")->offset),
              b.types->referenceText(b.find("Main.r")->type, b.find("Main.m")->offset));
    EXPECT_EQ(b.types->referenceText(b.find("Main.r")->type, b.find("Main.m")->offset), "Main.m");
}

TEST(PortableProgram, BytesThatAreNoProgramAreRefused) {
    const std::string bytes = image::toBytes(portable());
    EXPECT_FALSE(image::fromBytes(""));
    EXPECT_FALSE(image::fromBytes("PRGRAM02"));
    EXPECT_FALSE(image::fromBytes(bytes + "x"));
    for (size_t size = 0; size < bytes.size(); size += 1 + kFewer * size / 50)
        EXPECT_FALSE(image::fromBytes(std::string_view(bytes).substr(0, size))) << size;
    for (size_t at = 0; at < bytes.size(); at += 7 * kFewer * kFewer) { // whatever it makes of it, it comes back
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
        (void)image::fromBytes(damaged);
    }
}

} // namespace
} // namespace plc
