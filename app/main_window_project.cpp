// What the main window's actions do with the project: open, new, rename, libraries, tests, and what is kept per
// project.
#include "app/conversion_dialog.h"
#include "app/editor_tabs.h"
#include "app/live_views.h"
#include "app/main_window.h"
#include "app/new_project.h"
#include "app/project_tree.h"
#include "app/search_view.h"
#include "app/settings_dialog.h"
#include "app/start_page.h"
#include "app/tour.h"
#include "app/translation.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/icons.h"
#include "hmi/designer/alarm_editor.h"
#include "hmi/designer/panel_designer.h"
#include "hmi/designer/text_editor.h"
#include "projects/storage/project_file.h"
#include "projects/testing/test_run.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QStackedWidget>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>
#include <map>

namespace plc::app {

// ------------------------------------------------------------------ open and close

bool MainWindow::openProject(const QString& folder) {
    closeProject();
    if (m_workspace->isOpen()) return false; // kept open because of unsaved changes
    if (auto opened = m_workspace->open(folder); !opened) {
        m_settings.removeRecent(folder);
        m_startPage->reload();
        say(QString::fromStdString(opened.error().text()), true);
        QMessageBox::warning(this, tr("Open Project"), QString::fromStdString(opened.error().text()));
        return false;
    }
    m_settings.addRecent(m_workspace->folder());
    setWindowTitle(tr("%1 – Stepwise").arg(QString::fromStdString(m_workspace->project().name)));
    m_stack->setCurrentWidget(m_tabs);
    for (QDockWidget* each : findChildren<QDockWidget*>()) each->show();
    restoreProjectState();
    findChild<QToolBar*>("timeToolBar")->show();
    offerRecovery();
    return true;
}

void MainWindow::closeProject() {
    if (!m_workspace->isOpen()) return;
    saveProjectState();
    if (!m_tabs->closeAll()) return;
    m_workspace->discardRecovery();
    m_workspace->close();
    for (QDockWidget* each : findChildren<QDockWidget*>()) each->hide();
    findChild<QToolBar*>("timeToolBar")->hide();
    m_startPage->reload();
    m_stack->setCurrentWidget(m_startPage);
    setWindowTitle("Stepwise");
}

void MainWindow::saveProjectState() {
    const QString folder = m_workspace->folder();
    // Every page with its place: "src/main.st|120|Chart", "panel:overview".
    QStringList pages;
    for (int i = 0; i < m_tabs->count(); ++i) {
        if (auto* page = qobject_cast<StPage*>(m_tabs->widget(i)))
            pages << QStringList{page->file(), QString::number(page->first().cursorOffset()),
                                 page->chart() && page->chart()->isVisible() ? page->chart()->unit() : QString()}
                         .join('|');
        else if (const QString key = m_tabs->widget(i)->property("pageKey").toString(); !key.startsWith("library:"))
            pages << key;
    }
    m_settings.setProjectValue(folder, "pages", pages);
    m_settings.setProjectValue(folder, "currentPage", m_tabs->currentIndex());
    m_settings.setProjectValue(folder, "watches", m_watch->expressions());
    m_settings.setProjectValue(folder, "layout", saveState());
    QStringList breakpoints;
    for (const editor::EditorBreakpoint& b : m_control->breakpoints())
        breakpoints << QStringList{b.file,     QString::number(b.line), b.condition, QString::number(b.hitCount),
                                   b.instance, b.isEnabled ? "1" : "0"}
                           .join('\x1f');
    m_settings.setProjectValue(folder, "breakpoints", breakpoints);
}

void MainWindow::restoreProjectState() {
    const QString folder = m_workspace->folder();
    if (const QByteArray layout = m_settings.projectValue(folder, "layout").toByteArray(); !layout.isEmpty())
        restoreState(layout);
    else
        restoreState(m_defaultLayout);
    const QStringList pages = m_settings.projectValue(folder, "pages").toStringList();
    QStringList tabs;
    for (const QString& page : pages) {
        if (page.startsWith("panel:"))
            openDesigner(page.mid(6));
        else if (page == "texts")
            openTexts();
        else if (page == "alarms")
            openAlarms();
        else if (StPage* opened = m_tabs->openFile(page.section('|', 0, 0))) {
            opened->first().goTo(page.section('|', 1, 1).toUInt());
            if (const QString unit = page.section('|', 2); !unit.isEmpty()) opened->showChart(unit);
        }
    }
    if (m_tabs->count() > 0)
        m_tabs->setCurrentIndex(
            std::clamp(m_settings.projectValue(folder, "currentPage").toInt(), 0, m_tabs->count() - 1));
    if (tabs.isEmpty() && m_workspace->files().contains("src/main.st")) tabs << "src/main.st";
    if (tabs.isEmpty() && !m_workspace->files().isEmpty()) tabs << m_workspace->files().first();
    if (m_tabs->count() == 0)
        for (const QString& file : tabs) m_tabs->openFile(file);
    m_watch->setExpressions(m_settings.projectValue(folder, "watches").toStringList());
    std::vector<editor::EditorBreakpoint> breakpoints;
    for (const QString& text : m_settings.projectValue(folder, "breakpoints").toStringList()) {
        const QStringList parts = text.split('\x1f');
        if (parts.size() == 6)
            breakpoints.push_back({parts[0], parts[1].toInt(), parts[2], parts[3].toInt(), parts[4], parts[5] == "1"});
    }
    m_control->setBreakpoints(breakpoints);
}

void MainWindow::offerRecovery() {
    const auto found = m_workspace->recoverable();
    if (found.empty()) return;
    QStringList names;
    for (const auto& [file, text] : found) names << file;
    const auto answer = QMessageBox::question(
        this, tr("Recovery"),
        tr("The studio ended without saving. Unsaved changes of %1 were kept. Restore them?").arg(names.join(", ")));
    if (answer == QMessageBox::Yes)
        for (const auto& [file, text] : found) {
            m_workspace->setText(file, text);
            emit m_workspace->textReplaced(file);
        }
    else
        m_workspace->discardRecovery();
}

void MainWindow::fillRecentMenu() {
    m_recentMenu->clear();
    for (const QString& folder : m_settings.recentProjects())
        connect(m_recentMenu->addAction(folder), &QAction::triggered, this, [this, folder] { openProject(folder); });
    m_recentMenu->setEnabled(!m_recentMenu->isEmpty());
}

void MainWindow::newProject() {
    NewProjectDialog dialog(this);
    if (dialog.exec() != QDialog::Accepted) return;
    if (auto made = createProject(dialog.folder().toStdString(), dialog.name().toStdString(),
                                  dialog.templateId().toStdString());
        !made)
        return say(QString::fromStdString(made.error().text()), true);
    openProject(dialog.folder());
}

void MainWindow::chooseProject() {
    const QString folder = QFileDialog::getExistingDirectory(
        this, tr("Open Project"), m_workspace->isOpen() ? m_workspace->folder() : StartPage::examplesFolder());
    if (!folder.isEmpty()) openProject(folder);
}

// ------------------------------------------------------------------ units and names

void MainWindow::newUnit() {
    if (!m_workspace->isOpen()) return;
    NewUnitDialog dialog(m_workspace->files(), this);
    if (dialog.exec() != QDialog::Accepted) return;
    const std::string text = unitText(dialog.templateId().toStdString(), dialog.name().toStdString());
    const QString file = dialog.file();
    if (m_workspace->files().contains(file)) {
        const std::string old = m_workspace->text(file);
        const auto at = static_cast<uint32_t>(old.size());
        if (StPage* page = m_tabs->openFile(file)) {
            page->first().applyEdits(
                {{{FileId(), at, at}, (old.empty() || old.ends_with('\n') ? "\n" : "\n\n") + text}});
            page->first().goTo(at + 1);
        }
        return;
    }
    if (auto added = m_workspace->addFile(file, text); !added)
        return say(QString::fromStdString(added.error().text()), true);
    m_tabs->openFile(file);
}

void MainWindow::goToLine() {
    auto* editor = m_tabs->currentEditor();
    if (!editor) return;
    bool ok = false;
    const int line = QInputDialog::getInt(this, tr("Go to Line"), tr("Line (1 to %1)").arg(editor->lines()), 1, 1,
                                          editor->lines(), 1, &ok);
    if (ok) m_tabs->goToLine(editor->file(), line);
}

void MainWindow::findDefinition(const QString& file, uint32_t offset) {
    const auto model = m_workspace->model();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return;
    const auto place = model->definition(*id, offset);
    if (!place) return say(tr("Nothing is declared under this name"));
    const QString target = QString::fromStdString(model->sources()[place->file].path());
    m_tabs->goTo(target, place->begin, place->length());
}

void MainWindow::findUses(const QString& file, uint32_t offset) {
    const auto model = m_workspace->model();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return;
    const auto symbol = model->symbolAt(*id, offset);
    if (!symbol) return say(tr("There is no name at the cursor"));
    m_search->showUses(QString::fromStdString(model->symbol(*symbol).name), model->uses(*id, offset), model->sources());
    showDock("search");
}

void MainWindow::definitionAtCursor() {
    if (auto* editor = m_tabs->currentEditor()) findDefinition(editor->file(), editor->cursorOffset());
}
void MainWindow::usesAtCursor() {
    if (auto* editor = m_tabs->currentEditor()) findUses(editor->file(), editor->cursorOffset());
}
void MainWindow::renameAtCursor() {
    if (auto* editor = m_tabs->currentEditor()) renameSymbol(editor->file(), editor->cursorOffset());
}

void MainWindow::showConverted(analysis::TextLanguage to) {
    auto* editor = m_tabs->currentEditor();
    if (!editor) return;
    const std::string path = editor->file().toStdString();
    const auto places = [](const std::string& text, auto&& wanted) {
        std::optional<analysis::BodyPlace> found;
        for (const analysis::BodyPlace& place : analysis::bodiesOf(text))
            if (wanted(place)) found = place; // the innermost is the last
        return found;
    };
    const std::string text = editor->utf8();
    const uint32_t at = editor->cursorOffset();
    const auto before = places(
        text, [&](const analysis::BodyPlace& place) { return at >= place.range.begin && at <= place.range.end; });
    if (!before) return say(tr("Put the cursor into a unit that is written in ST or IL"), true);
    driver::BuildInput input = m_workspace->buildInput();
    for (driver::SourceFile& source : input.files)
        if (source.path == path) source.text = text;
    const auto converted = analysis::convertBody(input, path, before->unit, to);
    if (!converted) return say(QString::fromStdString(converted.error().text()), true);
    const auto after =
        places(converted->text, [&](const analysis::BodyPlace& place) { return place.unit == before->unit; });
    const auto slice = [](const std::string& whole, const std::optional<analysis::BodyPlace>& place) {
        return place ? whole.substr(place->range.begin, place->range.length()) : whole;
    };
    auto* dialog = new ConversionDialog(slice(text, before), slice(converted->text, after), *converted, to, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ConversionDialog::replaceRequested, editor, [this, editor, text, edits = converted->edits] {
        if (editor->utf8() == text)
            editor->applyEdits(edits);
        else
            say(tr("The text has changed meanwhile"), true);
    });
    dialog->open();
}

void MainWindow::renameSymbol(const QString& file, uint32_t offset) {
    const auto model = m_workspace->model();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return;
    const auto symbol = model->symbolAt(*id, offset);
    if (!symbol) return say(tr("There is no name at the cursor"));
    const QString old = QString::fromStdString(model->symbol(*symbol).name);
    bool ok = false;
    const QString name = QInputDialog::getText(this, tr("Rename"), tr("New name of %1, in the whole project:").arg(old),
                                               QLineEdit::Normal, old, &ok)
                             .trimmed();
    if (!ok || name.isEmpty() || name == old) return;
    const auto edits = model->rename(*id, offset, name.toStdString());
    if (!edits) return say(QString::fromStdString(edits.error().text()), true);
    size_t places = 0;
    for (const analysis::FileEdits& each : *edits) places += each.edits.size();
    m_tabs->applyEdits(*edits, model->sources());
    const sema::Symbol& symbolNow = model->symbol(*symbol);
    const QString path = QString::fromStdString(symbolNow.path);
    if (m_live->design() && path.endsWith(old, Qt::CaseInsensitive) &&
        m_live->design()->renameVariable(path, path.left(path.size() - old.size()) + name))
        (void)m_live->design()->save();
    emit renamed(QString::fromStdString(model->symbol(*symbol).path), old, name);
    say(tr("%1 is now %2 in %n place(s)", nullptr, static_cast<int>(places)).arg(old, name));
}

void MainWindow::deleteUnit(const QString& file, uint32_t begin, uint32_t end, const QString& name) {
    const auto model = m_workspace->model();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return;
    int others = 0;
    for (const analysis::Use& use : model->uses(*id, begin))
        others += !use.isDeclaration && !(use.range.file == *id && use.range.begin >= begin && use.range.end <= end);
    QString question = tr("Delete %1?").arg(name);
    if (others) question += "\n" + tr("It is used in %n other place(s).", nullptr, others);
    QMessageBox box(QMessageBox::Question, tr("Delete"), question, QMessageBox::Cancel, this);
    QPushButton* plain = box.addButton(tr("Delete"), QMessageBox::DestructiveRole);
    QPushButton* commentOut =
        others ? box.addButton(tr("Delete and Comment Out the Uses"), QMessageBox::DestructiveRole) : nullptr;
    QPushButton* show = others ? box.addButton(tr("Show the Uses"), QMessageBox::ActionRole) : nullptr;
    box.exec();
    if (show && box.clickedButton() == show) return findUses(file, begin);
    const bool comments = commentOut && box.clickedButton() == commentOut;
    if (!comments && box.clickedButton() != plain) return;
    if (others) findUses(file, begin);
    SourceRange range{*id, begin, end};
    for (const analysis::OutlineItem& item : model->outline(*id))
        if (item.nameRange.begin == begin) range = item.range;
    const std::string text = m_workspace->text(file);
    while (range.end < text.size() && (text[range.end] == ' ' || text[range.end] == '\t' || text[range.end] == ';'))
        ++range.end;
    if (range.end < text.size() && text[range.end] == '\n') ++range.end;
    std::map<FileId, std::vector<diagnostics::TextEdit>> edits;
    edits[*id].push_back({range, ""});
    if (comments)
        for (const analysis::Use& use : model->uses(*id, begin)) {
            if (use.isDeclaration ||
                (use.range.file == *id && use.range.begin >= range.begin && use.range.end <= range.end))
                continue;
            const std::string_view source = model->sources()[use.range.file].text();
            const size_t newline =
                use.range.begin == 0 ? std::string_view::npos : source.rfind('\n', use.range.begin - 1);
            const auto lineBegin = static_cast<uint32_t>(newline == std::string_view::npos ? 0 : newline + 1);
            auto& here = edits[use.range.file];
            if (std::none_of(here.begin(), here.end(),
                             [&](const diagnostics::TextEdit& each) { return each.range.begin == lineBegin; }))
                here.push_back({{use.range.file, lineBegin, lineBegin}, "// "});
        }
    std::vector<analysis::FileEdits> all;
    for (auto& [where, list] : edits) {
        std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.range.begin < b.range.begin; });
        all.push_back({where, std::move(list)});
    }
    m_tabs->applyEdits(all, model->sources());
    // A file that held nothing else goes with it.
    const std::string rest = m_workspace->text(file);
    if (rest.find_first_not_of(" \t\r\n") == std::string::npos)
        if (auto removed = m_workspace->removeFile(file); !removed)
            say(QString::fromStdString(removed.error().text()), true);
}

