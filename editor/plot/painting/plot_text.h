// The translation context of everything a plot says. No state, GUI thread.
#pragma once

#include <QCoreApplication>

namespace plc::plot {

struct PlotText {
    Q_DECLARE_TR_FUNCTIONS(PlotText)
};

} // namespace plc::plot
