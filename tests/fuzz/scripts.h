// Inputs that are scripts: a line "> {…}" is a message, "? name" waits for something, other lines are not read. A
// change is mostly one of a message as JSON, or of the script as a list of messages: a change of bytes seldom leaves
// one that is read.
#pragma once
#include "tests/support/damage.h"

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace plc::fuzz {

using plc::testing::Damage;

inline std::vector<std::string> linesOf(const std::string& script) {
    std::vector<std::string> out;
    std::istringstream text(script);
    for (std::string line; std::getline(text, line);)
        if (line.starts_with("> ") || line.starts_with("? ")) out.push_back(std::move(line));
    return out;
}

/// Lines of scripts tried before, which others borrow.
class Lent {
public:
    [[nodiscard]] const std::string& any(Damage& damage) const { return m_lines[damage.pick(m_count)]; }
    void keep(const std::string& line, Damage& damage) {
        const size_t at = m_count < m_lines.size() ? m_count++ : damage.pick(m_lines.size());
        m_lines[at] = line;
    }

private:
    std::array<std::string, 256> m_lines;
    size_t m_count = 0;
};

inline std::string changedMessage(const std::string& line, const Lent& lent, Damage& damage) {
    const auto message = Damage::readable(std::string_view(line).substr(2));
    if (!line.starts_with("> ") || !message) return "> " + damage.text(line.substr(2));
    const auto donor = Damage::readable(std::string_view(lent.any(damage)).substr(2));
    return "> " + damage.json(*message, donor ? *donor : *message)
                      .dump(-1, ' ', false, Damage::Json::error_handler_t::replace);
}

/// One to three changes; empty where the script has no line that is read. `lent` is of the scripts changed before.
inline std::string changedScript(const std::string& script, Lent& lent, Damage& damage) {
    std::vector<std::string> lines = linesOf(script);
    if (lines.empty()) return {};
    lent.keep(lines[damage.pick(lines.size())], damage);
    const auto at = [&](size_t index) { return lines.begin() + static_cast<std::ptrdiff_t>(index); };
    for (size_t i = 1 + damage.pick(3); i > 0 && !lines.empty(); --i) {
        const size_t chosen = damage.pick(lines.size());
        switch (damage.pick(8)) {
        case 0:
            lines.erase(at(chosen));
            break;
        case 1: // a message of another script
        case 2:
            lines.insert(at(damage.pick(lines.size() + 1)), lent.any(damage));
            break;
        case 3:
            std::swap(lines[chosen], lines[damage.pick(lines.size())]);
            break;
        default:
            lines[chosen] = changedMessage(lines[chosen], lent, damage);
        }
    }
    std::string changed;
    for (const std::string& line : lines) changed += line + "\n";
    return changed;
}

} // namespace plc::fuzz
