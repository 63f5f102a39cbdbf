// All libraries together: namespaces, warnings, examples in the comments, every block called once.
#include "tests/library/bench.h"
#include "tests/library/library_texts.h"

#include <gtest/gtest.h>

namespace plc::test {
namespace {

const std::vector<std::string> everything{"analog", "plant", "toolbox", "util", "workshop"};

TEST(Namespaces, TellBlocksOfTheSameNameApart) {
    Bench bench(
        "VAR u : Util.INTEGRAL; a : Analog.INTEGRAL; p : Analog.PID; q : Util.PID; h : Util.HYSTERESIS; g : "
        "Analog.HYSTERESIS; END_VAR",
        "u(IN := 3.0, TM := 1000, RESET := FALSE); a(RUN := TRUE, R1 := FALSE, XIN := 2.0, X0 := 0.0, CYCLE := T#1s);\n"
        "p(AUTO := TRUE, PV := 5.0, SP := 0.0, X0 := 0.0, KP := 1.0, TR := 1.0, TD := 0.0, CYCLE := T#1s);\n"
        "q(ACTUAL := 0.0, SET_POINT := 1.0, KP := 2.0, TN := 0.0); h(IN := 1, HIGH := 5, LOW := 2); g(XIN1 := 1.0, "
        "XIN2 := 2.0, EPS := 0.5);",
        everything);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("u.OUT"), 3.0);
    EXPECT_DOUBLE_EQ(bench.real("a.XOUT"), 2.0);
    EXPECT_DOUBLE_EQ(bench.real("p.XOUT"), 10.0) << "its parts are those of its own library";
    EXPECT_DOUBLE_EQ(bench.real("q.Y"), 2.0);
    EXPECT_TRUE(bench.is("h.OUT"));
    EXPECT_FALSE(bench.is("g.Q"));
}

TEST(Namespaces, ANameOfTwoLibrariesNeedsOne) {
    try {
        buildText(programText("VAR p : PID; END_VAR", "p();", 10ms), {"analog", "util"});
        ADD_FAILURE() << "PID alone says neither";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("Analog"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("Util"), std::string::npos) << error.what();
    }
}

TEST(Libraries, CompileWithoutAWarning) {
    driver::BuildInput input;
    input.files.push_back({"bench.st", programText("", ";", 10ms)});
    input.libraries = everything;
    const driver::Checked checked = driver::check(input);
    for (const diagnostics::Diagnostic& diagnostic : checked.analysis->diagnostics)
        if (diagnostic.severity != diagnostics::Severity::Info)
            ADD_FAILURE() << diagnostics::renderText(*checked.sources, diagnostic, false);
}

TEST(Libraries, EveryBlockAndFunctionRunsWithItsDefaults) {
    std::string declarations = "VAR\n", body;
    int number = 0;
    std::vector<std::string> names{"standard"};
    names.insert(names.end(), everything.begin(), everything.end());
    for (const std::string& name : names) {
        const ParsedLibrary parsed = parseLibrary(name);
        for (const auto& [folded, entry] : parsed.pous) {
            const auto& [pou, file] = entry;
            const std::string variable = "v" + std::to_string(number++),
                              qualified = library::namespaceOf(name) + "." + std::string(pou->name.text);
            std::string arguments;
            for (const syntax::VarSection* section : pou->sections) {
                const bool isInOut = section->kind == syntax::SectionKind::InOut;
                if (!isInOut &&
                    !(section->kind == syntax::SectionKind::Input && pou->kind == syntax::PouKind::Function))
                    continue;
                for (const syntax::VarDecl* pin : section->declarations) {
                    std::string type(file->source.text.substr(pin->type->range.begin, pin->type->range.length()));
                    if (pin->type->kind == syntax::TypeSpecKind::OpenArray)
                        type = "ARRAY[0..3] OF " + std::string(type.ends_with("LREAL") ? "LREAL" : "REAL");
                    if (type == "ARRAY[0..10] OF POINT") type = "ARRAY[0..10] OF Util.POINT";
                    if (parsed.types.contains(foldCase(type))) type = library::namespaceOf(name) + "." + type;
                    const std::string argument = "v" + std::to_string(number++);
                    declarations += argument + " : " + type + ";\n";
                    arguments += (arguments.empty() ? "" : ", ") + std::string(pin->names[0].text) + " := " + argument;
                }
            }
            if (pou->kind == syntax::PouKind::FunctionBlock) {
                declarations += variable + " : " + qualified + ";\n";
                body += variable + "(" + arguments + ");\n";
            } else {
                body += qualified + "(" + arguments + ");\n";
            }
        }
    }
    EXPECT_GT(number, 200);
    Bench bench(declarations + "END_VAR", body, everything, 100ms);
    bench.scan(50);
}

TEST(DocComments, HoldExamplesThatParse) {
    for (const std::string_view name : library::libraries()) {
        const ParsedLibrary parsed = parseLibrary(name);
        for (const auto& [folded, entry] : parsed.pous) {
            const std::string comment(entry.first->comment);
            const size_t begin = comment.find("Example:");
            bool isHidden = false;
            for (const syntax::Pragma& pragma : entry.first->pragmas)
                isHidden |= pragma.isAttribute && pragma.key == "hide";
            if (isHidden || name == "standard") continue;
            ASSERT_NE(begin, std::string::npos) << folded << " has no example";
            size_t end = comment.find("Corrected:", begin);
            if (end == std::string::npos) end = comment.size();
            const std::string example = comment.substr(begin + 8, end - begin - 8);
            diagnostics::Sink sink;
            syntax::SyntaxFile file;
            static_cast<void>(parse::parseStatements(file, example, sink));
            EXPECT_FALSE(sink.hasErrors()) << name << '.' << folded << ": " << example
                                           << (sink.all().empty() ? "" : sink.all()[0].message.english());
        }
    }
}

} // namespace
} // namespace plc::test
