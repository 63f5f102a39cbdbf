#include "app/pages/editor_tabs.h"

#include "app/pages/disk_change.h"
#include "app/pages/file_changes.h"
#include "app/pages/graph_pages.h"
#include "app/pages/instance_bar.h"
#include "editor/debug/line_map.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTabBar>
#include <QToolTip>

namespace plc::app {

using editor::StEditor;

// ------------------------------------------------------------------ the tabs

EditorTabs::EditorTabs(editor::Workspace& workspace, editor::RunControl& control, Settings& settings, QWidget* parent)
    : QTabWidget(parent), m_workspace(workspace), m_control(control), m_settings(settings),
      m_changes(std::make_unique<FileChanges>(workspace, *this)), m_marks(new OnlineMarks(*this, workspace, control)),
      m_graphs(new GraphPages(*this, *m_marks, workspace, control, settings)) {
    setDocumentMode(true);
    setTabsClosable(true);
    setMovable(true);
    setAccessibleName(tr("Documents"));
    tabBar()->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(this, &QTabWidget::tabCloseRequested, this, &EditorTabs::closePage);
    connect(tabBar(), &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        const int index = tabBar()->tabAt(at);
        if (index < 0) return;
        QMenu menu(this);
        connect(menu.addAction(tr("Close")), &QAction::triggered, this, [this, index] { closePage(index); });
        connect(menu.addAction(tr("Close Others")), &QAction::triggered, this, [this, index] { closeOthers(index); });
        menu.exec(tabBar()->mapToGlobal(at));
    });
    connect(&workspace, &editor::Workspace::analysed, this,
            [this](const std::shared_ptr<const analysis::CodeModel>& model) {
                for (StPage* page : pages()) {
                    for (StEditor* editor : page->editors()) editor->setModel(model);
                    page->table().setModel(model);
                    for (editor::GraphView* graph : page->graphs()) graph->setModel(model, page->file());
                }
            });
    connect(&workspace, &editor::Workspace::textReplaced, this, [this](const QString& file) {
        if (StPage* page = pageOf(file)) {
            const editor::LineMap map(page->first().utf8(), m_workspace.text(file));
            std::map<int, int> moved;
            for (const editor::EditorBreakpoint& b : m_control.breakpoints())
                if (b.file == file) moved[b.line] = map.nearest(b.line);
            page->first().takeText(m_workspace.text(file)); // undo leads back to what was here
            for (StEditor* each : page->editors()) each->setSavedText(m_workspace.savedText(file));
            m_control.moveBreakpoints(file, moved);
            m_marks->showBreakpoints();
        }
    });
    connect(&workspace, &editor::Workspace::modificationChanged, this, &EditorTabs::markModified);
    connect(&workspace, &editor::Workspace::saved, this, [this](const QString& file) {
        if (StPage* page = pageOf(file))
            for (StEditor* each : page->editors()) each->setSavedText(m_workspace.text(file));
    });
    connect(&workspace, &editor::Workspace::accessChanged, this, [this](const QString& file, bool isReadOnly) {
        if (StPage* page = pageOf(file)) page->showReadOnly(isReadOnly);
    });
    connect(&workspace, &editor::Workspace::changedOnDiskAndHere, this, &EditorTabs::askAboutDiskChange);
    connect(&workspace, &editor::Workspace::filesChanged, this, [this] {
        const QStringList files = m_workspace.files();
        for (int i = count() - 1; i >= 0; --i)
            if (auto* page = qobject_cast<StPage*>(widget(i));
                page && !page->isLibrary() && !files.contains(page->file())) {
                removeTab(i);
                page->deleteLater();
            }
    });
    connect(&workspace, &editor::Workspace::closed, this, [this] {
        while (count()) {
            QWidget* page = widget(0);
            removeTab(0);
            page->deleteLater();
        }
        m_visited = {};
        m_changes->clear();
    });
}

EditorTabs::~EditorTabs() = default;

std::vector<StPage*> EditorTabs::pages() const {
    std::vector<StPage*> out;
    for (int i = 0; i < count(); ++i)
        if (auto* page = qobject_cast<StPage*>(widget(i))) out.push_back(page);
    return out;
}

StPage* EditorTabs::pageOf(const QString& file) const {
    for (int i = 0; i < count(); ++i)
        if (auto* page = qobject_cast<StPage*>(widget(i)); page && page->file() == file) return page;
    return nullptr;
}

QStringList EditorTabs::openFiles() const {
    QStringList out;
    for (int i = 0; i < count(); ++i)
        if (auto* page = qobject_cast<StPage*>(widget(i)); page && !page->isLibrary()) out << page->file();
    return out;
}

