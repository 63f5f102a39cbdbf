// Where the operator is among the panels: the panel shown, the way back, the pop-ups over it. It knows no widget, so
// the studio's player and a browser's session each own one. Main thread.
#pragma once
#include "hmi/model/faceplate.h"
#include "hmi/view/scene/requests.h"

#include <QObject>

namespace plc::hmi {

/// A panel and what its parameters stand for.
struct PanelPlace {
    QString panel;
    Arguments arguments;
    bool operator==(const PanelPlace&) const = default;
};

class Navigation final : public QObject {
    Q_OBJECT
public:
    explicit Navigation(PanelLookup panels, QObject* parent = nullptr) : QObject(parent), m_panels(std::move(panels)) {}

    /// The panel to begin with, and to which `home` leads; the way back is forgotten.
    void start(const PanelPlace& home);
    /// False: there is no such panel, or nothing to go back to.
    bool open(const PanelPlace& place);
    bool back();
    bool home() { return !m_home.panel.isEmpty() && open(m_home); }
    bool popUp(const PanelPlace& place);
    bool closePopUp();
    bool perform(const NavigationRequest& request);

    const PanelPlace& current() const { return m_current; }
    const std::vector<PanelPlace>& popUps() const { return m_popUps; }
    bool canGoBack() const { return !m_back.empty(); }

signals:
    void panelChanged();
    void popUpsChanged();

private:
    bool exists(const QString& panel) const { return m_panels && m_panels(panel); }
    void closeAll();

    PanelLookup m_panels;
    PanelPlace m_home, m_current;
    std::vector<PanelPlace> m_back, m_popUps;
};

} // namespace plc::hmi
