#include "projects/exchange/base/imported.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <cstring>

namespace plc::exchange {

std::string hashOf(const std::string& text) {
    uint64_t hash = 14695981039346656037ull; // FNV-1a
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    char out[17];
    std::snprintf(out, sizeof out, "%016llx", static_cast<unsigned long long>(hash));
    return out;
}

std::string fileNameOf(const std::string& name) {
    std::string out;
    for (const char c : name) out += std::strchr("/\\:*?\"<>|", c) || static_cast<unsigned char>(c) < 0x20 ? '_' : c;
    while (!out.empty() && (out.back() == '.' || out.back() == ' ')) out.pop_back();
    if (out.empty() || out[0] == '.') out = "_" + out;
    return out;
}

void addFile(Imported& imported, const std::string& folder, const std::string& name, std::string text) {
    const std::string stem = "src/" + (folder.empty() ? "" : folder + "/") + fileNameOf(name);
    std::string path = stem + ".st";
    const auto isTaken = [&] {
        return std::any_of(imported.files.begin(), imported.files.end(),
                           [&](const ImportedFile& file) { return equalsIgnoringCase(file.path, path); });
    };
    for (int number = 2; isTaken(); ++number) path = stem + "_" + std::to_string(number) + ".st";
    if (path != stem + ".st") imported.report.add(stem + ".st", remarks::NameInUse(name, path));
    imported.files.push_back({std::move(path), std::move(text), name});
}

} // namespace plc::exchange
