#include "projects/devices/configuration/wire.h"

#include "runtime/base/read_json.h"
#include "runtime/base/text.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

namespace plc::devices {

namespace {

using Json = nlohmann::ordered_json;

constexpr unsigned kMostRegisters = 4;

bool swapsWords(Order order) { return order == Order::Cdab || order == Order::Dcba; }
bool swapsBytes(Order order) { return order == Order::Badc || order == Order::Dcba; }
uint16_t swapped(uint16_t word) { return static_cast<uint16_t>(word << 8 | word >> 8); }

uint64_t bitsOf(const Channel& channel, std::span<const uint16_t> registers) {
    const unsigned count = channel.registers();
    uint64_t bits = 0;
    for (unsigned i = 0; i < count; ++i) {
        const uint16_t word = registers[swapsWords(channel.order) ? count - 1 - i : i];
        bits = bits << 16 | (swapsBytes(channel.order) ? swapped(word) : word);
    }
    return bits;
}

void putBits(const Channel& channel, uint64_t bits, std::span<uint16_t> registers) {
    const unsigned count = channel.registers();
    for (unsigned i = count; i-- > 0; bits >>= 16) {
        const auto word = static_cast<uint16_t>(bits);
        registers[swapsWords(channel.order) ? count - 1 - i : i] = swapsBytes(channel.order) ? swapped(word) : word;
    }
}

bool isScaled(const Channel& channel) { return channel.scale != 1 || channel.offset != 0; }

Sample scaled(const Channel& channel, Sample sample) {
    if (!isScaled(channel) || !sample.isNumber()) return sample;
    return Sample::of(sample.number() * channel.scale + channel.offset);
}

Sample unscaled(const Channel& channel, const Sample& sample) {
    if (!isScaled(channel) || !sample.isNumber()) return sample;
    return Sample::of((sample.number() - channel.offset) / channel.scale);
}

Sample numberOf(const Channel& channel, uint64_t bits) {
    switch (channel.type) {
    case WireType::Bool:
        return Sample::of(static_cast<int64_t>(bits >> (channel.bit > 0 ? channel.bit : 0) & 1));
    case WireType::Int:
        return Sample::of(static_cast<int64_t>(static_cast<int16_t>(bits)));
    case WireType::Dint:
        return Sample::of(static_cast<int64_t>(static_cast<int32_t>(bits)));
    case WireType::Lint:
        return Sample::of(static_cast<int64_t>(bits));
    case WireType::Uint:
    case WireType::Udint:
    case WireType::Ulint:
        return Sample::ofUnsigned(bits);
    case WireType::Real:
        return Sample::of(static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(bits))));
    case WireType::Lreal:
        return Sample::of(std::bit_cast<double>(bits));
    case WireType::Text:
        break;
    }
    return {};
}

/// The whole number of a sample within [-2^63, 2^64); none outside, and of NaN.
std::optional<std::pair<int64_t, bool>> wholeOf(const Sample& sample) {
    if (sample.kind == Sample::Kind::Integer) return std::pair(sample.integer, false);
    if (sample.kind == Sample::Kind::Unsigned) return std::pair(sample.integer, sample.integer < 0);
    const double whole = std::nearbyint(sample.real);
    if (!(whole >= -9223372036854775808.0 && whole < 18446744073709551616.0)) return std::nullopt;
    if (whole < 9223372036854775808.0) return std::pair(static_cast<int64_t>(whole), false);
    return std::pair(static_cast<int64_t>(static_cast<uint64_t>(whole)), true);
}

std::optional<uint64_t> wireBits(const Channel& channel, const Sample& sample) {
    if (channel.type == WireType::Real) {
        const auto single = static_cast<float>(sample.number());
        if (std::isinf(single) && !std::isinf(sample.number())) return std::nullopt;
        return std::bit_cast<uint32_t>(single);
    }
    if (channel.type == WireType::Lreal) return std::bit_cast<uint64_t>(sample.number());
    const auto whole = wholeOf(sample);
    if (!whole) return std::nullopt;
    const auto [number, isAbove] = *whole;
    const bool isUnsigned =
        channel.type == WireType::Uint || channel.type == WireType::Udint || channel.type == WireType::Ulint;
    const unsigned bits = channel.registers() * 16;
    if (isAbove && !(isUnsigned && bits == 64)) return std::nullopt;
    if (isUnsigned && !isAbove && number < 0) return std::nullopt;
    if (bits < 64) {
        const int64_t high = (int64_t(1) << (isUnsigned ? bits : bits - 1)) - 1;
        if (number > high || number < -(int64_t(1) << (bits - 1))) return std::nullopt;
    }
    return static_cast<uint64_t>(number);
}

} // namespace

Sample fromRegisters(const Channel& channel, std::span<const uint16_t> registers) {
    const unsigned count = channel.registers();
    if (count == 0 || count > kMostRegisters || registers.size() < count) return {};
    if (isBitTable(channel.table)) return Sample::of(static_cast<int64_t>(registers[0] != 0));
    return scaled(channel, numberOf(channel, bitsOf(channel, registers)));
}

bool toRegisters(const Channel& channel, const Sample& sample, std::span<uint16_t> registers) {
    const unsigned count = channel.registers();
    if (count == 0 || count > kMostRegisters || registers.size() < count || !sample.isNumber()) return false;
    if (isBitTable(channel.table)) {
        registers[0] = sample.number() != 0 ? 1 : 0;
        return true;
    }
    if (channel.type == WireType::Bool) {
        uint64_t bits = bitsOf(channel, registers);
        const uint64_t mask = uint64_t(1) << (channel.bit > 0 ? channel.bit : 0);
        bits = sample.number() != 0 ? bits | mask : bits & ~mask;
        putBits(channel, bits, registers);
        return true;
    }
    const auto bits = wireBits(channel, unscaled(channel, sample));
    if (!bits) return false;
    putBits(channel, *bits, registers);
    return true;
}

