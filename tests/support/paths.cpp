#include "tests/support/paths.h"

namespace plc {

std::string sourceDir() { return STEPWISE_SOURCE_DIR; }
std::string binaryDir() { return STEPWISE_BINARY_DIR; }

} // namespace plc
