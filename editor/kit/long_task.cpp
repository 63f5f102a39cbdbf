#include "editor/kit/long_task.h"

#include <algorithm>

namespace plc::kit {

namespace {
int patience = 500;
constexpr int kSteps = 1000;
} // namespace

LongTask::LongTask(const QString& label, QWidget* parent) : m_dialog(label, tr("Cancel"), 0, kSteps, parent) {
    m_dialog.setWindowModality(Qt::WindowModal);
    m_dialog.setMinimumDuration(patience);
    m_dialog.setAutoReset(false);
    m_dialog.setAutoClose(false);
    m_dialog.setValue(0);
}

void LongTask::setPatience(int milliseconds) { patience = milliseconds; }

bool LongTask::reached(double share) {
    if (!m_dialog.wasCanceled()) m_dialog.setValue(std::clamp(static_cast<int>(share * kSteps), 0, kSteps - 1));
    return !m_dialog.wasCanceled();
}

} // namespace plc::kit