// ------------------------------------------------------------------ files of the project

void MainWindow::newTrace() {
    if (!m_workspace->isOpen()) return;
    bool ok = false;
    const QString name =
        QInputDialog::getText(this, tr("New Trace"), tr("Name of the trace:"), QLineEdit::Normal, tr("trace"), &ok)
            .trimmed();
    if (!ok || name.isEmpty()) return;
    if (name.contains('/') || name.contains('\\')) return say(tr("A file name holds no / and no \\"), true);
    const QString path = m_workspace->folder() + "/traces/" + name + ".trace.json";
    if (QFile::exists(path)) return say(tr("There is a trace %1 already").arg(name), true);
    QDir().mkpath(QFileInfo(path).path());
    if (auto saved = trace::saveSetup({}, path.toStdString()); !saved)
        return say(QString::fromStdString(saved.error().text()), true);
    if (auto read = m_workspace->rereadProject(); !read) return say(QString::fromStdString(read.error().text()), true);
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
    const QString shown = kind == "test" ? QFileInfo(name).completeBaseName() : name;
    const QString chosen =
        QInputDialog::getText(this, tr("Rename"), tr("New name of %1:").arg(shown), QLineEdit::Normal, shown, &ok)
            .trimmed();
    if (!ok || chosen.isEmpty() || chosen == shown) return;
    if (chosen.contains('/') || chosen.contains('\\')) return say(tr("A file name holds no / and no \\"), true);
    const auto report = [this](const Result<void>& result) {
        if (!result) say(QString::fromStdString(result.error().text()), true);
        return static_cast<bool>(result);
    };
    if (kind == "test")
        return void(report(m_workspace->renameFile(name, QFileInfo(name).path() + "/" + chosen + ".st")));
    const QString from = pathOf(m_workspace->folder(), kind, name), to = pathOf(m_workspace->folder(), kind, chosen);
    if (QFile::exists(to)) return say(tr("There is a file %1 already").arg(QFileInfo(to).fileName()), true);
    if (kind == "panel" && !closeDesigns()) return;
    if (kind == "trace") m_live->saveTrace();
    if (!QFile::rename(from, to))
        return say(tr("The file can not be renamed; check the permissions of the folder"), true);
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
        tr("Delete %1?").arg(kind == "test" ? name : QFileInfo(pathOf(m_workspace->folder(), kind, name)).fileName());
    if (!users.isEmpty())
        question += "\n" + tr("These panels lead to it; their buttons will be problems: %1").arg(users.join(", "));
    if (QMessageBox::question(this, tr("Delete"), question) != QMessageBox::Yes) return;
    if (kind == "test") {
        if (auto removed = m_workspace->removeFile(name); !removed)
            say(QString::fromStdString(removed.error().text()), true);
        return;
    }
    if (kind == "panel" && !closeDesigns()) return;
    const QString path = pathOf(m_workspace->folder(), kind, name);
    const bool isShown =
        kind == "trace" && QFileInfo(m_live->traceView().setupPath()).fileName() == QFileInfo(path).fileName();
    if (!QFile::moveToTrash(path) && !QFile::remove(path))
        return say(tr("The file can not be removed; check the permissions of the folder"), true);
    if (auto read = m_workspace->rereadProject(); !read) return say(QString::fromStdString(read.error().text()), true);
    if (kind == "panel")
        m_live->reloadPanels();
    else if (isShown)
        m_live->openTrace({});
}

