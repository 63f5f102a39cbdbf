// The comparison can be seen: lines that differ have a ground of their own on both sides, and the dialog fits its
// screen.
#include "app/merge_dialog.h"

#include <Qsci/qsciscintilla.h>

#include <QScreen>
#include <QTest>
#include <gtest/gtest.h>

namespace plc::app {
namespace {

TEST(MergePicture, LinesThatDifferAreColouredOnBothSides) {
    MergeDialog dialog("a.st", "x := 1;\ny := 2;\nz := 3;\nw := 4;\n", "x := 1;\ny := 2;\nz := 33;\nw := 4;\n",
                       nullptr);
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    EXPECT_LE(dialog.width(), dialog.screen()->availableSize().width());
    EXPECT_LE(dialog.height(), dialog.screen()->availableSize().height());
    const auto sides = dialog.findChildren<QsciScintilla*>();
    ASSERT_EQ(sides.size(), 2);
    for (QsciScintilla* side : sides) {
        const QImage picture = side->viewport()->grab().toImage();
        const int height = side->textHeight(0), x = picture.width() - 30;
        const QColor same = picture.pixelColor(x, height * 3 + height / 2),
                     different = picture.pixelColor(x, height * 2 + height / 2);
        EXPECT_GT(std::abs(same.red() - different.red()) + std::abs(same.blue() - different.blue()), 20)
            << side->accessibleName().toStdString() << " " << different.name().toStdString();
    }
}

} // namespace
} // namespace plc::app
