// A text as the content or attribute of XML or HTML: reports, pictures, JUnit. A pure function, any thread.
#pragma once
#include <string>
#include <string_view>

namespace plc {

/// Escapes < > & and ", and leaves out the control characters that XML 1.0 has no way to write.
[[nodiscard]] std::string xmlText(std::string_view text);

} // namespace plc
