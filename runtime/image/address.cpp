#include "runtime/image/address.h"
#include "runtime/base/chars.h"

#include <algorithm>
#include <vector>

namespace plc::image {
namespace {

using types::TypeKind;

std::optional<Area> areaOf(char letter) {
    switch (asciiLower(letter)) {
    case 'i':
        return Area::Input;
    case 'q':
        return Area::Output;
    case 'm':
        return Area::Memory;
    default:
        return std::nullopt;
    }
}

std::optional<TypeKind> kindOf(char letter) {
    switch (asciiLower(letter)) {
    case 'x':
        return TypeKind::Bool;
    case 'b':
        return TypeKind::Byte;
    case 'w':
        return TypeKind::Word;
    case 'd':
        return TypeKind::Dword;
    case 'l':
        return TypeKind::Lword;
    default:
        return std::nullopt;
    }
}

char letterOf(TypeKind kind) {
    switch (kind) {
    case TypeKind::Byte:
        return 'B';
    case TypeKind::Word:
        return 'W';
    case TypeKind::Dword:
        return 'D';
    case TypeKind::Lword:
        return 'L';
    default:
        return 'X';
    }
}

char letterOf(Area area) { return area == Area::Input ? 'I' : area == Area::Output ? 'Q' : 'M'; }

/// "3.1.2"; nothing for anything else.
std::optional<std::vector<uint64_t>> numbersOf(std::string_view text) {
    std::vector<uint64_t> numbers;
    for (size_t at = 0; at < text.size(); ++at) {
        if (!isDigit(text[at])) return std::nullopt;
        uint64_t number = 0;
        for (; at < text.size() && isDigit(text[at]); ++at)
            number = std::min<uint64_t>(number * 10 + static_cast<uint64_t>(text[at] - '0'), uint64_t(1) << 28);
        numbers.push_back(number);
        if (at == text.size()) return numbers;
        if (text[at] != '.') return std::nullopt;
    }
    return std::nullopt;
}

/// The letters of an address and where its numbers begin.
struct Head {
    DirectAddress address;
    size_t numbers = 2;
};

std::optional<Head> headOf(std::string_view text) {
    if (text.size() < 3 || text[0] != '%') return std::nullopt;
    const std::optional<Area> area = areaOf(text[1]);
    if (!area) return std::nullopt;
    Head head;
    head.address.area = *area;
    if (isDigit(text[2]) || text[2] == '*') return head;
    const std::optional<TypeKind> kind = kindOf(text[2]);
    if (!kind) return std::nullopt;
    head.address.kind = *kind;
    head.numbers = 3;
    return head;
}

} // namespace

std::optional<DirectAddress> parseAddress(std::string_view text, Addressing addressing) {
    const std::optional<Head> head = headOf(text);
    if (!head) return std::nullopt;
    DirectAddress out = head->address;
    const std::string_view rest = text.substr(head->numbers);
    if (rest == "*") {
        out.isOpen = true;
        return out;
    }
    const std::optional<std::vector<uint64_t>> numbers = numbersOf(rest);
    if (!numbers) return std::nullopt;
    const bool isBit = out.kind == TypeKind::Bool;
    out.isHierarchical = numbers->size() > (isBit ? 2u : 1u);
    if (out.isHierarchical) {
        if (isBit) out.bit = 0;
        return out;
    }
    out.byte = static_cast<uint32_t>(numbers->front());
    if (!isBit) {
        if (addressing == Addressing::Words) out.byte *= types::bitsOf(out.kind) / 8;
        return out;
    }
    const uint64_t bit = numbers->size() == 2 ? numbers->back() : out.byte % 8;
    if (numbers->size() == 1) out.byte /= 8;
    if (bit > 7) return std::nullopt;
    out.bit = static_cast<int16_t>(bit);
    return out;
}

std::optional<std::string> addressText(const DirectAddress& address, Addressing addressing) {
    std::string text = std::string("%") + letterOf(address.area) + letterOf(address.kind);
    if (address.isOpen) return text + "*";
    if (address.isHierarchical) return std::nullopt;
    if (address.bit >= 0) return text + std::to_string(address.byte) + "." + std::to_string(address.bit);
    const uint32_t unit = addressing == Addressing::Words ? std::max(1u, types::bitsOf(address.kind) / 8) : 1;
    if (address.byte % unit != 0) return std::nullopt;
    return text + std::to_string(address.byte / unit);
}

std::string hierarchicalName(std::string_view text) {
    const std::optional<Head> head = headOf(text);
    const auto numbers = head ? numbersOf(text.substr(head->numbers)) : std::nullopt;
    if (!numbers) return std::string(text);
    std::string name = std::string("%") + letterOf(head->address.area) + letterOf(head->address.kind);
    for (size_t i = 0; i < numbers->size(); ++i) name += (i ? "." : "") + std::to_string((*numbers)[i]);
    return name;
}

} // namespace plc::image
