// Docks that hide themselves: a pin in the title of each dock turns it into a button at the edge of the window, which
// slides the dock out over the documents until the focus or a click goes elsewhere. Owned by the main window; GUI
// thread.
#pragma once
#include <QFrame>
#include <QMap>
#include <QObject>
#include <QStringList>

class QAction;
class QDockWidget;
class QMainWindow;
class QToolBar;

namespace plc::app {

class SideBars : public QObject {
    Q_OBJECT
public:
    explicit SideBars(QMainWindow& window);
    ~SideBars() override;
    /// Gives the dock a title with the pin, before it is shown.
    void add(QDockWidget& dock);
    /// From now on behind a button at the edge where the dock is; false: back to its place.
    void setHidesItself(QDockWidget& dock, bool hides);
    [[nodiscard]] bool hidesItself(const QDockWidget& dock) const;
    /// The dock that has the focus hides itself, or the one that slid out stays: the pin, by key.
    void toggleFocused();
    /// Slides a dock that hides itself out, or does nothing.
    void reveal(QDockWidget& dock);
    void conceal();
    [[nodiscard]] QDockWidget* revealed() const { return m_revealed; }
    /// The names of those that hide themselves, for the project's state.
    [[nodiscard]] QStringList stored() const;
    /// After the layout was restored: these hide themselves, all others are where the layout has them.
    void restore(const QStringList& names);

private:
    [[nodiscard]] QToolBar* barOf(Qt::DockWidgetArea area) const { return m_bars.value(area); }
    void addButton(QDockWidget& dock);
    void removeButton(QDockWidget& dock);
    void checkButtonOf(const QDockWidget* dock);
    void takeBack();
    void placeFrame();
    void showBars();
    bool eventFilter(QObject* watched, QEvent* event) override;

    QMainWindow& m_window;
    QMap<Qt::DockWidgetArea, QToolBar*> m_bars;
    QMap<QDockWidget*, QAction*> m_buttons; // of those that hide themselves
    QFrame* m_frame = nullptr;              // the room that slides out
    QDockWidget* m_revealed = nullptr;      // whose widget is in the frame
    bool m_isPlacing = false;
};

} // namespace plc::app
