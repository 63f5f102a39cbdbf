// What a scan computed, and why, as JSON and as text (D13). Functions.
#pragma once
#include "runtime/inside/why.h"

#include <string>

namespace plc::cli {

[[nodiscard]] std::string toJson(const inside::Writer& writer);
[[nodiscard]] std::string toJson(const inside::Explanation& answer);
[[nodiscard]] std::string toJson(const inside::WhyNot& answer);
/// Every statement of the scan with the values it used and wrote.
[[nodiscard]] std::string insideText(const inside::Look& look);
[[nodiscard]] std::string insideJson(const inside::Look& look);

/// "1.5s" or a scan's number → its position in the recording.
[[nodiscard]] Result<history::Position> positionOf(const history::History& history, const std::string& text);
/// Rebuilds the program of a recording; `failure` says why it could not.
[[nodiscard]] Result<std::unique_ptr<history::History>> openRecording(const std::string& path);

} // namespace plc::cli
