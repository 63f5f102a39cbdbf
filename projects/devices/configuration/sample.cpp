#include "projects/devices/configuration/sample.h"

#include "projects/devices/configuration/errors.h"
#include "runtime/base/text.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace plc::devices {

using types::Family;
using types::TypeKind;

double Sample::number() const {
    switch (kind) {
    case Kind::Integer:
        return static_cast<double>(integer);
    case Kind::Unsigned:
        return static_cast<double>(static_cast<uint64_t>(integer));
    case Kind::Real:
        return real;
    case Kind::None:
    case Kind::Text:
        return 0;
    }
    return 0;
}

std::string Sample::shown() const {
    switch (kind) {
    case Kind::None:
        return {};
    case Kind::Integer:
        return std::to_string(integer);
    case Kind::Unsigned:
        return std::to_string(static_cast<uint64_t>(integer));
    case Kind::Real:
        return shortestReal(real);
    case Kind::Text:
        return text;
    }
    return {};
}

namespace {

/// An address is typed by its size; the variable declared there knows better.
image::Place locatedAt(const image::Layout& layout, const image::Place& place) {
    const types::TypeTable& types = *layout.types;
    for (const image::Root& root : layout.roots)
        if (!root.address.empty() && root.offset == place.offset && root.bit == place.bit &&
            types[root.type].size == types[place.type].size && !types.isAggregate(root.type))
            return {root.type, root.offset, root.bit};
    return place;
}

bool isCarried(Family family) {
    return family == Family::Bool || types::isInteger(family) || family == Family::Real || family == Family::Duration;
}

} // namespace

Result<Target> resolve(const image::Layout& layout, const std::string& path, WireType wire) {
    Result<image::Place> found = layout.find(path);
    if (!found) return found.error();
    const types::TypeTable& types = *layout.types;
    Target target;
    target.place = path.starts_with('%') ? locatedAt(layout, *found) : *found;
    const types::Type& type = types[target.place.type];
    target.kind = types.storageKind(target.place.type);
    target.family = types.family(target.place.type);
    target.size = target.place.bit >= 0 ? 1 : type.size;
    target.typeName = type.name;
    if (type.kind == TypeKind::String) target.capacity = type.capacity;
    target.strings = types.strings;
    if (type.kind == TypeKind::Subrange) target.range = {type.low, type.high};
    target.takesRealBits = target.family == Family::Bits && ((wire == WireType::Real && target.size == 4) ||
                                                             (wire == WireType::Lreal && target.size == 8));
    if (!isCarried(target.family) && type.kind != TypeKind::String)
        return Error{errors::WrongType(path, type.name, spelling(wire)), path};
    return target;
}

bool canCarry(const Channel& channel, const Target& target) {
    if ((channel.type == WireType::Text) != (target.kind == TypeKind::String)) return false;
    return (channel.type == WireType::Bool) == (target.family == Family::Bool) || channel.type == WireType::Text;
}

namespace {

struct Span {
    double low, high;
};

Span spanOf(WireType type) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    switch (type) {
    case WireType::Bool:
        return {0, 1};
    case WireType::Int:
        return {-32768, 32767};
    case WireType::Uint:
        return {0, 65535};
    case WireType::Dint:
        return {-2147483648.0, 2147483647};
    case WireType::Udint:
        return {0, 4294967295.0};
    case WireType::Lint:
        return {-9223372036854775808.0, 9223372036854775807.0};
    case WireType::Ulint:
        return {0, 18446744073709551615.0};
    case WireType::Real:
    case WireType::Lreal:
        return {-kInfinity, kInfinity};
    case WireType::Text:
        return {0, 0};
    }
    return {0, 0};
}

/// A bit string takes a signed number as its pattern.
Span spanOf(const Target& target) {
    if (target.range) return {static_cast<double>(target.range->first), static_cast<double>(target.range->second)};
    const unsigned bits = target.size * 8;
    switch (target.family) {
    case Family::Signed:
        return {-std::ldexp(1, static_cast<int>(bits) - 1), std::ldexp(1, static_cast<int>(bits) - 1) - 1};
    case Family::Unsigned:
        return {0, std::ldexp(1, static_cast<int>(bits)) - 1};
    case Family::Bits:
        return {-std::ldexp(1, static_cast<int>(bits) - 1), std::ldexp(1, static_cast<int>(bits)) - 1};
    case Family::Bool:
    case Family::Real:
    case Family::Duration:
    case Family::Date:
    case Family::TimeOfDay:
    case Family::DateTime:
    case Family::Character:
    case Family::Other:
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }
    return {0, 0};
}

} // namespace

bool mayNotFit(const Channel& channel, const Target& target) {
    if (target.takesRealBits || channel.type == WireType::Text || channel.type == WireType::Bool) return false;
    const bool isReal = channel.type == WireType::Real || channel.type == WireType::Lreal;
    if (isReal) return false; // nobody can say what a REAL holds
    Span wire = spanOf(channel.type);
    const Span variable = spanOf(target);
    if (channel.direction == Direction::In) {
        wire = {wire.low * channel.scale + channel.offset, wire.high * channel.scale + channel.offset};
        if (channel.scale < 0) std::swap(wire.low, wire.high);
        return wire.low < variable.low || wire.high > variable.high;
    }
    if (target.family == Family::Real || target.family == Family::Duration) return false;
    Span sent{(variable.low - channel.offset) / channel.scale, (variable.high - channel.offset) / channel.scale};
    if (channel.scale < 0) std::swap(sent.low, sent.high);
    return sent.low < wire.low || sent.high > wire.high;
}

