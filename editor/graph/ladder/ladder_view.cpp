#include "editor/graph/ladder/ladder_view.h"

#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <QLabel>
#include <QToolBar>

#include <algorithm>
#include <cmath>

namespace plc::editor {

using ladder::Form;
using ladder::NodeId;
using ladder::NodeKind;
using ladder::RungId;
using ladder::RungKind;

LadderView::LadderView(QWidget* parent)
    : GraphView(*new LadderScene, tr("Ladder or function block diagram"), parent),
      m_scene(static_cast<LadderScene*>(m_canvas->scene())) {
    m_scene->setParent(this);
    m_canvas->setAlignment(Qt::AlignLeft | Qt::AlignTop); // a rung stays where it is when others come
    const auto command = [&](kit::Icon icon, const QString& text, auto run) {
        return addCommand(icon, text, this, run);
    };
    command(kit::Icon::Add, tr("Insert a rung below (Ctrl+T)"), &LadderView::insertRungBelow);
    command(kit::Icon::AlignLeft, tr("Insert a contact on the left (Ctrl+K)"), &LadderView::insertContactLeft);
    command(kit::Icon::AlignRight, tr("Insert a contact on the right (Ctrl+D)"), &LadderView::insertContactRight);
    command(kit::Icon::Split, tr("Insert a parallel contact (Ctrl+R)"), &LadderView::insertParallel);
    command(kit::Icon::Action, tr("Insert a coil (Ctrl+A)"), &LadderView::insertCoil);
    command(kit::Icon::Layers, tr("Insert a function block (Ctrl+B)"), &LadderView::insertBlock);
    command(kit::Icon::Edit, tr("Edit (F2)"), &LadderView::editSelected);
    command(kit::Icon::Delete, tr("Delete (Del)"), &LadderView::deleteSelected);
    m_bar->addSeparator();
    command(kit::Icon::Breakpoint, tr("Breakpoint on the rung (F9)"), &LadderView::toggleBreakpoint);
    m_formAction = command(kit::Icon::Forward, tr("Show as a function block diagram"), &LadderView::toggleForm);
    m_bar->addSeparator();
    addLookMenu();
    addSheetCommands();
    m_canvas->viewport()->setAcceptDrops(true);
    m_canvas->viewport()->setMouseTracking(true); // a wire shows that a click inserts
    connect(m_scene, &QGraphicsScene::selectionChanged, this, [this] {
        const LadderPick& pick = m_scene->picked();
        if (m_isStale || !pick.rung.isValid()) return;
        m_canvas->ensureVisible(m_scene->rectOf(pick), 20, 20);
        emit placeSelected(placeOfName(pick));
    });
}

LadderView::~LadderView() {
    m_scene->disconnect(this);
    m_scene->forget(); // before the diagram goes
}

void LadderView::setUnit(const QString& unit) {
    if (unit.compare(m_unit, Qt::CaseInsensitive) != 0) {
        closeField(false);
        m_scene->forget();
        m_syntax.reset();
        m_place = {};
        m_isFresh = true;
    }
    m_unit = unit;
}

void LadderView::setForm(Form form) {
    if (form == m_form) return;
    m_form = form;
    m_formAction->setText(form == Form::Ladder ? tr("Show as a function block diagram")
                                               : tr("Show as a ladder diagram"));
    m_isFresh = true;
    if (m_syntax && !m_isStale) rebuild();
}

void LadderView::toggleForm() { setForm(m_form == Form::Ladder ? Form::Blocks : Form::Ladder); }

void LadderView::showStale(const QString& reason) {
    GraphView::showStale(reason);
    m_scene->setFaint(true);
}

void LadderView::setText(const std::string& text) {
    if (text == m_text && m_syntax) {
        showFresh();
        m_scene->setFaint(false);
        return;
    }
    diagnostics::Sink sink;
    std::string kept = text;
    kept.reserve(64); // on the heap, where a swap leaves the bytes that the tree views
    auto syntax = parse::parseFile(FileId(size_t(0)), kept, sink);
    const ladder::Unit place = ladder::findUnit(*syntax, m_unit.toStdString());
    if (!place.body)
        return showStale(tr("%1 is no longer in the text; undo the change or close this view").arg(m_unit));
    for (const diagnostics::Diagnostic& d : sink.all())
        if (m_syntax && d.severity == diagnostics::Severity::Error && d.range.begin >= place.range.begin &&
            d.range.begin <= place.range.end)
            return showStale(tr("The text has errors: this is the last valid drawing"));
    showFresh();
    closeField(false);
    // The tree views the text: both are replaced together.
    m_types.reset();
    m_text.swap(kept);
    m_syntax = std::move(syntax);
    m_place = place;
    rebuild();
}

/// This text's own declarations first, then those of the last check.
void LadderView::makeTypes() {
    m_typesModel = m_model;
    std::vector<const syntax::SyntaxFile*> files{m_syntax.get()};
    if (m_model)
        for (const auto& file : m_model->checked().analysis->files) files.push_back(file.get());
    m_types = std::make_unique<ladder::DeclaredTypes>(files);
}

void LadderView::rebuild() {
    const LadderPick before = m_scene->picked();
    if (!m_types) makeTypes();
    ladder::Diagram diagram = ladder::project(m_text, *m_syntax, m_place, *m_types, m_form);
    ladder::Layout layout = ladder::computeLayout(diagram, m_look.layout);
    m_diagram = std::move(diagram);
    m_layout = std::move(layout);
    m_scene->show(m_diagram, m_layout);
    showProblems();
    marksChanged();
    selectAgain(before);
    if (std::exchange(m_isFresh, false)) showWhole();
    updateMap();
    m_canvas->viewport()->update();
}

/// The new part by its label, else what is now where the selection was.
void LadderView::selectAgain(const LadderPick& before) {
    QString wanted = std::exchange(m_selectAfter, {}); // as it was typed: "/stop", "NOT stop"
    if (wanted.startsWith('/')) wanted.remove(0, 1);
    if (wanted.startsWith("NOT ", Qt::CaseInsensitive)) wanted.remove(0, 4);
    wanted = wanted.trimmed();
    if (m_diagram.rungs.empty()) return;
    const QSignalBlocker blocker(m_scene);
    const size_t rung = before.rung.isValid() ? std::min(before.rung.index(), m_diagram.rungs.size() - 1) : 0;
    if (!wanted.isEmpty())
        for (size_t distance = 0; distance < 2 * m_diagram.rungs.size(); ++distance) {
            const size_t at = distance % 2 ? rung - (distance + 1) / 2 : rung + distance / 2;
            if (at >= m_diagram.rungs.size()) continue;
            for (const LadderPick& pick : m_scene->picksOf(RungId(at)))
                if (kit::fromView(m_diagram[pick.node].label).compare(wanted, Qt::CaseInsensitive) == 0) {
                    m_scene->select(pick);
                    return m_canvas->ensureVisible(m_scene->rectOf(pick), 20, 20); // what was drawn is looked at
                }
        }
    if (before.rung.isValid()) m_scene->select({RungId(rung), {}});
}

void LadderView::revealSelection() {
    if (m_scene->picked().rung.isValid()) m_canvas->ensureVisible(m_scene->rectOf(m_scene->picked()), 20, 20);
}

void LadderView::setModel(const std::shared_ptr<const analysis::CodeModel>& model, const QString& file) {
    m_model = model;
    m_file = file;
    if (!m_syntax || m_isStale) return;
    // Types of other files may be known now that were not.
    const std::string before = ladder::describe(m_diagram);
    makeTypes();
    if (ladder::describe(ladder::project(m_text, *m_syntax, m_place, *m_types, m_form)) != before) return rebuild();
    showProblems();
}

void LadderView::showProblems() {
    QHash<uint32_t, LadderProblem> nodes, rungs;
    for (const diagnostics::Diagnostic& d : modelMessages()) {
        if (d.range.begin < m_place.range.begin || d.range.begin > m_place.range.end) continue;
        const NodeId node = m_diagram.nodeAt(d.range.begin);
        const RungId rung = m_diagram.rungAt(d.range.begin);
        if (!rung.isValid()) continue;
        LadderProblem& problem = node.isValid() ? nodes[node.value] : rungs[rung.value];
        problem.text += (problem.text.isEmpty() ? "" : "\n") + kit::messageText(d.message);
        problem.isError = d.severity == diagnostics::Severity::Error;
    }
    m_scene->setProblems(std::move(nodes), std::move(rungs));
}

void LadderView::marksChanged() {
    std::vector<uint32_t> places;
    for (const ladder::Rung& rung : m_diagram.rungs) places.push_back(rung.range.begin);
    m_scene->setMarks(m_isStale ? std::vector<int>() : breakpointsAt(places));
    std::vector<bool> bookmarks(places.size(), false);
    if (!m_bookmarks.empty() && !m_isStale) {
        std::vector<uint32_t> ends;
        for (const ladder::Rung& rung : m_diagram.rungs) ends.push_back(rung.range.end);
        const std::vector<int> first = linesOf(places), last = linesOf(ends);
        for (size_t i = 0; i < places.size(); ++i) {
            const auto next = m_bookmarks.lower_bound(first[i]);
            bookmarks[i] = next != m_bookmarks.end() && *next <= last[i];
        }
    }
    m_scene->setBookmarks(std::move(bookmarks));
    setStanding(m_standing);
}

void LadderView::setStanding(std::optional<uint32_t> offset) {
    m_standing = offset;
    const RungId before = m_scene->standing();
    const RungId rung = offset && m_syntax && !m_isStale ? m_diagram.rungAt(*offset) : RungId();
    m_scene->setStanding(rung);
    if (rung.isValid() && rung != before) m_canvas->ensureVisible(m_scene->rectOf({rung, {}}), 20, 20);
}

void LadderView::setLook(const LadderLook& look) {
    if (look == m_look) return;
    const bool isLaidOut = look.layout == m_look.layout;
    m_look = look;
    m_scene->setLook(look);
    m_canvas->setBackgroundBrush(m_scene->colors().base);
    if (m_syntax && !isLaidOut) rebuild();
    emit lookChosen(look.bits());
}

// ------------------------------------------------------------------ selection

const ladder::Node* LadderView::pickedNode() const {
    const LadderPick& pick = m_scene->picked();
    return pick.node.isValid() && m_syntax ? &m_diagram[pick.node] : nullptr;
}

RungId LadderView::pickedRung() const {
    if (m_scene->picked().rung.isValid()) return m_scene->picked().rung;
    return m_diagram.rungs.empty() ? RungId() : RungId(m_diagram.rungs.size() - 1);
}

void LadderView::showCursor(uint32_t offset) {
    if (!m_syntax || m_isStale) return;
    const QSignalBlocker blocker(m_scene);
    m_scene->select({m_diagram.rungAt(offset), m_diagram.nodeAt(offset)});
    revealSelection();
    m_canvas->viewport()->update();
}

void LadderView::selectTowards(int dx, int dy) {
    if (m_diagram.rungs.empty()) return;
    const LadderPick from = m_scene->picked();
    if (!from.rung.isValid()) return m_scene->select({RungId(0), {}});
    const auto rungsFrom = [&](int step) {
        const auto next = static_cast<std::ptrdiff_t>(from.rung.index()) + step;
        if (next >= 0 && next < static_cast<std::ptrdiff_t>(m_diagram.rungs.size()))
            m_scene->select({RungId(static_cast<size_t>(next)), {}});
    };
    const std::vector<LadderPick> parts = m_scene->picksOf(from.rung);
    if (!from.node.isValid()) {
        if (dy != 0) return rungsFrom(dy);
        if (dx > 0 && !parts.empty()) m_scene->select(parts.front());
        return;
    }
    const QPointF middle = m_scene->rectOf(from).center();
    const LadderPick* best = nullptr;
    double least = 1e18;
    for (const LadderPick& part : parts) {
        const QPointF way = m_scene->rectOf(part).center() - middle;
        const double along = way.x() * dx + way.y() * dy, across = std::abs(way.x() * dy) + std::abs(way.y() * dx);
        if (part == from || along < 2 || across > along * 2 + 40) continue;
        if (along + 2.5 * across < least) least = along + 2.5 * across, best = &part;
    }
    if (best) return m_scene->select(*best);
    if (dy != 0) return rungsFrom(dy);
    if (dx < 0) m_scene->select({from.rung, {}});
}

void LadderView::toggleBreakpoint() {
    const RungId rung = pickedRung();
    if (!rung.isValid() || m_isStale) return emit failed(tr("Select a rung"));
    emit breakpointRequested(m_diagram[rung].range.begin);
}

} // namespace plc::editor
