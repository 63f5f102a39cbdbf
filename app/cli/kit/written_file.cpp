#include "app/cli/kit/written_file.h"

#include "app/cli/kit/errors.h"

#include <cerrno>
#include <filesystem>
#include <fstream>

namespace plc::cli {

Result<void> checkPlace(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return Error{errors::FileNotWritten(errors::IsAFolder()), path};
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (folder.empty() || std::filesystem::is_directory(folder, ignored)) return {};
    return Error{errors::NoFolderForFile(folder.string()), path};
}

Result<void> writeFile(const std::string& path, const std::string& text) {
    if (auto good = checkPlace(path); !good) return good;
    errno = 0;
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    if (!file) return Error{errors::FileNotWritten(errors::ofSystem(errno)), path};
    return {};
}

} // namespace plc::cli
