// Fuzzy match of what a person types against a name: letters in order, best where words begin and letters touch.
// Pure functions, any thread.
#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace plc::kit {

struct FuzzyMatch {
    int score = 0;
    std::vector<int> positions; // of the matched letters in the name
};

/// Nothing when some letter of `pattern` does not occur in order. An empty pattern matches with score 0. Case is
/// ignored; blanks in the pattern separate parts that may match anywhere after one another.
std::optional<FuzzyMatch> fuzzyMatch(QStringView pattern, QStringView name);

} // namespace plc::kit
