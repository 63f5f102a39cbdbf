// What takes long shows how far it got and can be cancelled: search and replace in all files, export of samples.
#include "app/search_view.h"
#include "editor/kit/long_task.h"
#include "editor/kit/plot_export.h"
#include "tests/app/studio_fixture.h"

#include <QLabel>
#include <QLineEdit>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>

namespace plc::app {
namespace {

class LongTaskTest : public StudioTest {
protected:
    void SetUp() override {
        for (int i = 0; i < 20; ++i) {
            QByteArray text = "FUNCTION F" + QByteArray::number(i) + " : INT\nVAR\n    needle : INT;\nEND_VAR\n";
            for (int line = 0; line < 50; ++line) text += "needle := needle + 1;\n";
            write(QString("src/f%1.st").arg(i, 2, 10, QChar('0')), text + "END_FUNCTION\n");
        }
        StudioTest::SetUp();
        kit::LongTask::setPatience(0);
        clicker.setInterval(0);
        QObject::connect(&clicker, &QTimer::timeout, [this] {
            for (QWidget* each : QApplication::topLevelWidgets())
                if (auto* dialog = qobject_cast<QProgressDialog*>(each);
                    dialog && dialog->isVisible() && dialog->value() >= cancelAt)
                    if (auto* button = dialog->findChild<QPushButton*>())
                        QTest::mouseClick(button, Qt::LeftButton), ++clicks;
        });
    }
    void TearDown() override {
        clicker.stop();
        kit::LongTask::setPatience(500);
        StudioTest::TearDown();
    }
    QTimer clicker;
    int cancelAt = 300, clicks = 0; // of 1000
};

constexpr int kAll = 20 * 101;

TEST_F(LongTaskTest, ASearchIsCancelledAndKeepsWhatItFound) {
    window->search().openSearch("needle");
    window->search().search();
    EXPECT_EQ(window->search().results().topLevelItemCount(), kAll) << "nobody cancelled";
    clicker.start();
    window->search().search();
    EXPECT_EQ(clicks, 1);
    EXPECT_GT(window->search().results().topLevelItemCount(), 0);
    EXPECT_LT(window->search().results().topLevelItemCount(), kAll);
    bool said = false;
    for (QLabel* label : window->search().findChildren<QLabel*>()) said |= label->text().startsWith("Cancelled");
    EXPECT_TRUE(said);
}

TEST_F(LongTaskTest, ACancelledReplaceChangesNothing) {
    window->search().openSearch("needle");
    window->search().findChildren<QLineEdit*>()[1]->setText("thread");
    clicker.start();
    EXPECT_EQ(window->search().replaceAll(), 0);
    clicker.stop();
    EXPECT_EQ(clicks, 1);
    for (const QString& file : window->workspace().files())
        EXPECT_EQ(window->workspace().text(file).find("thread"), std::string::npos) << file.toStdString();
    EXPECT_EQ(window->search().replaceAll(), kAll);
    EXPECT_NE(window->workspace().text("src/f19.st").find("thread := thread + 1"), std::string::npos);
}

TEST_F(LongTaskTest, ACancelledExportLeavesTheFileAsItWas) {
    kit::PlotModel model;
    auto samples = std::make_shared<kit::SampleList>();
    for (int i = 0; i < 100'000; ++i) samples->append(i * 1'000'000LL, i);
    kit::PlotCurve curve;
    curve.name = "a";
    curve.source = samples;
    model.curves = {curve};
    write("out.csv", "before");
    const QString path = folder.path() + "/out.csv";
    const auto size = [&] { return QFileInfo(path).size(); };
    const auto save = [&] {
        kit::LongTask task("Saving", window.get());
        return kit::exportCsv(model, 0, 100'000'000'000LL, path, [&](double share) { return task.reached(share); })
            .
            operator bool();
    };
    clicker.start();
    EXPECT_TRUE(save());
    clicker.stop();
    EXPECT_EQ(clicks, 1);
    EXPECT_EQ(size(), 6);
    EXPECT_TRUE(save());
    EXPECT_GT(size(), 700'000);
}

} // namespace
} // namespace plc::app
