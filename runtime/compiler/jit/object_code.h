// Optimised code as an object file, for a program that is linked instead of loaded. Any thread.
#pragma once
#include "runtime/compiler/codegen/codegen.h"

#include <string>

namespace plc::jit {

/// A machine other than this one, and bytes that go with the code: the constant `dataName`, its length in
/// `dataName`_size.
struct ObjectFor {
    std::string triple; // "aarch64-linux-gnu"
    std::string cpu;    // "generic"
    std::string dataName;
    std::string data;
};
/// The optimised tier as an object file, the same code as compile() makes but for the machine. Its entries are in the
/// table "plc.entries.0"; it calls what the runner defines (runtime/runner/code_symbols.cpp).
[[nodiscard]] Result<std::string> compileObject(const tree::Program& program, const ObjectFor& wanted);

} // namespace plc::jit
