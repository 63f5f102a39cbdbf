#include "hmi/view/displays/basics.h"

#include "hmi/view/paint/colour_sight.h"
#include "hmi/view/paint/picture_file.h"
#include "hmi/view/paint/symbol_art.h"
#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

TextBox TextView::label(const QString& forTag) const {
    const bool filled = color("fill").isValid();
    TextBox out = textBox(shown(text("text"), forTag), filled ? box().adjusted(6, 2, -6, -2) : box(), num("fontSize"),
                          textAlign(text("align")), "text", flag("bold"), forTag);
    out.wraps = flag("wrap");
    return out;
}

bool TextView::update() {
    const QString now = shown(text("text"));
    return std::exchange(m_shown, now) != now;
}

void TextView::draw(QPainter& painter) {
    const QColor fill = stateColor(color("fill"));
    if (fill.isValid()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        painter.drawRoundedRect(box(), 3, 3);
    }
    const bool ownFill = appearance().color.isValid() && !appearance().textColor.isValid();
    painter.setPen(ownFill ? PanelTheme::inkOn(fill) : inkColor(color("textColor")));
    drawText(painter, label(tag()));
}

void TextView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const { out.push_back(label(forTag)); }

void ImageView::setUp() {
    const QString file = text("file");
    if (file == m_file) return;
    m_file = file;
    m_picture = {};
    if (file.isEmpty()) return;
    if (Result<QPixmap> picture = loadPicture(scene().pictures(), file, rect().size() * 2)) m_picture = *picture;
}

void ImageView::draw(QPainter& painter) {
    if (m_picture.isNull()) {
        painter.setPen(QPen(theme().color("faint"), 1.5, Qt::DashLine));
        painter.setBrush(theme().color("surface"));
        painter.drawRoundedRect(box(), 4, 4);
        // A landscape stands for the picture that is not there.
        const double side = std::min(width(), height()) * 0.5;
        const QRectF art(box().center() - QPointF(side / 2, side / 2), QSizeF(side, side));
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().color("muted"));
        painter.drawEllipse(art.topLeft() + QPointF(side * 0.75, side * 0.25), side * 0.1, side * 0.1);
        painter.drawPolygon(
            QPolygonF{art.topLeft() + QPointF(0, side * 0.85), art.topLeft() + QPointF(side * 0.35, side * 0.3),
                      art.topLeft() + QPointF(side * 0.55, side * 0.62),
                      art.topLeft() + QPointF(side * 0.7, side * 0.45), art.topLeft() + QPointF(side, side * 0.85)});
        return;
    }
    const QString fit = text("fit");
    QSizeF size = m_picture.size();
    if (fit == QStringLiteral("stretch"))
        size = box().size();
    else
        size.scale(box().size(), fit == QStringLiteral("cover") ? Qt::KeepAspectRatioByExpanding : Qt::KeepAspectRatio);
    painter.setClipRect(box(), Qt::IntersectClip);
    painter.drawPixmap(QRectF(box().center() - QPointF(size.width() / 2, size.height() / 2), size), m_picture,
                       m_picture.rect());
}

void SymbolView::setUp() {
    m_state = bindProperty("state");
    m_warning = bindProperty("warning");
    m_fault = bindProperty("fault");
    m_closed = bindProperty("closed");
    m_transit = bindProperty("transit");
    m_manual = bindProperty("manual");
    m_service = bindProperty("service");
    m_level = bindProperty("level");
}

bool SymbolView::update() {
    const auto before = std::pair(m_now, m_shownLevel);
    m_now = {isTrue(m_state),   isTrue(m_warning), isTrue(m_fault),  isTrue(m_closed),
             isTrue(m_transit), isTrue(m_manual),  isTrue(m_service)};
    const double full = num("levelMax");
    const std::optional<double> level = number(m_level, full * 0.6);
    m_shownLevel = level && full != 0 ? static_cast<int>(std::clamp(*level / full, 0.0, 1.0) * 100) : 0;
    if (!m_now.running) m_frame = 0;
    return before != std::pair(m_now, m_shownLevel);
}

