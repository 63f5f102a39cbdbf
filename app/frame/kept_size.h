// Keeps the size of the window while its docks are shown: one after the other they need more room than together, and
// the last of it is given back by events that are still to come. On a small screen the window would end outside.
// Deletes itself when the layout has come to rest; GUI thread.
#pragma once
#include <QObject>
#include <QSize>
#include <QTimer>

class QMainWindow;

namespace plc::app {

class KeptSize : public QObject {
    Q_OBJECT
public:
    /// `size` is what the window may have at most; one before this is replaced.
    static void keep(QMainWindow& window, QSize size);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    KeptSize(QMainWindow& window, QSize size);
    void giveBack();
    void rest();

    QMainWindow& m_window;
    QSize m_size;
    QTimer m_rest; // since the layout last asked
    int m_tries = 0;
};

} // namespace plc::app
