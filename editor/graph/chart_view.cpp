#include "editor/graph/chart_view.h"

#include "editor/graph/chart_items.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGraphicsItem>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPrintDialog>
#include <QPrinter>
#include <QScrollBar>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace plc::editor {

using chart::StepId;
using chart::TransitionId;

ChartView::ChartView(QWidget* parent) : QWidget(parent) {
    m_scene = new ChartScene(this);
    m_canvas = new kit::Canvas(this);
    m_canvas->setScene(m_scene);
    m_canvas->setAccessibleName(tr("Sequential function chart"));
    m_canvas->setBackgroundBrush(kit::colors().base);
    m_canvas->viewport()->installEventFilter(this);
    m_canvas->installEventFilter(this);
    m_bar = new QToolBar(this);
    m_bar->setIconSize({16, 16});
    const auto action = [&](kit::Icon icon, const QString& text, auto run) {
        QAction* made = m_bar->addAction(kit::icon(icon), text);
        connect(made, &QAction::triggered, this, run);
        return made;
    };
    m_up = action(kit::Icon::Up, tr("To the chart around (Backspace)"), &ChartView::openParent);
    action(kit::Icon::Add, tr("Insert a step behind (Ins)"), &ChartView::insertStep);
    action(kit::Icon::Split, tr("Insert a branch beside"), &ChartView::insertAlternative);
    action(kit::Icon::Layers, tr("Insert a simultaneous branch"), &ChartView::insertSimultaneous);
    action(kit::Icon::Action, tr("Add an action"), &ChartView::insertAction);
    action(kit::Icon::Edit, tr("Edit name or condition (F2)"), &ChartView::editSelected);
    action(kit::Icon::Delete, tr("Delete (Del)"), &ChartView::deleteSelected);
    m_bar->addSeparator();
    action(kit::Icon::Breakpoint,
           tr("Breakpoint: stops when the step becomes active, when the transition is taken (F9)"),
           &ChartView::toggleBreakpoint);
    action(kit::Icon::Force, tr("Force the step on"), [this] { forceSelected(true); });
    action(kit::Icon::Unforce, tr("Release the step"), [this] { forceSelected(false); });
    m_bar->addSeparator();
    action(kit::Icon::Fit, tr("Show all"), [this] { m_canvas->zoomToFit(); });
    action(kit::Icon::Export, tr("Export as SVG, PNG or PDF…"), [this] {
        const QString path =
            QFileDialog::getSaveFileName(this, tr("Export the chart"), QString(m_unit).replace('.', '_') + ".svg",
                                         tr("SVG (*.svg);;PNG (*.png);;PDF (*.pdf)"));
        if (path.isEmpty()) return;
        const bool good = path.endsWith(".png")   ? m_canvas->exportPng(path)
                          : path.endsWith(".pdf") ? m_canvas->exportPdf(path)
                                                  : m_canvas->exportSvg(path);
        if (!good) emit failed(tr("%1 can not be written").arg(path));
    });
    action(kit::Icon::Print, tr("Print…"), [this] {
        QPrinter printer;
        if (QPrintDialog(&printer, this).exec() == QDialog::Accepted) m_canvas->print(printer);
    });
    m_state = new QLabel(this);
    m_state->setContentsMargins(8, 0, 8, 0);
    m_bar->addWidget(m_state);
    m_field = new kit::ExpressionEdit(m_canvas->viewport());
    m_field->hide();
    m_field->installEventFilter(this);
    m_field->setCompletionSource([this](const QString& text, int cursor) { return completions(text, cursor); });
    m_field->setCheck([this](const QString& text) { return complaintOf(text); });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(m_canvas);
    m_clock.start();
    connect(m_scene, &QGraphicsScene::selectionChanged, this, &ChartView::selectionMoved);
    connect(m_canvas, &kit::Canvas::zoomChanged, this, [this] { updateMap(); });
    connect(&kit::Theme::current(), &kit::Theme::changed, this, [this] {
        m_canvas->setBackgroundBrush(kit::colors().base);
        m_scene->refreshTheme();
    });
    updateActions();
}

