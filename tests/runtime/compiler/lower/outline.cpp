#include "tests/runtime/compiler/parse/outline.cpp" // NOLINT: the outline serves both test programs
