// The command palette: every action of the window, found by a few typed letters (Ctrl+Shift+P).
// Owned by the window it lies over; GUI thread. Actions are asked for each time it opens, so nothing goes stale.
#pragma once

#include <QFrame>
#include <QPointer>

#include <functional>
#include <vector>

class QAction;
class QLineEdit;
class QListView;
class QStandardItemModel;

namespace plc::kit {

class CommandPalette : public QFrame {
    Q_OBJECT
public:
    using ActionSource = std::function<QList<QAction*>()>;

    /// Without a source, all named actions found below `window` are offered.
    explicit CommandPalette(QWidget* window, ActionSource source = {});

    void open(const QString& text = {});
    QStringList shownTexts() const;
    /// Object names or texts of the last actions run, newest first; offered first when nothing is typed.
    const QStringList& recent() const { return m_recent; }
    void setRecent(const QStringList& recent) { m_recent = recent; }

signals:
    void ran(QAction* action);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Entry {
        QPointer<QAction> action;
        QString text;
    };
    void collect();
    void filter(const QString& text);
    void runCurrent();
    void moveCurrent(int rows);

    QWidget* m_window = nullptr;
    ActionSource m_source;
    QLineEdit* m_input = nullptr;
    QPointer<QWidget> m_before; // had the focus, and gets it back: commands are about it
    QListView* m_list = nullptr;
    QStandardItemModel* m_model = nullptr;
    std::vector<Entry> m_entries;
    QStringList m_recent;
};

} // namespace plc::kit
