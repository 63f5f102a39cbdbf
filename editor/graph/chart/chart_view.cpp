#include "editor/graph/chart/chart_view.h"

#include "editor/graph/chart/chart_items.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QGraphicsItem>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace plc::editor {

using chart::StepId;
using chart::TransitionId;

ChartView::ChartView(QWidget* parent)
    : GraphView(*new ChartScene, tr("Sequential function chart"), parent),
      m_scene(static_cast<ChartScene*>(m_canvas->scene())) {
    m_scene->setParent(this);
    const auto action = [&](kit::Icon icon, const QString& text, auto run) {
        return addCommand(icon, text, this, run);
    };
    m_up = action(kit::Icon::Up, tr("To the enclosing chart (Backspace)"), &ChartView::openParent);
    action(kit::Icon::Add, tr("Insert a step after it (Ins)"), &ChartView::insertStep);
    action(kit::Icon::Split, tr("Insert an alternative branch"), &ChartView::insertAlternative);
    action(kit::Icon::Layers, tr("Insert a simultaneous branch"), &ChartView::insertSimultaneous);
    action(kit::Icon::Action, tr("Add an action"), &ChartView::insertAction);
    action(kit::Icon::Edit, tr("Edit name or condition (F2)"), &ChartView::editSelected);
    action(kit::Icon::Delete, tr("Delete (Del)"), &ChartView::deleteSelected);
    m_bar->addSeparator();
    action(kit::Icon::Breakpoint, tr("Breakpoint: stops when the step becomes active or the transition is taken (F9)"),
           &ChartView::toggleBreakpoint);
    action(kit::Icon::Force, tr("Force the step active"), [this] { forceSelected(true); });
    action(kit::Icon::Unforce, tr("Release the step"), [this] { forceSelected(false); });
    m_bar->addSeparator();
    addSheetCommands();
    addClipboardCommands();
    m_begin = new QWidget(m_canvas);
    m_beginText = new QLabel(m_begin);
    m_beginText->setWordWrap(true);
    m_beginText->setAlignment(Qt::AlignCenter);
    m_beginButton = new QPushButton(kit::icon(kit::Icon::Add), tr("Start a Chart"), m_begin);
    connect(m_beginButton, &QPushButton::clicked, this, &ChartView::beginChart);
    auto* column = new QVBoxLayout(m_begin);
    column->addStretch();
    column->addWidget(m_beginText);
    column->addWidget(m_beginButton, 0, Qt::AlignHCenter);
    column->addStretch();
    auto* over = new QVBoxLayout(m_canvas);
    over->addWidget(m_begin);
    m_begin->hide();
    m_clock.start();
    connect(m_scene, &QGraphicsScene::selectionChanged, this, &ChartView::selectionMoved);
    updateActions();
}

void ChartView::themeChanged() { m_scene->refreshTheme(); }

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
    GraphView::showStale(reason);
    m_scene->setFaint(true);
}

