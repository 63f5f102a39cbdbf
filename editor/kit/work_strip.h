// Work that goes on while the window is used, in the status line: what it is, how far it got, and a button that ends
// it. Shows itself once the work has taken half a second. Owned by the status line; GUI thread.
#pragma once
#include "runtime/base/progress.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <vector>

class QLabel;
class QProgressBar;
class QToolButton;

namespace plc::kit {

class WorkStrip : public QWidget {
    Q_OBJECT
public:
    explicit WorkStrip(QWidget* parent = nullptr);
    void begin(const QString& label, std::shared_ptr<Progress> progress);
    void end(const std::shared_ptr<Progress>& progress);

private:
    void look();
    struct Work {
        QString label;
        std::shared_ptr<Progress> progress;
        QElapsedTimer since;
    };
    std::vector<Work> m_works; // the newest is shown
    QTimer m_timer;
    QLabel* m_label;
    QProgressBar* m_bar;
    QToolButton* m_cancel;
};

} // namespace plc::kit
