#include "editor/graph/ladder_scene.h"

#include "editor/kit/texts.h"
#include "editor/kit/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include <algorithm>

namespace plc::editor {

using ladder::Shape;
using ladder::ShapeKind;
using ladder::TextRole;

namespace {

const QFont& ladderFont() {
    static const QFont font = [] {
        QFont f("DejaVu Sans Mono");
        f.setStyleHint(QFont::Monospace);
        f.setPointSizeF(9);
        return f;
    }();
    return font;
}

const QFont& boldFont() {
    static const QFont font = [] {
        QFont f = ladderFont();
        f.setBold(true);
        return f;
    }();
    return font;
}

QColor thinned(const QColor& colour, const QColor& ground, double share) {
    return QColor::fromRgbF(colour.redF() * share + ground.redF() * (1 - share),
                            colour.greenF() * share + ground.greenF() * (1 - share),
                            colour.blueF() * share + ground.blueF() * (1 - share));
}

} // namespace

LadderScene::LadderScene(QObject* parent) : QGraphicsScene(parent) {
    const QFontMetricsF metrics(ladderFont());
    m_cellWidth = metrics.horizontalAdvance("0");
    m_cellHeight = metrics.height() * 1.2;
    setItemIndexMethod(QGraphicsScene::NoIndex); // rungs are looked up by their place
}

void LadderScene::forget() {
    m_items.clear();
    m_diagram = nullptr;
    m_layout = nullptr;
    m_pick = {};
    m_online = {};
    m_marks.clear();
    m_nodeProblems.clear();
    m_rungProblems.clear();
}

void LadderScene::show(const ladder::Diagram& diagram, const ladder::Layout& layout) {
    m_diagram = &diagram;
    m_layout = &layout;
    m_online = {};
    m_isFaint = false;
    m_pick = {};
    m_marks.clear();
    m_nodeProblems.clear();
    m_rungProblems.clear();
    while (m_items.size() > layout.rungs.size()) m_items.pop_back();
    for (const auto& item : m_items) item->resized();
    while (m_items.size() < layout.rungs.size()) {
        m_items.push_back(std::make_unique<RungItem>(*this, m_items.size()));
        addItem(m_items.back().get());
    }
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

std::vector<LadderPick> LadderScene::picksOf(ladder::RungId rung) const {
    std::vector<LadderPick> out;
    if (!m_layout || !rung.isValid()) return out;
    for (const ladder::Hit& hit : m_layout->rungs[rung.index()].hits) out.push_back({rung, hit.node});
    return out;
}

QString LadderScene::problemAt(const LadderPick& pick) const {
    if (pick.node.isValid() && m_nodeProblems.contains(pick.node.value)) return m_nodeProblems[pick.node.value].text;
    return pick.rung.isValid() ? m_rungProblems.value(pick.rung.value).text : QString();
}

// ------------------------------------------------------------------ a rung

QRectF RungItem::boundingRect() const {
    if (!m_scene.m_layout || m_index >= m_scene.m_layout->rungs.size()) return {};
    const ladder::RungPicture& rung = m_scene.m_layout->rungs[m_index];
    return {-12, -4, (std::max(rung.width, 24) + 4) * m_scene.m_cellWidth + 24,
            (rung.height + 1) * m_scene.m_cellHeight + 8};
}

void RungItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const double detail = QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
    painter->setRenderHint(QPainter::Antialiasing, detail > 0.35);
    if (m_scene.m_isFaint) painter->setOpacity(0.5);
    paintSelection(*painter);
    const ladder::RungPicture& rung = m_scene.m_layout->rungs[m_index];
    for (const Shape& shape : rung.shapes)
        if (shape.kind != ShapeKind::Text) paintShape(*painter, shape);
    if (detail > 0.25)
        for (const Shape& shape : rung.shapes)
            if (shape.kind == ShapeKind::Text) paintText(*painter, shape);
    paintProblems(*painter);
    if (m_index < m_scene.m_marks.size() && m_scene.m_marks[m_index] != 0) {
        const kit::ThemeColors& c = kit::colors();
        painter->setPen(QPen(c.breakpoint, 1.5));
        painter->setBrush(m_scene.m_marks[m_index] > 0 ? QBrush(c.breakpoint) : QBrush(c.base));
        painter->drawEllipse(QPointF(-2, m_scene.m_cellHeight), 4.5, 4.5);
    }
}

QColor RungItem::inkOf(ladder::NodeId node, bool isWire) const {
    const kit::ThemeColors& c = kit::colors();
    if (!m_scene.m_online.isOn) return c.text;
    // A wire that comes from the rail carries power whenever the controller runs.
    const ladder::Power power = !node.isValid() ? (isWire ? ladder::Power::On : ladder::Power::Unknown)
                                : node.index() < m_scene.m_online.power.size() ? m_scene.m_online.power[node.index()]
                                                                               : ladder::Power::Unknown;
    return power == ladder::Power::On ? c.good : power == ladder::Power::Off ? c.muted : c.text;
}

void RungItem::paintSelection(QPainter& painter) const {
    const LadderPick& pick = m_scene.m_pick;
    if (!pick.rung.isValid() || pick.rung.index() != m_index) return;
    const kit::ThemeColors& c = kit::colors();
    const QRectF rect = m_scene.rectOf(pick).translated(0, -y());
    painter.setPen(QPen(c.accent, pick.node.isValid() ? 1.6 : 1.0));
    painter.setBrush(thinned(c.accent, c.base, pick.node.isValid() ? 0.16 : 0.06));
    painter.drawRoundedRect(rect.adjusted(-3, -2, 3, 2), 3, 3);
}

void RungItem::paintProblems(QPainter& painter) const {
    if (m_scene.m_nodeProblems.isEmpty() && m_scene.m_rungProblems.isEmpty()) return;
    const kit::ThemeColors& c = kit::colors();
    const auto underline = [&](const QRectF& rect, const LadderProblem& problem) {
        painter.setPen(QPen(problem.isError ? c.bad : c.warning, 1.6, Qt::DotLine));
        painter.drawLine(rect.bottomLeft() + QPointF(0, 1), rect.bottomRight() + QPointF(0, 1));
    };
    const ladder::RungPicture& rung = m_scene.m_layout->rungs[m_index];
    for (const ladder::Hit& hit : rung.hits) {
        const auto problem = m_scene.m_nodeProblems.find(hit.node.value);
        if (problem != m_scene.m_nodeProblems.end()) underline(m_scene.cells(hit), *problem);
    }
    const auto problem = m_scene.m_rungProblems.find(static_cast<uint32_t>(m_index));
    if (problem == m_scene.m_rungProblems.end()) return;
    const double height = m_scene.m_cellHeight;
    underline({height / 2, 0, 4 * m_scene.m_cellWidth, rung.height * height}, *problem);
}

void RungItem::paintShape(QPainter& painter, const Shape& s) const {
    const kit::ThemeColors& c = kit::colors();
    const double w = m_scene.m_cellWidth, h = m_scene.m_cellHeight;
    const QPointF at((s.x + 0.5) * w, (s.y + 0.5) * h);
    switch (s.kind) {
    case ShapeKind::Wire: {
        const QColor ink = inkOf(s.node, true);
        const bool isLive = m_scene.m_online.isOn && ink == c.good;
        painter.setPen(QPen(ink, isLive ? 2.4 : 1.3, Qt::SolidLine, Qt::FlatCap));
        const QLineF line(at, at + QPointF(s.w * w, s.h * h));
        if (!s.isDouble) return painter.drawLine(line);
        const QPointF aside = s.h == 0 ? QPointF(0, 1.5) : QPointF(1.5, 0);
        painter.drawLine(line.translated(aside));
        return painter.drawLine(line.translated(-aside));
    }
    case ShapeKind::Rail:
        painter.setPen(QPen(m_scene.m_online.isOn ? c.good : c.text, 2.6, Qt::SolidLine, Qt::FlatCap));
        return painter.drawLine(QPointF(at.x(), s.y * h), QPointF(at.x(), (s.y + s.h) * h));
    case ShapeKind::Nest:
        painter.setPen(QPen(c.border, 2));
        return painter.drawLine(QPointF(at.x(), s.y * h), QPointF(at.x(), (s.y + s.h + 1) * h));
    case ShapeKind::Contact:
    case ShapeKind::Coil:
        return paintGlyph(painter, s);
    case ShapeKind::Box:
        return paintBox(painter, s);
    case ShapeKind::Circle:
        painter.setPen(QPen(inkOf(s.node, false), 1.3));
        painter.setBrush(c.base);
        return painter.drawEllipse(at, 3.2, 3.2);
    case ShapeKind::Arrow:
        painter.setPen(inkOf(s.node, true));
        painter.setFont(ladderFont());
        return painter.drawText(QRectF(at - QPointF(w, h / 2), QSizeF(2 * w, h)), Qt::AlignCenter,
                                QString::fromStdString(s.text));
    case ShapeKind::Text:
        return;
    }
}

void RungItem::paintGlyph(QPainter& painter, const Shape& s) const {
    const kit::ThemeColors& c = kit::colors();
    const double w = m_scene.m_cellWidth, h = m_scene.m_cellHeight, y = (s.y + 0.5) * h;
    const double left = (s.x + 0.5) * w, right = (s.x + s.w + 0.5) * w, half = h * 0.4;
    const QColor ink = inkOf(s.node, false);
    const bool isLive = m_scene.m_online.isOn && ink == c.good;
    if (isLive) painter.fillRect(QRectF(left, y - half, right - left, 2 * half), thinned(c.good, c.base, 0.25));
    painter.setPen(QPen(ink, isLive ? 2.4 : 1.9, Qt::SolidLine, Qt::FlatCap));
    painter.setBrush(Qt::NoBrush);
    if (s.kind == ShapeKind::Contact) {
        painter.drawLine(QPointF(left, y - half), QPointF(left, y + half));
        painter.drawLine(QPointF(right, y - half), QPointF(right, y + half));
    } else {
        painter.drawArc(QRectF(left - 2, y - half, 1.2 * half, 2 * half), 105 * 16, 150 * 16);
        painter.drawArc(QRectF(right + 2 - 1.2 * half, y - half, 1.2 * half, 2 * half), -75 * 16, 150 * 16);
    }
    if (s.text == "/") {
        painter.setPen(QPen(ink, 1.3));
        return painter.drawLine(QPointF(left + 2, y + half), QPointF(right - 2, y - half));
    }
    painter.setPen(ink);
    painter.setFont(ladderFont());
    painter.drawText(QRectF(left, y - h / 2, right - left, h), Qt::AlignCenter, kit::fromView(s.text));
}

void RungItem::paintBox(QPainter& painter, const Shape& s) const {
    const kit::ThemeColors& c = kit::colors();
    const double w = m_scene.m_cellWidth, h = m_scene.m_cellHeight;
    const bool isPart = s.node.isValid(); // a box with pins, its title inside; else text in a frame
    const QRectF frame((s.x + 0.5) * w, isPart ? s.y * h + 1 : (s.y + 0.5) * h, s.w * w,
                       isPart ? s.h * h + 0.25 * h : s.h * h);
    painter.setPen(QPen(c.text, s.isDouble ? 2 : 1.3, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.setBrush(c.alternate);
    painter.drawRect(frame);
    if (!isPart || s.node.index() >= m_scene.m_online.progress.size()) return;
    const double progress = m_scene.m_online.progress[s.node.index()];
    if (progress < 0) return;
    painter.fillRect(QRectF(frame.left() + 1, frame.bottom() - 4, (frame.width() - 2) * std::min(1.0, progress), 3),
                     c.online);
}

void RungItem::paintText(QPainter& painter, const Shape& s) const {
    const kit::ThemeColors& c = kit::colors();
    const double w = m_scene.m_cellWidth, h = m_scene.m_cellHeight;
    QColor ink = c.text;
    const bool isBold = s.role == TextRole::Title || s.role == TextRole::Heading;
    switch (s.role) {
    case TextRole::Operand: {
        ink = s.isMarked ? c.warning : c.text;
        const bool isForced = s.node.isValid() && s.node.index() < m_scene.m_online.forced.size() &&
                              m_scene.m_online.forced[s.node.index()];
        if (isForced) ink = c.forced;
        break;
    }
    case TextRole::Instance:
        ink = c.info;
        break;
    case TextRole::Pin:
    case TextRole::Order:
    case TextRole::Note:
    case TextRole::Number:
        ink = c.muted;
        break;
    case TextRole::Title:
    case TextRole::Heading:
    case TextRole::Code:
        break;
    }
    painter.setPen(ink);
    painter.setFont(isBold ? boldFont() : ladderFont());
    const QString text = kit::fromView(s.text) + (s.isMarked ? QStringLiteral("↺") : QString());
    painter.drawText(QRectF(s.x * w, s.y * h, (s.w + 2) * w, h), Qt::AlignLeft | Qt::AlignVCenter, text);
    if (s.role != TextRole::Operand || !s.node.isValid() || s.node.index() >= m_scene.m_online.values.size()) return;
    const QString& value = m_scene.m_online.values[s.node.index()];
    if (value.isEmpty()) return;
    painter.setPen(c.online);
    painter.drawText(QRectF((s.x - 30) * w, s.y * h, 29.5 * w, h), Qt::AlignRight | Qt::AlignVCenter, value);
}

} // namespace plc::editor
