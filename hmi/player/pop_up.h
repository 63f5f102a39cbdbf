// A panel in a box over the player: a dialog with parameters. A press beside it, or its close button, closes it. Owned
// by the player; main thread.
#pragma once
#include "hmi/player/keypad.h"
#include "hmi/station/navigation.h"
#include "hmi/view/panel_view.h"

class QLabel;

namespace plc::hmi {

class PopUp final : public Overlay {
    Q_OBJECT
public:
    PopUp(const OverlayLook& look, const PanelPlace& place, QWidget* parent);
    const PanelPlace& panelPlace() const { return m_place; }
    PanelScene& scene() { return m_view->scene(); }
    PanelView& view() { return *m_view; }
    /// It goes as soon as what is under way has returned.
    void end();
    bool isClosing() const { return m_isClosing; }
    /// The panel in its size, or as large as fits.
    void showPanel(const Panel& panel);

private:
    PanelPlace m_place;
    QLabel* m_title;
    PanelView* m_view;
    bool m_isClosing = false;
};

} // namespace plc::hmi