ChartView::~ChartView() { m_scene->disconnect(this); } // selected items that die would ask for their place

void ChartView::setUnit(const QString& unit) {
    if (unit.compare(m_unit, Qt::CaseInsensitive) != 0) {
        closeField(false);
        const QSignalBlocker blocker(m_scene);
        m_scene->forget();
        m_chart.reset();
        m_place = {};
        m_isFresh = true;
    }
    m_unit = unit;
    updateActions();
}

void ChartView::showStale(const QString& reason) {
    m_isStale = true;
    m_state->setText(reason);
    m_scene->setFaint(true);
    closeField(false);
}

void ChartView::setText(const std::string& text) {
    if (text == m_text && m_chart) {
        m_isStale = false;
        m_state->clear();
        m_scene->setFaint(false);
        return;
    }
    diagnostics::Sink sink;
    // The tree views the text: both are replaced together, the old chart first.
    auto kept = std::make_unique<std::string>(text);
    auto syntax = parse::parseFile(FileId(size_t(0)), *kept, sink);
    const ChartPlace place = findChart(*syntax, m_unit.toStdString());
    if (!place.pou) return showStale(tr("The unit %1 is not in the text any more").arg(m_unit));
    for (const diagnostics::Diagnostic& d : sink.all())
        if (d.severity == diagnostics::Severity::Error && d.range.begin >= place.pou->range.begin &&
            d.range.begin <= place.pou->range.end)
            return showStale(tr("The text has errors: this is the last good drawing"));
    if (!place) return showStale(tr("%1 is not a chart").arg(m_unit));
    m_isStale = false;
    m_state->clear();
    closeField(false);
    {
        const QSignalBlocker blocker(m_scene);
        m_scene->forget();
    }
    m_chart.reset();
    m_syntax.reset();
    m_text = text;
    diagnostics::Sink again;
    m_syntax = parse::parseFile(FileId(size_t(0)), m_text, again);
    m_place = findChart(*m_syntax, m_unit.toStdString());
    m_chart = std::make_unique<chart::Chart>(chart::build(*m_place.chart));
    rebuild();
}

void ChartView::rebuild() {
    const QSignalBlocker blocker(m_scene);
    QSet<QString> charts;
    for (const auto* list : {&m_place.pou->actions, &m_place.chart->actions})
        for (const syntax::ActionDecl* action : *list)
            if (action->body.chart) charts.insert(kit::fromView(action->name.text).toLower());
    m_scene->show(*m_chart, m_text, charts);
    m_takenAt.assign(m_chart->transitions.size(), -100000);
    m_enteredBy.assign(m_chart->steps.size(), -1);
    m_wasActive.assign(m_chart->steps.size(), false);
    m_listConditions.clear();
    diagnostics::Sink sink;
    chart::check(*m_chart, sink);
    std::vector<ChartMessage> messages;
    for (const diagnostics::Diagnostic& d : sink.all())
        messages.push_back({d.range, kit::messageText(d.message), d.severity == diagnostics::Severity::Error});
    m_scene->showMessages(messages);
    applyBreakpoints();
    if (!m_selectAfter.isEmpty())
        for (size_t i = 0; i < m_chart->steps.size(); ++i)
            if (kit::fromView(m_chart->steps[i].decl->name.text) == m_selectAfter)
                if (QGraphicsItem* item = m_scene->itemOf(ChartScene::Step, static_cast<int>(i))) {
                    item->setSelected(true);
                    m_canvas->ensureVisible(item->sceneBoundingRect(), 30, 30);
                }
    m_selectAfter.clear();
    if (std::exchange(m_isFresh, false))
        QMetaObject::invokeMethod(
            m_canvas,
            [this] {
                m_canvas->zoomToFit();
                if (m_canvas->zoom() > 1) m_canvas->setZoom(1);
                if (m_canvas->zoom() < 0.45) { // too long to be read as a whole: from the top
                    m_canvas->setZoom(0.8);
                    m_canvas->centerOn(m_scene->sceneRect().center().x(), 0);
                    m_canvas->verticalScrollBar()->setValue(m_canvas->verticalScrollBar()->minimum());
                }
                updateMap();
            },
            Qt::QueuedConnection);
    updateMap();
    updateActions();
}

