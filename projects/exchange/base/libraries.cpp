#include "projects/exchange/base/libraries.h"

#include "projects/exchange/base/xml.h"
#include "runtime/base/text.h"
#include "runtime/compiler/driver/driver.h"

#include <algorithm>

namespace plc::exchange {

namespace {

struct Row {
    std::string_view theirs, ours; // folded; ours empty: always there
};
constexpr Row kRows[] = {
    {"standard", ""}, {"standard64", ""}, {"tc2_standard", ""}, {"tc3_standard", ""}, {"util", "util"}, {"iecsfc", ""},
};

} // namespace

void useLibrary(Imported& imported, const std::string& name, bool isSystem, const std::string& place) {
    std::string folded = foldCase(name.substr(0, name.find(',')));
    while (!folded.empty() && folded[0] == '#') folded.erase(0, 1);
    for (const Row& row : kRows) {
        if (row.theirs != folded) continue;
        if (!row.ours.empty()) imported.libraries.insert(std::string(row.ours));
        imported.coveredNamespaces.insert(trimmed(name.substr(0, name.find(','))));
        return;
    }
    const std::vector<std::string> ours = driver::libraryNames();
    if (std::find(ours.begin(), ours.end(), folded) != ours.end())
        imported.libraries.insert(folded);
    else if (!isSystem)
        imported.report.add(place, remarks::LibraryUnknown(name));
}

} // namespace plc::exchange
