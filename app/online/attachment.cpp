#include "app/online/attachment.h"

#include "app/online/attach_dialog.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "projects/remote/errors.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMainWindow>
#include <QMenu>
#include <QSaveFile>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QToolButton>

namespace plc::app {

using editor::RemoteController;
using State = RemoteController::State;

namespace {

constexpr int kMostRecent = 10;

/// Whatever the controller says its files are called, they stay below the folder.
QString placeOf(const std::string& path) {
    const QString clean = QDir::cleanPath(QString::fromStdString(path));
    const bool isInside = !clean.startsWith(QLatin1String("..")) && QDir::isRelativePath(clean);
    return isInside ? clean : QStringLiteral("src/") + QFileInfo(clean).fileName();
}

bool write(const QString& path, const QByteArray& bytes) {
    QDir().mkpath(QFileInfo(path).path());
    QSaveFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit();
}

} // namespace

Attachment& Attachment::of(editor::RunControl& control, const editor::Workspace& workspace,
                           const Surroundings& around) {
    auto* known = control.findChild<Attachment*>(QString(), Qt::FindDirectChildrenOnly);
    if (!known) known = new Attachment(control, workspace);
    known->follow(around);
    return *known;
}

Attachment::Attachment(editor::RunControl& control, const editor::Workspace& workspace)
    : QObject(&control), m_control(control), m_workspace(workspace) {
    connect(&m_run, &editor::AttachedRun::sessionReady, this, &Attachment::show);
    connect(&m_run, &editor::AttachedRun::failed, this, [this](const Message& why) {
        say(kit::messageText(why), true);
        emit failed(kit::messageText(why));
    });
    connect(&m_run.controller(), &RemoteController::stateChanged, this, [this] {
        const bool isGone = m_run.controller().state() == State::Detached;
        const Message why = m_run.controller().problem();
        showState();
        if (isGone && !why.isEmpty()) emit failed(kit::messageText(why));
        if (isGone && m_isShown) detach(); // it does not come back by itself
    });
}

/// The window may be another one than before, around the same control.
void Attachment::follow(const Surroundings& around) {
    if (m_window == around.window) return;
    m_window = around.window;
    m_around = around;
    m_control.disconnect(this);
    connect(&m_control, &editor::RunControl::sessionAboutToEnd, this, [this] {
        if (!m_control.session() || !m_control.session()->isMirror()) return;
        m_isShown = false;
        m_run.forget();
        m_run.controller().detach();
        showState();
    });
    m_button = new QToolButton(m_window);
    m_button->setObjectName("attachedButton");
    m_button->setAutoRaise(true);
    m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_button);
    menu->addAction(tr("Detach"), this, &Attachment::detach);
    m_button->setMenu(menu);
    m_window->statusBar()->addPermanentWidget(m_button);
    showState();
}

void Attachment::say(const QString& text, bool isError) const {
    if (m_window) m_around.say(text, isError);
}

void Attachment::ask() {
    AttachDialog dialog(*this, m_window);
    dialog.exec();
}

Result<void> Attachment::attach(RemoteController::Address address) {
    if (m_isShown) detach();
    address.name = QStringLiteral("studio");
    return m_run.controller().attach(std::move(address));
}

void Attachment::detach() {
    const bool wasShown = std::exchange(m_isShown, false);
    if (m_run.controller().state() != State::Detached) m_run.controller().detach();
    if (wasShown) m_control.showElsewhere(nullptr);
    m_run.forget();
    showState();
}

/// The program that runs there as a project of its own, so that its text can be looked at.
Result<QString> Attachment::fetchedProject(const driver::BuildInput& input) const {
    const QUrl& url = m_run.controller().address().url;
    const QString name = m_run.controller().project();
    QString folderName = QStringLiteral("%1-%2-%3").arg(url.host()).arg(url.port(80)).arg(name);
    for (QChar& each : folderName)
        if (!each.isLetterOrNumber() && each != u'-' && each != u'_' && each != u'.') each = u'_';
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/attached/" + folderName;
    QDir(folder).removeRecursively(); // what was fetched before
    QJsonArray libraries;
    for (const std::string& each : input.libraries) libraries.append(QString::fromStdString(each));
    const QJsonObject project{{"name", name}, {"libraries", libraries}};
    bool isGood = write(folder + "/project.json", QJsonDocument(project).toJson());
    for (const driver::SourceFile& file : input.files)
        isGood = isGood && write(folder + "/" + placeOf(file.path), QByteArray::fromStdString(file.text));
    if (!isGood) return Error{remote::errors::FileNotWritten(remote::errors::ofSystem(errno)), folder.toStdString()};
    return folder;
}

void Attachment::show() {
    std::unique_ptr<session::Session> mirror = m_run.takeSession();
    if (!mirror || !m_window) return;
    if (!m_workspace.isOpen()) {
        const auto folder = fetchedProject(*mirror->built().input);
        if (!folder)
            say(kit::messageText(folder.error()), true);
        else
            (void)m_around.openProject(*folder);
    }
    m_isShown = true;
    m_control.showElsewhere(std::move(mirror));
    remember();
    showState();
    say(m_control.isUpToDate()
            ? tr("Attached to %1").arg(m_run.controller().host())
            : tr("Attached to %1; its program is not the one that is open here").arg(m_run.controller().host()));
    emit attached();
}

void Attachment::showState() {
    if (!m_button) return;
    const QUrl& url = m_run.controller().address().url;
    const QString place = QStringLiteral("%1:%2").arg(url.host()).arg(url.port(80));
    const State state = m_run.controller().state();
    m_button->setVisible(state != State::Detached);
    const bool isLost = state == State::Lost;
    m_button->setIcon(kit::icon(isLost ? kit::Icon::Warning : kit::Icon::Link));
    m_button->setText(isLost                     ? tr("Connection to %1 lost – reconnecting…").arg(place)
                      : state == State::Attached ? tr("%1 at %2").arg(m_run.controller().project(), place)
                                                 : tr("Attaching to %1…").arg(place));
    m_button->setToolTip(isLost ? kit::messageText(m_run.controller().problem())
                                : tr("The controller runs remotely; values written and forced here take effect there"));
}

QList<QPair<QString, QString>> Attachment::recent() {
    QList<QPair<QString, QString>> out;
    const QStringList kept = QSettings("Stepwise", "Stepwise").value("attach/recent").toStringList();
    for (const QString& each : kept) out.append({each.section(u'\n', 0, 0), each.section(u'\n', 1)});
    return out;
}

void Attachment::remember() {
    QSettings store("Stepwise", "Stepwise");
    const RemoteController::Address& address = m_run.controller().address();
    QStringList kept{address.url.toString() + "\n" + address.trustFile};
    for (const auto& [url, trust] : recent())
        if (url != address.url.toString() && kept.size() < kMostRecent) kept.append(url + "\n" + trust);
    store.setValue("attach/recent", kept);
}

} // namespace plc::app
