// The status line of the window: work that goes on, faults and problems, the cursor, what is recorded, and state, time
// and load of the controller. Reads what it shows from those who know it. Owned by the main window; GUI thread.
#pragma once
#include "editor/debug/run_control.h"

#include <QElapsedTimer>
#include <QObject>

class QLabel;
class QStatusBar;
class QToolButton;

namespace plc::kit {
class WorkStrip;
}

namespace plc::app {

class ProblemsView;

class StatusLine : public QObject {
    Q_OBJECT
public:
    StatusLine(QStatusBar& bar, editor::RunControl& control, editor::Workspace& workspace, ProblemsView& problems);

    void refresh();
    void showCursor(int line, int column); // from 1
    void hideCursor();                     // no text is in front
    [[nodiscard]] kit::WorkStrip& work() { return *m_work; }
    [[nodiscard]] static QString speedText(session::RunMode mode); // "10 ×"

signals:
    void changed(); // what it shows, and with it what may be done
    void failed();  // the controller, just now
    void problemsRequested();
    void placeRequested(const QString& file, uint32_t offset, uint32_t length);

private:
    void makeButtons(QStatusBar& bar);
    void makeLabels(QStatusBar& bar);
    void statusChanged();
    void showState();
    void showFigures();
    void showFault();
    void goToFault();

    editor::RunControl& m_control;
    ProblemsView& m_problems;
    kit::WorkStrip* m_work = nullptr;
    QToolButton *m_faultButton = nullptr, *m_problemButton = nullptr;
    QLabel *m_cursor = nullptr, *m_history = nullptr, *m_time = nullptr, *m_load = nullptr, *m_state = nullptr;
    controller::State m_shownState = controller::State::Stopped;
    QElapsedTimer m_sinceStatus;
};

} // namespace plc::app
