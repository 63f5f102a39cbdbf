// What client and server of Modbus share: the contexts of libmodbus, what its errors mean, which registers go together.
// Functions for the link's thread.
#pragma once
#include "projects/devices/port.h"

#include <memory>
#include <modbus/modbus.h>

namespace plc::devices {

struct FreeModbus {
    void operator()(modbus_t* context) const {
        modbus_close(context);
        modbus_free(context);
    }
};
using Modbus = std::unique_ptr<modbus_t, FreeModbus>;

/// Not connected yet; null with errno set when the system has no memory.
[[nodiscard]] Modbus makeContext(const Device& device);
/// The device answered that it does not do it (the connection is good).
[[nodiscard]] bool isException(int code);
[[nodiscard]] Message modbusProblem(int code, const Device& device);

/// Neighbouring registers that one request reads.
struct Block {
    Table table = Table::Holding;
    uint32_t first = 0, count = 0;
    Milliseconds poll{0};
    std::vector<size_t> channels;
};
[[nodiscard]] std::vector<Block> planBlocks(const Device& device);
inline constexpr uint32_t kMostRegistersRead = 125, kMostBitsRead = 2000, kMostRegistersWritten = 123,
                          kMostBitsWritten = 1968;

} // namespace plc::devices
