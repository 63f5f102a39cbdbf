#include "app/editor_tabs.h"

#include "app/computed_places.h"
#include "app/disk_change.h"
#include "app/instance_bar.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/own_keys.h"
#include "editor/kit/post.h"
#include "editor/kit/theme.h"
#include "runtime/compiler/driver/driver.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTabBar>
#include <QToolTip>

namespace plc::app {

using editor::StEditor;

// ------------------------------------------------------------------ the tabs

EditorTabs::EditorTabs(editor::Workspace& workspace, editor::RunControl& control, Settings& settings, QWidget* parent)
    : QTabWidget(parent), m_workspace(workspace), m_control(control), m_settings(settings) {
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
        connect(menu.addAction(tr("Close Others")), &QAction::triggered, this, [this, index] {
            QWidget* keep = widget(index);
            for (int i = count() - 1; i >= 0; --i)
                if (widget(i) != keep && !closePage(i)) return;
        });
        menu.exec(tabBar()->mapToGlobal(at));
    });
    connect(&workspace, &editor::Workspace::analysed, this,
            [this](const std::shared_ptr<const analysis::CodeModel>& model) {
                for (int i = 0; i < count(); ++i)
                    if (auto* page = qobject_cast<StPage*>(widget(i))) {
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
            showBreakpoints();
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
        m_back.clear();
        m_forward.clear();
        m_groups.clear();
    });
    connect(&control, &editor::RunControl::breakpointsChanged, this, &EditorTabs::showBreakpoints);
    connect(&control, &editor::RunControl::statusChanged, this, &EditorTabs::showExecutedLine);
    connect(&control, &editor::RunControl::halted, this, &EditorTabs::showExecutedLine);
    m_computed = new editor::ComputedScan(control, this);
    connect(m_computed, &editor::ComputedScan::changed, this, [this] {
        if (StPage* page = currentPage())
            for (editor::GraphView* graph : page->graphs()) graph->refreshOnline();
    });
    connect(&control, &editor::RunControl::refreshed, this, [this] {
        // Ten times a second while it runs: more nobody reads.
        if (m_control.status().state == controller::State::Running && !m_control.viewed() && ++m_frames % 3 != 0)
            return;
        if (StPage* page = currentPage()) {
            for (StEditor* editor : page->editors()) editor->refreshOnlineValues();
            if (page->beside()) page->beside()->refreshOnlineValues();
            page->active().atShownMoment([page] { page->table().refreshOnlineValues(); });
            showInstance(*page);
            for (editor::GraphView* graph : page->graphs()) {
                graph->setPast(m_control.viewed().has_value());
                graph->refreshOnline();
            }
        }
    });
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
    showBreakpoints();
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
    connect(page, &StPage::chartMade, this, [this, page](editor::ChartView* chart) { connectChart(page, chart); });
    connect(page, &StPage::ladderMade, this, [this, page](editor::LadderView* ladder) { connectLadder(page, ladder); });
    connectEditor(&page->first());
    connect(&page->instanceBar(), &InstanceBar::instanceChosen, &m_control, &editor::RunControl::setPreferredInstance);
    page->table().setOnlineValues(onlineValues());
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
    showBreakpoints();
    return &page->first();
}

std::vector<StEditor*> EditorTabs::allEditors() const {
    std::vector<StEditor*> out;
    for (int i = 0; i < count(); ++i) {
        if (auto* page = qobject_cast<StPage*>(widget(i))) {
            for (StEditor* each : page->editors()) out.push_back(each);
            if (page->beside()) out.push_back(page->beside());
        }
    }
    return out;
}