void ChartView::setText(const std::string& text) {
    if (text == m_text && m_chart) {
        showFresh();
        m_scene->setFaint(false);
        return;
    }
    diagnostics::Sink sink;
    // The tree views the text: both are replaced together, the old chart first.
    auto kept = std::make_unique<std::string>(text);
    auto syntax = parse::parseFile(FileId(size_t(0)), *kept, sink);
    const ChartPlace place = findChart(*syntax, m_unit.toStdString());
    if (!place.pou)
        return showStale(tr("The unit %1 is no longer in the text; undo the change or close this view").arg(m_unit));
    for (const diagnostics::Diagnostic& d : sink.all())
        if (d.severity == diagnostics::Severity::Error && d.range.begin >= place.pou->range.begin &&
            d.range.begin <= place.pou->range.end)
            return showStale(tr("The text has errors: this is the last valid drawing"));
    if (!place) return showNoChart(text);
    m_begin->hide();
    showFresh();
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

/// What a unit without a chart shows instead of an empty sheet.
void ChartView::showNoChart(const std::string& text) {
    showStale({});
    {
        const QSignalBlocker blocker(m_scene);
        m_scene->forget();
    }
    m_chart.reset();
    m_text = text;
    diagnostics::Sink sink;
    m_syntax = parse::parseFile(FileId(size_t(0)), m_text, sink);
    m_place = findChart(*m_syntax, m_unit.toStdString());
    m_beginText->setText(canBegin()
                             ? tr("%1 has no chart yet. A chart starts with an initial step; more steps are inserted "
                                  "after it with Ins, and F2 edits names and conditions.")
                                   .arg(m_unit)
                             : tr("%1 is not a chart: its body has statements. A chart can be started in a program or "
                                  "function block whose body is empty.")
                                   .arg(m_unit));
    m_beginButton->setVisible(canBegin());
    m_begin->show();
    updateMap();
}

bool ChartView::canBegin() const {
    if (!m_place.pou || m_unit.contains('.')) return false;
    const syntax::Body& body = m_place.pou->body;
    const bool isUnit =
        m_place.pou->kind == syntax::PouKind::Program || m_place.pou->kind == syntax::PouKind::FunctionBlock;
    return isUnit && body.statements.empty() && !body.chart && m_place.pou->hasEnd;
}

void ChartView::beginChart() {
    if (!canBegin()) return;
    const uint32_t at = m_place.pou->body.range.begin;
    const bool isLineBegun = at > 0 && m_text[at - 1] != '\n';
    const std::string lineEnd = m_text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
    m_selectAfter = QStringLiteral("Init");
    m_namesInserted = false;
    m_isFresh = true;
    emit editsRequested({{{FileId(size_t(0)), at, at}, (isLineBegun ? lineEnd : "") + chart::emptyChart({}, lineEnd)}});
    m_canvas->setFocus();
}

void ChartView::selectInserted() {
    const QString name = std::exchange(m_selectAfter, {});
    const bool isNamed = std::exchange(m_namesInserted, false);
    if (name.isEmpty()) return;
    for (size_t i = 0; i < m_chart->steps.size(); ++i) {
        const syntax::StepDecl& step = *m_chart->steps[i].decl;
        QGraphicsItem* item = m_scene->itemOf(ChartScene::Step, static_cast<int>(i));
        if (!item || kit::fromView(step.name.text) != name) continue;
        item->setSelected(true);
        m_canvas->ensureVisible(item->sceneBoundingRect(), 30, 30);
        // Not while the text is still changing: the cursor follows, and the name is open for typing.
        kit::post(this, [this, at = step.name.range.begin, isNamed] {
            if (!m_chart || m_isStale) return;
            emit placeSelected(at);
            if (isNamed && picked().kind == ChartScene::Step) editSelected();
        });
    }
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
    marksChanged();
    selectInserted();
    if (std::exchange(m_isFresh, false)) showWhole();
    updateMap();
    updateActions();
}

void ChartView::updateActions() { m_up->setVisible(m_unit.contains('.')); }

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
    for (const diagnostics::Diagnostic& d : modelMessages())
        messages.push_back({d.range, kit::messageText(d.message), d.severity == diagnostics::Severity::Error});
    m_scene->showMessages(messages);
}

void ChartView::marksChanged() {
    ChartMarks marks;
    if (m_chart && !m_isStale) {
        std::vector<uint32_t> places;
        for (const chart::Step& step : m_chart->steps) places.push_back(step.decl->range.begin);
        for (const chart::Transition& transition : m_chart->transitions) places.push_back(transition.decl->range.begin);
        const std::vector<int> found = breakpointsAt(places);
        for (size_t i = 0; i < found.size(); ++i) {
            if (found[i] == 0) continue;
            const bool isStep = i < m_chart->steps.size();
            (isStep ? marks.steps : marks.transitions)[static_cast<int>(isStep ? i : i - m_chart->steps.size())] =
                found[i] > 0;
        }
    }
    m_scene->setMarks(marks);
    m_scene->setCoverage(coverageOf());
}

