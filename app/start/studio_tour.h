// The stops of the tour through the studio, about the project that is open. GUI thread.
#pragma once
#include "app/start/tour.h"

#include <QString>

namespace plc::app {

/// What the tour is about, and how it reaches the parts of the window.
struct TouredStudio {
    QString summary, project; // the first sentences of the README, if any; the project's name
    bool hasPanel = false;
    QWidget* documents = nullptr;
    std::function<QWidget*(const char*)> dock, toolBar; // by name
    std::function<void(const char*)> showDock;
    std::function<void()> run, fillWatch;
};
[[nodiscard]] std::vector<TourStop> studioTour(const TouredStudio& studio);

} // namespace plc::app