void EditorTabs::connectEditor(StEditor* editor) {
    editor->setSettings(m_settings.editor());
    editor->setModel(m_workspace.model());
    editor->setOnlineValues(onlineValues());
    editor->setPathOf([this](const QString& name, const QString& pou) { return pathOf(name, pou); });
    connect(editor, &StEditor::writeRequested, this,
            [this](const QString& name, const QString& pou) { askForValue(name, pou, false); });
    connect(editor, &StEditor::forceRequested, this,
            [this](const QString& name, const QString& pou) { askForValue(name, pou, true); });
    connect(editor, &StEditor::unforceRequested, this,
            [this](const QString& name, const QString& pou) { m_control.unforce(pathOf(name, pou)); });
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

void EditorTabs::connectGraph(StPage* page, editor::GraphView* graph) {
    StEditor* text = &page->first();
    graph->setModel(m_workspace.model(), page->file());
    graph->setValues([this, graph](const QString& expression) {
        const auto shown = m_control.valueIn(expression, graph->unit().section('.', 0, 0));
        const auto* program = m_control.imageProgram();
        const bool isTime =
            program && shown.type.isValid() && program->layout.types->storageKind(shown.type) == types::TypeKind::Time;
        return editor::GraphValue{shown.text, shown.isTrue, shown.isForced,
                                  isTime && !shown.text.isEmpty() ? shown.value.integer() : 0};
    });
    graph->setCoverage([text](int line) -> std::optional<editor::CoverageMark> {
        const auto coverage = text->coverageOf(line - 1);
        if (!coverage) return std::nullopt;
        using State = editor::CoverageMark::State;
        using From = editor::LineCoverage::State;
        const State state = coverage->state == From::Run      ? State::Run
                            : coverage->state == From::Partly ? State::Partly
                                                              : State::NotRun;
        return editor::CoverageMark{state, coverage->text};
    });
    connect(graph, &editor::GraphView::editsRequested, text,
            [text](const std::vector<diagnostics::TextEdit>& edits) { text->applyEdits(edits); });
    connect(graph, &editor::GraphView::placeSelected, text, [text](uint32_t offset) {
        const QSignalBlocker blocker(text); // the graph follows the cursor; here the cursor follows the graph
        text->SendScintilla(QsciScintillaBase::SCI_GOTOPOS, static_cast<unsigned long>(offset));
    });
    connect(graph, &editor::GraphView::breakpointRequested, this, [this, page, text](uint32_t offset) {
        const auto line =
            text->SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, static_cast<unsigned long>(offset));
        m_control.toggleBreakpoint(page->file(), static_cast<int>(line) + 1);
    });
    connect(graph, &editor::GraphView::renameRequested, text,
            [text](uint32_t offset) { emit text->renameRequested(text->file(), offset); });
    connect(graph, &editor::GraphView::usesRequested, text,
            [text](uint32_t offset) { emit text->usesRequested(text->file(), offset); });
    connect(graph, &editor::GraphView::definitionRequested, text,
            [text](uint32_t offset) { emit text->definitionRequested(text->file(), offset); });
    connect(graph, &editor::GraphView::fixRequested, text, [text](uint32_t offset) {
        text->goTo(offset);
        text->applyFix();
    });
    connect(graph, &editor::GraphView::bookmarkRequested, text, [text](uint32_t offset) {
        text->toggleBookmark(static_cast<int>(
            text->SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, static_cast<unsigned long>(offset))));
    });
    connect(text, &StEditor::bookmarksChanged, graph, [text, graph] { graph->setBookmarks(text->bookmarks()); });
    const auto addKeys = [&](const char* name, std::initializer_list<QKeySequence> keys, void (EditorTabs::*run)()) {
        auto* action = new QAction(graph);
        action->setObjectName(name);
        action->setShortcuts(keys);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        connect(action, &QAction::triggered, this, run);
        graph->addAction(action);
    };
    addKeys("undo", {QKeySequence::Undo}, &EditorTabs::undo); // what is drawn is an edit of the text
    addKeys("redo", {Qt::CTRL | Qt::Key_Y, Qt::CTRL | Qt::SHIFT | Qt::Key_Z}, &EditorTabs::redo);
    new kit::OwnKeys(graph);
    connect(graph, &editor::GraphView::failed, this, [this](const QString& what) { emit message(what, true); });
    connect(text, &StEditor::edited, graph, [text, graph] {
        if (graph->isVisible()) graph->setText(text->utf8());
        graph->setBookmarks(text->bookmarks());
    });
    connect(text, &StEditor::cursorMoved, graph, [text, graph] {
        // Also when the find bar moves it; what is selected in the graph moves it itself.
        if (graph->isVisible() && !graph->isAncestorOf(QApplication::focusWidget()))
            graph->showCursor(text->cursorOffset());
    });
    kit::post(this, [this] {
        showBreakpoints();
        showExecutedLine();
    });
}

