// What is in a file of an example, empty where there is none.
#pragma once
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace plc {

inline std::string textOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

} // namespace plc
