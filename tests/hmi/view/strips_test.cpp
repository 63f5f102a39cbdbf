// A panel in a window of any size covers every pixel of it: nothing of what was there before is left in a strip.
#include "hmi/view/panel_view.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QPaintEvent>
#include <QtTest>

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

TEST(PanelView, CoversEveryPixelAtEverySize) {
    PanelView view;
    const Result<Panel> panel = Panel::parse(R"({"size":[1024,600],"elements":[]})", QString());
    ASSERT_TRUE(panel);
    view.scene().setPanel(*panel);
    const QColor before(255, 0, 255);
    for (const QSize size : {QSize(317, 211), QSize(640, 481), QSize(1000, 333), QSize(801, 600), QSize(97, 401)}) {
        view.resize(size);
        QImage image(size, QImage::Format_RGB32);
        image.fill(before);
        view.render(&image, QPoint(), QRegion(), QWidget::DrawChildren);
        int left = 0;
        for (int y = 0; y < size.height(); ++y)
            for (int x = 0; x < size.width(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                left += pixel.red() > pixel.green() + 12 && pixel.blue() > pixel.green() + 12;
            }
        EXPECT_EQ(left, 0) << size.width() << " x " << size.height();
    }
}

/// What a widget was asked to paint.
class Painted : public QObject {
public:
    explicit Painted(QWidget& of) { of.installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) region += static_cast<QPaintEvent*>(event)->region();
        return false;
    }
    QRegion region;
};

TEST(PanelView, APanelOfAnotherSizeOrThemeLeavesNothingOfTheOneBefore) {
    PanelView view;
    view.resize(800, 480);
    view.scene().setPanel(*Panel::parse(R"({"size":[800,480],"elements":[]})", QString()));
    view.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&view, kPatience));
    view.frame();
    QApplication::processEvents();
    for (const char* next :
         {R"({"size":[300,480],"elements":[]})", R"({"size":[300,480],"theme":"dark","elements":[]})",
          R"({"size":[800,200],"theme":"dark","elements":[]})"}) {
        Painted painted(view);
        view.scene().setPanel(*Panel::parse(next, QString()));
        view.frame();
        QApplication::processEvents();
        EXPECT_TRUE((QRegion(view.rect()) - painted.region).isEmpty()) << next;
    }
    Painted again(view);
    view.frame();
    QApplication::processEvents();
    EXPECT_TRUE(again.region.isEmpty()) << "nothing changed";
}

} // namespace
} // namespace plc::hmi
