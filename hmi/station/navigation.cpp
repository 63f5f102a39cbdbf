#include "hmi/station/navigation.h"

#include <algorithm>

namespace plc::hmi {

namespace {
constexpr size_t kLongestWay = 64, kMostPopUps = 8;
}

void Navigation::start(const PanelPlace& home) {
    m_home = home;
    m_back.clear();
    closeAll();
    m_current = home;
    emit panelChanged();
}

bool Navigation::open(const PanelPlace& place) {
    if (!exists(place.panel)) return false;
    closeAll();
    if (place == m_current) return true;
    if (!m_current.panel.isEmpty()) m_back.push_back(m_current);
    if (m_back.size() > kLongestWay) m_back.erase(m_back.begin());
    m_current = place;
    emit panelChanged();
    return true;
}

bool Navigation::back() {
    if (closePopUp()) return true;
    // A panel may have been deleted meanwhile.
    while (!m_back.empty() && !exists(m_back.back().panel)) m_back.pop_back();
    if (m_back.empty()) return false;
    m_current = m_back.back();
    m_back.pop_back();
    emit panelChanged();
    return true;
}

bool Navigation::popUp(const PanelPlace& place) {
    if (!exists(place.panel) || m_popUps.size() >= kMostPopUps) return false;
    if (std::find(m_popUps.begin(), m_popUps.end(), place) != m_popUps.end()) return true; // it is open
    m_popUps.push_back(place);
    emit popUpsChanged();
    return true;
}

bool Navigation::closePopUp() {
    if (m_popUps.empty()) return false;
    m_popUps.pop_back();
    emit popUpsChanged();
    return true;
}

void Navigation::closeAll() {
    if (m_popUps.empty()) return;
    m_popUps.clear();
    emit popUpsChanged();
}

bool Navigation::perform(const NavigationRequest& request) {
    const PanelPlace place{request.panel, request.arguments};
    switch (request.kind) {
    case NavigationKind::Open:
        return open(place);
    case NavigationKind::PopUp:
        return popUp(place);
    case NavigationKind::Close:
        return closePopUp();
    case NavigationKind::Back:
        return back();
    case NavigationKind::Home:
        return home();
    }
    return false;
}

} // namespace plc::hmi