bool SymbolView::advance(qint64 milliseconds) {
    if (!m_now.running || !isMoving(text("symbol"))) return false;
    const int frame = scene().isMotionReduced() ? 0 : static_cast<int>(milliseconds / 100 % kSymbolFrames);
    return std::exchange(m_frame, frame) != frame;
}

QRectF SymbolView::artRect() const {
    const double label = text("label").isEmpty() ? 0 : num("fontSize") * 1.45;
    return {0, 0, width(), std::max(8.0, height() - label)};
}

TextBox SymbolView::label(const QString& forTag) const {
    const QRectF art = artRect();
    TextBox out = textBox(shown(text("label"), forTag), QRectF(0, art.bottom(), width(), height() - art.bottom()),
                          num("fontSize"), TextAlign::Center, "label", false, forTag);
    return out;
}

/// Closed is filled dark, open is light, between the two is between the two.
QColor SymbolView::bodyColor() const {
    const QColor on = color("onColor"), off = color("offColor");
    QColor body = m_now.running ? on : off;
    if (m_closed.isBound() && !m_now.running && !m_now.closed)
        body = QColor((on.red() + off.red()) / 2, (on.green() + off.green()) / 2, (on.blue() + off.blue()) / 2);
    if (m_now.fault)
        body = theme().color("alarm");
    else if (m_now.warning || contradicts())
        body = theme().color("warning");
    body = stateColor(body);
    return body.isValid() ? body : theme().color("off");
}

/// Colour alone must not tell: a fault, a warning and a contradiction have a mark with a shape of its own.
void SymbolView::drawAlarmMark(QPainter& painter, const QRectF& art) {
    const bool isWarning = m_now.warning || contradicts();
    if (!m_now.fault && !isWarning) return;
    m_blinking = m_now.fault;
    const double side = std::clamp(std::min(art.width(), art.height()) * 0.3, 12.0, 30.0);
    const QRectF mark(art.right() - side, art.top(), side, side);
    const QColor ground = theme().color(m_now.fault ? "alarm" : "warning");
    painter.setPen(QPen(theme().color("background"), 1.5));
    painter.setBrush(ground);
    if (!m_now.fault)
        painter.drawPolygon(QPolygonF{QPointF(mark.center().x(), mark.top()), mark.bottomRight(), mark.bottomLeft()});
    else if (isLit())
        painter.drawRect(mark.adjusted(1, 1, -1, -1));
    else
        painter.drawEllipse(mark.adjusted(side * 0.3, side * 0.3, -side * 0.3, -side * 0.3));
    if (m_now.fault && !isLit()) return;
    painter.setPen(PanelTheme::inkOn(ground));
    const QString sign = contradicts() && !m_now.fault && !m_now.warning ? QStringLiteral("?") : QStringLiteral("!");
    drawText(painter, textBox(sign, m_now.fault ? mark : mark.adjusted(0, side * 0.15, 0, 0), side * 0.7,
                              TextAlign::Center, "", true));
}

