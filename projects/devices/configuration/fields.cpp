#include "projects/devices/configuration/fields.h"

#include "projects/devices/configuration/errors.h"
#include "runtime/base/text.h"
#include "runtime/types/value.h"

#include <cmath>

namespace plc::devices {

namespace {
constexpr int64_t kHour = 3'600'000;
} // namespace

void Fields::report(Message message, std::string_view key, bool isError) {
    auto line = m_lines.find(key.empty() ? m_place.path : m_place.path + "/" + std::string(key));
    if (line == m_lines.end()) line = m_lines.find(m_place.path);
    m_findings.push_back(
        {isError, std::move(message), line == m_lines.end() ? 0 : line->second, m_place.device, m_place.channel});
}

const Fields::Json* Fields::find(const char* key) {
    m_known.emplace_back(key);
    const auto it = m_object.find(key);
    return it == m_object.end() ? nullptr : &*it;
}

void Fields::needed(const char* key) { report(errors::FieldMissing(Verbatim(key))); }

void Fields::text(const char* key, std::string& into, bool isNeeded) {
    const Json* value = find(key);
    if (!value) {
        if (isNeeded) needed(key);
    } else if (!value->is_string()) {
        report(errors::NotText(Verbatim(key)), key);
    } else {
        into = value->get<std::string>();
        if (isNeeded && into.empty()) needed(key);
    }
}

void Fields::flag(const char* key, bool& into) {
    const Json* value = find(key);
    if (!value) return;
    if (value->is_boolean())
        into = value->get<bool>();
    else
        report(errors::NotTrueOrFalse(Verbatim(key)), key);
}

void Fields::real(const char* key, double& into) {
    std::optional<double> number;
    real(key, number);
    if (number) into = *number;
}

void Fields::real(const char* key, std::optional<double>& into) {
    const Json* value = find(key);
    if (!value) return;
    if (value->is_number() && std::isfinite(value->get<double>()))
        into = value->get<double>();
    else if (value->is_boolean())
        into = value->get<bool>() ? 1 : 0;
    else
        report(errors::NotNumber(Verbatim(key)), key);
}

std::optional<int64_t> Fields::wholeOf(const char* key, int64_t low, int64_t high, bool isNeeded) {
    const Json* value = find(key);
    if (!value) {
        if (isNeeded) needed(key);
        return std::nullopt;
    }
    const double number = value->is_number() ? value->get<double>() : std::nan("");
    if (number >= static_cast<double>(low) && number <= static_cast<double>(high) && number == std::floor(number))
        return static_cast<int64_t>(number);
    report(errors::OutOfRange(Verbatim(key), low, high), key);
    return std::nullopt;
}

void Fields::duration(const char* key, Milliseconds& into, int64_t least) {
    const Json* value = find(key);
    if (!value) return;
    const auto time = value->is_string() ? types::parseDuration(value->get<std::string>()) : std::nullopt;
    const int64_t milliseconds = time ? *time / 1'000'000 : -1;
    if (milliseconds < least || milliseconds > kHour)
        report(errors::NotDuration(Verbatim(key), least), key);
    else
        into = Milliseconds(milliseconds);
}

int Fields::wordOf(const char* key, std::span<const char* const> spellings) {
    const Json* value = find(key);
    if (!value) return -1;
    if (!value->is_string()) {
        report(errors::NotText(Verbatim(key)), key);
        return -1;
    }
    const std::string wanted = value->get<std::string>();
    for (size_t i = 0; i < spellings.size(); ++i)
        if (equalsIgnoringCase(wanted, spellings[i])) return static_cast<int>(i);
    report(errors::NotAWord(Verbatim(key), wanted, std::vector<std::string>(spellings.begin(), spellings.end())), key);
    return -1;
}

void Fields::reportUnknown() {
    for (const auto& [key, value] : m_object.items()) {
        if (std::find(m_known.begin(), m_known.end(), key) != m_known.end()) continue;
        const auto near = nearestName(key, m_known);
        report(near ? errors::UnknownFieldSuggest(key, *near) : errors::UnknownField(key), key, false);
    }
}

} // namespace plc::devices
