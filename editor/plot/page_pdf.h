// A page of HTML with SVG charts in it, as `tune --report` makes one, as a PDF file on A4. Needs a QApplication; its
// thread.
#pragma once
#include "runtime/base/result.h"

#include <string>

namespace plc::plot {

Result<void> exportPage(const std::string& html, const std::string& title, const std::string& path);

} // namespace plc::plot
