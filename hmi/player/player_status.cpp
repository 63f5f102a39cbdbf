#include "hmi/player/player_status.h"

#include <QPainter>

namespace plc::hmi {

PlayerStatus::PlayerStatus(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    hide();
}

void PlayerStatus::setState(const OverlayLook& look, const QString& text, StateWeight weight) {
    if (text == m_state && weight == m_weight && look.tag == m_look.tag && look.theme == m_look.theme) return;
    m_look = look;
    m_state = text;
    m_weight = weight;
    setVisible(!m_state.isEmpty() || !m_refusal.isEmpty());
    raise();
    update();
}

void PlayerStatus::setRefusal(const OverlayLook& look, const QString& text) {
    if (text == m_refusal) return;
    m_look = look;
    m_refusal = text;
    setVisible(!m_state.isEmpty() || !m_refusal.isEmpty());
    raise();
    update();
}

QRect PlayerStatus::stateRect() const { return {0, 0, width(), 34}; }

QRect PlayerStatus::refusalRect() const {
    const int w = std::min(width() - 24, 560);
    return {(width() - w) / 2, height() - 78, w, 56};
}

void PlayerStatus::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font;
    font.setFamilies(m_look.texts->settings().fontFamilies(m_look.tag));
    font.setBold(true);
    const auto strip = [&](const QRect& rect, const QColor& ground, const QString& text, int radius) {
        painter.setPen(QPen(PanelTheme::inkOn(ground), radius ? 1.5 : 0));
        if (!radius) painter.setPen(Qt::NoPen);
        painter.setBrush(ground);
        painter.drawRoundedRect(rect, radius, radius);
        painter.setPen(PanelTheme::inkOn(ground));
        const QRect inside = rect.adjusted(12, 2, -12, -2);
        constexpr int flags = Qt::AlignCenter | Qt::TextWordWrap;
        // On a narrow panel the words are smaller rather than cut off.
        for (int size = 16; size >= 10; --size) {
            font.setPixelSize(size);
            painter.setFont(font);
            if (painter.boundingRect(inside, flags, text).height() <= inside.height()) break;
        }
        painter.drawText(inside, flags, text);
    };
    if (!m_state.isEmpty()) {
        // Values of a controller that does not run lie under a veil: they are not fresh.
        QColor veil = m_look.theme.color("background");
        veil.setAlphaF(m_weight == StateWeight::Notice ? 0.0f : 0.45f);
        painter.fillRect(rect().adjusted(0, stateRect().height(), 0, 0), veil);
        strip(stateRect(),
              m_look.theme.color(m_weight == StateWeight::Bad      ? "alarm"
                                 : m_weight == StateWeight::Notice ? "warning"
                                                                   : "faint"),
              m_state, 0);
    }
    if (!m_refusal.isEmpty()) strip(refusalRect(), m_look.theme.color("warning"), m_refusal, 8);
}

} // namespace plc::hmi
