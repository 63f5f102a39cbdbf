#include "editor/graph/chart_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/theme.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <QContextMenuEvent>
#include <QFileDialog>
#include <QGraphicsItem>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPrintDialog>
#include <QPrinter>
#include <QToolBar>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::editor {

using chart::StepId;
using chart::TransitionId;

namespace {
QString view(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }
constexpr double kFadeMs = 1500;
} // namespace

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
    const auto action = [&](kit::Icon icon, const QString& text, auto run) { connect(m_bar->addAction(kit::icon(icon), text), &QAction::triggered, this, run); };
    action(kit::Icon::Add, tr("Insert a step behind (Ins)"), &ChartView::insertStep);
    action(kit::Icon::Split, tr("Insert a branch beside"), &ChartView::insertAlternative);
    action(kit::Icon::Layers, tr("Insert a simultaneous branch"), &ChartView::insertSimultaneous);
    action(kit::Icon::Action, tr("Add an action"), &ChartView::insertAction);
    action(kit::Icon::Edit, tr("Edit name or condition (F2)"), &ChartView::editSelected);
    action(kit::Icon::Delete, tr("Delete (Del)"), &ChartView::deleteSelected);
    m_bar->addSeparator();
    action(kit::Icon::Fit, tr("Show all"), [this] { m_canvas->zoomToFit(); });
    action(kit::Icon::Export, tr("Export as SVG or PNG…"), [this] {
        const QString path = QFileDialog::getSaveFileName(this, tr("Export the chart"), m_unit + ".svg", tr("SVG (*.svg);;PNG (*.png);;PDF (*.pdf)"));
        if (path.isEmpty()) return;
        const bool good = path.endsWith(".png") ? m_canvas->exportPng(path) : path.endsWith(".pdf") ? m_canvas->exportPdf(path) : m_canvas->exportSvg(path);
        if (!good) emit failed(tr("%1 can not be written").arg(path));
    });
    action(kit::Icon::Print, tr("Print…"), [this] {
        QPrinter printer;
        if (QPrintDialog(&printer, this).exec() == QDialog::Accepted) m_canvas->print(printer);
    });
    m_state = new QLabel(this);
    m_bar->addWidget(m_state);
    m_field = new kit::ExpressionEdit(m_canvas->viewport());
    m_field->hide();
    m_field->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(m_canvas);
    m_clock.start();
    connect(m_scene, &QGraphicsScene::selectionChanged, this, &ChartView::selectionMoved);
    connect(&kit::Theme::current(), &kit::Theme::changed, this, [this] {
        m_canvas->setBackgroundBrush(kit::colors().base);
        m_scene->refreshTheme();
    });
    m_field->setCompletionSource([this](const QString& text, int cursor) {
        std::vector<kit::Completion> out;
        if (!m_model || !m_pou) return out;
        const std::string utf8 = text.toStdString();
        const analysis::Completion found = m_model->complete(m_pou->range.file, utf8, static_cast<uint32_t>(text.left(cursor).toUtf8().size()));
        for (const analysis::CompletionItem& item : found.items)
            if (item.kind != analysis::ItemKind::Snippet && item.kind != analysis::ItemKind::Keyword) out.push_back({QString::fromStdString(item.text), QString::fromStdString(item.detail)});
        return out;
    });
}

ChartView::~ChartView() { m_scene->disconnect(this); } // selected items that die would ask for their place

void ChartView::setText(const std::string& text) {
    if (text == m_text && m_chart) {
        m_isStale = false;
        m_state->clear();
        return;
    }
    diagnostics::Sink sink;
    // The tree views the text: both are replaced together, the old chart first.
    auto fresh = std::make_unique<std::string>(text);
    auto syntax = parse::parseFile(FileId(size_t(0)), *fresh, sink);
    bool broken = false;
    const syntax::Pou* pou = nullptr;
    for (const syntax::Decl* decl : syntax->declarations)
        if (decl->kind == syntax::DeclKind::Pou && equalsIgnoringCase(std::string(decl->pou->name.text), m_unit.toStdString())) pou = decl->pou;
    if (pou)
        for (const diagnostics::Diagnostic& d : sink.all())
            if (d.severity == diagnostics::Severity::Error && d.range.begin >= pou->range.begin && d.range.begin <= pou->range.end) broken = true;
    if (!pou || broken || !pou->body.chart) {
        m_isStale = true;
        m_state->setText(!pou ? tr("The unit %1 is not in the text any more").arg(m_unit) : broken ? tr("The text has errors: this is the last good drawing") : tr("%1 is not a chart").arg(m_unit));
        return;
    }
    m_isStale = false;
    m_state->clear();
    m_scene->clear();
    m_chart.reset();
    m_syntax.reset();
    m_text = text;
    diagnostics::Sink again;
    m_syntax = parse::parseFile(FileId(size_t(0)), m_text, again);
    for (const syntax::Decl* decl : m_syntax->declarations)
        if (decl->kind == syntax::DeclKind::Pou && equalsIgnoringCase(std::string(decl->pou->name.text), m_unit.toStdString())) m_pou = decl->pou;
    m_chart = std::make_unique<chart::Chart>(chart::build(*m_pou->body.chart));
    rebuild();
}

