// The tabs of docks that share a room: with their names as long as these fit, else as pictures with a tip, and only the
// dock in front keeps its name. Owned by the main window; GUI thread.
#pragma once
#include <QObject>

class QMainWindow;
class QTabBar;

namespace plc::app {

class DockTabs : public QObject {
    Q_OBJECT
public:
    explicit DockTabs(QMainWindow& window);

private:
    void fit(QTabBar& bar) const;
    bool eventFilter(QObject* watched, QEvent* event) override;

    QMainWindow& m_window;
};

} // namespace plc::app