void ChartView::updateMap() {
    const QRectF scene = m_scene->sceneRect();
    const double zoom = m_canvas->zoom();
    const bool isBig = m_chart && (scene.width() * zoom > m_canvas->viewport()->width() * 1.3 ||
                                   scene.height() * zoom > m_canvas->viewport()->height() * 1.3);
    if (isBig != m_canvas->isMapVisible()) m_canvas->setMapVisible(isBig);
}

void ChartView::updateActions() { m_up->setVisible(m_unit.contains('.')); }

void ChartView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    updateMap();
}

void ChartView::setModel(const std::shared_ptr<const analysis::CodeModel>& model, const QString& file) {
    m_model = model;
    m_file = file;
    m_listConditions.clear();
    if (!model || !m_chart || m_isStale) return;
    const auto id = model->fileOf(file.toStdString());
    if (!id || model->sources()[*id].text() != m_text) return;
    const std::vector<analysis::AccumulatorPlace> results = model->accumulators(*id);
    m_listConditions.resize(m_chart->transitions.size());
    for (size_t i = 0; i < m_chart->transitions.size(); ++i) {
        const syntax::Block& list = m_chart->transitions[i].decl->ilCondition;
        if (list.empty()) continue;
        for (const analysis::AccumulatorPlace& result : results)
            if (result.at >= list.front()->range.begin && result.at <= list.back()->range.end)
                m_listConditions[i] = QString::fromStdString(result.expression);
    }
    std::vector<ChartMessage> messages;
    for (const diagnostics::Diagnostic& d : model->diagnostics())
        if (d.range.file == *id && d.severity != diagnostics::Severity::Info)
            messages.push_back({d.range, kit::messageText(d.message), d.severity == diagnostics::Severity::Error});
    m_scene->showMessages(messages);
}

void ChartView::setBreakpoints(const std::set<int>& lines, const std::set<int>& disabled) {
    m_breakpoints = lines;
    m_disabled = disabled;
    applyBreakpoints();
}

void ChartView::applyBreakpoints() {
    ChartMarks marks;
    if (m_chart && !m_isStale && !m_breakpoints.empty()) {
        std::vector<uint32_t> lineBegins{0};
        for (size_t i = 0; i < m_text.size(); ++i)
            if (m_text[i] == '\n') lineBegins.push_back(static_cast<uint32_t>(i) + 1);
        const auto mark = [&](QHash<int, bool>& where, size_t index, uint32_t at) {
            const int line =
                static_cast<int>(std::upper_bound(lineBegins.begin(), lineBegins.end(), at) - lineBegins.begin());
            if (m_breakpoints.contains(line)) where[static_cast<int>(index)] = !m_disabled.contains(line);
        };
        for (size_t i = 0; i < m_chart->steps.size(); ++i) mark(marks.steps, i, m_chart->steps[i].decl->range.begin);
        for (size_t i = 0; i < m_chart->transitions.size(); ++i)
            mark(marks.transitions, i, m_chart->transitions[i].decl->range.begin);
    }
    m_scene->setMarks(marks);
}

// ------------------------------------------------------------------ selection

ChartView::Picked ChartView::picked() const {
    const auto selected = m_scene->selectedItems();
    if (selected.isEmpty()) return {};
    return {static_cast<ChartScene::ItemKind>(selected.first()->data(ChartScene::Kind).toInt()),
            selected.first()->data(ChartScene::Index).toInt(), selected.first()->data(ChartScene::Sub).toInt()};
}

ChartView::Picked ChartView::pickedAt(QPoint viewportPoint) const {
    for (QGraphicsItem* item : m_canvas->items(viewportPoint))
        if (item->data(ChartScene::Kind).toInt() != ChartScene::None)
            return {static_cast<ChartScene::ItemKind>(item->data(ChartScene::Kind).toInt()),
                    item->data(ChartScene::Index).toInt(), item->data(ChartScene::Sub).toInt()};
    return {};
}

