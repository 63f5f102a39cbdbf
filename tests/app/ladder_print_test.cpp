// A long ladder on paper: as many pages as it takes, cut between rungs, ink on white in the dark theme too.
#include "editor/kit/paper.h"
#include "editor/kit/theme.h"
#include "tests/app/studio_fixture.h"

#include <QGraphicsItem>
#include <QGraphicsScene>
#include <QPrinter>

#include <algorithm>

namespace plc::app {
namespace {

std::string rungs(int count) {
    std::string text = "PROGRAM Main\nVAR\n    start, stop, motor : BOOL;\nEND_VAR\n";
    for (int i = 0; i < count; ++i) text += "\n// holds itself\nmotor := (start OR motor) AND NOT stop;\n";
    return text + "END_PROGRAM\n";
}

class LadderPrint : public StudioTest {
protected:
    editor::LadderView& ladder(int count) {
        const std::string text = rungs(count);
        editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, text}});
        analysed();
        return *window->tabs().currentPage()->showLadder("Main");
    }
    /// Pages of the PDF that printing makes.
    static int pagesOf(editor::LadderView& view, const QString& path) {
        {
            QPrinter printer(QPrinter::HighResolution);
            printer.setPageSize(QPageSize(QPageSize::A4));
            printer.setOutputFormat(QPrinter::PdfFormat);
            printer.setOutputFileName(path);
            view.print(printer);
        }
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly)) return 0;
        return static_cast<int>(file.readAll().count("/Type /Page\n"));
    }
};

TEST_F(LadderPrint, AShortOneIsOnePageAndALongOneIsReadableOnMany) {
    editor::LadderView& view = ladder(3);
    EXPECT_EQ(pagesOf(view, folder.filePath("short.pdf")), 1);
    ladder(60);
    const int pages = pagesOf(view, folder.filePath("long.pdf"));
    EXPECT_GE(pages, 5) << "not all squeezed onto one page";
    const auto rungs = view.scene().items();
    const QRectF whole = view.scene().itemsBoundingRect();
    for (const QRectF& page : kit::pagesOf(view.scene(), whole, 1000)) {
        int begin = 0;
        for (const QGraphicsItem* rung : rungs) begin += page.contains(rung->sceneBoundingRect().center()) ? 1 : 0;
        EXPECT_GE(begin, 1) << "no page is empty";
        if (page.bottom() < whole.bottom() - 1) {
            EXPECT_TRUE(
                std::any_of(rungs.begin(), rungs.end(),
                            [&](const QGraphicsItem* rung) { return std::abs(rung->pos().y() - page.bottom()) < 10; }))
                << "cut through a rung at " << page.bottom();
        }
    }
    EXPECT_LE(pages, 15) << "as large as on the screen, not larger";
    if (qEnvironmentVariableIsSet("STEPWISE_PICTURES"))
        QFile::copy(folder.filePath("long.pdf"), qEnvironmentVariable("STEPWISE_PICTURES") + "/ladder.pdf");
}

TEST_F(LadderPrint, TheScreenKeepsItsColoursAndPaperIsWhite) {
    kit::Theme::current().setChoice(kit::ThemeChoice::Dark);
    editor::LadderView& view = ladder(3);
    const QColor before = view.scene().colors().base;
    EXPECT_LT(before.lightness(), 100);
    {
        const kit::PaperColors paper;
        EXPECT_GT(kit::colors().base.lightness(), 240);
    }
    EXPECT_EQ(pagesOf(view, folder.filePath("dark.pdf")), 1);
    EXPECT_EQ(view.scene().colors().base, before);
    kit::Theme::current().setChoice(kit::ThemeChoice::Light);
}

TEST(Pages, AreCutBetweenItemsAndThroughOneThatIsHigherThanAPage) {
    QGraphicsScene scene;
    for (int i = 0; i < 4; ++i) scene.addRect(0, i * 40, 100, 30);
    scene.addRect(0, 160, 100, 250); // higher than a page
    const auto pages = kit::pagesOf(scene, QRectF(0, 0, 100, 410), 100);
    ASSERT_GE(pages.size(), 4u);
    EXPECT_NEAR(pages[0].height(), 80, 1) << "the third rectangle begins the next page";
    double reached = 0;
    for (const QRectF& page : pages) {
        EXPECT_DOUBLE_EQ(page.top(), reached) << "nothing is left out, nothing twice";
        EXPECT_LE(page.height(), 100);
        EXPECT_GT(page.height(), 0);
        reached = page.bottom();
    }
    EXPECT_DOUBLE_EQ(reached, 410);
}

} // namespace
} // namespace plc::app
