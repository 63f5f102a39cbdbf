// What a mouse does to the window, as commands for whoever has only keys: the size, side and floating of the pane that
// has the focus, the columns of its table, its context menu. Functions over the window; GUI thread.
#pragma once
#include <QObject>

#include <functional>

class QDockWidget;
class QKeySequence;
class QMainWindow;
class QMenu;

namespace plc::app {

class SideBars;

/// The focus goes to the documents or to a dock in sight: by 1 the next one, by -1 the one before, around the end.
void focusNextPane(QMainWindow& window, SideBars& bars, int by);
/// Of the widget that has the focus, at what is selected in it: for keyboards without the key that does it.
void showContextMenu();
/// Null when the focus is not in a table with a head.
[[nodiscard]] QMenu* makeColumnMenu();
/// The dock that has the focus goes to the next side: left, below, right.
void moveFocusedDock(QMainWindow& window, SideBars& bars);
/// Out of the window, or back to its side.
void floatFocusedDock(SideBars& bars);

/// The sizes of panes by key, also in dialogs, where the window's commands are out of reach. Owned by the window.
class PaneKeys : public QObject {
    Q_OBJECT
public:
    enum class Change { Wider, Narrower, Taller, Shorter };
    PaneKeys(QObject* window, std::function<QKeySequence(Change)> keys);
    static void change(Change change);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<QKeySequence(Change)> m_keys;
};

} // namespace plc::app
