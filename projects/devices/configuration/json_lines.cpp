#include "projects/devices/configuration/json_lines.h"

#include <vector>

namespace plc::devices {

namespace {

class LineReader {
public:
    explicit LineReader(std::string_view text) : m_text(text) {}
    std::map<std::string, int> read() {
        for (; m_at < m_text.size(); ++m_at) step(m_text[m_at]);
        return std::move(m_lines);
    }

private:
    struct Level {
        bool isList = false;
        size_t index = 0;
        std::string path, key;
    };

    [[nodiscard]] std::string pathHere() const {
        if (m_levels.empty()) return {};
        const Level& level = m_levels.back();
        return level.path + "/" + (level.isList ? std::to_string(level.index) : level.key);
    }
    void step(char c) {
        switch (c) {
        case '\n':
            ++m_line;
            return;
        case '{':
        case '[':
            open(c == '[');
            return;
        case '}':
        case ']':
            if (!m_levels.empty()) m_levels.pop_back();
            return;
        case ',':
            next();
            return;
        case '"':
            text();
            return;
        default:
            if (c > ' ' && c != ':') note();
        }
    }
    void open(bool isList) {
        note();
        m_levels.push_back({isList, 0, m_levels.empty() ? std::string() : pathHere(), {}});
        m_wantsKey = !isList;
    }
    void next() {
        if (m_levels.empty()) return;
        if (m_levels.back().isList)
            ++m_levels.back().index;
        else
            m_wantsKey = true;
    }
    void text() {
        const size_t first = ++m_at;
        while (m_at < m_text.size() && m_text[m_at] != '"') m_at += m_text[m_at] == '\\' ? 2 : 1;
        const bool isKey = !m_levels.empty() && !m_levels.back().isList && m_wantsKey;
        if (isKey) {
            m_levels.back().key = std::string(m_text.substr(first, std::min(m_at, m_text.size()) - first));
            m_wantsKey = false;
        }
        note();
    }
    void note() { m_lines.emplace(pathHere(), m_line); }

    std::string_view m_text;
    size_t m_at = 0;
    int m_line = 1;
    bool m_wantsKey = false;
    std::vector<Level> m_levels;
    std::map<std::string, int> m_lines;
};

} // namespace

std::map<std::string, int> linesOfJson(std::string_view text) { return LineReader(text).read(); }

} // namespace plc::devices