bool MainWindow::closeDesigns() {
    for (int i = m_tabs->count() - 1; i >= 0; --i) {
        const QString key = m_tabs->widget(i)->property("pageKey").toString();
        if ((key.startsWith("panel:") || key == "texts" || key == "alarms") && !m_tabs->closePage(i)) return false;
    }
    return true;
}

// ------------------------------------------------------------------ libraries, tests

void MainWindow::chooseLibraries() {
    if (!m_workspace->isOpen()) return;
    QDialog dialog(this);
    dialog.setWindowTitle(tr("Libraries"));
    auto* layout = new QVBoxLayout(&dialog);
    std::vector<std::pair<std::string, QCheckBox*>> boxes;
    const auto& used = m_workspace->project().libraries;
    for (const std::string& name : driver::libraryNames()) {
        auto* box = new QCheckBox(QString::fromStdString(name), &dialog);
        box->setChecked(std::find(used.begin(), used.end(), name) != used.end());
        layout->addWidget(box);
        boxes.emplace_back(name, box);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    layout->addWidget(buttons);
    if (dialog.exec() != QDialog::Accepted) return;
    projects::Project project = m_workspace->project();
    project.libraries.clear();
    for (const auto& [name, box] : boxes)
        if (box->isChecked()) project.libraries.push_back(name);
    project.json["libraries"] = project.libraries;
    if (auto saved = m_workspace->saveProjectFile(project); !saved)
        say(QString::fromStdString(saved.error().text()), true);
}

void MainWindow::runTests() {
    if (!m_workspace->isOpen() || m_isTesting) return;
    projects::Project project = m_workspace->project();
    project.sources = m_workspace->buildInput().files;
    project.tests.clear();
    for (const QString& file : m_workspace->files())
        if (editor::Workspace::isTestFile(file)) project.tests.push_back({file.toStdString(), m_workspace->text(file)});
    showDock("log");
    say(tr("The tests run…"));
    if (m_tester.joinable()) m_tester.join();
    m_isTesting = true;
    m_tester = std::thread([this, project = std::move(project)] {
        auto report = testing::runTests(project, {});
        QMetaObject::invokeMethod(
            this,
            [this, report = std::make_shared<Result<testing::Report>>(std::move(report))] {
                m_isTesting = false;
                if (!*report) return say(QString::fromStdString(report->error().text()), true);
                const testing::Report& done = **report;
                for (const std::string& text : done.diagnostics)
                    m_log->addMessage(QString::fromStdString(text).trimmed(), true);
                for (const testing::TestResult& result : done.results) {
                    m_log->addMessage((result.passed() ? tr("passed: %1") : tr("FAILED: %1"))
                                          .arg(QString::fromStdString(result.title)),
                                      !result.passed());
                    for (const testing::Failure& failure : result.failures)
                        m_log->addMessage(
                            QString("    %1:%2  %3  %4")
                                .arg(QString::fromStdString(failure.file))
                                .arg(failure.line)
                                .arg(QString::fromStdString(failure.message), QString::fromStdString(failure.detail)),
                            true);
                }
                say(tr("%1 passed, %2 failed").arg(done.results.size() - done.failed()).arg(done.failed()),
                    done.failed() != 0 || done.hasErrors);
            },
            Qt::QueuedConnection);
    });
}

// ------------------------------------------------------------------ settings and the like

void MainWindow::openSettings() {
    SettingsDialog dialog(m_settings, m_actions, this);
    if (dialog.exec() != QDialog::Accepted) return;
    changeTheme(m_settings.theme());
    m_tabs->applySettings();
    if (m_control->session())
        m_control->session()->history().setBudget(static_cast<size_t>(m_settings.historyMegabytes()) << 20);
    if (dialog.languageChanged()) restartForLanguage();
}

void MainWindow::setSpeed() {
    const QStringList choices{tr("Real time"), tr("2 ×"), tr("10 ×"), tr("100 ×"), tr("As fast as possible")};
    bool ok = false;
    const QString chosen =
        QInputDialog::getItem(this, tr("Speed"), tr("Speed of the controller:"), choices, 0, false, &ok);
    if (!ok) return;
    const int index = static_cast<int>(choices.indexOf(chosen));
    if (index == 0)
        m_control->setMode({session::Pace::Real, 1.0});
    else if (index == 4)
        m_control->setMode({session::Pace::Fastest, 1.0});
    else
        m_control->setMode({session::Pace::Factor, index == 1 ? 2.0 : index == 2 ? 10.0 : 100.0});
}

void MainWindow::setHistoryBudget() {
    bool ok = false;
    const int megabytes =
        QInputDialog::getInt(this, tr("Recording"), tr("Memory for the recording of every scan [MB]:"),
                             m_settings.historyMegabytes(), 16, 16384, 16, &ok);
    if (!ok) return;
    m_settings.setHistoryMegabytes(megabytes);
    if (m_control->session()) m_control->session()->history().setBudget(static_cast<size_t>(megabytes) << 20);
}

// ------------------------------------------------------------------ panels, texts, alarms

void MainWindow::newPanel() {
    if (!m_workspace->isOpen()) return;
    bool ok = false;
    const QString name =
        QInputDialog::getText(this, tr("New Panel"), tr("Name of the panel:"), QLineEdit::Normal, tr("overview"), &ok)
            .trimmed();
    if (!ok || name.isEmpty()) return;
    if (name.contains('/') || name.contains('\\'))
        return say(tr("A panel's name is a file name: no / and no \\"), true);
    if (auto added = m_live->addPanel(name); !added) return say(QString::fromStdString(added.error().text()), true);
    openDesigner(name);
}

void MainWindow::addDesignPage(QWidget* page, const QString& title, int icon, const QString& key) {
    // A closed page dies a moment later, perhaps after the project: it keeps what it works on.
    connect(page, &QObject::destroyed, [kept = m_live->sharedDesign()] { (void)kept; });
    m_tabs->addPage(page, title, kit::icon(static_cast<kit::Icon>(icon)), key);
}

void MainWindow::openDesigner(const QString& panel) {
    if (!m_live->design() || !m_live->panels().find(panel)) return;
    const QString key = "panel:" + panel;
    if (QWidget* open = m_tabs->pageByKey(key)) return m_tabs->setCurrentWidget(open);
    auto* designer = new hmi::PanelDesigner(*m_live->design(), panel, m_tabs);
    addDesignPage(designer, panel, static_cast<int>(kit::Icon::Panel), key);
    QTimer::singleShot(0, designer, [designer] { // once it has its size: the whole panel
        if (auto* fit = designer->findChild<QAction*>("zoom-fit")) fit->trigger();
    });
    connect(designer, &hmi::PanelDesigner::modifiedChanged, this, [this, designer, panel](bool modified) {
        m_tabs->setTabText(m_tabs->indexOf(designer), panel + (modified ? " ●" : ""));
    });
}

void MainWindow::openTexts() {
    if (!m_live->design()) return;
    if (QWidget* open = m_tabs->pageByKey("texts")) return m_tabs->setCurrentWidget(open);
    addDesignPage(new hmi::TextEditor(*m_live->design(), m_tabs), tr("Texts"), static_cast<int>(kit::Icon::Texts),
                  "texts");
}

void MainWindow::openAlarms() {
    if (!m_live->design()) return;
    if (QWidget* open = m_tabs->pageByKey("alarms")) return m_tabs->setCurrentWidget(open);
    addDesignPage(new hmi::AlarmEditor(*m_live->design(), m_tabs), tr("Alarms"), static_cast<int>(kit::Icon::Alarm),
                  "alarms");
}

void MainWindow::saveDocument() {
    if (auto* designer = qobject_cast<hmi::PanelDesigner*>(m_tabs->currentWidget())) {
        if (auto saved = designer->save(); !saved) return say(QString::fromStdString(saved.error().text()), true);
        if (m_live->player()) m_live->player()->projectChanged();
    }
    if (m_live->design())
        if (auto saved = m_live->design()->save(); !saved)
            return say(QString::fromStdString(saved.error().text()), true);
    saveLanguages();
    m_tabs->saveCurrent();
}

void MainWindow::saveLanguages() {
    if (!m_live->design()) return;
    std::vector<std::string> languages;
    for (const QString& tag : m_live->panels().texts.settings().languages) languages.push_back(tag.toStdString());
    projects::Project project = m_workspace->project();
    if (languages == project.languages) return;
    project.languages = languages;
    project.json["hmi"]["languages"] = languages;
    if (auto saved = m_workspace->saveProjectFile(project); !saved)
        say(QString::fromStdString(saved.error().text()), true);
}

void MainWindow::openDesignPlace(const QString& file, const QString& element) {
    if (file.endsWith(".csv")) return openTexts();
    if (!file.endsWith(".panel.json")) return openAlarms();
    const QString panel = QFileInfo(file).fileName().chopped(QString(".panel.json").size());
    openDesigner(panel);
    auto* designer = qobject_cast<hmi::PanelDesigner*>(m_tabs->pageByKey("panel:" + panel));
    if (designer && designer->document().panel().find(element)) designer->selection().set({element});
}

bool MainWindow::maySwitchAway(QWidget* page) {
    auto* designer = qobject_cast<hmi::PanelDesigner*>(page);
    const bool isTexts = qobject_cast<hmi::TextEditor*>(page) != nullptr,
               isAlarms = qobject_cast<hmi::AlarmEditor*>(page) != nullptr;
    hmi::DesignContext* design = m_live->design();
    const bool changed = (designer && designer->isModified()) || (design && isTexts && design->areTextsChanged()) ||
                         (design && isAlarms && design->areAlarmsChanged());
    if (!changed) return true;
    const QString name = designer ? tr("Panel %1").arg(designer->panelName()) : isTexts ? tr("Texts") : tr("Alarms");
    const auto answer = QMessageBox::question(this, tr("Unsaved changes"), tr("%1 was changed. Save it?").arg(name),
                                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Cancel) return false;
    Result<void> saved;
    if (answer == QMessageBox::Save)
        saved = designer ? designer->save() : design->save();
    else if (designer)
        m_live->discardPanel(designer->panelName());
    else
        m_live->discardTables();
    if (!saved) say(QString::fromStdString(saved.error().text()), true);
    return static_cast<bool>(saved);
}

void MainWindow::openRecording() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open a Recording"), m_workspace->folder(), tr("Recordings (*.rec)"));
    if (path.isEmpty()) return;
    if (auto opened = m_live->openRecording(path); !opened)
        return say(QString::fromStdString(opened.error().text()), true);
    showDock("trace");
}

