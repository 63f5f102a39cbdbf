// Values as a user types them: "TRUE", "5", "T#1s", "Red", "'text'". Functions, any thread.
#pragma once
#include "runtime/compiler/driver/driver.h"

#include <string>

namespace plc::session {

/// For a variable of `type`; the error names `path` and says what is wrong (not a value of the type, out of its range).
[[nodiscard]] Result<types::Value> parseValue(const driver::Checked& checked, types::TypeId type,
                                              const std::string& text, const std::string& path);

} // namespace plc::session