StPage* EditorTabs::openFile(const QString& file) {
    if (!m_workspace.files().contains(file)) return nullptr;
    if (StPage* page = pageOf(file)) {
        setCurrentWidget(page);
        return page;
    }
    auto* page = new StPage(file, this);
    page->first().load(m_workspace.text(file));
    page->first().setSavedText(m_workspace.savedText(file));
    connectPage(page);
    connect(&page->table(), &editor::DeclarationTable::renameRequested, this,
            [this, file](uint32_t offset, const QString& name) { emit renameRequested(file, offset, name); });
    const int index = addTab(page, kit::icon(m_workspace.isTestFile(file) ? kit::Icon::Test : kit::Icon::File),
                             QFileInfo(file).fileName());
    setTabToolTip(index, m_workspace.absolutePath(file));
    setCurrentIndex(index);
    markModified(file, m_workspace.isModified(file));
    page->showReadOnly(m_workspace.isReadOnly(file));
    page->showPreferred();
    connect(page, &StPage::writableRequested, this, &EditorTabs::makeWritable);
    m_marks->showBreakpoints();
    return page;
}

void EditorTabs::openBeside(const QString& file) {
    StPage* here = currentPage();
    StPage* other = openFile(file);
    if (!here || !other || here == other) return;
    setCurrentWidget(here);
    here->showBeside(other);
}

void EditorTabs::connectPage(StPage* page) {
    connect(page, &StPage::editorMade, this, &EditorTabs::connectEditor);
    connect(page, &StPage::chartMade, this, [this, page](editor::ChartView* chart) { m_graphs->add(page, chart); });
    connect(page, &StPage::ladderMade, this, [this, page](editor::LadderView* ladder) { m_graphs->add(page, ladder); });
    connectEditor(&page->first());
    connect(&page->instanceBar(), &InstanceBar::instanceChosen, &m_control, &editor::RunControl::setPreferredInstance);
    page->table().setOnlineValues(m_marks->values());
    page->table().setModel(m_workspace.model());
}

StEditor* EditorTabs::openSource(const QString& file) {
    if (StPage* page = openFile(file)) return &page->active();
    const QString key = "library:" + file;
    if (auto* open = qobject_cast<StPage*>(pageByKey(key))) {
        setCurrentWidget(open);
        return &open->active();
    }
    // A library's source opens read-only beside the project's; breakpoints, values and steps work in it as anywhere.
    const auto model = m_workspace.model();
    const auto id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id) return nullptr;
    auto* page = new StPage(file, this, StPage::Kind::Library);
    page->first().setReadOnly(false);
    page->first().load(std::string(model->sources()[*id].text()));
    page->first().setReadOnly(true);
    connectPage(page);
    addPage(page, file.section('/', -1), kit::icon(kit::Icon::Library), key);
    setTabToolTip(indexOf(page), file);
    m_marks->showBreakpoints();
    return &page->first();
}

std::vector<StEditor*> EditorTabs::editors() const {
    std::vector<StEditor*> out;
    for (StPage* page : pages()) {
        for (StEditor* each : page->editors()) out.push_back(each);
        if (page->beside()) out.push_back(page->beside());
    }
    return out;
}

void EditorTabs::connectEditor(StEditor* editor) {
    editor->setSettings(m_settings.editor());
    editor->setModel(m_workspace.model());
    // A test runs on a controller of its own: values of the one that runs say nothing beside its statements.
    if (!editor::Workspace::isTestFile(editor->file())) editor->setOnlineValues(m_marks->values());
    editor->setPathOf([this](const QString& name, const QString& pou) { return m_marks->pathOf(name, pou); });
    connect(editor, &StEditor::writeRequested, this,
            [this](const QString& name, const QString& pou) { m_marks->askForValue(name, pou, false); });
    connect(editor, &StEditor::forceRequested, this,
            [this](const QString& name, const QString& pou) { m_marks->askForValue(name, pou, true); });
    connect(editor, &StEditor::unforceRequested, this,
            [this](const QString& name, const QString& pou) { m_control.unforce(m_marks->pathOf(name, pou)); });
    connect(editor, &StEditor::edited, this, [this, editor](const QString& file) {
        if (!m_isApplying) m_workspace.setText(file, editor->utf8());
        if (const std::map<int, int> moved = editor->movedBreakpoints(); !moved.empty())
            m_control.moveBreakpoints(file, moved);
    });
    editor->setUndo([this] { undo(); }, [this] { redo(); });
    connect(editor, &StEditor::projectEditsRequested, this, [this](const std::vector<analysis::FileEdits>& edits) {
        if (m_workspace.model()) applyEdits(edits, m_workspace.model()->sources());
    });
    connect(editor, &StEditor::breakpointToggled, &m_control, &editor::RunControl::toggleBreakpoint);
    connect(editor, &StEditor::cursorMoved, this, &EditorTabs::cursorMoved);
    connect(editor, &StEditor::hoverRequested, this,
            [this, editor](const QString& file, uint32_t offset, const QPoint& at) {
                if (!m_workspace.model()) return;
                const auto& model = *m_workspace.model();
                const auto id = model.fileOf(file.toStdString());
                if (!id || editor->utf8() != model.sources()[*id].text()) return;
                const auto hover = model.hover(*id, offset);
                if (!hover) return QToolTip::hideText();
                QString html = "<p style='white-space:pre'><b>" +
                               QString::fromStdString(hover->declaration).toHtmlEscaped() + "</b></p>";
                if (!hover->comment.empty())
                    html +=
                        "<p>" + QString::fromStdString(hover->comment).toHtmlEscaped().replace('\n', "<br>") + "</p>";
                if (m_control.hasValues() && !hover->path.empty()) {
                    const auto shown =
                        m_control.valueIn(QString::fromStdString(hover->path),
                                          hover->isRelative ? QString::fromStdString(hover->pou) : QString());
                    if (!shown.text.isEmpty()) html += "<p>= " + shown.text.left(400).toHtmlEscaped() + "</p>";
                }
                QToolTip::showText(at, html, editor);
            });
    emit editorMade(editor);
}

