#include "projects/devices/modbus_requests.h"

#include "projects/devices/configuration/wire.h"

namespace plc::devices {

namespace {

constexpr size_t kHead = 6, kFunction = 7;

uint32_t wordAt(std::span<const uint8_t> frame, size_t at) {
    return static_cast<uint32_t>(frame[at]) << 8 | frame[at + 1];
}

/// What is asked for makes sense: the exception it gets, or 0.
int objection(std::span<const uint8_t> frame) {
    constexpr int kIllegalFunction = MODBUS_EXCEPTION_ILLEGAL_FUNCTION,
                  kIllegalValue = MODBUS_EXCEPTION_ILLEGAL_DATA_VALUE;
    const auto isLong = [&](size_t size) { return frame.size() == size; };
    const auto quantity = [&](size_t at, uint32_t most) { return wordAt(frame, at) >= 1 && wordAt(frame, at) <= most; };
    switch (frame[kFunction]) {
    case MODBUS_FC_READ_COILS:
    case MODBUS_FC_READ_DISCRETE_INPUTS:
        return isLong(12) && quantity(10, kMostBitsRead) ? 0 : kIllegalValue;
    case MODBUS_FC_READ_HOLDING_REGISTERS:
    case MODBUS_FC_READ_INPUT_REGISTERS:
        return isLong(12) && quantity(10, kMostRegistersRead) ? 0 : kIllegalValue;
    case MODBUS_FC_WRITE_SINGLE_COIL:
        return isLong(12) && (wordAt(frame, 10) == 0xff00 || wordAt(frame, 10) == 0) ? 0 : kIllegalValue;
    case MODBUS_FC_WRITE_SINGLE_REGISTER:
        return isLong(12) ? 0 : kIllegalValue;
    case MODBUS_FC_WRITE_MULTIPLE_COILS:
        return frame.size() >= 14 && quantity(10, kMostBitsWritten) && frame[12] == (wordAt(frame, 10) + 7) / 8 &&
                       isLong(13u + frame[12])
                   ? 0
                   : kIllegalValue;
    case MODBUS_FC_WRITE_MULTIPLE_REGISTERS:
        return frame.size() >= 15 && quantity(10, kMostRegistersWritten) && frame[12] == wordAt(frame, 10) * 2 &&
                       isLong(13u + frame[12])
                   ? 0
                   : kIllegalValue;
    case MODBUS_FC_MASK_WRITE_REGISTER:
        return isLong(14) ? 0 : kIllegalValue;
    case MODBUS_FC_WRITE_AND_READ_REGISTERS:
        return frame.size() >= 19 && quantity(10, kMostRegistersRead) && quantity(14, 121) &&
                       frame[16] == wordAt(frame, 14) * 2 && isLong(17u + frame[16])
                   ? 0
                   : kIllegalValue;
    default:
        return kIllegalFunction;
    }
}

WrittenRange writtenBy(std::span<const uint8_t> frame) {
    switch (frame[kFunction]) {
    case MODBUS_FC_WRITE_SINGLE_COIL:
        return {Table::Coil, wordAt(frame, 8), 1};
    case MODBUS_FC_WRITE_MULTIPLE_COILS:
        return {Table::Coil, wordAt(frame, 8), wordAt(frame, 10)};
    case MODBUS_FC_WRITE_SINGLE_REGISTER:
    case MODBUS_FC_MASK_WRITE_REGISTER:
        return {Table::Holding, wordAt(frame, 8), 1};
    case MODBUS_FC_WRITE_MULTIPLE_REGISTERS:
        return {Table::Holding, wordAt(frame, 8), wordAt(frame, 10)};
    case MODBUS_FC_WRITE_AND_READ_REGISTERS:
        return {Table::Holding, wordAt(frame, 12), wordAt(frame, 14)};
    default:
        return {};
    }
}

struct Extent {
    uint32_t first = 0, end = 0;
};

Extent extentOf(const Device& device, Table table) {
    Extent extent{65536, 0};
    for (const Channel& channel : device.channels) {
        if (channel.table != table) continue;
        extent.first = std::min(extent.first, channel.address);
        extent.end = std::max(extent.end, std::min<uint32_t>(65536, channel.address + channel.registers()));
    }
    return extent.end > extent.first ? extent : Extent{};
}

} // namespace

FrameSize requestSize(std::span<const uint8_t> bytes) {
    if (bytes.size() < kHead) return {};
    const uint32_t length = wordAt(bytes, 4);
    if (wordAt(bytes, 2) != 0 || length < 2 || length > kLargestRequest - kHead) return {0, true};
    return {kHead + length, false};
}

ServerRegisters::ServerRegisters(const Device& device) : m_unit(device.unit), m_context(modbus_new_tcp(nullptr, 1502)) {
    const Extent coils = extentOf(device, Table::Coil), discretes = extentOf(device, Table::Discrete),
                 holding = extentOf(device, Table::Holding), inputs = extentOf(device, Table::Input);
    m_mapping.reset(modbus_mapping_new_start_address(
        coils.first, coils.end - coils.first, discretes.first, discretes.end - discretes.first, holding.first,
        holding.end - holding.first, inputs.first, inputs.end - inputs.first));
    if (m_context) modbus_set_response_timeout(m_context.get(), 0, 1); // it never waits for a client
}

ServerAnswer ServerRegisters::answer(int socket, std::span<const uint8_t> frame) {
    ServerAnswer done;
    if (!m_context || !m_mapping || frame.size() <= kFunction) return done;
    modbus_set_socket(m_context.get(), socket);
    const int unit = frame[kHead];
    int problem = unit == m_unit || unit == 0 || unit == 255 ? objection(frame) : MODBUS_EXCEPTION_GATEWAY_TARGET;
    if (problem != 0)
        done.bytes = modbus_reply_exception(m_context.get(), frame.data(), static_cast<unsigned>(problem));
    else
        done.bytes = modbus_reply(m_context.get(), frame.data(), static_cast<int>(frame.size()), m_mapping.get());
    modbus_set_socket(m_context.get(), -1); // it is the caller's
    done.isException = done.bytes == 9;
    if (!done.isException && done.bytes > 0) done.written = writtenBy(frame);
    return done;
}

std::array<uint16_t, 4> ServerRegisters::load(const Channel& channel) const {
    std::array<uint16_t, 4> words{};
    for (uint32_t i = 0; i < channel.registers(); ++i) {
        const uint32_t at = channel.address + i;
        switch (channel.table) {
        case Table::Coil:
            words[i] = m_mapping->tab_bits[at - static_cast<uint32_t>(m_mapping->start_bits)];
            break;
        case Table::Discrete:
            words[i] = m_mapping->tab_input_bits[at - static_cast<uint32_t>(m_mapping->start_input_bits)];
            break;
        case Table::Holding:
            words[i] = m_mapping->tab_registers[at - static_cast<uint32_t>(m_mapping->start_registers)];
            break;
        case Table::Input:
            words[i] = m_mapping->tab_input_registers[at - static_cast<uint32_t>(m_mapping->start_input_registers)];
            break;
        }
    }
    return words;
}

Sample ServerRegisters::get(const Channel& channel) const {
    return m_mapping ? fromRegisters(channel, load(channel)) : Sample();
}

bool ServerRegisters::put(const Channel& channel, const Sample& sample) {
    if (!m_mapping) return false;
    std::array<uint16_t, 4> words = load(channel);
    if (!toRegisters(channel, sample, words)) return false;
    for (uint32_t i = 0; i < channel.registers(); ++i) {
        const uint32_t at = channel.address + i;
        switch (channel.table) {
        case Table::Coil:
            m_mapping->tab_bits[at - static_cast<uint32_t>(m_mapping->start_bits)] = static_cast<uint8_t>(words[i]);
            break;
        case Table::Discrete:
            m_mapping->tab_input_bits[at - static_cast<uint32_t>(m_mapping->start_input_bits)] =
                static_cast<uint8_t>(words[i]);
            break;
        case Table::Holding:
            m_mapping->tab_registers[at - static_cast<uint32_t>(m_mapping->start_registers)] = words[i];
            break;
        case Table::Input:
            m_mapping->tab_input_registers[at - static_cast<uint32_t>(m_mapping->start_input_registers)] = words[i];
            break;
        }
    }
    return true;
}

} // namespace plc::devices
