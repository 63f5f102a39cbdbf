#include "runtime/library/sources.h"

#include <algorithm>

namespace plc::library {
namespace {

char toLower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool isSameName(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, toLower, toLower); }

} // namespace

std::span<const Source> sourcesOf(std::string_view library) {
    const auto all = sources();
    const auto matches = [&](const Source& source) { return isSameName(source.library, library); };
    const auto first = std::ranges::find_if(all, matches);
    const auto last = std::find_if_not(first, all.end(), matches);
    return {first, last};
}

std::vector<std::string_view> libraries() {
    std::vector<std::string_view> names;
    for (const Source& source : sources())
        if (names.empty() || names.back() != source.library) names.push_back(source.library);
    return names;
}

std::string namespaceOf(std::string_view library) {
    std::string name{library};
    std::ranges::transform(name, name.begin(), toLower);
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

} // namespace plc::library