SourceRange ChartView::rangeOf(const Picked& p) const {
    const auto index = static_cast<size_t>(p.index);
    if (p.kind == ChartScene::Transition) return m_chart->transitions[index].decl->range;
    if (p.kind == ChartScene::Step) return m_chart->steps[index].decl->range;
    return m_chart->steps[index].decl->actions[static_cast<size_t>(p.sub)].range;
}

void ChartView::selectionMoved() {
    const Picked p = picked();
    if (!m_chart || m_isStale || p.kind == ChartScene::None) return;
    emit placeSelected(p.kind == ChartScene::Step ? m_chart->steps[static_cast<size_t>(p.index)].decl->name.range.begin
                                                  : rangeOf(p).begin);
}

void ChartView::showCursor(uint32_t offset) {
    if (!m_chart || m_isStale) return;
    const QSignalBlocker blocker(m_scene);
    m_scene->clearSelection();
    const auto select = [&](ChartScene::ItemKind kind, size_t index, int sub = -1) {
        QGraphicsItem* item = m_scene->itemOf(kind, static_cast<int>(index), sub);
        if (!item) return;
        item->setSelected(true);
        m_canvas->ensureVisible(item->sceneBoundingRect(), 20, 20);
    };
    for (size_t i = 0; i < m_chart->steps.size(); ++i) {
        const syntax::StepDecl& step = *m_chart->steps[i].decl;
        if (!step.range.contains(offset)) continue;
        for (size_t k = 0; k < step.actions.size(); ++k)
            if (step.actions[k].range.contains(offset)) return select(ChartScene::Action, i, static_cast<int>(k));
        return select(ChartScene::Step, i);
    }
    for (size_t i = 0; i < m_chart->transitions.size(); ++i)
        if (m_chart->transitions[i].decl->range.contains(offset)) return select(ChartScene::Transition, i);
    for (const auto* list :
         {&m_place.chart->actions, &m_place.pou->actions}) // in the body of an action: who asks for it
        for (const syntax::ActionDecl* action : *list) {
            if (!action->range.contains(offset)) continue;
            for (size_t i = 0; i < m_chart->steps.size(); ++i)
                for (size_t k = 0; k < m_chart->steps[i].decl->actions.size(); ++k)
                    if (equalsIgnoringCase(m_chart->steps[i].decl->actions[k].action.text, action->name.text))
                        return select(ChartScene::Action, i, static_cast<int>(k));
        }
}

void ChartView::selectTowards(int dx, int dy) {
    const auto selected = m_scene->selectedItems();
    if (selected.isEmpty()) {
        if (QGraphicsItem* first = m_scene->itemOf(ChartScene::Step, 0)) first->setSelected(true);
        return;
    }
    const auto middle = [](const QGraphicsItem* item) { // of a transition, its bar: conditions differ in length
        const QRectF rect = item->boundingRect();
        return item->data(ChartScene::Kind).toInt() == ChartScene::Transition
                   ? QPointF(rect.left() + 40 + kBarHalf, rect.center().y())
                   : rect.center();
    };
    const QPointF from = middle(selected.first());
    QGraphicsItem* best = nullptr;
    double least = 1e18;
    for (QGraphicsItem* item : m_scene->items()) {
        if (item->data(ChartScene::Kind).toInt() == ChartScene::None || item == selected.first()) continue;
        const QPointF way = middle(item) - from;
        const double along = way.x() * dx + way.y() * dy, across = std::abs(way.x() * dy) + std::abs(way.y() * dx);
        if (along < 4 || across > along * 2 + 60) continue;
        const double cost = along + 2.5 * across;
        if (cost < least) least = cost, best = item;
    }
    if (!best) return;
    m_scene->clearSelection();
    best->setSelected(true);
    m_canvas->ensureVisible(best->sceneBoundingRect(), 20, 20);
}

