// Places of a text as editors name them: lines from 0 and UTF-16 units from 0, against byte offsets; and files as URIs.
// Immutable values and functions, any thread.
#pragma once
#include "projects/protocol/json_rpc.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plc::lsp {

using protocol::Json;

struct Position {
    uint32_t line = 0, character = 0;
    bool operator==(const Position&) const = default;
};

/// The lines of one text; it keeps the text alive.
class Places {
public:
    explicit Places(std::string text);
    [[nodiscard]] const std::string& text() const { return m_text; }
    [[nodiscard]] Position positionOf(uint32_t offset) const;
    /// A place behind the line is its end, a line behind the last the text's end; never inside a character.
    [[nodiscard]] uint32_t offsetOf(Position position) const;
    [[nodiscard]] uint32_t lineCount() const { return static_cast<uint32_t>(m_begins.size()); }
    [[nodiscard]] Json range(uint32_t begin, uint32_t end) const;

private:
    [[nodiscard]] uint32_t endOf(uint32_t line) const; // before its line end
    std::string m_text;
    std::vector<uint32_t> m_begins;
};

[[nodiscard]] Json toJson(Position position);
[[nodiscard]] std::optional<Position> positionAt(const Json& json, std::string_view path);

/// "file:///a%20b/main.st" → "/a b/main.st", normalised; other schemes: nothing.
[[nodiscard]] std::optional<std::string> pathOfUri(std::string_view uri);
[[nodiscard]] std::string uriOfPath(std::string_view path);

} // namespace plc::lsp
