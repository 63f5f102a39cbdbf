#include "runtime/compiler/format/format.h"
#include "tests/support/paths.h"

#include "runtime/compiler/parse/parser.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

using namespace plc;
using format::FormatOptions;
namespace fs = std::filesystem;

namespace {

std::string readFile(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string tidy(std::string_view text, FormatOptions options = {}) { return format::format(text, options); }

/// The tokens and comments, words in lower case, one after the other.
std::string contents(std::string_view text) {
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(0), text, sink);
    std::string out;
    size_t comment = 0;
    for (const lex::Token& token : list.tokens) {
        for (; comment < list.comments.size() && list.comments[comment].begin < token.begin; ++comment) {
            std::string_view c =
                text.substr(list.comments[comment].begin, list.comments[comment].end - list.comments[comment].begin);
            while (!c.empty() && (c.back() == ' ' || c.back() == '\t')) c.remove_suffix(1);
            out += "|" + std::string(c);
        }
        out += "|";
        for (char c : text.substr(token.begin, token.end - token.begin))
            out += static_cast<char>(lex::isKeyword(token.kind) || token.soft != lex::SoftWord::None
                                         ? std::tolower(static_cast<unsigned char>(c))
                                         : c);
    }
    return out;
}

std::vector<fs::path> examples() {
    std::vector<fs::path> out;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(plc::sourceDir()) / "projects/examples"))
        if (entry.path().extension() == ".st") out.push_back(entry.path());
    return out;
}

std::vector<fs::path> texts() {
    std::vector<fs::path> out;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(plc::sourceDir()) / "runtime/library/st"))
        if (entry.path().extension() == ".st") out.push_back(entry.path());
    for (const fs::path& path : examples()) out.push_back(path);
    if (const char* corpus = std::getenv("STEPWISE_CORPUS"))
        for (const auto& entry : fs::directory_iterator(fs::path(corpus) / "st")) out.push_back(entry.path());
    return out;
}

} // namespace

TEST(Format, TidiesBlanksCaseAndIndentation) {
    EXPECT_EQ(tidy("program  p\nvar\n a:int:=3; (* one *)\nlonger   :  BOOL;// two\nend_var\nif  a>3 and not longer "
                   "then\nf( a,b:=-1,c=>d );\nelsif x then\ny:=z [1 , 2].q ^;\n   else\n\n\n\ng();\nend_if;\n"
                   "case s of\n1,2 ..4 :a:=1;\nred: b := AND (a,b);\nelse\nc:=1;\nend_case\nfor i:=1 to 3 do\nx:=INT# "
                   "5+- 3;\nend_for\nend_program"),
              "PROGRAM p\nVAR\n    a : int := 3;  (* one *)\n    longer : BOOL; // two\nEND_VAR\nIF a > 3 AND NOT "
              "longer THEN\n    f(a, b := -1, c => d);\nELSIF x THEN\n    y := z[1, 2].q^;\nELSE\n\n    g();\nEND_IF;\n"
              "CASE s OF\n    1, 2..4: a := 1;\n    red: b := AND(a, b);\nELSE\n    c := 1;\nEND_CASE\nFOR i := 1 TO 3 "
              "DO\n    x := INT#5 + -3;\nEND_FOR\nEND_PROGRAM\n");
}