void ChartView::rebuild() {
    const QSignalBlocker blocker(m_scene);
    const bool first = m_takenAt.empty();
    m_scene->show(*m_chart, m_text);
    m_takenAt.assign(m_chart->transitions.size(), -100000);
    m_wasActive.assign(m_chart->steps.size(), false);
    diagnostics::Sink sink;
    chart::check(*m_chart, sink);
    std::vector<ChartMessage> messages;
    for (const diagnostics::Diagnostic& d : sink.all()) messages.push_back({d.range, QString::fromStdString(d.message()), d.severity == diagnostics::Severity::Error});
    m_scene->showMessages(messages);
    if (!m_selectAfter.isEmpty())
        for (size_t i = 0; i < m_chart->steps.size(); ++i)
            if (view(m_chart->steps[i].decl->name.text) == m_selectAfter)
                if (QGraphicsItem* item = m_scene->itemOf(ChartScene::Step, static_cast<int>(i))) item->setSelected(true);
    m_selectAfter.clear();
    if (first) QMetaObject::invokeMethod(m_canvas, [this] { m_canvas->zoomToFit(); if (m_canvas->zoom() > 1) m_canvas->setZoom(1); }, Qt::QueuedConnection);
}

void ChartView::setModel(const std::shared_ptr<const analysis::CodeModel>& model, const QString& file) {
    m_model = model;
    if (!model || !m_chart || m_isStale) return;
    const auto id = model->fileOf(file.toStdString());
    if (!id || model->sources()[*id].text() != m_text) return;
    std::vector<ChartMessage> messages;
    for (const diagnostics::Diagnostic& d : model->diagnostics())
        if (d.range.file == *id && d.severity != diagnostics::Severity::Info) messages.push_back({d.range, QString::fromStdString(d.message()), d.severity == diagnostics::Severity::Error});
    m_scene->showMessages(messages);
}

void ChartView::refreshOnline() {
    if (!m_values || !m_chart || !isVisible()) return;
    ChartOnline online;
    const qint64 now = m_clock.elapsed();
    std::vector<bool> active(m_chart->steps.size());
    for (size_t i = 0; i < m_chart->steps.size(); ++i) {
        const QString name = view(m_chart->steps[i].decl->name.text);
        const ChartValue x = m_values(name + ".X");
        if (!x.text.isEmpty()) online.isOn = true;
        active[i] = x.isTrue;
        online.steps.push_back({x.isTrue, x.isTrue ? m_values(name + ".T").text.section('#', 1) : QString()});
        for (const syntax::ActionAssociation& action : m_chart->steps[i].decl->actions) {
            const QString actionName = view(action.action.text);
            if (!online.actions.contains(actionName.toLower())) online.actions[actionName.toLower()] = m_values(actionName + ".Q").isTrue || m_values(actionName).isTrue;
        }
    }
    for (size_t i = 0; i < m_chart->transitions.size(); ++i) {
        const chart::Transition& transition = m_chart->transitions[i];
        const syntax::Expr* condition = transition.decl->condition;
        const ChartValue value = condition ? m_values(view(std::string_view(m_text).substr(condition->range.begin, condition->range.length()))) : ChartValue();
        online.transitions.push_back(value.text.isEmpty() ? std::nullopt : std::optional(value.isTrue));
        const bool left = std::any_of(transition.from.begin(), transition.from.end(), [&](StepId step) { return m_wasActive[step.index()] && !active[step.index()]; });
        const bool entered = std::any_of(transition.to.begin(), transition.to.end(), [&](StepId step) { return !m_wasActive[step.index()] && active[step.index()]; });
        if (left && entered) m_takenAt[i] = now;
        online.taken.push_back(std::max(0.0, 1.0 - static_cast<double>(now - m_takenAt[i]) / kFadeMs));
    }
    m_wasActive = active;
    if (online.isOn || m_scene->online().isOn) m_scene->setOnline(std::move(online));
}

