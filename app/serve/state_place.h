// Where a served controller keeps what outlives it when nobody names a folder. Functions, any thread.
#pragma once
#include <filesystem>
#include <string>

namespace plc::serve {

/// What decides it besides the project.
struct Surroundings {
    std::filesystem::path installation; // what is below it belongs to the package; empty: unknown
    std::filesystem::path service;      // the folder that the service manager gives; empty: none
    std::filesystem::path user;         // states of this user's programs; empty: unknown
};
/// Of this process.
[[nodiscard]] Surroundings surroundings();

/// The service manager's folder; else .stepwise/serve in the project, unless that is part of an installation or cannot
/// be written to: then the user's, under the project's name and a mark of its folder.
[[nodiscard]] std::filesystem::path stateFolderOf(const std::filesystem::path& project, const Surroundings& around);

} // namespace plc::serve