void EditorTabs::connectChart(StPage* page, editor::ChartView* chart) {
    connectGraph(page, chart);
    connect(chart, &editor::ChartView::forceStepRequested, this, [this, chart](const QString& step, bool active) {
        const QString path = m_control.preferredInstance(chart->unit().section('.', 0, 0)) + "." + step + ".X";
        if (!active) return m_control.unforce(path);
        if (auto forced = m_control.force(path, "TRUE"); !forced) emit message(kit::messageText(forced.error()), true);
    });
}

void EditorTabs::connectLadder(StPage* page, editor::LadderView* ladder) {
    connectGraph(page, ladder);
    ladder->setLook(editor::LadderLook::fromBits(m_settings.ladderLook()));
    connect(ladder, &editor::LadderView::lookChosen, this, [this](int bits) {
        m_settings.setLadderLook(bits);
        for (int i = 0; i < count(); ++i)
            if (auto* each = qobject_cast<StPage*>(widget(i)); each && each->ladder())
                each->ladder()->setLook(editor::LadderLook::fromBits(bits));
    });
    connect(ladder, &editor::LadderView::writeRequested, this,
            [this, ladder](const QString& variable, const QString& value) {
                const QString path = pathOf(variable, ladder->unit());
                if (path.isEmpty())
                    return emit message(tr("%1 is no variable of the running program").arg(variable), true);
                if (auto written = m_control.write(path, value); !written)
                    emit message(kit::messageText(written.error()), true);
            });
    StEditor* text = &page->first();
    ladder->setComputed(computedPlaces(
        *m_computed, page->file(), [text] { return text->utf8(); },
        [this, ladder] { return m_control.preferredInstance(ladder->unit().section('.', 0, 0)); }));
    connect(ladder, &editor::LadderView::forceRequested, this,
            [this, ladder](const QString& variable, const QString& value) {
                const QString path = pathOf(variable, ladder->unit());
                if (path.isEmpty())
                    return emit message(tr("%1 is no variable of the running program").arg(variable), true);
                if (value.isEmpty()) return m_control.unforce(path);
                if (auto forced = m_control.force(path, value); !forced)
                    emit message(kit::messageText(forced.error()), true);
            });
}

/// A local of the instance that the text shows, else a global; "" when it is neither.
QString EditorTabs::pathOf(const QString& name, const QString& pou) const {
    if (!m_workspace.model()) return {};
    const auto& checked = m_workspace.model()->checked();
    const QString block = pou.section('.', 0, 0), instance = m_control.preferredInstance(block);
    for (const QString& path : {(instance.isEmpty() ? block : instance) + '.' + name, name})
        if (driver::compileExpression(checked, path.toStdString())) return path;
    return {};
}

void EditorTabs::askForValue(const QString& name, const QString& pou, bool force) {
    const QString path = pathOf(name, pou);
    if (path.isEmpty()) return emit message(tr("%1 is no variable of the running program").arg(name), true);
    const auto shown = m_control.value(path);
    bool ok = false;
    const QString present = shown.isBool ? (shown.isTrue ? "FALSE" : "TRUE") : shown.text; // a BOOL is to be the other
    const QString typed =
        QInputDialog::getText(this, force ? tr("Force") : tr("Write"), path, QLineEdit::Normal, present, &ok);
    if (!ok || typed.trimmed().isEmpty()) return;
    const auto done = force ? m_control.force(path, typed.trimmed()) : m_control.write(path, typed.trimmed());
    if (!done) emit message(kit::messageText(done.error()), true);
}

void EditorTabs::showInstance(StPage& page) {
    const auto model = m_workspace.model();
    const auto file = model ? model->fileOf(page.file().toStdString()) : std::nullopt;
    QString block;
    QStringList instances;
    if (file && m_control.hasValues()) {
        block = QString::fromStdString(model->pouAt(*file, page.active().cursorOffset())).section('.', 0, 0);
        for (const QString& each : m_control.instancesOf(block)) instances << each;
        if (instances.size() == 1 && instances.front().compare(block, Qt::CaseInsensitive) == 0)
            instances.clear(); // a program is its own
    }
    page.instanceBar().show(block, instances, m_control.preferredInstance(block));
}

