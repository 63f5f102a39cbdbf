// Random programs from a seed: statements of every kind over every elementary type, blocks that inherit, methods,
// properties and an interface. The same seed gives the same program. Functions; one thread each.
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace plc::golden {

/// What every random program uses beside its own variables.
[[nodiscard]] std::string randomPrelude();

struct RandomProgram {
    uint32_t seed = 0;
    std::string name, text;
    std::vector<std::pair<std::string, std::string>> watched; // a variable, and the expression it is given last
};
enum class Faults : uint8_t { None, Possible };
[[nodiscard]] RandomProgram randomProgram(uint32_t seed, Faults faults, const std::string& name);

} // namespace plc::golden