void MainWindow::backToLive() {
    if (m_control->showsRecorded()) m_live->closeRecording();
    m_control->view(std::nullopt);
}

void MainWindow::restartForLanguage() {
    const auto answer = QMessageBox::question(this, tr("Language"),
                                              tr("The window is built anew in the other language; the project opens "
                                                 "again where it was, and a running controller stops. Do it now?"));
    if (answer != QMessageBox::Yes) return;
    m_folderToReopen = m_workspace->isOpen() ? m_workspace->folder() : QString();
    m_settings.setWindowGeometry(saveGeometry());
    m_wantsRestart = true;
    if (!close()) m_wantsRestart = false;
}

void MainWindow::saveRecording() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save the Recording"), m_workspace->folder() + "/recording.rec", tr("Recordings (*.rec)"));
    if (path.isEmpty()) return;
    if (auto saved = m_live->saveRecording(path); !saved)
        say(QString::fromStdString(saved.error().text()), true);
    else
        say(tr("Saved: %1").arg(path));
}

void MainWindow::about() {
    QMessageBox::about(this, tr("About Stepwise"),
                       tr("<h3>Stepwise 0.1</h3><p>An open PLC studio: IEC 61131-3 programs as native code, every scan "
                          "recorded, operator panels in many languages.</p><p>Licence: GPL-3.0</p>"));
}

