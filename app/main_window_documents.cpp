// What the main window's actions do with the project's documents: panels, texts, alarms, traces.
#include "app/main_window.h"
#include "app/online/devices_view.h"
#include "app/pages/editor_tabs.h"
#include "app/panels/design_findings.h"
#include "app/panels/live_views.h"
#include "app/panels/panel_files.h"
#include "app/panels/text_page.h"
#include "app/project/new_project.h"
#include "app/project/project_tree.h"
#include "app/project/search_view.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "hmi/designer/editors/alarm_editor.h"
#include "hmi/designer/editors/people_editor.h"
#include "hmi/designer/editors/recipe_editor.h"
#include "hmi/designer/editors/text_editor.h"
#include "hmi/designer/panel_designer.h"
#include "projects/storage/project_file.h"

#include <QDir>
#include <QFileInfo>
#include <QInputDialog>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTimer>

namespace plc::app {

void MainWindow::newTrace() {
    if (!m_workspace->isOpen()) return;
    bool ok = false;
    const QString name =
        QInputDialog::getText(this, tr("New Trace"), tr("Name of the trace:"), QLineEdit::Normal, tr("trace"), &ok)
            .trimmed();
    if (!ok || name.isEmpty()) return;
    if (name.contains('/') || name.contains('\\'))
        return say(tr("A file name cannot contain / or \\; choose another name"), true);
    const QString path = m_workspace->folder() + "/traces/" + name + ".trace.json";
    if (QFile::exists(path)) return say(tr("A trace %1 already exists; choose another name").arg(name), true);
    QDir().mkpath(QFileInfo(path).path());
    if (auto saved = trace::saveSetup({}, path.toStdString()); !saved)
        return say(kit::messageText(saved.error()), true);
    if (auto read = m_workspace->rereadProject(); !read) return say(kit::messageText(read.error()), true);
    m_live->openTrace(name);
    showDock("trace");
}

namespace {
QString pathOf(const QString& folder, const QString& kind, const QString& name) {
    return kind == "panel"   ? folder + "/hmi/" + name + ".panel.json"
           : kind == "trace" ? folder + "/traces/" + name + ".trace.json"
                             : folder + "/" + name;
}
/// Buttons and the like of other panels that lead to a panel.
QRegularExpression leadsTo(const QString& panel) {
    return QRegularExpression("(\"panel\"\\s*:\\s*)\"" + QRegularExpression::escape(panel) + "\"");
}
} // namespace

void MainWindow::renameProjectFile(const QString& kind, const QString& name) {
    bool ok = false;
    const QString shown = kind == "test" || kind == "source" ? QFileInfo(name).completeBaseName() : name;
    const QString chosen =
        QInputDialog::getText(this, tr("Rename"), tr("New name of %1:").arg(shown), QLineEdit::Normal, shown, &ok)
            .trimmed();
    if (!ok || chosen.isEmpty() || chosen == shown) return;
    if (chosen.contains('/') || chosen.contains('\\'))
        return say(tr("A file name cannot contain / or \\; choose another name"), true);
    const auto report = [this](const Result<void>& result) {
        if (!result) say(kit::messageText(result.error()), true);
        return static_cast<bool>(result);
    };
    if (kind == "test" || kind == "source") return renameSource(name, QFileInfo(name).path() + "/" + chosen + ".st");
    const QString from = pathOf(m_workspace->folder(), kind, name), to = pathOf(m_workspace->folder(), kind, chosen);
    if (QFile::exists(to))
        return say(tr("A file %1 already exists; choose another name").arg(QFileInfo(to).fileName()), true);
    if (kind == "panel" && !closeDesigns()) return;
    if (kind == "trace") m_live->saveTrace();
    if (!QFile::rename(from, to))
        return say(tr("The file cannot be renamed; check the permissions of the folder"), true);
    if (kind == "panel") {
        for (const QFileInfo& other :
             QDir(m_workspace->folder() + "/hmi").entryInfoList({"*.panel.json"}, QDir::Files)) {
            const auto text = projects::readFile(other.filePath().toStdString());
            if (!text) continue;
            QString changed = QString::fromStdString(*text);
            changed.replace(leadsTo(name), "\\1\"" + chosen + "\"");
            if (!report(projects::writeFileAtomically(other.filePath().toStdString(), changed.toStdString()))) return;
        }
        projects::Project project = m_workspace->project();
        if (QString::fromStdString(project.startPanel) == name) {
            project.startPanel = chosen.toStdString();
            project.json["hmi"]["startPanel"] = project.startPanel;
            if (!report(m_workspace->saveProjectFile(project))) return;
        }
    }
    if (!report(m_workspace->rereadProject())) return;
    if (kind == "panel")
        m_live->reloadPanels();
    else if (QFileInfo(m_live->traceView().setupPath()).fileName() == QFileInfo(from).fileName())
        m_live->openTrace(chosen);
}

void MainWindow::deleteProjectFile(const QString& kind, const QString& name) {
    QStringList users;
    if (kind == "panel")
        for (const QFileInfo& other : QDir(m_workspace->folder() + "/hmi").entryInfoList({"*.panel.json"}, QDir::Files))
            if (const auto text = projects::readFile(other.filePath().toStdString());
                text && QString::fromStdString(*text).contains(leadsTo(name)))
                users << other.fileName();
    QString question =
        tr("Delete %1?")
            .arg(kind == "test" || kind == "source" ? name
                                                    : QFileInfo(pathOf(m_workspace->folder(), kind, name)).fileName());
    if (kind == "source") {
        QStringList units;
        if (const auto model = m_workspace->presentModel())
            if (const auto id = model->fileOf(name.toStdString()))
                for (const analysis::OutlineItem& item : model->outline(*id))
                    units << QString::fromStdString(item.name);
        if (!units.isEmpty()) question += "\n" + tr("It contains %1.").arg(units.join(", "));
    }
    if (!users.isEmpty())
        question +=
            "\n" + tr("These panels link to it; their buttons will be reported as errors: %1").arg(users.join(", "));
    if (QMessageBox::question(this, tr("Delete"), question) != QMessageBox::Yes) return;
    if (kind == "test" || kind == "source") {
        if (auto removed = m_workspace->removeFile(name); !removed) say(kit::messageText(removed.error()), true);
        return;
    }
    if (kind == "panel" && !closeDesigns()) return;
    const QString path = pathOf(m_workspace->folder(), kind, name);
    const bool isShown =
        kind == "trace" && QFileInfo(m_live->traceView().setupPath()).fileName() == QFileInfo(path).fileName();
    if (!QFile::moveToTrash(path) && !QFile::remove(path))
        return say(tr("The file cannot be removed; check the permissions of the folder"), true);
    if (auto read = m_workspace->rereadProject(); !read) return say(kit::messageText(read.error()), true);
    if (kind == "panel")
        m_live->reloadPanels();
    else if (isShown)
        m_live->openTrace({});
}

bool MainWindow::isDesignKey(const QString& key) {
    static const QStringList single{"texts", "alarms", "recipes", "people"};
    return key.startsWith("panel:") || single.contains(key);
}

bool MainWindow::closeDesigns() {
    for (int i = m_tabs->count() - 1; i >= 0; --i) {
        const QString key = m_tabs->widget(i)->property("pageKey").toString();
        if ((isDesignKey(key) || key.startsWith("text:")) && !m_tabs->closePage(i)) return false;
    }
    return true;
}

void MainWindow::newPanel() {
    if (!m_workspace->isOpen()) return;
    bool ok = false;
    const QString name =
        QInputDialog::getText(this, tr("New Panel"), tr("Name of the panel:"), QLineEdit::Normal, tr("overview"), &ok)
            .trimmed();
    if (!ok || name.isEmpty()) return;
    if (name.contains('/') || name.contains('\\'))
        return say(tr("A panel's name cannot contain / or \\; choose another name"), true);
    if (auto added = m_live->addPanel(name); !added) return say(kit::messageText(added.error()), true);
    openDesigner(name);
    if (QWidget* page = m_tabs->pageByKey("panel:" + name)) page->setFocus();
}

void MainWindow::addDesignPage(QWidget* page, const QString& title, int icon, const QString& key) {
    // A closed page dies a moment later, perhaps after the project: it keeps what it works on, the panels last.
    connect(page, &QObject::destroyed,
            [panels = m_live->sharedPanels(), design = m_live->sharedDesign()] { (void)panels, (void)design; });
    m_tabs->addPage(page, title, kit::icon(static_cast<kit::Icon>(icon)), key);
}

void MainWindow::openDesigner(const QString& panel) {
    if (!m_live->design()) return;
    const QString key = "panel:" + panel;
    if (!m_live->panels().find(panel)) return openAsText(key); // what is wrong with it can be put right there
    if (QWidget* open = m_tabs->pageByKey(key)) return m_tabs->setCurrentWidget(open);
    auto* designer = new hmi::PanelDesigner(*m_live->design(), panel, m_tabs);
    addDesignPage(designer, panel, static_cast<int>(kit::Icon::Panel), key);
    QTimer::singleShot(0, designer, [designer] { // once it has its size: the whole panel
        if (auto* fit = designer->findChild<QAction*>("zoom-fit")) fit->trigger();
    });
    constexpr int kLittle = 420; // pixels of height for a drawing with its lists around
    if (m_tabs->height() < kLittle)
        say(tr("%1 arranges the window for drawing panels")
                .arg(action("view.panelDesign")->shortcut().toString(QKeySequence::NativeText)));
    connect(designer, &hmi::PanelDesigner::panelRequested, this, &MainWindow::openDesigner); // of a faceplate
    connect(designer, &hmi::PanelDesigner::modifiedChanged, m_tabs,
            [this, key](bool modified) { m_tabs->markPage(key, modified); });
    m_tabs->markPage(key, m_files->isChanged(key));
}

void MainWindow::openAsText(const QString& key) {
    const QString path = m_files->pathOf(key);
    if (!QFile::exists(path)) return;
    if (QWidget* open = m_tabs->pageByKey("text:" + key)) return m_tabs->setCurrentWidget(open);
    auto* page = new TextPage(path, m_tabs);
    m_tabs->addPage(page, QFileInfo(path).fileName(), kit::icon(kit::Icon::Error), "text:" + key);
    connect(page, &TextPage::modifiedChanged, m_tabs,
            [this, key](bool modified) { m_tabs->markPage("text:" + key, modified); });
    const auto showProblem = [this, page, path] {
        const PanelProblem problem = m_findings->problemOf(m_live->panels().placeOf(path));
        page->showProblem(problem.message, problem.line);
    };
    showProblem();
    page->setFocus();
    connect(page, &TextPage::saved, this, [this, page, key, showProblem] {
        m_files->look();
        const bool isGood = m_live->panels().disk->isKnown(m_files->pathOf(key));
        if (!isGood) return showProblem();
        m_tabs->closePage(m_tabs->indexOf(page)); // it can be opened as what it is
        openDocument(key);
    });
}

void MainWindow::openDocument(const QString& key) {
    if (key == "texts") return openTexts();
    if (key == "alarms") return openAlarms();
    if (key == "recipes") return openRecipes();
    if (key == "people") return openPeople();
    openDesigner(key.mid(6));
}

void MainWindow::openTexts() {
    if (!m_live->design()) return;
    if (isUnread("texts")) return openAsText("texts");
    if (QWidget* open = m_tabs->pageByKey("texts")) return m_tabs->setCurrentWidget(open);
    addDesignPage(new hmi::TextEditor(*m_live->design(), m_tabs), tr("Texts"), static_cast<int>(kit::Icon::Texts),
                  "texts");
}

/// The file is there, and what it holds could not be understood.
bool MainWindow::isUnread(const QString& key) const {
    const QString path = m_files->pathOf(key);
    return QFile::exists(path) && !m_live->panels().disk->isKnown(path);
}

void MainWindow::openAlarms() {
    if (!m_live->design()) return;
    if (isUnread("alarms")) return openAsText("alarms");
    if (QWidget* open = m_tabs->pageByKey("alarms")) return m_tabs->setCurrentWidget(open);
    addDesignPage(new hmi::AlarmEditor(*m_live->design(), m_tabs), tr("Alarms"), static_cast<int>(kit::Icon::Alarm),
                  "alarms");
}

void MainWindow::openRecipes() {
    if (!m_live->design()) return;
    if (isUnread("recipes")) return openAsText("recipes");
    if (QWidget* open = m_tabs->pageByKey("recipes")) return m_tabs->setCurrentWidget(open);
    addDesignPage(new hmi::RecipeEditor(*m_live->design(), m_tabs), tr("Recipes"), static_cast<int>(kit::Icon::Table),
                  "recipes");
}

void MainWindow::openPeople() {
    if (!m_live->design()) return;
    if (isUnread("people")) return openAsText("people");
    if (QWidget* open = m_tabs->pageByKey("people")) return m_tabs->setCurrentWidget(open);
    addDesignPage(new hmi::PeopleEditor(*m_live->design(), m_tabs), tr("Users and Rights"),
                  static_cast<int>(kit::Icon::User), "people");
}

void MainWindow::report(const Result<void>& result) {
    if (!result) say(kit::messageText(result.error()), true);
}

void MainWindow::saveDocument() {
    QWidget* page = m_tabs->currentWidget();
    if (auto* text = qobject_cast<TextPage*>(page)) return report(text->save());
    if (m_tabs->currentPage()) return m_tabs->saveCurrent();
    if (!page || !m_live->design()) return;
    report(m_files->save(page->property("pageKey").toString()));
    saveLanguages();
}

void MainWindow::saveAll() {
    for (int i = 0; i < m_tabs->count(); ++i)
        if (auto* text = qobject_cast<TextPage*>(m_tabs->widget(i)); text && text->isModified()) report(text->save());
    report(m_files->saveAll());
    saveLanguages();
    m_tabs->saveAll();
}

void MainWindow::saveLanguages() {
    if (!m_live->design()) return;
    std::vector<std::string> languages;
    for (const QString& tag : m_live->panels().texts.settings().languages) languages.push_back(tag.toStdString());
    projects::Project project = m_workspace->project();
    if (languages == project.languages) return;
    project.languages = languages;
    project.json["hmi"]["languages"] = languages;
    if (auto saved = m_workspace->saveProjectFile(project); !saved) say(kit::messageText(saved.error()), true);
}

void MainWindow::openDesignPlace(const QString& file, const QString& element) {
    if (file == "devices.json") {
        showDock("devices");
        return DevicesView::of(*this).select(element);
    }
    if (file.endsWith(".csv")) return openTexts();
    if (!file.endsWith(".panel.json")) return openAlarms();
    const QString panel = QFileInfo(file).fileName().chopped(QString(".panel.json").size());
    openDesigner(panel);
    auto* designer = qobject_cast<hmi::PanelDesigner*>(m_tabs->pageByKey("panel:" + panel));
    if (designer && designer->document().panel().find(element)) designer->selection().set({element});
}

bool MainWindow::maySwitchAway(QWidget* page) {
    if (auto* text = qobject_cast<TextPage*>(page)) {
        if (!text->isModified()) return true;
        return asksToSave(
            QFileInfo(text->path()).fileName(), [text] { return text->save(); }, [] {});
    }
    return maySwitchAway(page->property("pageKey").toString());
}

bool MainWindow::maySwitchAway(const QString& key) {
    if (!m_files->isChanged(key)) return true;
    return asksToSave(
        PanelFiles::titleOf(key), [this, key] { return m_files->save(key); }, [this, key] { m_files->discard(key); });
}

bool MainWindow::asksToSave(const QString& title, const std::function<Result<void>()>& save,
                            const std::function<void()>& discard) {
    const auto answer = QMessageBox::question(this, tr("Unsaved changes"), tr("%1 was changed. Save it?").arg(title),
                                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Cancel) return false;
    if (answer == QMessageBox::Discard) {
        discard();
        return true;
    }
    const Result<void> saved = save();
    report(saved);
    return static_cast<bool>(saved);
}

/// All that is open or unsaved; false keeps the project.
bool MainWindow::mayLeaveProject() {
    if (!m_tabs->closeAll()) return false;
    for (const QString& key : m_files->changed()) // what has no page, as texts typed in a panel
        if (!maySwitchAway(key)) return false;
    return true;
}

} // namespace plc::app
