// Alt+Up and Alt+Down move lines: whatever is selected, none changes and none is lost.
// is lost.
#include "editor/text/st_editor.h"

#include <gtest/gtest.h>

#include <QTest>

#include <algorithm>
#include <random>

namespace plc::editor {
namespace {

using S = QsciScintillaBase;

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines{{}};
    for (const char c : text)
        if (c == '\n')
            lines.emplace_back();
        else if (c != '\r')
            lines.back() += c;
    return lines;
}

TEST(MovedLines, AreTheSameLinesWhateverIsSelected) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    StEditor editor;
    editor.resize(500, 300);
    editor.show();
    for (int round = 0; round < 400; ++round) {
        std::string text;
        for (uint32_t i = 0, count = 1 + random() % 8; i < count; ++i)
            text += std::string(random() % 30, static_cast<char>('a' + i)) + "\n";
        if (random() % 3 == 0) text.pop_back();
        editor.load(text);
        const auto any = [&] { return static_cast<long>(random() % (text.size() + 1)); };
        editor.SendScintilla(S::SCI_SETSELECTION, static_cast<unsigned long>(any()), any());
        for (uint32_t more = random() % 3; more > 0; --more)
            editor.SendScintilla(S::SCI_ADDSELECTION, static_cast<unsigned long>(any()), any());
        if (random() % 4 == 0)
            editor.SendScintilla(S::SCI_SETRECTANGULARSELECTIONCARET, static_cast<unsigned long>(any()));
        for (int step = 0; step < 6; ++step) {
            QTest::keyClick(&editor, random() % 2 ? Qt::Key_Up : Qt::Key_Down, Qt::AltModifier);
            auto before = linesOf(text), after = linesOf(editor.utf8());
            std::sort(before.begin(), before.end());
            std::sort(after.begin(), after.end());
            ASSERT_EQ(after, before) << "round " << round << " step " << step;
        }
    }
}

struct Move {
    std::string text;
    std::pair<long, long> selected; // anchor, caret
    Qt::Key key;
    std::string after;
    std::string stillSelected;
};

TEST(MovedLines, GoPastTheLineBesideThemAndStaySelected) {
    const std::string three = "one\ntwo\nthree\n";
    for (const Move& each : std::vector<Move>{
             {three, {5, 5}, Qt::Key_Up, "two\none\nthree\n", ""},
             {three, {5, 6}, Qt::Key_Down, "one\nthree\ntwo\n", "w"},
             {three, {0, 8}, Qt::Key_Down, "three\none\ntwo\n", "one\ntwo\n"},
             {three, {1, 1}, Qt::Key_Up, three, ""},
             {three, {9, 9}, Qt::Key_Down, three, ""}, // below is only the end of the text
             {"one\ntwo", {5, 5}, Qt::Key_Up, "two\none", ""},
             {"one\ntwo", {1, 2}, Qt::Key_Down, "two\none", "n"},
             {"one\r\ntwo", {6, 7}, Qt::Key_Up, "two\r\none", "w"},
             {"\u00E4\u00F6\nb\n", {2, 4}, Qt::Key_Down, "b\n\u00E4\u00F6\n", "\u00F6"},
         }) {
        StEditor editor;
        editor.show();
        editor.load(each.text);
        editor.SendScintilla(S::SCI_SETSEL, static_cast<unsigned long>(each.selected.first), each.selected.second);
        QTest::keyClick(&editor, each.key, Qt::AltModifier);
        EXPECT_EQ(editor.utf8(), each.after) << each.text;
        EXPECT_EQ(editor.selectedText().toStdString(), each.stillSelected) << each.text;
        if (each.after == each.text) continue;
        editor.undo();
        EXPECT_EQ(editor.utf8(), each.text) << "one step";
    }
}

TEST(MovedLines, OfSeveralCaretsAllMove) {
    StEditor editor;
    editor.show();
    editor.load("a\nb\nc\nd\ne\n");
    editor.SendScintilla(S::SCI_SETSELECTION, 2ul, 2l); // b
    editor.SendScintilla(S::SCI_ADDSELECTION, 6ul, 6l); // d
    QTest::keyClick(&editor, Qt::Key_Up, Qt::AltModifier);
    EXPECT_EQ(editor.utf8(), "b\na\nd\nc\ne\n");
    QTest::keyClick(&editor, Qt::Key_Down, Qt::AltModifier);
    EXPECT_EQ(editor.utf8(), "a\nb\nc\nd\ne\n");
}

TEST(MovedLines, MarksStayWithTheirLines) {
    StEditor editor;
    editor.show();
    editor.load("one\ntwo\nthree\n");
    const int mark = editor.markerDefine(QsciScintilla::Circle, 20);
    editor.markerAdd(2, mark);
    editor.setCursorPosition(2, 1);
    QTest::keyClick(&editor, Qt::Key_Up, Qt::AltModifier);
    ASSERT_EQ(editor.utf8(), "one\nthree\ntwo\n");
    EXPECT_EQ(editor.markerFindNext(0, 1u << 20), 1);
    EXPECT_EQ(editor.markerFindNext(2, 1u << 20), -1);
}

} // namespace
} // namespace plc::editor
