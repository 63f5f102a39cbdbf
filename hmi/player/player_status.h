// The strips over a playing panel: what state the controller is in, and why a write was refused. Owned by the player.
#pragma once
#include "hmi/player/keypad.h"

#include <QWidget>

namespace plc::hmi {

class PlayerStatus final : public QWidget {
    Q_OBJECT
public:
    explicit PlayerStatus(QWidget* parent);
    /// An empty text hides the strip. `isBad`: the values are those of a controller that does not run.
    void setState(const OverlayLook& look, const QString& text, bool isBad);
    void setRefusal(const OverlayLook& look, const QString& text);
    QString stateText() const { return m_state; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRect stateRect() const;
    QRect refusalRect() const;
    OverlayLook m_look;
    QString m_state, m_refusal;
    bool m_isBad = false;
};

} // namespace plc::hmi
