// Modbus TCP to one device, or RTU to the units of a serial line: writes the outputs that changed, reads each block at
// its poll rate, gives up on what does not answer and tries again with growing pauses.
#include "projects/devices/configuration/errors.h"
#include "projects/devices/configuration/wire.h"
#include "projects/devices/link.h"
#include "projects/devices/modbus.h"

#include <cerrno>

namespace plc::devices {

namespace {

using Time = SteadyClock::time_point;

struct TimedBlock {
    Block block;
    Time next{};
    bool isSplit = false; // one of its registers was refused: each channel alone, so that the others go on
};

/// A register or coil that outputs set.
struct OutputCell {
    uint16_t value = 0;
    bool isKnown = false; // the device has `value`
    bool isWanted = false;
};

struct Unit {
    explicit Unit(Port& p) : port(p), backOff(p.device.retry) {
        for (Block& block : planBlocks(p.device)) blocks.push_back({std::move(block), {}, false});
    }
    Port& port;
    BackOff backOff;
    std::vector<TimedBlock> blocks;
    std::map<std::pair<Table, uint32_t>, OutputCell> cells;
    std::vector<Sample> outputs;
    uint64_t seenOutputs = 0;
    bool isUp = false, hasMore = false;
    Time retryAt{};
};

class ModbusClient final : public Link {
public:
    explicit ModbusClient(const std::vector<Port*>& ports) {
        for (Port* port : ports) m_units.emplace_back(*port);
        m_isSerial = m_units.front().port.device.protocol == Protocol::ModbusRtu;
    }

protected:
    void run() override;

private:
    [[nodiscard]] Time serve(Unit& unit, Time now);
    [[nodiscard]] bool open(Unit& unit);
    void takeOutputs(Unit& unit, bool isAll);
    [[nodiscard]] bool writeOutputs(Unit& unit);
    [[nodiscard]] bool writeRun(Unit& unit, Table table, uint32_t first, std::span<const uint16_t> values);
    [[nodiscard]] bool readBlock(Unit& unit, TimedBlock& timed);
    [[nodiscard]] bool readChannels(Unit& unit, const Block& block, std::span<const size_t> channels, uint32_t first,
                                    uint32_t count, bool& isRefused);
    [[nodiscard]] int read(Table table, uint32_t first, uint32_t count, std::span<uint16_t> into);
    [[nodiscard]] int write(Table table, uint32_t first, std::span<const uint16_t> values);
    /// Carries `request` out, counted and timed; on a serial line a second time when the first was disturbed.
    template <class Request> int counted(Unit& unit, size_t bytesOut, size_t bytesIn, Request&& request);
    void came(Unit& unit);
    void lose(Unit& unit, Message why);
    void leave(Unit& unit);