void MainWindow::startTour() {
    if (!m_workspace->isOpen()) {
        const QString example = StartPage::examplesFolder() + "/pid_pt1";
        if (!openProject(example)) return;
    }
    const auto dockWidget = [this](const char* name) { return [this, name]() -> QWidget* { return dock(name); }; };
    std::vector<TourStop> stops = {
        {tr("Welcome"),
         tr("This is a PID controller working on a simulated process: the program above, its trace below, its operator "
            "panel at the right. Nothing can break: the plant is only numbers. Press Next to look around for a minute, "
            "or F5 to run it at once."),
         {},
         {}},
        {tr("The project"),
         tr("Programs, blocks, tasks, panels, traces and tests, made from the text files in the folder."),
         dockWidget("project"), [this] { showDock("project"); }},
        {tr("The program"),
         tr("Structured Text with colours by meaning. Errors are underlined while you type; Alt+Enter mends what it "
            "can; Ctrl+Space completes."),
         [this]() -> QWidget* { return m_tabs; },
         {}},
        {tr("Run"), tr("F5 compiles to native code and runs it. Values then stand beside each line."),
         [this]() -> QWidget* { return findChild<QToolBar*>("mainToolBar"); },
         [this] {
             if (!m_control->isRunning()) m_control->start();
         }},
        {tr("Watch"), tr("Any expression, at any moment. Prepare a value and write or force it with one click."),
         dockWidget("watch"),
         [this] {
             showDock("watch");
             if (m_watch->expressions().isEmpty())
                 m_watch->setExpressions({"Main.SetPoint", "Main.ControlError", "Plant.ClosedLoop", "Plant.OpenLoop"});
         }},
        {tr("The trace"),
         tr("Nothing had to be chosen before it happened: every scan is recorded, and a chart can be made of any "
            "expression afterwards."),
         dockWidget("trace"), [this] { showDock("trace"); }},
        {tr("The panel"),
         tr("What the operator sees, in the languages of the machine. It works here as it will on the machine."),
         dockWidget("panel"), [this] { showDock("panel"); }},
        {tr("Time runs backwards, too"),
         tr("Drag the time slider, or press Ctrl+Alt+Left: code, charts and panel show the past. “Resume From Here” "
            "goes on from there."),
         [this]() -> QWidget* { return findChild<QToolBar*>("timeToolBar"); },
         {}},
        {tr("That is it"),
         tr("Ctrl+Shift+P finds every command. The start page has more machines to play with."),
         {},
         {}},
    };
    auto* tour = new Tour(std::move(stops), this);
    connect(tour, &Tour::finished, this, [this, tour] {
        m_settings.setSawTour();
        tour->deleteLater();
    });
    tour->begin();
}

} // namespace plc::app
