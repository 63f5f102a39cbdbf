// The texts of the libraries written in ST, as they lie in runtime/library/st, built into the binary.
// One folder is one library; its files hold no NAMESPACE wrapper: whoever loads them puts every POU and type
// of folder `toolbox` into the namespace `Toolbox` (likewise Standard, Util, Analog, Plant, Workshop).
// Constant data, readable from any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plc::library {

struct Source {
    std::string_view library;  ///< folder name: "standard", "toolbox", …
    std::string_view fileName; ///< "timers.st"
    std::string_view text;     ///< UTF-8
};

/// Every file of every library, ordered by library, then file name.
[[nodiscard]] std::span<const Source> sources();

/// The files of one library (name in any case), empty where there is none.
[[nodiscard]] std::span<const Source> sourcesOf(std::string_view library);

/// The names of the libraries, as folders spell them.
[[nodiscard]] std::vector<std::string_view> libraries();

/// "toolbox" -> "Toolbox".
[[nodiscard]] std::string namespaceOf(std::string_view library);

} // namespace plc::library
