// The colours of a text while it is typed: up to the first change by meaning, behind it by its words.
#include "editor/text/st_lexer.h"

#include <Qsci/qsciscintilla.h>
#include <gtest/gtest.h>

namespace plc::editor {
namespace {

using analysis::TokenClass;

class Colours : public testing::Test {
protected:
    void SetUp() override {
        view.setLexer(&lexer);
        driver::BuildInput input;
        input.files.push_back({"list.st", kText});
        const auto model = analysis::CodeModel::make(input);
        lexer.setModel(model, model->fileOf("list.st"), kText);
        view.setText(QString::fromStdString(kText));
    }
    TokenClass at(const std::string& word) {
        const std::string text = view.text().toStdString();
        const size_t place = text.find(word);
        EXPECT_NE(place, std::string::npos) << word;
        lexer.styleText(0, static_cast<int>(text.size()));
        return static_cast<TokenClass>(view.SendScintilla(QsciScintillaBase::SCI_GETSTYLEAT, place));
    }
    const std::string kText = "PROGRAM Main\nVAR\n    Level : INT;\nEND_VAR\nLD Level\nST Level\nEND_PROGRAM\n";
    QsciScintilla view;
    StLexer lexer{&view};
};

TEST_F(Colours, AnalysedTextIsColouredByMeaning) {
    EXPECT_EQ(at("PROGRAM"), TokenClass::Keyword);
    EXPECT_EQ(at("LD "), TokenClass::Keyword);
    EXPECT_EQ(at("INT"), TokenClass::Type);
}

TEST_F(Colours, AnInstructionBehindTheChangeIsOneAtOnce) {
    view.insertAt("ADD 1\nshift: SUB 2\nLDX := 3;\n", 5, 0);
    EXPECT_EQ(at("ADD "), TokenClass::Keyword);
    EXPECT_EQ(at("SUB "), TokenClass::Keyword) << "behind a label";
    EXPECT_EQ(at("LDX"), TokenClass::Plain);
    EXPECT_EQ(at("LD Level"), TokenClass::Keyword) << "before the change, as it was";
    EXPECT_EQ(at("ST Level"), TokenClass::Keyword) << "behind it";
}

TEST_F(Colours, AWordThatIsAssignedToIsNoInstruction) {
    view.insertAt("AND_ := 1;\nADD := 2;\nSUB.x := 3;\n", 5, 0);
    EXPECT_EQ(at("ADD :="), TokenClass::Plain);
    EXPECT_EQ(at("SUB.x"), TokenClass::Plain);
}

TEST_F(Colours, ACommentThatIsStillOpenIsOne) {
    view.insertAt("(* going on\n", 5, 0);
    EXPECT_EQ(at("(*"), TokenClass::Comment);
}

} // namespace
} // namespace plc::editor