TEST(Format, KnowsChartsTypesAndConfigurations) {
    EXPECT_EQ(tidy("type a:(red,\ngreen:=2)int;\ns:struct\nx:array [1..3] of int;\nend_struct\nend_type\nprogram "
                   "p\ninitial_step S0{minTime := T#1s} :\na( N );b(D,T#1s);\nend_step\ntransition t1(priority:=1) "
                   "from S0 to( S0 , S1 ):=x;\nend_transition\naction a :\nx:=1;\nend_action\nend_program\n"
                   "configuration c\nresource r on cpu\ntask t( interval:=T#1s );\nprogram q with t : p( i:=%IX0.0 "
                   ");\nend_resource\nend_configuration\ntest 'x'\nrun 3 scans;\nassert a=b,'m';\nend_test\n"),
              "TYPE a : (red,\n    green := 2) int;\ns : STRUCT\n    x : ARRAY[1..3] OF int;\n"
              "END_STRUCT\nEND_TYPE\nPROGRAM p\nINITIAL_STEP S0 {minTime := T#1s}:\n    a(N); b(D, T#1s);\nEND_STEP\n"
              "TRANSITION t1 (PRIORITY := 1) FROM S0 TO (S0, S1) := x;\nEND_TRANSITION\nACTION a:\n    x := "
              "1;\nEND_ACTION\nEND_PROGRAM\n"
              "CONFIGURATION c\n    RESOURCE r ON cpu\n        TASK t(interval := T#1s);\n        PROGRAM q WITH t : "
              "p(i := %IX0.0);\n    END_RESOURCE\nEND_CONFIGURATION\nTEST 'x'\nRUN 3 SCANS;\nASSERT a = b, "
              "'m';\nEND_TEST\n");
}

TEST(Format, IndentsTheThreePartsOfACaughtFault) {
    EXPECT_EQ(tidy("program p\n__try\na:=b/c; // may fault\nif a>3 then\n__try\nd:=1;\n__catch(code)\nd:=2;\n__endtry\n"
                   "end_if\n__catch( code )\na:=0;\n__finally\nn:=n+1;\n__endtry\nend_program"),
              "PROGRAM p\n__TRY\n    a := b / c; // may fault\n    IF a > 3 THEN\n        __TRY\n            d := 1;\n"
              "        __CATCH(code)\n            d := 2;\n        __ENDTRY\n    END_IF\n__CATCH(code)\n    a := 0;\n"
              "__FINALLY\n    n := n + 1;\n__ENDTRY\nEND_PROGRAM\n");
}

TEST(Format, LeavesTestsActionsAndNamedTypesAsDeepAsTheirUnits) {
    const std::string text =
        "TYPE Point :\nSTRUCT\n    x, y : REAL;\nEND_STRUCT\nEND_TYPE\nPROGRAM p\nVAR\n    a : INT;\n"
        "END_VAR\nIF a > 3 THEN\n    Count();\nEND_IF\n\nACTION Count:\na := a + 1;\nIF a > 5 THEN\n"
        "    a := 0;\nEND_IF\nEND_ACTION\nEND_PROGRAM\nTEST 'counts'\nVAR\n    n : INT;\nEND_VAR\n"
        "RUN 3 SCANS;\nFOR n := 1 TO 3 DO\n    ASSERT p.a > 0;\nEND_FOR\nEND_TEST\n";
    EXPECT_EQ(tidy(text), text);
}

TEST(Format, ExamplesStandAsItLeavesThem) {
    for (const fs::path& path : examples()) {
        const std::string text = readFile(path);
        EXPECT_EQ(tidy(text), text) << path << ": stepwise fmt";
    }
}

TEST(Format, KeepsContinuationsRelativeAndInstructionListsAsTheyAre) {
    EXPECT_EQ(tidy("PROGRAM p\n  x := a +\n       b;\nf(a,\nb);\nEND_PROGRAM\n"),
              "PROGRAM p\nx := a +\n     b;\nf(a,\n    b);\nEND_PROGRAM\n");
    const std::string il = "PROGRAM p\n          LD    a    (* x *)\nnext:     AND(  b\n          )\nEND_PROGRAM\n";
    EXPECT_EQ(tidy(il), il);
}

TEST(Format, KeepsTheLinesOfTheSiemensEditors) {
    EXPECT_EQ(tidy("FUNCTION \"F\" : Void\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\n   VAR_INPUT\n"
                   "      a { ExternalVisible := 'False'} : Bool;\n   END_VAR\n\nBEGIN\n\tREGION  Start & stop\n"
                   "\tIF #a THEN\n\tREGION inner\n\tRETURN;\n\tEND_REGION\n\tEND_IF;\n\tEND_REGION\nEND_FUNCTION\n"),
              "FUNCTION \"F\" : Void\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\nVAR_INPUT\n"
              "    a { ExternalVisible := 'False'} : Bool;\nEND_VAR\n\nBEGIN\nREGION  Start & stop\n"
              "    IF #a THEN\n        REGION inner\n            RETURN;\n        END_REGION\n    END_IF;\n"
              "END_REGION\nEND_FUNCTION\n");
}

