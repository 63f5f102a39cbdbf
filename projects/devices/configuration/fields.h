// Reads the fields of one JSON object and notes what is wrong with each, and which are not known. Used while
// devices.json is read; one thread.
#pragma once
#include "projects/devices/configuration/device.h"
#include "projects/devices/configuration/finding.h"

#include <map>
#include <nlohmann/json.hpp>
#include <span>

namespace plc::devices {

class Fields {
public:
    using Json = nlohmann::ordered_json;
    using Lines = std::map<std::string, int>;
    struct Place {
        std::string path; // "/devices/0"
        std::string device, channel;
    };
    Fields(const Json& object, Place place, const Lines& lines, std::vector<Finding>& findings)
        : m_object(object), m_place(std::move(place)), m_lines(lines), m_findings(findings) {}

    void text(const char* key, std::string& into, bool isNeeded = false);
    void flag(const char* key, bool& into);
    void real(const char* key, double& into);
    void real(const char* key, std::optional<double>& into);
    template <class Number>
    void whole(const char* key, Number& into, int64_t low, int64_t high, bool isNeeded = false) {
        if (const auto number = wholeOf(key, low, high, isNeeded)) into = static_cast<Number>(*number);
    }
    void duration(const char* key, Milliseconds& into, int64_t least);
    template <class Word> bool word(const char* key, Word& into, std::span<const std::pair<Word, const char*>> words);
    [[nodiscard]] bool has(const char* key) const { return m_object.contains(key); }
    void known(const char* key) { m_known.emplace_back(key); }
    void reportUnknown();
    void report(Message message, std::string_view key = {}, bool isError = true);
    void needed(const char* key);

private:
    [[nodiscard]] const Json* find(const char* key);
    [[nodiscard]] std::optional<int64_t> wholeOf(const char* key, int64_t low, int64_t high, bool isNeeded);
    [[nodiscard]] int wordOf(const char* key, std::span<const char* const> spellings);
    const Json& m_object;
    Place m_place;
    const Lines& m_lines;
    std::vector<Finding>& m_findings;
    std::vector<std::string> m_known;
};

template <class Word>
bool Fields::word(const char* key, Word& into, std::span<const std::pair<Word, const char*>> words) {
    std::vector<const char*> spellings;
    for (const auto& each : words) spellings.push_back(each.second);
    const int index = wordOf(key, spellings);
    if (index >= 0) into = words[static_cast<size_t>(index)].first;
    return index >= 0;
}

} // namespace plc::devices
