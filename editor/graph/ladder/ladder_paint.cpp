// How one rung is painted: wires and symbols, power and values, what is selected, wrong or marked.
#include "editor/graph/ladder/ladder_scene.h"

#include "editor/kit/texts.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>

#include <algorithm>

namespace plc::editor {

using ladder::Shape;
using ladder::ShapeKind;
using ladder::TextRole;

namespace {

constexpr double kLeastDetail = 0.08;

const QFont& boldFont() {
    static const QFont font = [] {
        QFont f = RungItem::font();
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

/// In the overview a rung is a stroke: its parts are smaller than a pixel.
void paintStroke(QPainter& painter, const ladder::RungPicture& rung, const LadderScene& scene) {
    const double w = scene.cellWidth(), h = scene.cellHeight();
    painter.fillRect(QRectF(5 * w, 0.3 * h, std::max(1, rung.width - 5) * w, std::max(0.6, rung.height - 0.6) * h),
                     thinned(scene.colors().text, scene.colors().base, 0.35));
}

} // namespace

const QFont& RungItem::font() {
    static const QFont font = [] {
        QFont f("DejaVu Sans Mono");
        f.setStyleHint(QFont::Monospace);
        f.setPointSizeF(9);
        return f;
    }();
    return font;
}

void RungItem::resized() {
    const QRectF now = bounds();
    if (now == m_bounds) return;
    prepareGeometryChange();
    m_bounds = now;
}

QRectF RungItem::bounds() const {
    if (!m_scene.m_layout || m_index >= m_scene.m_layout->rungs.size()) return {};
    const ladder::RungPicture& rung = m_scene.m_layout->rungs[m_index];
    return {-12, -4, (std::max(rung.width, 24) + 4) * m_scene.m_cellWidth + 24,
            (rung.height + 1) * m_scene.m_cellHeight + 8};
}

void RungItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    const double detail = QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
    painter->setRenderHint(QPainter::Antialiasing, detail > 0.35);
    const bool isLeftOut = m_index < m_scene.m_online.leftOut.size() && m_scene.m_online.leftOut[m_index];
    if (m_scene.m_isFaint || isLeftOut) painter->setOpacity(0.5);
    if (detail < kLeastDetail) return paintStroke(*painter, m_scene.m_layout->rungs[m_index], m_scene);
    paintSelection(*painter);
    const ladder::RungPicture& rung = m_scene.m_layout->rungs[m_index];
    for (const Shape& shape : rung.shapes)
        if (shape.kind != ShapeKind::Text) paintShape(*painter, shape);
    if (detail > 0.25)
        for (const Shape& shape : rung.shapes)
            if (shape.kind == ShapeKind::Text) paintText(*painter, shape);
    paintProblems(*painter);
    paintMargin(*painter);
}

/// Left of the rung: its breakpoint, its bookmark, and an arrow where the controller stands.
void RungItem::paintMargin(QPainter& painter) const {
    const kit::ThemeColors& c = m_scene.m_colors;
    const double y = m_scene.m_cellHeight;
    if (m_index < m_scene.m_marks.size() && m_scene.m_marks[m_index] != 0) {
        painter.setPen(QPen(c.breakpoint, 1.5));
        painter.setBrush(m_scene.m_marks[m_index] > 0 ? QBrush(c.breakpoint) : QBrush(c.base));
        painter.drawEllipse(QPointF(-2, y), 4.5, 4.5);
    }
    if (m_index < m_scene.m_bookmarks.size() && m_scene.m_bookmarks[m_index]) {
        painter.setPen(QPen(c.accent, 1));
        painter.setBrush(c.accent);
        painter.drawPolygon(QPolygonF({{-8, y + 7}, {0, y + 7}, {0, y + 18}, {-4, y + 14}, {-8, y + 18}}));
    }
    if (m_scene.m_standing.isValid() && m_scene.m_standing.index() == m_index) {
        painter.setPen(QPen(c.current, 1.4));
        painter.setBrush(c.current);
        painter.drawPolygon(QPolygonF(
            {{-10, y - 2.5}, {-1, y - 2.5}, {-1, y - 6}, {7, y}, {-1, y + 6}, {-1, y + 2.5}, {-10, y + 2.5}}));
    }
    if (m_scene.m_gap && m_scene.m_gap->rung.isValid() && m_scene.m_gap->rung.index() == m_index) {
        const QPointF at = m_scene.m_gap->at.center() - QPointF(0, this->y());
        painter.setPen(QPen(c.accent, 2));
        painter.setBrush(c.base);
        painter.drawEllipse(at, 6, 6);
        painter.drawLine(at - QPointF(3.5, 0), at + QPointF(3.5, 0));
        painter.drawLine(at - QPointF(0, 3.5), at + QPointF(0, 3.5));
    }
}

QColor RungItem::inkOf(ladder::NodeId node, bool isWire) const {
    const kit::ThemeColors& c = m_scene.m_colors;
    if (!m_scene.m_online.isOn) return c.text;
    if (m_index < m_scene.m_online.leftOut.size() && m_scene.m_online.leftOut[m_index]) return c.muted;
    // A wire that comes from the rail carries power whenever the controller runs.
    const ladder::Power power = !node.isValid() ? (isWire ? ladder::Power::On : ladder::Power::Unknown)
                                : node.index() < m_scene.m_online.power.size() ? m_scene.m_online.power[node.index()]
                                                                               : ladder::Power::Unknown;
    return power == ladder::Power::On ? c.good : power == ladder::Power::Off ? c.muted : c.text;
}

void RungItem::paintSelection(QPainter& painter) const {
    const LadderPick& pick = m_scene.m_pick;
    if (!pick.rung.isValid() || pick.rung.index() != m_index) return;
    const kit::ThemeColors& c = m_scene.m_colors;
    const QRectF rect = m_scene.rectOf(pick).translated(0, -y());
    painter.setPen(QPen(c.accent, pick.node.isValid() ? 1.6 : 1.0));
    painter.setBrush(thinned(c.accent, c.base, pick.node.isValid() ? 0.16 : 0.06));
    painter.drawRoundedRect(rect.adjusted(-3, -2, 3, 2), 3, 3);
}

void RungItem::paintProblems(QPainter& painter) const {
    if (m_scene.m_nodeProblems.isEmpty() && m_scene.m_rungProblems.isEmpty()) return;
    const kit::ThemeColors& c = m_scene.m_colors;
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
    const kit::ThemeColors& c = m_scene.m_colors;
    const double w = m_scene.m_cellWidth, h = m_scene.m_cellHeight;
    const QPointF at((s.x + 0.5) * w, (s.y + 0.5) * h);
    switch (s.kind) {
    case ShapeKind::Wire: {
        const QColor ink = inkOf(s.node, true);
        const bool isLive = m_scene.m_online.isOn && ink == c.good;
        painter.setPen(QPen(ink, m_scene.thick(isLive ? 2.4 : 1.3), Qt::SolidLine, Qt::FlatCap));
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
        painter.setFont(font());
        return painter.drawText(QRectF(at - QPointF(w, h / 2), QSizeF(2 * w, h)), Qt::AlignCenter,
                                QString::fromStdString(s.text));
    case ShapeKind::Text:
        return;
    }
}

void RungItem::paintGlyph(QPainter& painter, const Shape& s) const {
    const kit::ThemeColors& c = m_scene.m_colors;
    const double w = m_scene.m_cellWidth, h = m_scene.m_cellHeight, y = (s.y + 0.5) * h;
    const double left = (s.x + 0.5) * w, right = (s.x + s.w + 0.5) * w, half = h * 0.4;
    const QColor ink = inkOf(s.node, false);
    const bool isLive = m_scene.m_online.isOn && ink == c.good;
    const bool isCircuit = m_scene.m_look.symbols == ladder::Symbols::Circuit;
    const bool isLever = isCircuit && s.kind == ShapeKind::Contact && (s.text == " " || s.text == "/");
    if (isLive) // a lever is above its wire
        painter.fillRect(QRectF(left, y - half - (isLever ? 2 : 0), right - left, isLever ? half + 2 : 2 * half),
                         thinned(c.good, c.base, 0.25));
    painter.setPen(QPen(ink, m_scene.thick(isLive ? 2.4 : 1.9), Qt::SolidLine, Qt::FlatCap));
    painter.setBrush(Qt::NoBrush);
    if (isLever) return paintLever(painter, s, y);
    if (isCircuit && s.kind == ShapeKind::Coil) {
        painter.drawRect(QRectF(left - 1, y - half, right - left + 2, 2 * half));
    } else if (s.kind == ShapeKind::Contact) {
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
    painter.setFont(font());
    painter.drawText(QRectF(left, y - h / 2, right - left, h), Qt::AlignCenter, kit::fromView(s.text));
}

/// A lever over a gap: away from the contact, or against it (IEC 60617).
void RungItem::paintLever(QPainter& painter, const Shape& s, double y) const {
    const double w = m_scene.m_cellWidth, reach = m_scene.m_cellHeight * 0.5;
    const double left = (s.x + 0.5) * w, right = (s.x + s.w + 0.5) * w;
    if (s.text == "/") {
        painter.drawLine(QPointF(left, y), QPointF(right + 2, y - reach));
        painter.drawLine(QPointF(right, y), QPointF(right, y - reach));
    } else {
        painter.drawLine(QPointF(left, y), QPointF(right - 2, y - reach));
    }
}

void RungItem::paintBox(QPainter& painter, const Shape& s) const {
    const kit::ThemeColors& c = m_scene.m_colors;
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
    const kit::ThemeColors& c = m_scene.m_colors;
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
    case TextRole::Address:
    case TextRole::Instance:
        ink = c.info;
        break;
    case TextRole::Pin:
    case TextRole::Order:
    case TextRole::Note:
    case TextRole::Number:
    case TextRole::Comment:
        ink = c.muted;
        break;
    case TextRole::Title:
    case TextRole::Heading:
    case TextRole::Code:
        break;
    }
    painter.setPen(ink);
    painter.setFont(isBold ? boldFont() : font());
    const QString text = kit::fromView(s.text) + (s.isMarked ? QStringLiteral("↺") : QString());
    painter.drawText(QRectF(s.x * w, s.y * h, (s.w + 2) * w, h), Qt::AlignLeft | Qt::AlignVCenter, text);
    if (s.role == TextRole::Operand && s.node.isValid()) paintValue(painter, s);
}

/// Left of what is read, right of what is written.
void RungItem::paintValue(QPainter& painter, const Shape& s) const {
    const double w = m_scene.m_cellWidth, h = m_scene.m_cellHeight;
    const LadderOnline& online = m_scene.m_online;
    const bool isRead = s.pin < 0 && s.node.index() < online.values.size();
    const QString value = isRead ? online.values[s.node.index()] : online.outputs.value(s.node.value).value(s.pin);
    if (value.isEmpty()) return;
    painter.setPen(m_scene.m_colors.online);
    const QRectF place =
        isRead ? QRectF((s.x - 30) * w, s.y * h, 29.5 * w, h) : QRectF((s.x + s.w + 1) * w, s.y * h, 30 * w, h);
    painter.drawText(place, (isRead ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter, value);
}

} // namespace plc::editor
