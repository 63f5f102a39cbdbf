#include "editor/graph/ladder/ladder_scene.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace plc::editor {

using ladder::Shape;
using ladder::ShapeKind;

LadderScene::LadderScene(QObject* parent) : QGraphicsScene(parent) {
    const QFontMetricsF metrics(RungItem::font());
    m_cellWidth = metrics.horizontalAdvance("0");
    m_cellHeight = metrics.height() * 1.2;
    setItemIndexMethod(QGraphicsScene::NoIndex); // rungs are looked up by their place
    refreshTheme();
}

void LadderScene::setLook(const LadderLook& look) {
    m_look = look;
    refreshTheme();
}

/// High contrast: black on white or white on black, and nothing that is only paler.
void LadderScene::refreshTheme() {
    m_colors = kit::colors();
    if (m_look.isHighContrast) {
        const QColor ink = m_colors.dark ? Qt::white : Qt::black;
        for (QColor* each : {&m_colors.text, &m_colors.muted, &m_colors.info, &m_colors.border}) *each = ink;
        m_colors.base = m_colors.alternate = m_colors.dark ? Qt::black : Qt::white;
        m_colors.good = m_colors.dark ? QColor(0x00, 0xff, 0x66) : QColor(0x00, 0x6b, 0x1f);
        m_colors.online = m_colors.dark ? QColor(0x66, 0xd9, 0xff) : QColor(0x00, 0x2f, 0xa7);
        m_colors.forced = m_colors.dark ? QColor(0xff, 0xd0, 0x00) : QColor(0xa0, 0x30, 0x00);
    }
    update();
}

void LadderScene::setStanding(ladder::RungId rung) {
    if (rung == m_standing) return;
    m_standing = rung;
    update();
}

void LadderScene::setBookmarks(std::vector<bool> byRung) {
    if (byRung == m_bookmarks) return;
    m_bookmarks = std::move(byRung);
    update();
}

void LadderScene::markGap(std::optional<LadderGap> gap) {
    if (!gap && !m_gap) return;
    m_gap = std::move(gap);
    update();
}

void LadderScene::forget() {
    m_items.clear();
    m_diagram = nullptr;
    m_layout = nullptr;
    m_pick = {};
    m_online = {};
    m_marks.clear();
    m_bookmarks.clear();
    m_standing = {};
    m_gap.reset();
    m_nodeProblems.clear();
    m_rungProblems.clear();
}

void LadderScene::show(const ladder::Diagram& diagram, const ladder::Layout& layout) {
    m_diagram = &diagram;
    m_layout = &layout;
    m_online = {};
    m_isFaint = false;
    m_pick = {};
    m_gap.reset();
    m_standing = {};
    m_marks.clear();
    m_bookmarks.clear();
    m_nodeProblems.clear();
    m_rungProblems.clear();
    while (m_items.size() > layout.rungs.size()) m_items.pop_back();
    while (m_items.size() < layout.rungs.size()) {
        m_items.push_back(std::make_unique<RungItem>(*this, m_items.size()));
        addItem(m_items.back().get());
    }
    for (const auto& item : m_items) item->resized();
    for (size_t i = 0; i < m_items.size(); ++i) m_items[i]->setPos(0, layout.rungs[i].top * m_cellHeight);
    setSceneRect(-16, -16, (layout.width + 2) * m_cellWidth + 32, (layout.height + 1) * m_cellHeight + 32);
    update();
}

void LadderScene::setFaint(bool faint) {
    m_isFaint = faint;
    update();
}

void LadderScene::setOnline(LadderOnline online) {
    if (online == m_online) return;
    m_online = std::move(online);
    update();
}

void LadderScene::setMarks(std::vector<int> marks) {
    m_marks = std::move(marks);
    update();
}

void LadderScene::setProblems(QHash<uint32_t, LadderProblem> byNode, QHash<uint32_t, LadderProblem> byRung) {
    m_nodeProblems = std::move(byNode);
    m_rungProblems = std::move(byRung);
    update();
}

void LadderScene::select(LadderPick pick) {
    if (pick == m_pick) return;
    m_pick = pick;
    emit selectionChanged();
    update();
}

QRectF LadderScene::cells(const ladder::Hit& hit) const {
    return {hit.x * m_cellWidth, hit.y * m_cellHeight, hit.w * m_cellWidth, hit.h * m_cellHeight};
}

LadderPick LadderScene::pickAt(QPointF point) const {
    if (!m_layout) return {};
    const auto& rungs = m_layout->rungs;
    const auto behind = std::upper_bound(rungs.begin(), rungs.end(), point.y(),
                                         [&](double y, const auto& rung) { return y < rung.top * m_cellHeight; });
    if (behind == rungs.begin()) return {};
    const auto index = static_cast<size_t>(behind - rungs.begin()) - 1;
    const ladder::RungPicture& rung = rungs[index];
    if (point.y() > (rung.top + rung.height + 1) * m_cellHeight) return {};
    const QPointF inside = point - QPointF(0, rung.top * m_cellHeight);
    LadderPick pick{ladder::RungId(index), {}};
    for (const ladder::Hit& hit : rung.hits)
        if (cells(hit).adjusted(-2, -2, 2, 2).contains(inside)) pick.node = hit.node;
    return pick;
}

