#include "app/testing/test_log.h"

#include "editor/debug/debug_views.h"
#include "editor/kit/message_text.h"

#include <QCoreApplication>

namespace plc::app {

namespace {
/// It speaks as part of the window.
struct TestWords {
    Q_DECLARE_TR_FUNCTIONS(plc::app::MainWindow)
};
} // namespace

void logTests(editor::EventLog& log, const testing::Report& report) {
    for (const std::string& text : report.diagnostics) log.addMessage(QString::fromStdString(text).trimmed(), true);
    for (const testing::TestResult& result : report.results) {
        log.addMessage((result.passed() ? TestWords::tr("passed: %1") : TestWords::tr("FAILED: %1"))
                           .arg(QString::fromStdString(result.title)),
                       !result.passed());
        for (const testing::Failure& failure : result.failures)
            log.addMessage(QString("    %1:%2  %3  %4")
                               .arg(QString::fromStdString(failure.file))
                               .arg(failure.line)
                               .arg(kit::messageText(failure.message), kit::messageText(failure.detail)),
                           true);
    }
}

} // namespace plc::app
