#include "projects/devices/configuration/device.h"

namespace plc::devices {

std::string_view spelling(Protocol protocol) {
    switch (protocol) {
#define PLC_PROTOCOL(Name, Spelling)                                                                                   \
    case Protocol::Name:                                                                                               \
        return Spelling;
#include "projects/devices/configuration/words.def"
    }
    return {};
}

std::string_view spelling(Table table) {
    switch (table) {
#define PLC_TABLE(Name, Spelling)                                                                                      \
    case Table::Name:                                                                                                  \
        return Spelling;
#include "projects/devices/configuration/words.def"
    }
    return {};
}

std::string_view spelling(WireType type) {
    switch (type) {
#define PLC_WIRE_TYPE(Name, Spelling, Registers)                                                                       \
    case WireType::Name:                                                                                               \
        return Spelling;
#include "projects/devices/configuration/words.def"
    }
    return {};
}

std::string_view spelling(Order order) {
    switch (order) {
#define PLC_ORDER(Name, Spelling)                                                                                      \
    case Order::Name:                                                                                                  \
        return Spelling;
#include "projects/devices/configuration/words.def"
    }
    return {};
}

std::string_view spelling(OnLoss onLoss) {
    switch (onLoss) {
#define PLC_ON_LOSS(Name, Spelling)                                                                                    \
    case OnLoss::Name:                                                                                                 \
        return Spelling;
#include "projects/devices/configuration/words.def"
    }
    return {};
}

std::string_view spelling(Parity parity) {
    switch (parity) {
#define PLC_PARITY(Name, Spelling)                                                                                     \
    case Parity::Name:                                                                                                 \
        return Spelling;
#include "projects/devices/configuration/words.def"
    }
    return {};
}

std::string_view spelling(Direction direction) {
    switch (direction) {
#define PLC_DIRECTION(Name, Spelling)                                                                                  \
    case Direction::Name:                                                                                              \
        return Spelling;
#include "projects/devices/configuration/words.def"
    }
    return {};
}

unsigned registersOf(WireType type) {
    switch (type) {
#define PLC_WIRE_TYPE(Name, Spelling, Registers)                                                                       \
    case WireType::Name:                                                                                               \
        return Registers;
#include "projects/devices/configuration/words.def"
    }
    return 0;
}

} // namespace plc::devices
