// What the panel check says about panels, texts and alarms, kept up to date in the list of problems: a moment after the
// last edit, one panel per turn of the event loop, so that typing never waits. Owned by the main window; GUI thread
// (fonts are measured).
#pragma once
#include "app/project/problems_view.h"
#include "hmi/check/panel_check.h"

#include <QObject>
#include <QTimer>

namespace plc::app {

class LiveViews;

/// Why a file could not be read.
struct PanelProblem {
    QString file, message;
    int line = 0; // from 1, 0 = nowhere
};

class DesignFindings : public QObject {
    Q_OBJECT
public:
    DesignFindings(LiveViews& live, ProblemsView& problems, QObject* parent);
    void schedule() { m_pause.start(); }
    [[nodiscard]] PanelProblem problemOf(const QString& file) const;

private:
    [[nodiscard]] std::vector<PanelProblem> problems() const;
    void begin();
    void continueCheck();

    LiveViews& m_live;
    ProblemsView& m_problems;
    QTimer m_pause, m_turn;
    hmi::CheckInput m_input;
    std::vector<hmi::Finding> m_found;
    size_t m_next = 0;
};

} // namespace plc::app
