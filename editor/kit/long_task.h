// Work on the window's thread that may take long: after half a second it shows how far it got, with a button that ends
// it. Lives in the function that does the work; GUI thread.
#pragma once

#include "runtime/base/progress.h"

#include <QCoreApplication>
#include <QProgressDialog>

#include <functional>

namespace plc::kit {

class LongTask {
    Q_DECLARE_TR_FUNCTIONS(LongTask)
public:
    LongTask(const QString& label, QWidget* parent);
    /// Half a second, unless a test has less patience.
    static void setPatience(int milliseconds);
    [[nodiscard]] static int patience();
    /// Work that knows nothing of the window, on a thread of its own: what the window shows goes on, keys and clicks
    /// wait for the dialog or for the end. False when it was cancelled.
    static bool runAside(const QString& label, QWidget* parent, const std::function<void(Progress&)>& work);

    /// `share` of the whole (0..1) is done; false when it is to end. Other events of the window are handled meanwhile,
    /// so what the work reads must be its own.
    bool reached(double share);
    [[nodiscard]] bool isCancelled() const { return m_dialog.wasCanceled(); }

private:
    QProgressDialog m_dialog;
};

} // namespace plc::kit