void EditorTabs::showChart(const QString& file, const QString& unit) {
    if (StPage* page = openFile(file)) page->showChart(unit);
}

// ------------------------------------------------------------------ moving about

void EditorTabs::rememberPlace() {
    if (const auto here = visitedNow()) m_visited.remember(*here);
}

std::optional<VisitedPlaces::Place> EditorTabs::visitedNow() const {
    const StEditor* editor = currentEditor();
    return editor ? std::optional(VisitedPlaces::Place{editor->file(), editor->cursorOffset()}) : std::nullopt;
}

void EditorTabs::goTo(const QString& file, uint32_t offset, uint32_t length) {
    rememberPlace();
    if (StEditor* text = openSource(file)) text->goTo(offset, length);
}

void EditorTabs::goToLine(const QString& file, int line) {
    rememberPlace();
    if (StEditor* text = openSource(file)) text->goToLine(line);
}

void EditorTabs::goBack() {
    if (const auto to = m_visited.back(visitedNow()))
        if (StEditor* text = openSource(to->file)) text->goTo(to->offset);
}

void EditorTabs::goForward() {
    if (const auto to = m_visited.forward(visitedNow()))
        if (StEditor* text = openSource(to->file)) text->goTo(to->offset);
}

// ------------------------------------------------------------------ pages of other kinds

void EditorTabs::addPage(QWidget* page, const QString& title, const QIcon& icon, const QString& key) {
    page->setProperty("pageKey", key);
    page->setProperty("pageTitle", title);
    setCurrentIndex(addTab(page, icon, title));
}

QWidget* EditorTabs::pageByKey(const QString& key) const {
    for (int i = 0; i < count(); ++i)
        if (widget(i)->property("pageKey").toString() == key) return widget(i);
    return nullptr;
}

// ------------------------------------------------------------------ saving and closing

void EditorTabs::markPage(const QString& key, bool modified) {
    for (int i = 0; i < count(); ++i)
        if (widget(i)->property("pageKey").toString() == key)
            setTabText(i, widget(i)->property("pageTitle").toString() + (modified ? " ●" : ""));
}

void EditorTabs::markModified(const QString& file, bool modified) {
    for (int i = 0; i < count(); ++i)
        if (auto* page = qobject_cast<StPage*>(widget(i)); page && page->file() == file)
            setTabText(i, QFileInfo(file).fileName() + (modified ? " ●" : ""));
}

/// False: not saved, and why was said.
bool EditorTabs::saveAsking(const QString& file) {
    auto wanted = editor::Workspace::ReadOnly::Keep;
    if (m_workspace.isReadOnly(file) && m_workspace.text(file) != m_workspace.savedText(file)) {
        QMessageBox box(QMessageBox::Warning, tr("Read-only file"),
                        tr("%1 is read-only. Replace it anyway? It stays read-only.").arg(file), QMessageBox::Cancel,
                        this);
        QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
        box.setDefaultButton(QMessageBox::Cancel);
        box.exec();
        if (box.clickedButton() != replace) {
            emit message(tr("%1 was not saved").arg(file), true);
            return false;
        }
        wanted = editor::Workspace::ReadOnly::Replace;
    }
    const auto done = m_workspace.save(file, wanted);
    if (!done) emit message(kit::messageText(done.error()), true);
    return static_cast<bool>(done);
}

