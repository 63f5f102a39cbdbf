// Values of a controller that runs the program which is edited, for the hints beside its lines. The server says what
// it wants to know and takes what is known; how they come is the owner's affair. Called by the server's thread.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace plc::lsp {

class LiveValues {
public:
    virtual ~LiveValues() = default;
    /// From now on these are asked for, in place of those before.
    virtual void want(std::vector<std::string> expressions) = 0;
    /// As ST writes it; nothing: not known, or not yet.
    [[nodiscard]] virtual std::optional<std::string> valueOf(const std::string& expression) const = 0;
    /// Another number whenever a value became another one.
    [[nodiscard]] virtual uint64_t revision() const = 0;
};

} // namespace plc::lsp
