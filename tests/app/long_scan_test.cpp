// A scan that would take years is left at once, however one leaves it: by the key for Stop, by closing the project, by
// closing the window.
#include "tests/app/studio_fixture.h"
#include "tests/support/long_scans.h"
#include "tests/support/processor_time.h"

#include <QAction>

namespace plc::app {
namespace {

class LongScanTest : public StudioTest, public ::testing::WithParamInterface<size_t> {
protected:
    /// In the middle of its first scan.
    void SetUp() override {
        StudioTest::SetUp();
        window->workspace().setText("src/main.st", longScans()[GetParam()].text);
        ASSERT_TRUE(window->workspace().save("src/main.st"));
        analysed();
        QTest::keyClick(window.get(), Qt::Key_F5);
        ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Running; }));
        QTest::qWait(300); // a duration: of the scan; that it has begun cannot be seen before it ends
        ASSERT_EQ(window->control().status().scans, 0u);
        m_since = ownSeconds();
    }
    /// With what else closing does; the scan itself takes years. The threads of window and scan work at the same time.
    /// The last values are kept and shown: two images of memory, which is nothing of the scan's.
    void expectAtOnce() const {
        const double took = ownSeconds() - m_since;
        EXPECT_LT(took, kAtOnceSeconds + kTimesTouched * secondsForNewMemory(240'000'000));
    }

    /// The thread sanitizer keeps what it knows of memory in other memory, and goes through that when it comes and
    /// goes.
#ifdef PLC_THREAD_SANITIZED
    static constexpr double kTimesTouched = 3;
#else
    static constexpr double kTimesTouched = 1;
#endif
    double m_since = 0;
};

TEST_P(LongScanTest, StopEndsIt) {
    QTest::keyClick(window.get(), Qt::Key_F8, Qt::ShiftModifier);
    EXPECT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Stopped; }));
    expectAtOnce();
}

TEST_P(LongScanTest, ClosingTheProjectEndsIt) {
    QTest::keyClick(window.get(), Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(window->workspace().isOpen());
    EXPECT_EQ(window->control().session(), nullptr);
    expectAtOnce();
}

TEST_P(LongScanTest, ClosingTheWindowEndsIt) {
    EXPECT_TRUE(window->close());
    EXPECT_EQ(window->control().session(), nullptr);
    expectAtOnce();
}

INSTANTIATE_TEST_SUITE_P(Programs, LongScanTest, ::testing::Values(0, 1, 2),
                         [](const auto& info) { return std::string(longScans()[info.param].name); });

} // namespace
} // namespace plc::app
