#include "app/pages/graph_pages.h"

#include "app/pages/computed_places.h"
#include "app/pages/editor_tabs.h"
#include "editor/kit/message_text.h"
#include "editor/kit/own_keys.h"
#include "editor/kit/post.h"

#include <QAction>
#include <QApplication>

namespace plc::app {

using editor::StEditor;

GraphPages::GraphPages(EditorTabs& tabs, OnlineMarks& marks, editor::Workspace& workspace, editor::RunControl& control,
                       Settings& settings)
    : QObject(&tabs), m_tabs(tabs), m_marks(marks), m_workspace(workspace), m_control(control), m_settings(settings),
      m_computed(new editor::ComputedScan(control, this)) {
    connect(m_computed, &editor::ComputedScan::changed, this, [this] {
        if (StPage* page = m_tabs.currentPage())
            for (editor::GraphView* graph : page->graphs()) graph->refreshOnline();
    });
}

void GraphPages::connectGraph(StPage* page, editor::GraphView* graph) {
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
        connect(action, &QAction::triggered, &m_tabs, run);
        graph->addAction(action);
    };
    addKeys("undo", {QKeySequence::Undo}, &EditorTabs::undo); // what is drawn is an edit of the text
    addKeys("redo", {Qt::CTRL | Qt::Key_Y, Qt::CTRL | Qt::SHIFT | Qt::Key_Z}, &EditorTabs::redo);
    new kit::OwnKeys(graph);
    connect(graph, &editor::GraphView::failed, this, [this](const QString& what) { emit m_tabs.message(what, true); });
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
        m_marks.showBreakpoints();
        m_marks.showExecutedLine();
    });
}

void GraphPages::add(StPage* page, editor::ChartView* chart) {
    connectGraph(page, chart);
    connect(chart, &editor::ChartView::forceStepRequested, this, [this, chart](const QString& step, bool active) {
        const QString path = m_control.preferredInstance(chart->unit().section('.', 0, 0)) + "." + step + ".X";
        if (!active) return m_control.unforce(path);
        if (auto forced = m_control.force(path, "TRUE"); !forced)
            emit m_tabs.message(kit::messageText(forced.error()), true);
    });
}

void GraphPages::add(StPage* page, editor::LadderView* ladder) {
    connectGraph(page, ladder);
    ladder->setLook(editor::LadderLook::fromBits(m_settings.ladderLook()));
    connect(ladder, &editor::LadderView::lookChosen, this, [this](int bits) {
        m_settings.setLadderLook(bits);
        for (StPage* each : m_tabs.pages())
            if (each->ladder()) each->ladder()->setLook(editor::LadderLook::fromBits(bits));
    });
    connect(ladder, &editor::LadderView::writeRequested, this,
            [this, ladder](const QString& variable, const QString& value) {
                const QString path = m_marks.pathOrComplain(variable, ladder->unit());
                if (path.isEmpty()) return;
                if (auto written = m_control.write(path, value); !written)
                    emit m_tabs.message(kit::messageText(written.error()), true);
            });
    StEditor* text = &page->first();
    ladder->setComputed(computedPlaces(
        *m_computed, page->file(), [text] { return text->utf8(); },
        [this, ladder] { return m_control.preferredInstance(ladder->unit().section('.', 0, 0)); }));
    connect(ladder, &editor::LadderView::forceRequested, this,
            [this, ladder](const QString& variable, const QString& value) {
                const QString path = m_marks.pathOrComplain(variable, ladder->unit());
                if (path.isEmpty()) return;
                if (value.isEmpty()) return m_control.unforce(path);
                if (auto forced = m_control.force(path, value); !forced)
                    emit m_tabs.message(kit::messageText(forced.error()), true);
            });
}

} // namespace plc::app
