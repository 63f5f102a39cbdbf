// Namespaces, which PLCopen XML does not have: their units come out under their own names where no other name is the
// same. Function, any thread.
#pragma once
#include "projects/exchange/base/report.h"
#include "runtime/compiler/driver/driver.h"

namespace plc::exchange {

/// The sources without NAMESPACE and USING, names without the path before them. A namespace with a name that is
/// declared elsewhere as well stays, and is reported; so do texts with errors of syntax.
[[nodiscard]] std::vector<driver::SourceFile> withoutNamespaces(const std::vector<driver::SourceFile>& sources,
                                                                Report& report);

} // namespace plc::exchange