QRectF LadderScene::rectOf(const LadderPick& pick) const {
    if (!m_layout || !pick.rung.isValid() || pick.rung.index() >= m_layout->rungs.size()) return {};
    const ladder::RungPicture& rung = m_layout->rungs[pick.rung.index()];
    for (const ladder::Hit& hit : rung.hits)
        if (pick.node.isValid() && hit.node == pick.node) return cells(hit).translated(0, rung.top * m_cellHeight);
    return {0, rung.top * m_cellHeight, std::max(40, rung.width) * m_cellWidth, rung.height * m_cellHeight};
}

std::pair<size_t, size_t> LadderScene::rungsIn(const QRectF& area) const {
    if (!m_layout) return {0, 0};
    const auto& rungs = m_layout->rungs;
    const auto first = std::partition_point(rungs.begin(), rungs.end(), [&](const ladder::RungPicture& rung) {
        return (rung.top + rung.height + 1) * m_cellHeight < area.top();
    });
    const auto last = std::partition_point(
        first, rungs.end(), [&](const ladder::RungPicture& rung) { return rung.top * m_cellHeight <= area.bottom(); });
    return {static_cast<size_t>(first - rungs.begin()), static_cast<size_t>(last - rungs.begin())};
}

std::vector<LadderPick> LadderScene::picksOf(ladder::RungId rung) const {
    std::vector<LadderPick> out;
    if (!m_layout || !rung.isValid()) return out;
    for (const ladder::Hit& hit : m_layout->rungs[rung.index()].hits) out.push_back({rung, hit.node});
    return out;
}

namespace {

bool covers(const Shape& wire, double x) { return wire.x <= x && x <= wire.x + wire.w; }

/// The parallel that begins with this node, seen from `rails` splits further left.
ladder::NodeId splitAround(const ladder::Diagram& diagram, const ladder::Rung& rung, ladder::NodeId first, int splits) {
    ladder::NodeId at = first;
    const std::vector<ladder::NodeId> all = diagram.nodesOf(rung);
    for (bool climbs = true; climbs && splits > 0;) {
        climbs = false;
        for (const ladder::NodeId each : all) {
            const auto& children = diagram[each].children;
            if (children.empty() || children.front() != at) continue;
            if (diagram[each].kind == ladder::NodeKind::Parallel) --splits;
            at = each;
            climbs = true;
            break;
        }
    }
    return at;
}

} // namespace

/// A wire leads to the contact on its right, unless the rung splits in between; else it comes from the one on its left.
std::optional<LadderGap> LadderScene::gapAt(QPointF point) const {
    const LadderPick pick = pickAt(point);
    if (!m_layout || !pick.rung.isValid() || pick.node.isValid()) return std::nullopt;
    const ladder::Rung& rung = (*m_diagram)[pick.rung];
    if (rung.kind != ladder::RungKind::Logic) return std::nullopt;
    const ladder::RungPicture& picture = m_layout->rungs[pick.rung.index()];
    const double x = point.x() / m_cellWidth - 0.5, y = point.y() / m_cellHeight - picture.top - 0.5;
    const Shape *wire = nullptr, *right = nullptr;
    for (const Shape& s : picture.shapes)
        if (s.kind == ShapeKind::Wire && s.h == 0 && covers(s, x) && std::abs(s.y - y) < 0.35) wire = &s;
    if (!wire) return std::nullopt;
    for (const Shape& s : picture.shapes)
        if (s.kind == ShapeKind::Contact && s.y == wire->y && s.x >= x && (!right || s.x < right->x)) right = &s;
    int splits = 0;
    for (const Shape& s : picture.shapes)
        if (right && s.kind == ShapeKind::Wire && s.w == 0 && s.x > x && s.x < right->x && s.y <= wire->y &&
            wire->y <= s.y + s.h)
            ++splits;
    LadderGap gap{pick.rung,
                  {},
                  ladder::Place::After,
                  QRectF(point.x() - 4, (picture.top + wire->y + 0.5) * m_cellHeight - 4, 8, 8)};
    const ladder::Node* source = wire->node.isValid() ? &(*m_diagram)[wire->node] : nullptr;
    const bool comesFrom = source && source->expr && source->kind != ladder::NodeKind::Box;
    if (right && splits == 0) {
        gap.beside = right->node;
        gap.place = ladder::Place::Before;
    } else if (comesFrom) {
        gap.beside = wire->node;
    } else if (right) {
        gap.beside = splitAround(*m_diagram, rung, right->node, splits);
        gap.place = ladder::Place::Before;
    }
    return gap;
}

QString LadderScene::problemAt(const LadderPick& pick) const {
    if (pick.node.isValid() && m_nodeProblems.contains(pick.node.value)) return m_nodeProblems[pick.node.value].text;
    return pick.rung.isValid() ? m_rungProblems.value(pick.rung.value).text : QString();
}

} // namespace plc::editor
