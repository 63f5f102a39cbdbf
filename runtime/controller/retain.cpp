#include "runtime/controller/retain.h"
#include "runtime/base/messages.h"

#include "runtime/base/text.h"
#include "runtime/controller/controller.h"
#include "runtime/controller/retained_places.h"
#include "runtime/platform/files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace plc::controller {

namespace {

constexpr std::string_view kFirstLine = "stepwise retain 1";

std::string spelled(const types::TypeTable& types, types::TypeId id) {
    const types::Type& type = types[id];
    return type.space.empty() ? type.name : type.space + "." + type.name;
}

bool isReference(const types::TypeTable& types, types::TypeId id) {
    const types::TypeKind kind = types.kind(id);
    return kind == types::TypeKind::Pointer || kind == types::TypeKind::Reference || kind == types::TypeKind::Interface;
}

/// The type, and of an enum the value's name behind it: a renumbered enumeration takes the name, not the number.
std::string typeText(const types::TypeTable& types, types::TypeId id, std::span<const std::byte> bytes) {
    std::string text = spelled(types, id);
    if (types.kind(id) != types::TypeKind::Enum) return text;
    const int64_t value = types::readValue(types, types.storage(id), bytes).integer();
    for (const types::Enumerator& e : types[id].enumerators)
        if (e.value == value) return text + "#" + e.name;
    return text;
}

uint32_t checksum(std::string_view text) { // FNV-1a
    uint32_t hash = 2166136261u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}

std::string hex(std::span<const std::byte> bytes) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (const std::byte b : bytes) {
        text += digits[static_cast<unsigned>(b) >> 4];
        text += digits[static_cast<unsigned>(b) & 15];
    }
    return text;
}
bool parseHex(std::string_view text, std::vector<std::byte>& bytes) {
    if (text.size() % 2) return false;
    const auto digit = [](char c) { return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1; };
    for (size_t i = 0; i < text.size(); i += 2) {
        if (digit(text[i]) < 0 || digit(text[i + 1]) < 0) return false;
        bytes.push_back(static_cast<std::byte>(digit(text[i]) * 16 + digit(text[i + 1])));
    }
    return true;
}

Error notWritten(const std::string& file) { return Error{errors::RetainNotWritten(errors::ofSystem(errno)), file}; }

} // namespace

std::vector<RetainedLeaf> retainedLeaves(const image::Layout& layout, std::span<const std::byte> image) {
    std::vector<RetainedLeaf> leaves;
    forEachRetained(layout, false, [&](const std::string& path, const image::Place& place) {
        layout.forEachLeaf(path, place, [&](const std::string& leaf, const image::Place& at) {
            if (isReference(*layout.types, at.type)) return true;
            const std::span<const std::byte> bytes =
                image.subspan(at.offset, at.bit >= 0 ? 1 : (*layout.types)[at.type].size);
            RetainedLeaf entry{leaf, typeText(*layout.types, at.type, bytes), {bytes.begin(), bytes.end()}};
            if (at.bit >= 0) entry.bytes = {std::byte(static_cast<unsigned>(bytes[0]) >> at.bit & 1)};
            leaves.push_back(std::move(entry));
            return true;
        });
    });
    return leaves;
}

Result<void> saveRetain(const std::string& file, const std::vector<RetainedLeaf>& leaves) {
    std::error_code none;
    if (std::filesystem::exists(file, none) && !std::filesystem::is_regular_file(file, none))
        return Error{errors::NotReplaceable(), file};
    std::string text(kFirstLine);
    text += "\n";
    for (const RetainedLeaf& leaf : leaves) text += leaf.path + "\t" + leaf.type + "\t" + hex(leaf.bytes) + "\n";
    char sum[16];
    std::snprintf(sum, sizeof sum, "%08x", checksum(text));
    text += std::string("end ") + sum + "\n";

    const std::string aside = file + ".new";
    const int handle = platform::openToWrite(aside, platform::Existing::Emptied);
    if (handle < 0) return notWritten(file);
    const auto refused = [&] {
        platform::removeFile(aside);
        return notWritten(file);
    };
    if (!platform::writeAll(handle, text) || !platform::syncFile(handle)) {
        const int code = errno;
        (void)platform::closeFile(handle);
        errno = code;
        return refused();
    }
    if (!platform::closeFile(handle) || !platform::replaceFile(aside, file)) return refused();
    return {};
}

