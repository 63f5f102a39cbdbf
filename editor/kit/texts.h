// Texts of the compiler for widgets. Any thread.
#pragma once
#include <QString>

#include <string_view>

namespace plc::kit {

/// UTF-8 as the compiler keeps it.
[[nodiscard]] inline QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace plc::kit