// ------------------------------------------------------------------ selection

ChartView::Picked ChartView::picked() const {
    const auto selected = m_scene->selectedItems();
    if (selected.isEmpty()) return {};
    return {static_cast<ChartScene::ItemKind>(selected.first()->data(ChartScene::Kind).toInt()), selected.first()->data(ChartScene::Index).toInt(), selected.first()->data(ChartScene::Sub).toInt()};
}

void ChartView::selectionMoved() {
    const Picked p = picked();
    if (!m_chart || p.kind == ChartScene::None) return;
    if (p.kind == ChartScene::Transition) emit placeSelected(m_chart->transitions[static_cast<size_t>(p.index)].decl->range.begin);
    else if (p.kind == ChartScene::Step) emit placeSelected(m_chart->steps[static_cast<size_t>(p.index)].decl->name.range.begin);
    else emit placeSelected(m_chart->steps[static_cast<size_t>(p.index)].decl->actions[static_cast<size_t>(p.sub)].range.begin);
}

void ChartView::showCursor(uint32_t offset) {
    if (!m_chart || m_isStale) return;
    const QSignalBlocker blocker(m_scene);
    m_scene->clearSelection();
    const auto select = [&](ChartScene::ItemKind kind, size_t index) {
        if (QGraphicsItem* item = m_scene->itemOf(kind, static_cast<int>(index))) {
            item->setSelected(true);
            m_canvas->ensureVisible(item, 40, 40);
        }
    };
    for (size_t i = 0; i < m_chart->steps.size(); ++i)
        if (m_chart->steps[i].decl->range.contains(offset)) return select(ChartScene::Step, i);
    for (size_t i = 0; i < m_chart->transitions.size(); ++i)
        if (m_chart->transitions[i].decl->range.contains(offset)) return select(ChartScene::Transition, i);
}

// ------------------------------------------------------------------ edits

void ChartView::request(const Result<chart::Edits>& edits, const QString& selectName) {
    if (m_isStale) return emit failed(tr("Mend the text first: this is the last good drawing"));
    if (!edits) return emit failed(QString::fromStdString(edits.error().text()));
    m_selectAfter = selectName;
    emit editsRequested(*edits);
}

void ChartView::insertStep() {
    const Picked p = picked();
    if (!m_chart || m_isStale) return;
    const std::string name = editor().freeStepName();
    if (p.kind == ChartScene::Transition) return request(editor().insertStepAfter(TransitionId(p.index), name), QString::fromStdString(name));
    const int step = p.kind == ChartScene::None ? static_cast<int>(m_chart->steps.size()) - 1 : p.index;
    if (step >= 0) request(editor().insertStepAfter(StepId(step), name), QString::fromStdString(name));
}

void ChartView::insertAlternative() {
    const Picked p = picked();
    if (!m_chart || p.kind == ChartScene::None) return emit failed(tr("Select the step from which the branch goes out"));
    const StepId step = p.kind == ChartScene::Transition ? m_chart->transitions[static_cast<size_t>(p.index)].from.front() : StepId(p.index);
    const std::string name = editor().freeStepName();
    request(editor().insertAlternativeBranch(step, name), QString::fromStdString(name));
}

void ChartView::insertSimultaneous() {
    const Picked p = picked();
    if (!m_chart || p.kind != ChartScene::Transition) return emit failed(tr("Select the transition behind which the steps run at the same time"));
    const std::string name = editor().freeStepName();
    request(editor().insertSimultaneousBranch(TransitionId(p.index), name), QString::fromStdString(name));
}

void ChartView::insertAction() {
    const Picked p = picked();
    if (!m_chart || (p.kind != ChartScene::Step && p.kind != ChartScene::Action)) return emit failed(tr("Select the step that gets the action"));
    const int step = p.index;
    const QRectF box = m_scene->stepRect(step);
    openField(QRectF(box.right() + 18, box.top(), 150, 24), {}, true, [this, step](const QString& text) {
        // "D T#2s Lamp", "S Motor" or just the name
        QStringList words = text.simplified().split(' ', Qt::SkipEmptyParts);
        if (words.isEmpty()) return;
        const QString name = words.takeLast();
        const QString qualifier = words.isEmpty() ? QStringLiteral("N") : words.takeFirst();
        request(editor().insertAction(StepId(step), m_chart->steps[static_cast<size_t>(step)].decl->actions.size(), name.toStdString(), qualifier.toStdString(), words.join(' ').toStdString()));
    });
}

