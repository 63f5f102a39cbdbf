// What a programmer from another tool reads about code that this one writes in another way.
#include "fixture.h"

namespace plc::exchange {
namespace {

class ForeignCode : public ::testing::Test {
protected:
    /// Everything that the check says about a program with these variables and statements.
    static std::string said(const std::string& variables, const std::string& statements) {
        driver::BuildInput input;
        input.files.push_back(
            {"p.st", "PROGRAM P\nVAR\n" + variables + "\nEND_VAR\n" + statements + "\nEND_PROGRAM\n"});
        const driver::Checked checked = driver::check(std::move(input));
        std::string out;
        for (const diagnostics::Diagnostic& each : checked.analysis->diagnostics)
            out += diagnostics::renderText(*checked.sources, each, false);
        return out;
    }
};

TEST_F(ForeignCode, ElseifIsCalledByItsName) {
    const std::string text = said("a : INT;", "IF a = 1 THEN a := 2;\nELSEIF a = 2 THEN a := 3;\nEND_IF");
    EXPECT_NE(text.find("p.st:6:1: error P1024: Use ELSIF instead of ELSEIF"), std::string::npos) << text;
    EXPECT_NE(text.find("Replace with ELSIF"), std::string::npos) << text;
    EXPECT_EQ(text.find("error", text.find("P1024")), std::string::npos) << "one message for one mistake:\n" << text;
}

TEST_F(ForeignCode, AnUnclosedCommentNamesTheInnerOne) {
    const std::string text = said("a : INT;", "a := 1; (* outer\n  (* inner *)\na := 2;");
    EXPECT_NE(text.find("p.st:5:9: error P1002"), std::string::npos) << text;
    EXPECT_NE(text.find("p.st:6:3: comments nest"), std::string::npos) << text;
}

TEST_F(ForeignCode, ACommentWithoutAnInnerOneSaysNothingOfNesting) {
    const std::string text = said("a : INT;", "a := 1; (* outer\na := 2;");
    EXPECT_NE(text.find("P1002"), std::string::npos) << text;
    EXPECT_EQ(text.find("nest"), std::string::npos) << text;
}

TEST_F(ForeignCode, AddressesWithSeveralNumbersAreAccepted) {
    EXPECT_EQ(said("x AT %IW3.1 : INT; y AT %QX1.2.3 : BOOL;", "y := x > 3;"), "");
}

TEST_F(ForeignCode, MessagesOfListsOfInstructionsHaveNoNamesOfTheCompiler) {
    for (const char* statements : {"LD a\nJMPC nowhere\nST a", "LD a\nCAL nothing(IN := a)\nST a", "LD a\nAND(\nST a",
                                   "LD 5\nST a\nJMP l\nl:", "LD x\nST a"}) {
        const std::string text = said("a : BOOL;", statements);
        EXPECT_EQ(text.find("__"), std::string::npos) << statements << "\n" << text;
    }
}

TEST_F(ForeignCode, BytesBehindTheAddressOfATextNeedNoWarning) {
    EXPECT_EQ(said("p : POINTER TO BYTE; s : STRING; b : BYTE;", "p := ADR(s);\nb := p^;\ns := '';"), "");
}

TEST_F(ForeignCode, APointerToAnotherTypeStillHasItsWarning) {
    EXPECT_NE(said("p : POINTER TO INT; r : REAL; i : INT;", "p := ADR(r);\ni := p^;\nr := 1.0;").find("warning"),
              std::string::npos);
}

} // namespace
} // namespace plc::exchange