void EditorTabs::showChart(const QString& file, const QString& unit) {
    if (StPage* page = openFile(file)) page->showChart(unit);
}

editor::OnlineValues EditorTabs::onlineValues() {
    return [this](const std::vector<std::pair<QString, QString>>& names) {
        std::vector<editor::OnlineValue> out;
        if (!m_control.hasValues()) return out;
        for (const auto& [name, pou] : names) {
            const auto shown = m_control.valueIn(name, pou);
            const auto* program = m_control.imageProgram();
            if (shown.text.isEmpty() || !program || !shown.type.isValid() ||
                program->layout.types->isAggregate(shown.type))
                continue;
            out.push_back({name, shown.text.left(40), shown.isBool, shown.isTrue, shown.isForced});
        }
        return out;
    };
}

// ------------------------------------------------------------------ moving about

void EditorTabs::rememberPlace() {
    StEditor* editor = currentEditor();
    if (!editor) return;
    const Visited here{editor->file(), editor->cursorOffset()};
    if (!m_back.empty() && m_back.back().file == here.file && m_back.back().offset == here.offset) return;
    m_back.push_back(here);
    if (m_back.size() > 100) m_back.pop_front();
    m_forward.clear();
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
    if (m_back.empty()) return;
    if (StEditor* editor = currentEditor()) m_forward.push_back({editor->file(), editor->cursorOffset()});
    const Visited to = m_back.back();
    m_back.pop_back();
    if (StEditor* text = openSource(to.file)) text->goTo(to.offset);
}

void EditorTabs::goForward() {
    if (m_forward.empty()) return;
    if (StEditor* editor = currentEditor()) m_back.push_back({editor->file(), editor->cursorOffset()});
    const Visited to = m_forward.back();
    m_forward.pop_back();
    if (StEditor* text = openSource(to.file)) text->goTo(to.offset);
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
                        tr("%1 is read-only. Replace it all the same? It stays read-only.").arg(file),
                        QMessageBox::Cancel, this);
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
    for (StEditor* editor : allEditors()) editor->setSettings(m_settings.editor());
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
    Group group;
    group.alongside = std::move(alongside);
    for (const auto& [file, list] : edits) {
        std::string text = m_workspace.text(file);
        Group::Texts& kept = group.texts[file];
        kept.before = text;
        if (StPage* page = pageOf(file)) {
            page->first().applyEdits(list);
        } else {
            for (size_t i = list.size(); i-- > 0;)
                text.replace(list[i].range.begin, list[i].range.length(), list[i].text);
            m_workspace.setText(file, std::move(text));
        }
        kept.after = m_workspace.text(file);
    }
    remember(std::move(group));
    m_workspace.checkNow();
}

void EditorTabs::applyTexts(const std::map<QString, std::string>& texts) {
    Group group;
    for (const auto& [file, text] : texts) {
        group.texts[file] = {m_workspace.text(file), text};
        if (StPage* page = pageOf(file)) page->first().takeText(text);
        m_workspace.setText(file, text);
    }
    remember(std::move(group));
    m_workspace.checkNow();
}

void EditorTabs::remember(Group group) {
    const bool isAnEditorsOwn = group.texts.size() == 1 && !group.alongside && pageOf(group.texts.begin()->first);
    if (group.texts.empty() || isAnEditorsOwn) return;
    std::erase_if(m_groups, [](const Group& each) { return each.isUndone; });
    m_groups.push_back(std::move(group));
    if (m_groups.size() > 20) m_groups.pop_front();
}

/// The newest change of several files whose state the text in front shows.
EditorTabs::Group* EditorTabs::groupAt(bool undone) {
    const StEditor* editor = currentEditor();
    if (!editor) return nullptr;
    const std::string text = editor->utf8();
    for (size_t i = m_groups.size(); i-- > 0;) {
        Group& group = m_groups[i];
        const auto here = group.texts.find(editor->file());
        if (group.isUndone == undone && here != group.texts.end() &&
            text == (undone ? here->second.before : here->second.after))
            return &group;
    }
    return nullptr;
}