void ChartView::deleteSelected() {
    const Picked p = picked();
    if (!m_chart) return;
    if (p.kind == ChartScene::Step) request(editor().deleteStep(StepId(p.index)));
    else if (p.kind == ChartScene::Transition) request(editor().deleteTransition(TransitionId(p.index)));
    else if (p.kind == ChartScene::Action) request(editor().deleteAction(StepId(p.index), static_cast<size_t>(p.sub)));
}

void ChartView::moveSelected(int direction) {
    const Picked p = picked();
    if (!m_chart) return;
    if (p.kind == ChartScene::Action) {
        const auto count = static_cast<int>(m_chart->steps[static_cast<size_t>(p.index)].decl->actions.size());
        const int to = p.sub + direction;
        if (to >= 0 && to < count) request(editor().moveAction(StepId(p.index), static_cast<size_t>(p.sub), static_cast<size_t>(to)));
        return;
    }
    if (p.kind != ChartScene::Transition || m_chart->transitions[static_cast<size_t>(p.index)].from.empty()) return;
    const auto& siblings = m_chart->steps[m_chart->transitions[static_cast<size_t>(p.index)].from.front().index()].out;
    const auto at = std::find(siblings.begin(), siblings.end(), TransitionId(p.index)) - siblings.begin();
    const auto to = at + direction;
    if (to < 0 || to >= static_cast<std::ptrdiff_t>(siblings.size())) return;
    request(editor().moveTransition(TransitionId(p.index), direction < 0 ? chart::Place::Before : chart::Place::After, siblings[static_cast<size_t>(to)]));
}

void ChartView::makeInitial() {
    const Picked p = picked();
    if (m_chart && p.kind == ChartScene::Step) request(editor().setInitial(StepId(p.index)));
}

void ChartView::editSelected() {
    const Picked p = picked();
    if (!m_chart || m_isStale || p.kind == ChartScene::None) return;
    const auto index = static_cast<size_t>(p.index);
    if (p.kind == ChartScene::Step)
        return openField(m_scene->stepRect(p.index), view(m_chart->steps[index].decl->name.text), false, [this, p](const QString& text) { request(editor().renameStep(StepId(p.index), text.trimmed().toStdString()), text.trimmed()); });
    if (p.kind == ChartScene::Transition) {
        const syntax::Expr* condition = m_chart->transitions[index].decl->condition;
        if (!condition) return emit failed(tr("This condition is written in IL; edit it in the text"));
        return openField(m_scene->conditionRect(p.index).adjusted(-4, -2, 120, 2), view(std::string_view(m_text).substr(condition->range.begin, condition->range.length())), true,
                         [this, p](const QString& text) { request(editor().setCondition(TransitionId(p.index), text.trimmed().toStdString())); });
    }
    const syntax::ActionAssociation& action = m_chart->steps[index].decl->actions[static_cast<size_t>(p.sub)];
    QString present = action.qualifier.text.empty() ? QStringLiteral("N") : view(action.qualifier.text);
    if (action.time) present += " " + view(std::string_view(m_text).substr(action.time->range.begin, action.time->range.length()));
    openField(m_scene->actionRect(p.index, p.sub), present + " " + view(action.action.text), true, [this, p](const QString& text) {
        QStringList words = text.simplified().split(' ', Qt::SkipEmptyParts);
        if (words.isEmpty()) return;
        const QString name = words.takeLast();
        const QString qualifier = words.isEmpty() ? QStringLiteral("N") : words.takeFirst();
        request(editor().changeAction(StepId(p.index), static_cast<size_t>(p.sub), name.toStdString(), qualifier.toStdString(), words.join(' ').toStdString()));
    });
}

void ChartView::openField(const QRectF& sceneRect, const QString& text, bool, std::function<void(const QString&)> done) {
    const QRect place = m_canvas->mapFromScene(sceneRect).boundingRect();
    m_field->setGeometry(place.x(), place.y(), std::max(160, place.width()), std::max(26, place.height()));
    m_field->setText(text);
    m_field->selectAll();
    m_field->show();
    m_field->setFocus();
    m_fieldDone = std::move(done);
}