Result<std::vector<RetainedLeaf>> loadRetain(const std::string& file) {
    std::error_code none;
    if (std::filesystem::exists(file, none) && !std::filesystem::is_regular_file(file, none))
        return Error{errors::RetainNotAFile(), file};
    std::ifstream in(file, std::ios::binary);
    if (!in) {
        const int code = errno;
        if (code == ENOENT || code == ENOTDIR) return std::vector<RetainedLeaf>{};
        return Error{errors::RetainNotRead(errors::ofSystem(code)), file};
    }
    std::stringstream buffer;
    buffer << in.rdbuf();
    const std::string text = buffer.str();
    const Error damaged{errors::RetainDamaged(), file};
    const size_t end = text.rfind("end ");
    if (text.compare(0, kFirstLine.size(), kFirstLine) != 0 || end == std::string::npos || end == 0 ||
        text[end - 1] != '\n')
        return damaged;
    char sum[16];
    std::snprintf(sum, sizeof sum, "%08x", checksum(std::string_view(text).substr(0, end)));
    if (text.compare(end + 4, 8, sum) != 0) return damaged;

    std::vector<RetainedLeaf> leaves;
    size_t at = text.find('\n') + 1;
    while (at < end) {
        const size_t lineEnd = text.find('\n', at);
        const std::string_view line = std::string_view(text).substr(at, lineEnd - at);
        at = lineEnd + 1;
        const size_t first = line.find('\t');
        const size_t second = line.find('\t', first + 1);
        if (first == std::string_view::npos || second == std::string_view::npos) return damaged;
        RetainedLeaf leaf;
        leaf.path = line.substr(0, first);
        leaf.type = line.substr(first + 1, second - first - 1);
        if (!parseHex(line.substr(second + 1), leaf.bytes)) return damaged;
        leaves.push_back(std::move(leaf));
    }
    return leaves;
}

namespace {

/// The leaf's value as the variable takes it; none when it has another type now.
std::optional<types::Value> valueFor(const types::TypeTable& types, const image::Place& place,
                                     const RetainedLeaf& leaf) {
    const size_t size = place.bit >= 0 ? 1 : types[place.type].size;
    const size_t hash = leaf.type.find('#');
    if (isReference(types, place.type) || leaf.bytes.size() != size ||
        !equalsIgnoringCase(leaf.type.substr(0, hash), spelled(types, place.type)))
        return std::nullopt;
    if (types.kind(place.type) != types::TypeKind::Enum || hash == std::string::npos)
        return types::readValue(types, place.type, leaf.bytes, place.bit >= 0 ? 0 : -1);
    for (const types::Enumerator& e : types[place.type].enumerators)
        if (equalsIgnoringCase(e.name, std::string_view(leaf.type).substr(hash + 1)))
            return types::Value{place.type, e.value};
    return std::nullopt;
}

} // namespace

RetainOutcome restoreRetained(Controller& controller, const std::vector<RetainedLeaf>& leaves) {
    RetainOutcome outcome;
    const image::Layout& layout = controller.program().layout;
    const types::TypeTable& types = *layout.types;
    std::vector<std::pair<std::string, types::Value>> values;
    for (const RetainedLeaf& leaf : leaves) {
        const Result<image::Place> place = layout.find(leaf.path);
        std::optional<types::Value> value = place ? valueFor(types, *place, leaf) : std::nullopt;
        if (value)
            values.emplace_back(leaf.path, std::move(*value));
        else
            outcome.lost.push_back(leaf.path);
    }
    outcome.restored = controller.restoreRetained(values);
    controller.report(EventKind::RetainRestored, errors::Count(outcome.restored));
    return outcome;
}

} // namespace plc::controller
