// A text in the editor is the one that was given, whatever bytes another tool or a torn disk left in it.
#include "editor/text/st_editor.h"

#include <gtest/gtest.h>

namespace plc::editor {
namespace {

TEST(LoadedText, IsWholeBehindAZeroByte) {
    using namespace std::string_literals;
    for (const std::string& text : {"a := 1;\nb\0 := 2;\nc := 3;\n"s, "\0"s, "x\0\0y"s, "\r\n\0\r\n"s, ""s}) {
        StEditor editor;
        editor.load(text);
        EXPECT_EQ(editor.utf8(), text);
        editor.load(text);
        EXPECT_EQ(editor.utf8(), text) << "again";
        editor.setReadOnly(true);
        editor.load(text + "more");
        EXPECT_EQ(editor.utf8(), text + "more") << "while it is only read";
        EXPECT_TRUE(editor.isReadOnly());
        EXPECT_FALSE(editor.isUndoAvailable());
    }
}

} // namespace
} // namespace plc::editor
