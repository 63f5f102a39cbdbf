// Names asked for in a dialog: a wrong one keeps the dialog open and says why, below the line, until a good one is
// there.
#include "editor/kit/inputs/text_question.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

namespace plc::app {
namespace {

class TextQuestionTest : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        QObject::connect(&m_hand, &QTimer::timeout, qApp, [this] { answer(); });
        m_hand.start(20);
    }
    /// The command that asks, and what is typed one after the other; the last is taken or the dialog cancelled.
    QStringList complaintsOn(const char* command, QStringList typed) {
        m_typed = std::move(typed);
        m_complaints.clear();
        window->action(command)->trigger();
        EXPECT_TRUE(m_typed.isEmpty()) << "the dialog was closed before " << m_typed.join(u' ').toStdString();
        return m_complaints;
    }

private:
    void answer() {
        auto* question = qobject_cast<kit::TextQuestion*>(QApplication::activeModalWidget());
        if (!question || !question->isVisible()) return;
        if (!question->complaint().isEmpty()) m_complaints << question->complaint();
        if (m_typed.isEmpty()) return question->reject();
        auto* line = question->findChild<QLineEdit*>();
        line->selectAll();
        QTest::keyClicks(line, m_typed.takeFirst());
        EXPECT_EQ(question->complaint(), "") << "it was about what stood there before";
        QTest::keyClick(line, Qt::Key_Return);
    }
    QTimer m_hand;
    QStringList m_typed, m_complaints;
};

TEST_F(TextQuestionTest, APanelsNameIsAskedForUntilItIsOne) {
    EXPECT_EQ(complaintsOn("file.newPanel", {"desk"}).size(), 0);
    const QStringList said = complaintsOn("file.newPanel", {"hall/left", "desk", "hall"});
    ASSERT_EQ(said.size(), 2) << said.join(u'\n').toStdString();
    EXPECT_TRUE(said[0].contains("cannot contain / or \\")) << said[0].toStdString();
    EXPECT_TRUE(said[1].contains("desk")) << said[1].toStdString();
    EXPECT_TRUE(QFile::exists(folder.path() + "/hmi/hall.panel.json"));
    EXPECT_EQ(complaintsOn("file.newPanel", {"desk"}).size(), 1) << "and it can be cancelled";
}

TEST_F(TextQuestionTest, ATracesNameIsAskedForUntilItIsOne) {
    EXPECT_EQ(complaintsOn("file.newTrace", {"valves"}).size(), 0);
    const QStringList said = complaintsOn("file.newTrace", {"a\\b", "valves", "pumps"});
    ASSERT_EQ(said.size(), 2) << said.join(u'\n').toStdString();
    EXPECT_TRUE(said[1].contains("valves")) << said[1].toStdString();
    EXPECT_TRUE(QFile::exists(folder.path() + "/traces/pumps.trace.json"));
}

TEST_F(TextQuestionTest, NothingIsNoAnswerAndTheReasonIsReadWhole) {
    const QString reason = QString("It is not possible to take this one, and here is at some length why. ").repeated(4);
    kit::TextQuestion question(
        "Title", "Label", "present", [&](const QString&) { return reason; }, window.get());
    question.show();
    auto* line = question.findChild<QLineEdit*>();
    auto* ok = question.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    EXPECT_TRUE(ok->isEnabled());
    EXPECT_GE(question.width(), 340) << "so that a reason has two lines rather than five";
    line->clear();
    EXPECT_FALSE(ok->isEnabled());
    QTest::keyClicks(line, "  ");
    EXPECT_FALSE(ok->isEnabled());
    QTest::keyClicks(line, "x");
    QTest::mouseClick(ok, Qt::LeftButton);
    EXPECT_TRUE(question.isVisible());
    QLabel* below = nullptr;
    for (QLabel* each : question.findChildren<QLabel*>())
        if (each->text() == reason) below = each;
    ASSERT_NE(below, nullptr);
    EXPECT_TRUE(waitFor([&] { return below->height() >= below->heightForWidth(below->width()); }))
        << below->height() << " of " << below->heightForWidth(below->width());
    EXPECT_EQ(line->accessibleDescription(), reason);
    EXPECT_EQ(line->selectedText(), "  x");
}

TEST_F(TextQuestionTest, AQuestionThatBeginsEmptyCannotBeAnsweredYet) {
    kit::TextQuestion question(
        "Title", "Label", {}, [](const QString&) { return QString(); }, window.get());
    question.show();
    auto* ok = question.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    EXPECT_FALSE(ok->isEnabled());
    QTest::keyClicks(question.findChild<QLineEdit*>(), "x");
    EXPECT_TRUE(ok->isEnabled());
}

} // namespace
} // namespace plc::app
