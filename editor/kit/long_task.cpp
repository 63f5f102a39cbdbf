#include "editor/kit/long_task.h"
#include "editor/kit/post.h"

#include <QEventLoop>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

namespace plc::kit {

namespace {
int waits = 500;
constexpr int kDialogSteps = 1000;
} // namespace

LongTask::LongTask(const QString& label, QWidget* parent) : m_dialog(label, tr("Cancel"), 0, kDialogSteps, parent) {
    m_dialog.setWindowModality(Qt::WindowModal);
    m_dialog.setMinimumDuration(waits);
    m_dialog.setAutoReset(false);
    m_dialog.setAutoClose(false);
    m_dialog.setValue(0);
}

void LongTask::setPatience(int milliseconds) { waits = milliseconds; }
int LongTask::patience() { return waits; }

bool LongTask::reached(double share) {
    if (!m_dialog.wasCanceled())
        m_dialog.setValue(std::clamp(static_cast<int>(share * kDialogSteps), 0, kDialogSteps - 1));
    return !m_dialog.wasCanceled();
}

bool LongTask::runAside(const QString& label, QWidget* parent, const std::function<void(Progress&)>& work) {
    Progress progress;
    std::atomic<bool> hasEnded{false};
    QEventLoop loop;
    std::thread worker([&] {
        work(progress);
        hasEnded = true;
        kit::post(&loop, [&loop] { loop.quit(); });
    });
    QTimer::singleShot(waits, &loop, &QEventLoop::quit);
    loop.exec(QEventLoop::ExcludeUserInputEvents);
    if (!hasEnded) {
        QProgressDialog dialog(label, tr("Cancel"), 0, kDialogSteps, parent);
        dialog.setWindowModality(Qt::WindowModal);
        dialog.setMinimumDuration(0);
        dialog.setAutoReset(false);
        dialog.setAutoClose(false);
        dialog.setValue(0);
        QTimer look;
        QObject::connect(&look, &QTimer::timeout, &dialog, [&] {
            dialog.setValue(std::clamp(static_cast<int>(progress.share() * kDialogSteps), 0, kDialogSteps - 1));
        });
        QObject::connect(&dialog, &QProgressDialog::canceled, &loop, [&] {
            progress.cancel();
            look.stop();
            loop.quit();
        });
        look.start(50);
        while (!hasEnded && !progress.isCancelled()) loop.exec();
        dialog.disconnect(&loop);
        while (!hasEnded) loop.exec(QEventLoop::ExcludeUserInputEvents); // it ends at its next piece
    }
    worker.join();
    return !progress.isCancelled();
}

} // namespace plc::kit
