#include "hmi/player/pop_up.h"

#include "hmi/model/property_literals.h"
#include "hmi/view/panel_keys.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace plc::hmi {

PopUp::PopUp(const OverlayLook& look, const PanelPlace& place, QWidget* parent)
    : Overlay(look, parent), m_place(place), m_title(new QLabel), m_view(new PanelView) {
    new PanelKeys(*m_view);
    auto* layout = new QVBoxLayout(m_box);
    layout->setContentsMargins(8, 8, 8, 8);
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    QPushButton* close = key(QStringLiteral("✕"));
    close->setObjectName(QStringLiteral("close"));
    close->setAccessibleName(words(SystemText::Close));
    connect(close, &QPushButton::clicked, this, &Overlay::cancelled);
    head->addWidget(close);
    layout->addLayout(head);
    layout->addWidget(m_view, 1);
}

void PopUp::end() {
    if (std::exchange(m_isClosing, true)) return;
    if (scene().pressedView()) scene().release(QPointF(-1e6, -1e6)); // what is down must come up
    scene().setValues(nullptr);
    hide();
    deleteLater();
}

void PopUp::showPanel(const Panel& panel) {
    m_view->scene().setPanel(panel);
    m_title->setText(m_look.texts->text(panel.text("title"_text), m_look.tag));
    const QSizeF room = QSizeF(size()) - QSizeF(40, 100), own = panel.size();
    const double scale = std::min({1.0, room.width() / own.width(), room.height() / own.height()});
    m_view->setFixedSize((own * std::max(0.1, scale)).toSize());
    Overlay::place();
}

} // namespace plc::hmi
