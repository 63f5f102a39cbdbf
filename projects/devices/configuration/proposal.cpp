#include "projects/devices/configuration/proposal.h"

#include <charconv>

namespace plc::devices {

namespace {

struct Size {
    char letter;
    uint32_t bytes;
    const char* type;
};

Size sizeOf(WireType type) {
    switch (type) {
    case WireType::Bool:
        return {'X', 0, "BOOL"};
    case WireType::Int:
        return {'W', 2, "INT"};
    case WireType::Uint:
        return {'W', 2, "UINT"};
    case WireType::Dint:
        return {'D', 4, "DINT"};
    case WireType::Udint:
        return {'D', 4, "UDINT"};
    case WireType::Lint:
        return {'L', 8, "LINT"};
    case WireType::Ulint:
        return {'L', 8, "ULINT"};
    case WireType::Real:
        return {'D', 4, "REAL"};
    case WireType::Lreal:
        return {'L', 8, "LREAL"};
    case WireType::Text:
        return {0, 0, ""};
    }
    return {0, 0, ""};
}

/// The bits of one area that are taken.
class Area {
public:
    void take(uint32_t bit, uint32_t count) {
        if (bit + count > m_taken.size()) m_taken.resize(bit + count);
        std::fill_n(m_taken.begin() + bit, count, true);
    }
    /// The first place behind everything that is declared, so that a gap the program leaves stays one.
    [[nodiscard]] uint32_t next(uint32_t bits) const {
        uint32_t at = static_cast<uint32_t>(m_taken.size());
        const uint32_t step = bits == 0 ? 1 : bits;
        at = (at + step - 1) / step * step;
        return at;
    }

private:
    std::vector<bool> m_taken;
};

/// "%IX1.3", "%QW4": area, first bit and how many; no other form is proposed or taken here.
std::optional<std::tuple<char, uint32_t, uint32_t>> bitsOf(const std::string& address) {
    if (address.size() < 4 || address[0] != '%') return std::nullopt;
    const char area = static_cast<char>(address[1] & ~0x20), size = static_cast<char>(address[2] & ~0x20);
    uint32_t byte = 0, bit = 0;
    const char* last = address.data() + address.size();
    const auto [end, problem] = std::from_chars(address.data() + 3, last, byte);
    if (problem != std::errc()) return std::nullopt;
    if (end != last && *end == '.') (void)std::from_chars(end + 1, last, bit);
    const uint32_t bits = size == 'X'   ? 1
                          : size == 'B' ? 8
                          : size == 'W' ? 16
                          : size == 'D' ? 32
                          : size == 'L' ? 64
                                        : 0;
    if (bits == 0 || bit > 7) return std::nullopt;
    return std::tuple(area, byte * 8 + bit, bits);
}

} // namespace

std::vector<Proposal> proposeAddresses(const DeviceFile& file, const image::Layout* layout) {
    Area inputs, outputs;
    const auto take = [&](const std::string& address) {
        const auto bits = bitsOf(address);
        if (!bits) return;
        const auto [area, first, count] = *bits;
        if (area == 'I') inputs.take(first, count);
        if (area == 'Q') outputs.take(first, count);
    };
    if (layout) {
        for (const image::Root& root : layout->roots) {
            const bool isIn = root.area == image::Area::Input, isOut = root.area == image::Area::Output;
            if (!isIn && !isOut) continue;
            const uint32_t byte = root.offset - (isIn ? layout->inputs.begin : layout->outputs.begin);
            const uint32_t bits = root.bit >= 0 ? 1 : (*layout->types)[root.type].size * 8;
            (isIn ? inputs : outputs).take(byte * 8 + static_cast<uint32_t>(std::max<int>(0, root.bit)), bits);
        }
    }
    for (const Device& device : file.devices())
        for (const Channel& channel : device.channels) take(channel.variable);
    std::vector<Proposal> proposals;
    for (size_t d = 0; d < file.devices().size(); ++d) {
        const Device& device = file.devices()[d];
        for (size_t c = 0; c < device.channels.size(); ++c) {
            const Channel& channel = device.channels[c];
            const Size size = sizeOf(channel.type);
            if (!channel.variable.empty() || size.letter == 0) continue;
            const bool isIn = channel.direction == Direction::In;
            Area& area = isIn ? inputs : outputs;
            const uint32_t at = area.next(size.bytes * 8);
            std::string address = std::string("%") + (isIn ? 'I' : 'Q') + size.letter + std::to_string(at / 8);
            if (size.bytes == 0) address += "." + std::to_string(at % 8);
            take(address);
            proposals.push_back(
                {d, c, address, device.name + "_" + channel.name + " AT " + address + " : " + size.type + ";"});
        }
    }
    return proposals;
}

std::string declarationsOf(const std::vector<Proposal>& proposals) {
    if (proposals.empty()) return {};
    std::string text = "VAR_GLOBAL\n";
    for (const Proposal& proposal : proposals) text += "    " + proposal.declaration + "\n";
    return text + "END_VAR\n";
}

} // namespace plc::devices