// ---------------------------------------------------------------- messages

namespace {

std::string unescaped(std::string_view part) {
    std::string out;
    for (size_t i = 0; i < part.size(); ++i) {
        if (part[i] == '~' && i + 1 < part.size()) {
            out += part[++i] == '1' ? '/' : '~';
            continue;
        }
        out += part[i];
    }
    return out;
}

std::vector<std::string> partsOf(std::string_view path) {
    std::vector<std::string> parts;
    while (!path.empty()) {
        path.remove_prefix(1);
        const size_t end = std::min(path.find('/'), path.size());
        parts.push_back(unescaped(path.substr(0, end)));
        path.remove_prefix(end);
    }
    return parts;
}

const Json* valueAt(const Json& json, std::string_view path) {
    const Json* at = &json;
    for (const std::string& part : partsOf(path)) {
        if (at->is_object()) {
            const auto it = at->find(part);
            if (it == at->end()) return nullptr;
            at = &*it;
        } else if (at->is_array()) {
            size_t index = 0;
            const auto [end, problem] = std::from_chars(part.data(), part.data() + part.size(), index);
            if (problem != std::errc() || end != part.data() + part.size() || index >= at->size()) return nullptr;
            at = &(*at)[index];
        } else {
            return nullptr;
        }
    }
    return at;
}

Sample textSample(std::string_view utf8) {
    return firstInvalidUtf8(utf8) ? Sample() : Sample::ofText(std::string(utf8));
}

Sample fromPlain(const Channel& channel, std::string_view text) {
    if (channel.type == WireType::Text) return textSample(text);
    while (!text.empty() && static_cast<unsigned char>(text.front()) <= ' ') text.remove_prefix(1);
    while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.remove_suffix(1);
    for (const char* word : {"true", "on"})
        if (equalsIgnoringCase(text, word)) return Sample::of(int64_t(1));
    for (const char* word : {"false", "off"})
        if (equalsIgnoringCase(text, word)) return Sample::of(int64_t(0));
    if (text.starts_with('+')) text.remove_prefix(1);
    int64_t whole = 0;
    const char* last = text.data() + text.size();
    if (const auto [end, problem] = std::from_chars(text.data(), last, whole);
        problem == std::errc() && end == last && !text.empty())
        return Sample::of(whole);
    uint64_t large = 0;
    if (const auto [end, problem] = std::from_chars(text.data(), last, large);
        problem == std::errc() && end == last && !text.empty())
        return Sample::ofUnsigned(large);
    double real = 0;
    if (const auto [end, problem] = std::from_chars(text.data(), last, real);
        problem == std::errc() && end == last && !text.empty() && std::isfinite(real))
        return Sample::of(real);
    return {};
}

Sample fromJson(const Channel& channel, const Json& value) {
    if (channel.type == WireType::Text)
        return textSample(value.is_string() ? value.get<std::string>()
                                            : value.dump(-1, ' ', false, Json::error_handler_t::replace));
    if (value.is_boolean()) return Sample::of(static_cast<int64_t>(value.get<bool>()));
    if (value.is_number_unsigned()) return Sample::ofUnsigned(value.get<uint64_t>());
    if (value.is_number_integer()) return Sample::of(value.get<int64_t>());
    if (value.is_number()) return Sample::of(value.get<double>());
    return value.is_string() ? fromPlain(channel, value.get<std::string>()) : Sample();
}

Json jsonOf(const Channel& channel, const Sample& sample) {
    switch (sample.kind) {
    case Sample::Kind::None:
        return nullptr;
    case Sample::Kind::Integer:
        return channel.type == WireType::Bool ? Json(sample.integer != 0) : Json(sample.integer);
    case Sample::Kind::Unsigned:
        return static_cast<uint64_t>(sample.integer);
    case Sample::Kind::Real:
        return std::isfinite(sample.real) ? Json(sample.real) : Json(nullptr);
    case Sample::Kind::Text:
        return sample.text;
    }
    return nullptr;
}

} // namespace

bool isJsonPath(std::string_view path) { return path.empty() || path.front() == '/'; }

Sample fromMessage(const Channel& channel, std::string_view payload) {
    if (channel.jsonPath.empty()) return scaled(channel, fromPlain(channel, payload));
    const JsonText<Json> json = readJson<Json>(payload);
    const Json* value = json.isGood() ? valueAt(json.value, channel.jsonPath) : nullptr;
    return value ? scaled(channel, fromJson(channel, *value)) : Sample();
}

std::string toMessage(std::span<const Channel* const> channels, std::span<const Sample* const> samples) {
    Json message = Json::object();
    for (size_t i = 0; i < channels.size(); ++i) {
        const Json value = jsonOf(*channels[i], unscaled(*channels[i], *samples[i]));
        if (channels[i]->jsonPath.empty())
            return value.is_string() ? value.get<std::string>()
                                     : value.dump(-1, ' ', false, Json::error_handler_t::replace);
        Json* at = &message;
        for (const std::string& part : partsOf(channels[i]->jsonPath)) {
            if (!at->is_object()) *at = Json::object();
            at = &(*at)[part];
        }
        *at = value;
    }
    return message.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace plc::devices
