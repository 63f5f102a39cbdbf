#include "projects/devices/modbus.h"

#include "projects/devices/configuration/errors.h"

#include <cerrno>

namespace plc::devices {

namespace {

char letterOf(Parity parity) {
    switch (parity) {
    case Parity::None:
        return 'N';
    case Parity::Even:
        return 'E';
    case Parity::Odd:
        return 'O';
    }
    return 'N';
}

} // namespace

Modbus makeContext(const Device& device) {
    Modbus context(device.protocol == Protocol::ModbusRtu
                       ? modbus_new_rtu(device.serial.c_str(), static_cast<int>(device.baud), letterOf(device.parity),
                                        device.dataBits, device.stopBits)
                       : modbus_new_tcp_pi(device.host.c_str(), std::to_string(device.port).c_str()));
    if (!context) return context;
    const auto timeout = static_cast<uint32_t>(device.timeout.count());
    modbus_set_response_timeout(context.get(), timeout / 1000, timeout % 1000 * 1000);
    // A frame's bytes may come in pieces, but not for longer than the whole answer may take.
    modbus_set_byte_timeout(context.get(), timeout / 1000, timeout % 1000 * 1000);
    return context;
}

bool isException(int code) { return code > MODBUS_ENOBASE && code <= EMBXGTAR; }

Message modbusProblem(int code, const Device& device) {
    switch (code) {
    case ETIMEDOUT:
        return errors::NoAnswer(device.timeout.count());
    case EMBXILFUN:
        return errors::IllegalFunction();
    case EMBXILADD:
        return errors::IllegalAddress();
    case EMBXILVAL:
        return errors::IllegalValue();
    case EMBXSBUSY:
    case EMBXACK:
        return errors::DeviceBusy();
    case EMBXGPATH:
    case EMBXGTAR:
        return errors::GatewayFails();
    case EMBBADCRC:
    case EMBBADDATA:
    case EMBBADEXC:
    case EMBUNKEXC:
    case EMBMDATA:
    case EMBBADSLAVE:
        return errors::BadAnswer();
    default:
        if (isException(code)) return errors::DeviceFailure();
        if (code >= MODBUS_ENOBASE) return errors::SystemSays(std::string(modbus_strerror(code)));
        return errors::ofSystem(code);
    }
}

std::vector<Block> planBlocks(const Device& device) {
    std::vector<size_t> order;
    for (size_t i = 0; i < device.channels.size(); ++i)
        if (device.channels[i].direction == Direction::In) order.push_back(i);
    const auto pollOf = [&](const Channel& c) { return c.poll.count() > 0 ? c.poll : device.poll; };
    const auto key = [&](size_t i) {
        const Channel& c = device.channels[i];
        return std::tuple(c.table, pollOf(c), c.address, i);
    };
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return key(a) < key(b); });
    std::vector<Block> blocks;
    for (const size_t i : order) {
        const Channel& c = device.channels[i];
        const uint32_t end = c.address + c.registers();
        const uint32_t most = isBitTable(c.table) ? kMostBitsRead : kMostRegistersRead;
        Block* last = blocks.empty() ? nullptr : &blocks.back();
        // A gap is not read: the device may have no register there.
        if (!last || last->table != c.table || last->poll != pollOf(c) || c.address > last->first + last->count ||
            end - last->first > most) {
            blocks.push_back({c.table, c.address, c.registers(), pollOf(c), {}});
            last = &blocks.back();
        }
        last->count = std::max(last->count, end - last->first);
        last->channels.push_back(i);
    }
    return blocks;
}

} // namespace plc::devices