    std::vector<Unit> m_units;
    Modbus m_context;
    bool m_isSerial = false;
};

void ModbusClient::run() {
    for (Unit& unit : m_units) unit.port.setState(LinkState::Connecting);
    while (!isStopping()) {
        const Time now = SteadyClock::now();
        Time next = now + std::chrono::hours(1);
        for (Unit& unit : m_units) {
            if (isStopping()) break;
            next = std::min(next, serve(unit, SteadyClock::now()));
        }
        waitUntil(next);
    }
    for (Unit& unit : m_units) leave(unit);
    m_context.reset();
}

/// One round with a unit; when it is to be served next.
Time ModbusClient::serve(Unit& unit, Time now) {
    if (now < unit.retryAt) return unit.retryAt;
    if (!open(unit)) return unit.retryAt;
    modbus_set_slave(m_context.get(), unit.port.device.unit);
    takeOutputs(unit, false);
    if (!writeOutputs(unit)) return unit.retryAt;
    // An output alone is looked after at the poll rate too.
    Time next = now + unit.port.device.poll;
    for (TimedBlock& timed : unit.blocks) {
        if (timed.next <= now) {
            if (!readBlock(unit, timed)) return unit.retryAt;
            // In step with the clock; what was missed is left out.
            timed.next = timed.next + timed.block.poll > now ? timed.next + timed.block.poll : now + timed.block.poll;
        }
        next = std::min(next, timed.next);
    }
    if (!unit.isUp && unit.blocks.empty()) came(unit); // nothing to ask for: connected is as good as it gets
    if (unit.isUp) unit.port.publish();
    return next;
}

bool ModbusClient::open(Unit& unit) {
    if (m_context) return true;
    const Device& device = unit.port.device;
    m_context = makeContext(device);
    if (m_context && modbus_connect(m_context.get()) == 0) {
        unit.port.countConnect();
        return true;
    }
    const int code = errno == 0 || errno == EINPROGRESS ? ETIMEDOUT : errno;
    m_context.reset();
    const std::string where = m_isSerial ? device.serial : device.host + ":" + std::to_string(device.port);
    for (Unit& each : m_units) lose(each, errors::NotConnected(where, modbusProblem(code, device)));
    return false;
}

void ModbusClient::came(Unit& unit) {
    if (unit.isUp) return;
    unit.isUp = true;
    unit.backOff.succeeded();
    unit.port.setState(LinkState::Online);
    for (size_t c = 0; c < unit.port.device.channels.size(); ++c)
        if (unit.port.device.channels[c].direction == Direction::Out) unit.port.setQuality(c, Quality::Good);
}

void ModbusClient::lose(Unit& unit, Message why) {
    unit.port.countError();
    unit.port.setAll(Quality::Lost);
    unit.port.setState(LinkState::Lost, std::move(why));
    unit.port.publish();
    unit.isUp = false;
    for (auto& [place, cell] : unit.cells) cell.isKnown = false; // it may have forgotten them
    for (TimedBlock& timed : unit.blocks) timed.next = {};
    unit.retryAt = unit.backOff.failed();
    if (!m_isSerial) m_context.reset();
}

template <class Request> int ModbusClient::counted(Unit& unit, size_t bytesOut, size_t bytesIn, Request&& request) {
    for (int attempt = 0;; ++attempt) {
        const Time begin = SteadyClock::now();
        errno = 0;
        const int done = request();
        const int code = done >= 0 ? 0 : errno == 0 ? ECONNRESET : errno;
        if (done >= 0 || isException(code))
            unit.port.countRequest(bytesOut, done >= 0 ? bytesIn : 9, SteadyClock::now() - begin);
        else
            unit.port.countBytes(bytesOut, 0);
        if (done >= 0 || isException(code)) {
            came(unit);
            return code;
        }
        if (!m_isSerial) return code;
        (void)modbus_flush(m_context.get());
        const bool isPortGone = code == EIO || code == EBADF || code == ENODEV || code == ENXIO;
        if (isPortGone) m_context.reset();
        if (isPortGone || attempt > 0 || isStopping()) return code;
    }
}

int ModbusClient::read(Table table, uint32_t first, uint32_t count, std::span<uint16_t> into) {
    const auto at = static_cast<int>(first), n = static_cast<int>(count);
    modbus_t* context = m_context.get();
    if (table == Table::Holding) return modbus_read_registers(context, at, n, into.data());
    if (table == Table::Input) return modbus_read_input_registers(context, at, n, into.data());
    std::array<uint8_t, kMostBitsRead> bits{};
    const int done = table == Table::Coil ? modbus_read_bits(context, at, n, bits.data())
                                          : modbus_read_input_bits(context, at, n, bits.data());
    std::copy_n(bits.begin(), count, into.begin());
    return done;
}

bool ModbusClient::readBlock(Unit& unit, TimedBlock& timed) {
    const Block& block = timed.block;
    bool isRefused = false;
    if (!timed.isSplit) {
        if (!readChannels(unit, block, block.channels, block.first, block.count, isRefused)) return false;
        timed.isSplit = isRefused && block.channels.size() > 1;
        if (!timed.isSplit) return true;
    }
    for (const size_t index : block.channels) {
        const Channel& channel = unit.port.device.channels[index];
        if (!readChannels(unit, block, {&index, 1}, channel.address, channel.registers(), isRefused)) return false;
    }
    return true;
}

bool ModbusClient::readChannels(Unit& unit, const Block& block, std::span<const size_t> channels, uint32_t first,
                                uint32_t count, bool& isRefused) {
    std::array<uint16_t, kMostBitsRead> values{};
    const size_t payload = isBitTable(block.table) ? (count + 7) / 8 : count * 2;
    const int code = counted(unit, 12, 9 + payload, [&] { return read(block.table, first, count, values); });
    if (code != 0 && !isException(code)) {
        lose(unit, modbusProblem(code, unit.port.device));
        return false;
    }
    if (code != 0) {
        isRefused = true;
        unit.port.countError();
        unit.port.note(errors::DeviceRefuses(spelling(block.table), first, modbusProblem(code, unit.port.device)));
        for (const size_t index : channels) unit.port.setQuality(index, Quality::Refused);
        return true;
    }
    for (const size_t index : channels) {
        const Channel& channel = unit.port.device.channels[index];
        Sample sample = fromRegisters(channel, std::span(values).subspan(channel.address - first));
        const bool isGood = sample.kind != Sample::Kind::None;
        unit.port.set(index, isGood ? Quality::Good : Quality::Unfit, std::move(sample));
    }
    return true;
}

// ---------------------------------------------------------------- outputs

void ModbusClient::takeOutputs(Unit& unit, bool isLeaving) {
    if (isLeaving ? !unit.port.safeOutputs(unit.outputs) : !unit.port.outputs(unit.outputs, unit.seenOutputs)) return;
    const Device& device = unit.port.device;
    for (size_t c = 0; c < device.channels.size() && c < unit.outputs.size(); ++c) {
        const Channel& channel = device.channels[c];
        if (channel.direction != Direction::Out || unit.outputs[c].kind == Sample::Kind::None) continue;
        std::array<uint16_t, 4> before{}, after{};
        for (unsigned i = 0; i < channel.registers(); ++i)
            before[i] = unit.cells[{channel.table, channel.address + i}].value;
        after = before;
        if (!toRegisters(channel, unit.outputs[c], after)) {
            unit.port.setQuality(c, Quality::Unfit);
            unit.port.note(errors::DoesNotFit(channel.name));
            continue;
        }
        // A number of several registers is written as a whole.
        bool isChanged = false;
        for (unsigned i = 0; i < channel.registers(); ++i) {
            const OutputCell& cell = unit.cells[{channel.table, channel.address + i}];
            isChanged |= !cell.isWanted || cell.value != after[i];
        }
        for (unsigned i = 0; isChanged && i < channel.registers(); ++i)
            unit.cells[{channel.table, channel.address + i}] = {after[i], false, true};
        if (unit.isUp && unit.port.now(c).quality == Quality::Unfit) unit.port.setQuality(c, Quality::Good);
    }
}

bool ModbusClient::writeOutputs(Unit& unit) {
    for (auto it = unit.cells.begin(); it != unit.cells.end();) {
        const auto [table, first] = it->first;
        if (!it->second.isWanted || it->second.isKnown) {
            ++it;
            continue;
        }
        const uint32_t most = isBitTable(table) ? kMostBitsWritten : kMostRegistersWritten;
        std::vector<uint16_t> values;
        auto last = it;
        for (; last != unit.cells.end() &&
               last->first == std::pair(table, first + static_cast<uint32_t>(values.size())) && last->second.isWanted &&
               !last->second.isKnown && values.size() < most;
             ++last)
            values.push_back(last->second.value);
        if (!writeRun(unit, table, first, values)) return false;
        for (; it != last; ++it) it->second.isKnown = true;
    }
    return true;
}

int ModbusClient::write(Table table, uint32_t first, std::span<const uint16_t> values) {
    const auto at = static_cast<int>(first), n = static_cast<int>(values.size());
    modbus_t* context = m_context.get();
    if (!isBitTable(table))
        return n == 1 ? modbus_write_register(context, at, values[0])
                      : modbus_write_registers(context, at, n, values.data());
    if (n == 1) return modbus_write_bit(context, at, values[0]);
    const std::vector<uint8_t> bits(values.begin(), values.end());
    return modbus_write_bits(context, at, n, bits.data());
}

bool ModbusClient::writeRun(Unit& unit, Table table, uint32_t first, std::span<const uint16_t> values) {
    const size_t payload = isBitTable(table) ? (values.size() + 7) / 8 : values.size() * 2;
    const size_t bytes = values.size() == 1 ? 12 : 13 + payload;
    const int code = counted(unit, bytes, 12, [&] { return write(table, first, values); });
    if (code != 0 && !isException(code)) {
        lose(unit, modbusProblem(code, unit.port.device));
        return false;
    }
    const auto end = first + static_cast<uint32_t>(values.size());
    for (size_t c = 0; c < unit.port.device.channels.size(); ++c) {
        const Channel& channel = unit.port.device.channels[c];
        if (channel.direction != Direction::Out || channel.table != table || channel.address >= end ||
            channel.address + channel.registers() <= first)
            continue;
        unit.port.setQuality(c, code == 0 ? Quality::Good : Quality::Refused);
    }
    if (code == 0) return true;
    unit.port.countError();
    unit.port.note(errors::DeviceRefuses(spelling(table), first, modbusProblem(code, unit.port.device)));
    return true;
}

/// The outputs are safe before the connection ends.
void ModbusClient::leave(Unit& unit) {
    if (m_context && unit.isUp) {
        modbus_set_slave(m_context.get(), unit.port.device.unit);
        takeOutputs(unit, true);
        (void)writeOutputs(unit);
    }
    unit.port.setAll(Quality::Waiting);
    unit.port.setState(LinkState::Off);
    unit.port.publish();
}

} // namespace

std::unique_ptr<Link> makeModbusClient(std::vector<Port*> units) { return std::make_unique<ModbusClient>(units); }

} // namespace plc::devices
