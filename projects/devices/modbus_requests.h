// The registers of a Modbus server and its answers. libmodbus answers sound requests; what is not sound is refused in
// front of it, because it waits and empties the connection where a request makes no sense. One thread.
#pragma once
#include "projects/devices/modbus.h"

#include <array>
#include <span>

namespace plc::devices {

inline constexpr size_t kLargestRequest = 260;

struct FrameSize {
    size_t bytes = 0;   // of the whole frame; 0: its head is not there yet
    bool isBad = false; // no Modbus: the connection cannot be understood from here on
};
[[nodiscard]] FrameSize requestSize(std::span<const uint8_t> bytes);

struct WrittenRange {
    Table table = Table::Holding;
    uint32_t first = 0, count = 0; // count 0: nothing was written
};
struct ServerAnswer {
    int bytes = -1; // sent; below 0: the client does not take them
    bool isException = false;
    WrittenRange written;
};

class ServerRegisters {
public:
    explicit ServerRegisters(const Device& device);
    /// Carries out a whole frame and sends the answer to `socket`.
    ServerAnswer answer(int socket, std::span<const uint8_t> frame);
    [[nodiscard]] bool put(const Channel& channel, const Sample& sample);
    [[nodiscard]] Sample get(const Channel& channel) const;

private:
    struct FreeMapping {
        void operator()(modbus_mapping_t* mapping) const { modbus_mapping_free(mapping); }
    };
    [[nodiscard]] std::array<uint16_t, 4> load(const Channel& channel) const;
    int m_unit;
    Modbus m_context;
    std::unique_ptr<modbus_mapping_t, FreeMapping> m_mapping;
};

} // namespace plc::devices