bool EditorTabs::saveModified() {
    bool all = true;
    for (const QString& file : m_workspace.modifiedFiles()) all = saveAsking(file) && all;
    return all;
}

void EditorTabs::makeWritable(const QString& file) {
    if (auto done = m_workspace.makeWritable(file); !done) emit message(kit::messageText(done.error()), true);
}

void EditorTabs::saveCurrent() {
    StPage* page = currentPage();
    if (!page || page->isLibrary()) return emit saved();
    if (m_settings.formatOnSave()) page->active().formatText();
    if (saveAsking(page->file())) emit saved();
}

void EditorTabs::saveAll() {
    if (saveModified()) emit saved();
}

void EditorTabs::closeOthers(int index) {
    const QWidget* keep = widget(index);
    for (int i = count() - 1; i >= 0; --i)
        if (widget(i) != keep && !closePage(i)) return;
}

void EditorTabs::moveCurrent(int by) {
    const int to = currentIndex() + by;
    if (currentIndex() >= 0 && to >= 0 && to < count()) tabBar()->moveTab(currentIndex(), to);
}

bool EditorTabs::closePage(int index) {
    QWidget* closing = widget(index);
    if (auto* page = qobject_cast<StPage*>(closing); page && m_workspace.isModified(page->file())) {
        const auto answer =
            QMessageBox::question(this, tr("Unsaved changes"), tr("%1 was changed. Save it?").arg(page->file()),
                                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
        if (answer == QMessageBox::Cancel) return false;
        if (answer == QMessageBox::Save) {
            if (!saveAsking(page->file())) return false;
        } else {
            m_workspace.revert(page->file());
        }
    }
    if (m_mayClose && !qobject_cast<StPage*>(closing) && !m_mayClose(closing)) return false;
    index = indexOf(closing); // the question may have changed the row
    if (index < 0 || !closing->close()) return false;
    removeTab(index);
    closing->deleteLater();
    return true;
}

bool EditorTabs::closeAll() {
    const QStringList modified = m_workspace.isOpen() ? m_workspace.modifiedFiles() : QStringList();
    if (!modified.isEmpty()) {
        const auto answer = QMessageBox::question(
            this, tr("Unsaved changes"),
            tr("%n file(s) were changed: %1. Save them?", nullptr, static_cast<int>(modified.size()))
                .arg(modified.join(", ")),
            QMessageBox::SaveAll | QMessageBox::Discard | QMessageBox::Cancel);
        if (answer == QMessageBox::Cancel) return false;
        if (answer == QMessageBox::SaveAll && !saveModified()) return false;
    }
    for (int i = 0; i < count(); ++i)
        if (!qobject_cast<StPage*>(widget(i)) && m_mayClose && !m_mayClose(widget(i))) return false;
    return true;
}

void EditorTabs::askAboutDiskChange(const QString& file) {
    if (!m_asked.insert(file).second) return; // the question stands already
    const DiskAnswer answer = app::askAboutDiskChange(file, m_workspace.text(file), m_workspace.savedText(file), this);
    m_asked.erase(file);
    if (answer.choice == DiskChoice::LoadFromDisk) m_workspace.revert(file);
    if (answer.choice != DiskChoice::Merged) return;
    if (StPage* page = pageOf(file)) page->first().takeText(answer.merged); // undo leads back to what was here
    m_workspace.setText(file, answer.merged);
}

void EditorTabs::applySettings() {
    for (StEditor* editor : editors()) editor->setSettings(m_settings.editor());
}

// ------------------------------------------------------------------ changes of several files

void EditorTabs::applyEdits(const std::vector<analysis::FileEdits>& edits, const SourceSet& sources) {
    std::map<QString, std::vector<diagnostics::TextEdit>> byFile;
    for (const analysis::FileEdits& each : edits)
        byFile[QString::fromStdString(sources[each.file].path())] = each.edits;
    applyEdits(byFile);
}

void EditorTabs::applyEdits(const std::map<QString, std::vector<diagnostics::TextEdit>>& edits,
                            std::function<void(bool)> alongside) {
    m_changes->apply(edits, std::move(alongside));
}

void EditorTabs::applyTexts(const std::map<QString, std::string>& texts) { m_changes->apply(texts); }

void EditorTabs::undo() {
    if (m_changes->undo()) return;
    if (StEditor* editor = currentEditor()) editor->undo();
}

void EditorTabs::redo() {
    if (m_changes->redo()) return;
    if (StEditor* editor = currentEditor()) editor->redo();
}

void EditorTabs::goToBookmark(int direction) {
    StPage* page = currentPage();
    if (!page) return;
    page->active().goToBookmark(direction);
    for (editor::GraphView* graph : page->graphs())
        if (graph->isVisible()) graph->showCursor(page->active().cursorOffset());
}

} // namespace plc::app
