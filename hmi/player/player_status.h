// The strips over a playing panel: what state the controller is in, and why a write was refused. Owned by the player.
#pragma once
#include "hmi/player/keypad.h"
#include "hmi/station/operator_station.h"

#include <QWidget>

namespace plc::hmi {

class PlayerStatus final : public QWidget {
    Q_OBJECT
public:
    explicit PlayerStatus(QWidget* parent);
    /// An empty text hides the strip.
    void setState(const OverlayLook& look, const QString& text, StateWeight weight);
    void setRefusal(const OverlayLook& look, const QString& text);
    QString stateText() const { return m_state; }
    /// Pixels that the strip takes from the panel's top; 0 when there is none.
    int stripHeight() const { return m_state.isEmpty() ? 0 : stateRect().height(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRect stateRect() const;
    QRect refusalRect() const;
    OverlayLook m_look;
    QString m_state, m_refusal;
    StateWeight m_weight = StateWeight::Quiet;
};

} // namespace plc::hmi