void EditorTabs::swapGroup(Group& group) {
    group.isUndone = !group.isUndone;
    const bool back = group.isUndone;
    int kept = 0;
    for (const auto& [file, texts] : group.texts) {
        const std::string &from = back ? texts.after : texts.before, &to = back ? texts.before : texts.after;
        if (!m_workspace.files().contains(file)) { // it left with the last unit in it
            if (back && !to.empty())
                if (auto added = m_workspace.addFile(file, to); !added)
                    emit message(kit::messageText(added.error()), true);
            continue;
        }
        if (m_workspace.text(file) != from) { // edited since
            ++kept;
            continue;
        }
        if (StPage* page = pageOf(file)) {
            back ? page->first().undo() : page->first().redo();
            page->first().takeText(to); // a page that was opened since has no undo of its own
        }
        m_workspace.setText(file, to);
    }
    if (group.alongside) group.alongside(back);
    m_workspace.checkNow();
    const int changed = static_cast<int>(group.texts.size()) - kept;
    emit message(kept ? tr("Changed in %n file(s); those edited since stay as they are", nullptr, changed)
                      : tr("Changed in %n file(s)", nullptr, changed),
                 false);
}

void EditorTabs::undo() {
    if (Group* group = groupAt(false)) return swapGroup(*group);
    if (StEditor* editor = currentEditor()) editor->undo();
}

void EditorTabs::redo() {
    if (Group* group = groupAt(true)) return swapGroup(*group);
    if (StEditor* editor = currentEditor()) editor->redo();
}

// ------------------------------------------------------------------ debugging marks

void EditorTabs::showBreakpoints() {
    for (StEditor* editor : allEditors()) {
        std::set<int> lines, disabled;
        for (const editor::EditorBreakpoint& b : m_control.breakpoints()) {
            if (b.file != editor->file()) continue;
            lines.insert(b.line);
            if (!b.isEnabled || !b.hasCode) disabled.insert(b.line);
        }
        editor->setBreakpoints(lines, disabled);
        if (StPage* page = pageOf(editor->file()))
            for (editor::GraphView* graph : page->graphs()) graph->setBreakpoints(lines, disabled);
    }
}

void EditorTabs::showWalk(std::optional<editor::RunControl::TextPlace> place) {
    m_walk = std::move(place);
    showExecutedLine();
}

/// Where the controller stands: at a breakpoint, after a step, or where a fault has stopped it.
void EditorTabs::showExecutedLine() {
    using controller::State;
    const State state = m_walk ? State::Halted : m_control.status().state;
    SourceRange range;
    if (m_walk) {
        range.begin = m_walk->offset;
    } else if (m_control.session() && state == State::Halted) {
        const auto frames = m_control.session()->haltFrames();
        if (!frames.empty()) range = frames.front().range;
    } else if (m_control.session() && state == State::Fault && m_control.status().fault) {
        range = m_control.status().fault->range;
    }
    const auto place = m_walk ? m_walk : m_control.placeInText(range);
    const QString file = place ? place->file : QString();
    const int line = place ? place->line : 0;
    const QString shown = QString("%1:%2:%3").arg(file).arg(range.begin).arg(static_cast<int>(state));
    const bool isNew = std::exchange(m_shownPlace, shown) != shown;
    if (line && isNew) {
        const QPointer<QWidget> focus = QApplication::focusWidget(); // who types elsewhere goes on there
        goToLine(file, line);
        if (focus && !isAncestorOf(focus)) focus->setFocus();
    }
    for (StEditor* editor : allEditors()) {
        const int here = editor->file() == file ? line : 0;
        editor->setExecutedLine(state == State::Halted ? here : 0);
        editor->setFaultLine(state == State::Fault ? here : 0);
    }
    for (int i = 0; i < count(); ++i)
        if (auto* page = qobject_cast<StPage*>(widget(i))) {
            const bool isHere = state == State::Halted && line && page->file() == file;
            for (editor::GraphView* graph : page->graphs())
                graph->setStanding(isHere ? std::optional(place->offset) : std::nullopt);
        }
    if (line && isNew && currentEditor()) currentEditor()->ensureLineVisible(line - 1);
}

void EditorTabs::goToBookmark(int direction) {
    StPage* page = currentPage();
    if (!page) return;
    page->active().goToBookmark(direction);
    for (editor::GraphView* graph : page->graphs())
        if (graph->isVisible()) graph->showCursor(page->active().cursorOffset());
}

} // namespace plc::app
