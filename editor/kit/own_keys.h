// Shortcuts of a place win over those of the window: a designer's Ctrl+G groups although the window has a Ctrl+G as
// well (two shortcuts for one key would both be dead). Works on the QActions that were added to the place. GUI thread.
#pragma once
#include <QObject>
#include <QPointer>

class QAction;
class QKeyEvent;
class QWidget;

namespace plc::kit {

/// The action of `place` or of a widget around it that has the key; disabled ones too, as the key is theirs all the
/// same. Null when nobody has it.
[[nodiscard]] QAction* actionOfKey(const QWidget* place, const QKeyEvent& event);

/// Watches the place and lives with it.
class OwnKeys : public QObject {
    Q_OBJECT
public:
    explicit OwnKeys(QWidget* place);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* m_place = nullptr;
    QPointer<QAction> m_pressed; // whose key is on its way
};

} // namespace plc::kit