namespace {

template <class Number> void store(Number number, std::span<std::byte> into) {
    std::memcpy(into.data(), &number, sizeof number);
}

bool storeReal(double number, const Target& target, std::span<std::byte> into) {
    if (target.size == 8) return store(number, into), true;
    const auto single = static_cast<float>(number);
    if (std::isinf(single) && !std::isinf(number)) return false;
    return store(single, into), true;
}

/// Whole numbers between those of the target's type; false outside.
bool storeInteger(const Sample& sample, const Target& target, std::span<std::byte> into) {
    int64_t number = sample.integer;
    bool isUnsigned = sample.kind == Sample::Kind::Unsigned && number < 0; // above 2^63
    if (sample.kind == Sample::Kind::Real) {
        double whole = std::nearbyint(sample.real); // to even
        if (target.family == Family::Duration) whole = std::nearbyint(sample.real * 1e6);
        if (!(whole >= -9223372036854775808.0 && whole < 18446744073709551616.0)) return false;
        isUnsigned = whole >= 9223372036854775808.0;
        number = isUnsigned ? static_cast<int64_t>(static_cast<uint64_t>(whole)) : static_cast<int64_t>(whole);
    } else if (target.family == Family::Duration) {
        if (isUnsigned || __builtin_mul_overflow(number, int64_t(1'000'000), &number)) return false;
    }
    const bool takesUnsigned = target.family == Family::Unsigned || target.family == Family::Bits;
    const unsigned bits = target.size * 8;
    if (target.range && (isUnsigned || number < target.range->first || number > target.range->second)) return false;
    if (isUnsigned && (!takesUnsigned || bits < 64)) return false;
    if (target.family == Family::Unsigned && !isUnsigned && number < 0) return false;
    if (bits < 64) {
        const int64_t high = takesUnsigned ? (int64_t(1) << bits) - 1 : (int64_t(1) << (bits - 1)) - 1;
        if (number > high || number < -(int64_t(1) << (bits - 1))) return false;
    }
    std::memcpy(into.data(), &number, target.size); // the low bytes
    return true;
}

bool storeText(const std::string& utf8, const Target& target, std::span<std::byte> into) {
    const auto text = types::stringOfUtf8(target.strings, utf8);
    if (!text || text->size() > target.capacity || text->find('\0') != std::string::npos) return false;
    std::memset(into.data(), 0, target.size);
    std::memcpy(into.data(), text->data(), text->size());
    return true;
}

} // namespace

bool encode(const Sample& sample, const Target& target, std::span<std::byte> into) {
    if (sample.kind == Sample::Kind::None || into.size() < target.size) return false;
    if (target.kind == TypeKind::String)
        return sample.kind == Sample::Kind::Text && storeText(sample.text, target, into);
    if (sample.kind == Sample::Kind::Text) return false;
    if (target.family == Family::Bool) {
        into[0] = std::byte(sample.number() != 0 ? 1 : 0);
        return true;
    }
    if (target.family == Family::Real) return storeReal(sample.number(), target, into);
    if (target.takesRealBits && sample.kind == Sample::Kind::Real) return storeReal(sample.real, target, into);
    return storeInteger(sample, target, into);
}

namespace {

template <class Number> Number load(std::span<const std::byte> bytes) {
    Number number;
    std::memcpy(&number, bytes.data(), sizeof number);
    return number;
}

Sample loadInteger(const Target& target, std::span<const std::byte> at) {
    uint64_t bits = 0;
    std::memcpy(&bits, at.data(), target.size);
    if (target.family == Family::Unsigned || target.family == Family::Bits) return Sample::ofUnsigned(bits);
    const unsigned unused = 64 - target.size * 8;
    const int64_t number = static_cast<int64_t>(bits << unused) >> unused;
    return Sample::of(target.family == Family::Duration ? number / 1'000'000 : number);
}

} // namespace

Sample decode(const Target& target, std::span<const std::byte> image) {
    const std::span<const std::byte> at = image.subspan(target.place.offset);
    if (target.kind == TypeKind::String) {
        const auto* text = reinterpret_cast<const char*>(at.data());
        return Sample::ofText(types::utf8OfString(target.strings, {text, ::strnlen(text, target.capacity)}));
    }
    if (target.place.bit >= 0)
        return Sample::of(static_cast<int64_t>((std::to_integer<unsigned>(at[0]) >> target.place.bit) & 1));
    if (target.family == Family::Bool) return Sample::of(static_cast<int64_t>(at[0] != std::byte{}));
    if (target.family == Family::Real || target.takesRealBits)
        return Sample::of(target.size == 4 ? static_cast<double>(load<float>(at)) : load<double>(at));
    return loadInteger(target, at);
}

} // namespace plc::devices