void ChartView::closeField(bool accept) {
    const auto done = std::exchange(m_fieldDone, {}); // hiding takes the focus, which comes here again
    if (!done) return;
    const QString text = m_field->text();
    m_field->hide();
    m_canvas->setFocus();
    if (accept && done && !text.trimmed().isEmpty()) done(text);
}

// ------------------------------------------------------------------ events

bool ChartView::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_field) {
        if (event->type() == QEvent::KeyPress) {
            const int key = static_cast<QKeyEvent*>(event)->key();
            if (key == Qt::Key_Escape) return closeField(false), true;
            if ((key == Qt::Key_Return || key == Qt::Key_Enter) && !m_field->isCompletionShown()) return closeField(true), true;
        }
        if (event->type() == QEvent::FocusOut && !m_field->isCompletionShown()) closeField(true);
        return false;
    }
    if (watched == m_canvas->viewport() && event->type() == QEvent::MouseButtonDblClick) {
        editSelected();
        return true;
    }
    if (watched == m_canvas && event->type() == QEvent::ShortcutOverride) { // F2 edits here, it does not rename in the text
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_F2 || key == Qt::Key_Delete || key == Qt::Key_Insert) return event->accept(), true;
    }
    if (watched == m_canvas && event->type() == QEvent::KeyPress) {
        keyPressEvent(static_cast<QKeyEvent*>(event));
        return event->isAccepted();
    }
    return QWidget::eventFilter(watched, event);
}

void ChartView::keyPressEvent(QKeyEvent* event) {
    event->accept();
    switch (event->key()) {
    case Qt::Key_Insert: return insertStep();
    case Qt::Key_Delete: return deleteSelected();
    case Qt::Key_F2:
    case Qt::Key_Return: return editSelected();
    case Qt::Key_Left:
        if (event->modifiers() & Qt::ControlModifier) return moveSelected(-1);
        break;
    case Qt::Key_Right:
        if (event->modifiers() & Qt::ControlModifier) return moveSelected(1);
        break;
    default: break;
    }
    event->ignore();
}

void ChartView::contextMenuEvent(QContextMenuEvent* event) {
    const QPoint inside = m_canvas->viewport()->mapFromGlobal(event->globalPos());
    for (QGraphicsItem* item : m_canvas->items(inside))
        if (item->data(ChartScene::Kind).toInt() != ChartScene::None) {
            m_scene->clearSelection();
            item->setSelected(true);
            break;
        }
    const Picked p = picked();
    QMenu menu(this);
    const auto add = [&](kit::Icon icon, const QString& text, auto run) { connect(menu.addAction(kit::icon(icon), text), &QAction::triggered, this, run); };
    add(kit::Icon::Add, tr("Insert a Step Behind"), &ChartView::insertStep);
    add(kit::Icon::Split, tr("Insert a Branch Beside"), &ChartView::insertAlternative);
    if (p.kind == ChartScene::Transition) add(kit::Icon::Layers, tr("Insert a Simultaneous Branch"), &ChartView::insertSimultaneous);
    if (p.kind == ChartScene::Step) {
        const QString name = view(m_chart->steps[static_cast<size_t>(p.index)].decl->name.text);
        add(kit::Icon::Action, tr("Add an Action"), &ChartView::insertAction);
        add(kit::Icon::Home, tr("Make It the Initial Step"), &ChartView::makeInitial);
        add(kit::Icon::Force, tr("Force the Step On"), [this, name] { emit forceStepRequested(name, true); });
        add(kit::Icon::Unforce, tr("Release the Step"), [this, name] { emit forceStepRequested(name, false); });
    }
    if (p.kind == ChartScene::Step || p.kind == ChartScene::Transition) {
        const uint32_t at = p.kind == ChartScene::Step ? m_chart->steps[static_cast<size_t>(p.index)].decl->range.begin : m_chart->transitions[static_cast<size_t>(p.index)].decl->range.begin;
        add(kit::Icon::Breakpoint, tr("Toggle Breakpoint"), [this, at] { emit breakpointRequested(at); });
    }
    if (p.kind != ChartScene::None) {
        add(kit::Icon::Edit, tr("Edit"), &ChartView::editSelected);
        add(kit::Icon::AlignLeft, tr("Move Left"), [this] { moveSelected(-1); });
        add(kit::Icon::AlignRight, tr("Move Right"), [this] { moveSelected(1); });
        add(kit::Icon::Delete, tr("Delete"), &ChartView::deleteSelected);
    }
    menu.exec(event->globalPos());
}

} // namespace plc::editor