ChartCoverage ChartView::coverageOf() const {
    ChartCoverage coverage;
    if (!m_coverage || !m_chart || m_isStale) return coverage;
    std::vector<uint32_t> places;
    for (const chart::Step& step : m_chart->steps) {
        places.push_back(step.decl->range.begin);
        for (const syntax::ActionAssociation& action : step.decl->actions) places.push_back(action.range.begin);
    }
    for (const chart::Transition& transition : m_chart->transitions) places.push_back(transition.decl->range.begin);
    const std::vector<int> lines = linesOf(places);
    auto line = lines.begin(); // in the same order
    const auto note = [&](auto& marks, const auto& key) {
        if (const auto mark = m_coverage(*line++)) marks[key] = *mark;
    };
    for (int i = 0; i < static_cast<int>(m_chart->steps.size()); ++i) {
        note(coverage.steps, i);
        for (int k = 0; k < static_cast<int>(m_chart->steps[static_cast<size_t>(i)].decl->actions.size()); ++k)
            note(coverage.actions, QPair<int, int>(i, k));
    }
    for (int i = 0; i < static_cast<int>(m_chart->transitions.size()); ++i) note(coverage.transitions, i);
    return coverage;
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

void ChartView::insertStep() {
    const Picked p = picked();
    if (!m_chart || m_isStale) return;
    m_namesInserted = true;
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
    m_namesInserted = true;
    const std::string name = editor().freeStepName();
    request(editor().insertAlternativeBranch(step, name), QString::fromStdString(name));
}

void ChartView::insertSimultaneous() {
    const Picked p = picked();
    if (!m_chart || p.kind != ChartScene::Transition)
        return emit failed(tr("Select the transition after which the steps run at the same time"));
    m_namesInserted = true;
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
    return GraphView::eventFilter(watched, event);
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
    const bool isByKey = event->reason() == QContextMenuEvent::Keyboard; // then it is about what is selected
    const Picked under = isByKey ? picked() : pickedAt(m_canvas->viewport()->mapFromGlobal(event->globalPos()));
    QPoint at = event->globalPos();
    if (QGraphicsItem* item = m_scene->itemOf(under.kind, under.index, under.sub)) {
        m_scene->clearSelection();
        item->setSelected(true);
        if (isByKey) at = m_canvas->menuPlace(item->sceneBoundingRect());
    }
    const Picked p = picked();
    QMenu menu(this);
    const auto add = [&](kit::Icon icon, const QString& text, auto run) {
        connect(menu.addAction(kit::icon(icon), text), &QAction::triggered, this, run);
    };
    if (!m_isStale) {
        add(kit::Icon::Add, tr("Insert a Step After It"), &ChartView::insertStep);
        add(kit::Icon::Split, tr("Insert an Alternative Branch"), &ChartView::insertAlternative);
        if (p.kind == ChartScene::Transition)
            add(kit::Icon::Layers, tr("Insert a Simultaneous Branch"), &ChartView::insertSimultaneous);
        if (p.kind == ChartScene::Step) {
            add(kit::Icon::Action, tr("Add an Action"), &ChartView::insertAction);
            add(kit::Icon::Home, tr("Set as Initial Step"), &ChartView::makeInitial);
        }
    }
    if (p.kind == ChartScene::Step) {
        add(kit::Icon::Force, tr("Force the Step Active"), [this] { forceSelected(true); });
        add(kit::Icon::Unforce, tr("Release the Step"), [this] { forceSelected(false); });
    }
    if (p.kind == ChartScene::Action) add(kit::Icon::Forward, tr("Open Its Chart or Text"), &ChartView::openAction);
    if (p.kind == ChartScene::Step || p.kind == ChartScene::Transition)
        add(kit::Icon::Breakpoint, tr("Toggle Breakpoint"), &ChartView::toggleBreakpoint);
    if (!m_isStale) {
        menu.addSeparator();
        if (p.kind != ChartScene::None) {
            menu.addAction(tr("Cut"), this, &ChartView::cutSelected);
            menu.addAction(tr("Copy"), this, &ChartView::copySelected);
        }
        menu.addAction(tr("Paste"), this, &ChartView::paste);
        menu.addSeparator();
    }
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
    menu.exec(at);
}

} // namespace plc::editor