/// On its way: arrows to both sides. By hand: a hand. Out of service: crossed out.
void SymbolView::drawStateMarks(QPainter& painter, const QRectF& art) const {
    const double side = std::clamp(std::min(art.width(), art.height()) * 0.3, 12.0, 30.0);
    const QColor ink = theme().color("text"), ground = theme().color("raised");
    const auto plate = [&](const QRectF& mark) {
        painter.setPen(QPen(ink, 1.2));
        painter.setBrush(ground);
        painter.drawRoundedRect(mark, side * 0.15, side * 0.15);
        painter.setPen(QPen(ink, side * 0.11, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
    };
    const auto line = [&](const QRectF& mark, std::initializer_list<QPointF> points) {
        QPolygonF out;
        for (const QPointF& one : points)
            out += mark.topLeft() + QPointF(one.x() * mark.width(), one.y() * mark.height());
        painter.drawPolyline(out);
    };
    if (m_now.service) {
        painter.setPen(QPen(ink, std::max(1.5, side * 0.12), Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(art.topLeft() + QPointF(3, 3), art.bottomRight() - QPointF(3, 3));
        painter.drawLine(art.topRight() + QPointF(-3, 3), art.bottomLeft() + QPointF(3, -3));
    }
    if (m_now.transit) {
        const QRectF mark(art.right() - side, art.bottom() - side, side, side);
        plate(mark);
        line(mark, {{0.2, 0.5}, {0.8, 0.5}});
        line(mark, {{0.36, 0.32}, {0.2, 0.5}, {0.36, 0.68}});
        line(mark, {{0.64, 0.32}, {0.8, 0.5}, {0.64, 0.68}});
    }
    if (!m_now.manual) return;
    const QRectF mark(art.left(), art.top(), side, side);
    plate(mark);
    line(mark, {{0.3, 0.6}, {0.3, 0.35}});
    line(mark, {{0.44, 0.55}, {0.44, 0.22}});
    line(mark, {{0.58, 0.55}, {0.58, 0.22}});
    line(mark, {{0.72, 0.6}, {0.72, 0.32}});
    line(mark, {{0.18, 0.55}, {0.34, 0.8}, {0.66, 0.8}, {0.72, 0.6}});
}

namespace {
/// Lines on a body that is as light as they are would not be seen: then a tone between it and the ground is taken.
QColor lineFor(const QColor& usual, const QColor& body, const QColor& ground) {
    constexpr double kSeen = 2;
    if (contrast(usual, body) >= kSeen) return usual;
    QColor best = usual;
    double bestLeast = 0;
    for (int part = 1; part < 10; ++part) {
        const auto mixed = [&](int a, int b) { return (a * (10 - part) + b * part) / 10; };
        const QColor tone(mixed(usual.red(), ground.red()), mixed(usual.green(), ground.green()),
                          mixed(usual.blue(), ground.blue()));
        const double least = std::min(contrast(tone, body), contrast(tone, ground));
        if (least <= bestLeast) continue;
        bestLeast = least;
        best = tone;
    }
    return best;
}
} // namespace

void SymbolView::draw(QPainter& painter) {
    SymbolLook look;
    look.symbol = text("symbol");
    look.body = bodyColor();
    look.line = theme().isDark() ? theme().color("text").darker(115) : QColor(0x33, 0x3A, 0x41);
    if (theme().kind() == PanelThemeKind::Contrast) look.line = theme().color("line");
    look.line = lineFor(look.line, look.body, theme().color("background"));
    look.accent = theme().color("liquid");
    look.ground = theme().color("surface");
    look.level = hasLevel(look.symbol) ? m_shownLevel : 0;
    look.frame = m_frame;
    const QString direction = text("direction");
    look.quarter = direction == QStringLiteral("down")   ? 1
                   : direction == QStringLiteral("left") ? 2
                   : direction == QStringLiteral("up")   ? 3
                                                         : 0;
    const QRectF art = artRect();
    const QTransform transform = painter.worldTransform();
    const double scale = painter.device()->devicePixelRatio() * std::hypot(transform.m11(), transform.m12());
    const QPixmap pixmap = symbolPixmap(look, (art.size() * std::max(0.1, scale)).toSize().expandedTo(QSize(1, 1)));
    painter.drawPixmap(art, pixmap, QRectF(pixmap.rect()));
    drawStateMarks(painter, art);
    drawAlarmMark(painter, art);
    painter.setPen(inkColor(theme().color("text")));
    drawText(painter, label(tag()));
}

void SymbolView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("label").isEmpty()) out.push_back(label(forTag));
}

void UnknownView::draw(QPainter& painter) {
    painter.setPen(QPen(theme().color("low"), 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box());
    painter.drawLine(box().topLeft(), box().bottomRight());
    painter.drawLine(box().topRight(), box().bottomLeft());
    painter.setPen(theme().color("text"));
    drawText(painter, textBox(text("kind"), box(), 12, TextAlign::Center, ""));
}

} // namespace plc::hmi
