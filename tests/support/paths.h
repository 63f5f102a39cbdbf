// Where the checkout under test and its build lie. Only paths.cpp is compiled with these paths, so that the object
// files of all other tests are the same in every checkout and a compiler cache serves them all. Values, any thread.
#pragma once
#include <string>

namespace plc {

[[nodiscard]] std::string sourceDir(); // the root of the checkout, without a slash at its end
[[nodiscard]] std::string binaryDir(); // the build folder: build/dev

} // namespace plc