// ------------------------------------------------------------------ edits

void ChartView::request(const Result<chart::Edits>& edits, const QString& selectName) {
    if (m_isStale) return emit failed(tr("Mend the text first: this is the last good drawing"));
    if (!edits) return emit failed(kit::messageText(edits.error()));
    if (edits->empty()) return;
    m_selectAfter = selectName;
    const chart::Edits wanted = *edits; // the chart they come from goes with the text
    emit editsRequested(wanted);
}

void ChartView::insertStep() {
    const Picked p = picked();
    if (!m_chart || m_isStale) return;
    const std::string name = editor().freeStepName();
    if (p.kind == ChartScene::Transition)
        return request(editor().insertStepAfter(TransitionId(p.index), name), QString::fromStdString(name));
    const int step = p.kind == ChartScene::None ? static_cast<int>(m_chart->steps.size()) - 1 : p.index;
    if (step >= 0) request(editor().insertStepAfter(StepId(step), name), QString::fromStdString(name));
}

void ChartView::insertAlternative() {
    const Picked p = picked();
    if (!m_chart || p.kind == ChartScene::None)
        return emit failed(tr("Select the step from which the branch goes out"));
    if (p.kind == ChartScene::Transition && m_chart->transitions[static_cast<size_t>(p.index)].from.empty()) return;
    const StepId step = p.kind == ChartScene::Transition
                            ? m_chart->transitions[static_cast<size_t>(p.index)].from.front()
                            : StepId(p.index);
    const std::string name = editor().freeStepName();
    request(editor().insertAlternativeBranch(step, name), QString::fromStdString(name));
}

void ChartView::insertSimultaneous() {
    const Picked p = picked();
    if (!m_chart || p.kind != ChartScene::Transition)
        return emit failed(tr("Select the transition behind which the steps run at the same time"));
    const std::string name = editor().freeStepName();
    request(editor().insertSimultaneousBranch(TransitionId(p.index), name), QString::fromStdString(name));
}

void ChartView::deleteSelected() {
    const Picked p = picked();
    if (!m_chart) return;
    if (p.kind == ChartScene::Step)
        request(editor().deleteStep(StepId(p.index)));
    else if (p.kind == ChartScene::Transition)
        request(editor().deleteTransition(TransitionId(p.index)));
    else if (p.kind == ChartScene::Action)
        request(editor().deleteAction(StepId(p.index), static_cast<size_t>(p.sub)));
}

void ChartView::deleteBranch() {
    const Picked p = picked();
    if (m_chart && p.kind == ChartScene::Transition) request(editor().deleteBranch(TransitionId(p.index)));
}

void ChartView::moveSelected(int direction) {
    const Picked p = picked();
    if (!m_chart) return;
    if (p.kind == ChartScene::Action) {
        const auto count = static_cast<int>(m_chart->steps[static_cast<size_t>(p.index)].decl->actions.size());
        const int to = p.sub + direction;
        if (to >= 0 && to < count)
            request(editor().moveAction(StepId(p.index), static_cast<size_t>(p.sub), static_cast<size_t>(to)));
        return;
    }
    if (p.kind != ChartScene::Transition || m_chart->transitions[static_cast<size_t>(p.index)].from.empty()) return;
    const auto& siblings = m_chart->steps[m_chart->transitions[static_cast<size_t>(p.index)].from.front().index()].out;
    const auto at = std::find(siblings.begin(), siblings.end(), TransitionId(p.index)) - siblings.begin();
    const auto to = at + direction;
    if (to < 0 || to >= static_cast<std::ptrdiff_t>(siblings.size())) return;
    request(editor().moveTransition(TransitionId(p.index), direction < 0 ? chart::Place::Before : chart::Place::After,
                                    siblings[static_cast<size_t>(to)]));
}

void ChartView::makeInitial() {
    const Picked p = picked();
    if (m_chart && p.kind == ChartScene::Step) request(editor().setInitial(StepId(p.index)));
}