TEST(Format, HasOptions) {
    const std::string_view text = "PROGRAM p\nIF a THEN\nb();\nEND_IF\nEND_PROGRAM\n";
    EXPECT_EQ(tidy(text, {.keywords = format::KeywordCase::Lower, .indentWidth = 2}),
              "program p\nif a then\n  b();\nend_if\nend_program\n");
    EXPECT_EQ(tidy(text, {.useTabs = true}), "PROGRAM p\nIF a THEN\n\tb();\nEND_IF\nEND_PROGRAM\n");
    EXPECT_EQ(tidy("program p\r\n\r\n\r\na();\r\nend_program", {.keywords = format::KeywordCase::AsWritten}),
              "program p\r\n\r\na();\r\nend_program\r\n");
}

TEST(Format, LeavesUnitsWithMistakesByteForByte) {
    const std::string bad = "PROGRAM  bad\n   a :=  ;\n\n\n  b:=1;\nEND_PROGRAM\n";
    EXPECT_EQ(tidy(bad + "PROGRAM good\nb:=1;\nEND_PROGRAM\n"), bad + "PROGRAM good\nb := 1;\nEND_PROGRAM\n");
    EXPECT_EQ(tidy("PROGRAM p\n(* not closed\n  x:=1;\n"), "PROGRAM p\n(* not closed\n  x:=1;\n");
}

TEST(Format, KeepsEveryTokenAndCommentAndIsDoneAfterOnce) {
    for (const fs::path& path : texts()) {
        const std::string text = readFile(path);
        for (const FormatOptions& options :
             {FormatOptions{},
              FormatOptions{.keywords = format::KeywordCase::Lower, .indentWidth = 2, .alignComments = false}}) {
            const std::string once = tidy(text, options);
            EXPECT_EQ(contents(once), contents(text)) << path;
            EXPECT_EQ(tidy(once, options), once) << path;
        }
    }
}

TEST(Format, SurvivesBrokenTexts) {
    const auto files = texts();
    const std::string text = readFile(files[0]);
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(0), text, sink);
    for (size_t i = 0; i + 1 < list.tokens.size(); i += 3) {
        const std::string cut = text.substr(0, list.tokens[i].begin) + " " + text.substr(list.tokens[i].end);
        const std::string once = tidy(cut);
        EXPECT_EQ(contents(once), contents(cut));
        EXPECT_EQ(tidy(once), once);
    }
}

TEST(Format, AlignsTheColonsOfNeighbouringDeclarations) {
    FormatOptions options;
    options.alignDeclarations = true;
    const std::string tidied =
        tidy("PROGRAM p\nVAR\na:INT:=3; // one\nlonger, and2 : BOOL; // two\nx AT %IX0.0 : BOOL;\n\nsmall : "
             "INT;\nEND_VAR\na := 3;\nCASE a OF\n1: a := 2;\nEND_CASE\nEND_PROGRAM\n"
             "TYPE T : STRUCT\na : INT;\nbbb : REAL := 1.5;\nEND_STRUCT END_TYPE\n",
             options);
    EXPECT_EQ(
        tidied,
        "PROGRAM p\nVAR\n    a            : INT := 3; // one\n    longer, and2 : BOOL;     // two\n    x AT %IX0.0  : "
        "BOOL;\n\n    small : INT;\nEND_VAR\na := 3;\nCASE a OF\n    1: a := 2;\nEND_CASE\nEND_PROGRAM\n"
        "TYPE T : STRUCT\n    a   : INT;\n    bbb : REAL := 1.5;\nEND_STRUCT END_TYPE\n");
    EXPECT_EQ(tidy(tidied, options), tidied);
}
