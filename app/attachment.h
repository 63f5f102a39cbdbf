// The studio at a controller that `stepwise serve` runs: asks for the address, shows that controller in the place of
// one of its own, says in the status line how it stands, and lets it go. A child of the RunControl, because the
// session that it feeds is the control's; GUI thread.
#pragma once
#include "editor/debug/run_control.h"
#include "editor/remote/attached_run.h"

#include <QPointer>

class QToolButton;

namespace plc::app {

class MainWindow;

class Attachment : public QObject {
    Q_OBJECT
public:
    /// The one of the window's control; made when there is none.
    static Attachment& of(MainWindow& window);

    /// The dialog; it closes when the controller is attached.
    void ask(MainWindow& window);
    [[nodiscard]] Result<void> attach(editor::RemoteController::Address address);
    void detach();
    [[nodiscard]] bool isAttached() const { return m_isShown; }
    [[nodiscard]] editor::RemoteController& controller() { return m_run.controller(); }
    [[nodiscard]] QToolButton* button() const { return m_button; }
    /// Newest first: address and certificate file, never the code.
    [[nodiscard]] static QList<QPair<QString, QString>> recent();

signals:
    void attached();
    void failed(const QString& why);

private:
    explicit Attachment(MainWindow& window);
    void follow(MainWindow& window);
    void show();
    void showState();
    void remember();
    [[nodiscard]] Result<QString> fetchedProject(const driver::BuildInput& input) const;
    editor::RunControl& m_control;
    QPointer<MainWindow> m_window;
    editor::AttachedRun m_run;
    QPointer<QToolButton> m_button;
    bool m_isShown = false;
};

} // namespace plc::app