void ChartView::openAction() {
    const Picked p = picked();
    if (!m_chart || p.kind != ChartScene::Action) return;
    const std::string_view name =
        m_chart->steps[static_cast<size_t>(p.index)].decl->actions[static_cast<size_t>(p.sub)].action.text;
    for (const auto* list : {&m_place.chart->actions, &m_place.pou->actions})
        for (const syntax::ActionDecl* action : *list) {
            if (!equalsIgnoringCase(action->name.text, name)) continue;
            const uint32_t at = action->body.range.begin;
            if (action->body.chart) {
                const std::string text = m_text;
                setUnit(m_unit.section('.', 0, 0) + "." + kit::fromView(action->name.text));
                setText(text);
            }
            return emit placeSelected(at);
        }
    emit failed(tr("%1 is a variable: it has no body").arg(kit::fromView(name)));
}

void ChartView::openParent() {
    if (!m_unit.contains('.') || m_text.empty()) return;
    const std::string text = m_text;
    // The chart that asks for this action; else the unit's own.
    const QString action = m_unit.section('.', 1), pou = m_unit.section('.', 0, 0);
    QString parent = pou;
    if (m_place.pou)
        for (const auto* list : {&m_place.pou->actions})
            for (const syntax::ActionDecl* each : *list)
                if (each->body.chart)
                    for (const syntax::StepDecl* step : each->body.chart->steps)
                        for (const syntax::ActionAssociation& association : step->actions)
                            if (kit::fromView(association.action.text).compare(action, Qt::CaseInsensitive) == 0)
                                parent = pou + "." + kit::fromView(each->name.text);
    setUnit(parent);
    setText(text);
}

void ChartView::toggleBreakpoint() {
    const Picked p = picked();
    if (!m_chart || m_isStale || p.kind == ChartScene::None || p.kind == ChartScene::Action)
        return emit failed(tr("Select a step or a transition"));
    emit breakpointRequested(rangeOf(p).begin);
}

void ChartView::forceSelected(bool active) {
    const Picked p = picked();
    if (!m_chart || p.kind != ChartScene::Step) return emit failed(tr("Select a step"));
    emit forceStepRequested(kit::fromView(m_chart->steps[static_cast<size_t>(p.index)].decl->name.text), active);
}

// ------------------------------------------------------------------ events

bool ChartView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_field) {
        if (event->type() == QEvent::KeyPress) {
            const int key = static_cast<QKeyEvent*>(event)->key();
            if (key == Qt::Key_Escape && !m_field->isCompletionShown()) return closeField(false), true;
            if ((key == Qt::Key_Return || key == Qt::Key_Enter) && !m_field->isCompletionShown())
                return closeField(true), true;
        }
        if (event->type() == QEvent::FocusOut && !m_field->isCompletionShown()) closeField(true);
        return false;
    }
    if (watched == m_canvas->viewport()) {
        if (event->type() == QEvent::MouseButtonDblClick) {
            const Picked p = picked();
            if (p.kind == ChartScene::Action && m_chart && !m_isStale) {
                const std::string_view name =
                    m_chart->steps[static_cast<size_t>(p.index)].decl->actions[static_cast<size_t>(p.sub)].action.text;
                for (const auto* list : {&m_place.chart->actions, &m_place.pou->actions})
                    for (const syntax::ActionDecl* action : *list)
                        if (action->body.chart && equalsIgnoringCase(action->name.text, name))
                            return openAction(), true;
            }
            editSelected();
            return true;
        }
        if (dragEvent(event)) return true;
    }
    if (watched == m_canvas &&
        event->type() == QEvent::ShortcutOverride) { // F2 edits here, it does not rename in the text
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_F2 || key == Qt::Key_Delete || key == Qt::Key_Insert || key == Qt::Key_Backspace)
            return event->accept(), true;
    }
    if (watched == m_canvas && event->type() == QEvent::KeyPress) {
        keyPressEvent(static_cast<QKeyEvent*>(event));
        return event->isAccepted();
    }
    return QWidget::eventFilter(watched, event);
}

