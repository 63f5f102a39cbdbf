// A moment as labels of the studio write it, with the decimal sign of its language; plots and tables keep the point of
// the values beside. Function, GUI thread.
#pragma once
#include "editor/plot/plot_scale.h"

#include <QLocale>

namespace plc::plot {

[[nodiscard]] inline QString momentLabel(int64_t nanoseconds) {
    return momentText(nanoseconds).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

} // namespace plc::plot
