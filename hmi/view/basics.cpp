#include "hmi/view/basics.h"

#include "hmi/view/panel_scene.h"
#include "hmi/view/picture_file.h"
#include "hmi/view/symbol_art.h"

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
    m_level = bindProperty("level");
}

bool SymbolView::update() {
    const auto before = std::tuple(m_running, m_isWarning, m_isFault, m_shownLevel);
    m_running = isTrue(m_state);
    m_isWarning = isTrue(m_warning);
    m_isFault = isTrue(m_fault);
    const double full = num("levelMax");
    const std::optional<double> level = number(m_level, full * 0.6);
    m_shownLevel = level && full != 0 ? static_cast<int>(std::clamp(*level / full, 0.0, 1.0) * 100) : 0;
    if (!m_running) m_frame = 0;
    return before != std::tuple(m_running, m_isWarning, m_isFault, m_shownLevel);
}

bool SymbolView::advance(qint64 milliseconds) {
    if (!m_running || !isMoving(text("symbol"))) return false;
    const int frame = static_cast<int>(milliseconds / 100 % kSymbolFrames);
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

void SymbolView::draw(QPainter& painter) {
    SymbolLook look;
    look.symbol = text("symbol");
    look.body = m_isFault     ? theme().color("alarm")
                : m_isWarning ? theme().color("warning")
                : m_running   ? color("onColor")
                              : color("offColor");
    look.body = stateColor(look.body);
    if (!look.body.isValid()) look.body = theme().color("off");
    look.line = theme().isDark() ? theme().color("text").darker(115) : QColor(0x33, 0x3A, 0x41);
    if (theme().kind() == PanelThemeKind::Contrast) look.line = theme().color("line");
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
    // Colour alone must not tell: a fault has a mark with a shape of its own.
    if (m_isFault || m_isWarning) {
        m_blinking = m_isFault;
        const double side = std::clamp(std::min(art.width(), art.height()) * 0.3, 12.0, 30.0);
        const QRectF mark(art.right() - side, art.top(), side, side);
        const QColor ground = theme().color(m_isFault ? "alarm" : "warning");
        painter.setPen(QPen(theme().color("background"), 1.5));
        painter.setBrush(ground);
        if (m_isFault) {
            if (isLit())
                painter.drawRect(mark.adjusted(1, 1, -1, -1));
            else
                painter.drawEllipse(mark.adjusted(side * 0.3, side * 0.3, -side * 0.3, -side * 0.3));
        } else {
            painter.drawPolygon(
                QPolygonF{QPointF(mark.center().x(), mark.top()), mark.bottomRight(), mark.bottomLeft()});
        }
        if (m_isWarning || isLit()) {
            painter.setPen(PanelTheme::inkOn(ground));
            TextBox sign = textBox(QStringLiteral("!"), m_isFault ? mark : mark.adjusted(0, side * 0.15, 0, 0),
                                   side * 0.7, TextAlign::Center, "", true);
            drawText(painter, sign);
        }
    }
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