void ChartView::keyPressEvent(QKeyEvent* event) {
    event->accept();
    const bool control = event->modifiers() & Qt::ControlModifier;
    switch (event->key()) {
    case Qt::Key_Insert:
        return insertStep();
    case Qt::Key_Delete:
        return event->modifiers() & Qt::ShiftModifier ? deleteBranch() : deleteSelected();
    case Qt::Key_F2:
    case Qt::Key_Return:
        return control ? openAction() : editSelected();
    case Qt::Key_Backspace:
        if (m_unit.contains('.')) return openParent();
        break;
    case Qt::Key_Escape:
        if (m_isDragging) return endDrag(false);
        break;
    case Qt::Key_Left:
        return control ? moveSelected(-1) : selectTowards(-1, 0);
    case Qt::Key_Right:
        return control ? moveSelected(1) : selectTowards(1, 0);
    case Qt::Key_Up:
        return control ? moveSelected(-1) : selectTowards(0, -1);
    case Qt::Key_Down:
        return control ? moveSelected(1) : selectTowards(0, 1);
    default:
        break;
    }
    event->ignore();
}

void ChartView::contextMenuEvent(QContextMenuEvent* event) {
    const Picked under = pickedAt(m_canvas->viewport()->mapFromGlobal(event->globalPos()));
    if (QGraphicsItem* item = m_scene->itemOf(under.kind, under.index, under.sub)) {
        m_scene->clearSelection();
        item->setSelected(true);
    }
    const Picked p = picked();
    QMenu menu(this);
    const auto add = [&](kit::Icon icon, const QString& text, auto run) {
        connect(menu.addAction(kit::icon(icon), text), &QAction::triggered, this, run);
    };
    if (!m_isStale) {
        add(kit::Icon::Add, tr("Insert a Step Behind"), &ChartView::insertStep);
        add(kit::Icon::Split, tr("Insert a Branch Beside"), &ChartView::insertAlternative);
        if (p.kind == ChartScene::Transition)
            add(kit::Icon::Layers, tr("Insert a Simultaneous Branch"), &ChartView::insertSimultaneous);
        if (p.kind == ChartScene::Step) {
            add(kit::Icon::Action, tr("Add an Action"), &ChartView::insertAction);
            add(kit::Icon::Home, tr("Make It the Initial Step"), &ChartView::makeInitial);
        }
    }
    if (p.kind == ChartScene::Step) {
        add(kit::Icon::Force, tr("Force the Step On"), [this] { forceSelected(true); });
        add(kit::Icon::Unforce, tr("Release the Step"), [this] { forceSelected(false); });
    }
    if (p.kind == ChartScene::Action) add(kit::Icon::Forward, tr("Open Its Chart or Text"), &ChartView::openAction);
    if (p.kind == ChartScene::Step || p.kind == ChartScene::Transition)
        add(kit::Icon::Breakpoint, tr("Toggle Breakpoint"), &ChartView::toggleBreakpoint);
    if (p.kind != ChartScene::None && !m_isStale) {
        add(kit::Icon::Edit, tr("Edit"), &ChartView::editSelected);
        if (p.kind == ChartScene::Transition) add(kit::Icon::Edit, tr("Priority…"), &ChartView::editPriority);
        if (p.kind != ChartScene::Step) {
            add(p.kind == ChartScene::Action ? kit::Icon::Up : kit::Icon::AlignLeft,
                p.kind == ChartScene::Action ? tr("Move Up") : tr("Move Left"), [this] { moveSelected(-1); });
            add(p.kind == ChartScene::Action ? kit::Icon::Down : kit::Icon::AlignRight,
                p.kind == ChartScene::Action ? tr("Move Down") : tr("Move Right"), [this] { moveSelected(1); });
        }
        add(kit::Icon::Delete, tr("Delete"), &ChartView::deleteSelected);
        if (p.kind == ChartScene::Transition)
            add(kit::Icon::Delete, tr("Delete the Whole Branch"), &ChartView::deleteBranch);
    }
    menu.exec(event->globalPos());
}

} // namespace plc::editor
