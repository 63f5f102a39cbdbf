// The studio at a controller that `stepwise serve` runs: asks for the address, shows that controller in the place of
// one of its own, says in the status line how it stands, and lets it go. A child of the RunControl, because the
// session that it feeds is the control's; GUI thread.
#pragma once
#include "editor/debug/run_control.h"
#include "editor/remote/attached_run.h"

#include <QPointer>

#include <functional>

class QMainWindow;
class QToolButton;

namespace plc::app {

class Attachment : public QObject {
    Q_OBJECT
public:
    /// The window around the control, as far as an attachment has to do with it.
    struct Surroundings {
        QMainWindow* window;
        std::function<void(const QString& text, bool isError)> say;
        std::function<bool(const QString& folder)> openProject;
    };
    /// The one of a control; made when there is none.
    static Attachment& of(editor::RunControl& control, const editor::Workspace& workspace, const Surroundings& around);

    /// The dialog; it closes when the controller is attached.
    void ask();
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
    Attachment(editor::RunControl& control, const editor::Workspace& workspace);
    void follow(const Surroundings& around);
    void say(const QString& text, bool isError = false) const;
    void show();
    void showState();
    void remember();
    [[nodiscard]] Result<QString> fetchedProject(const driver::BuildInput& input) const;
    editor::RunControl& m_control;
    const editor::Workspace& m_workspace;
    Surroundings m_around{};
    QPointer<QMainWindow> m_window; // null once it is gone: then nothing of the surroundings is called
    editor::AttachedRun m_run;
    QPointer<QToolButton> m_button;
    bool m_isShown = false;
};

} // namespace plc::app
