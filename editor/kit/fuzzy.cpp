#include "editor/kit/fuzzy.h"

#include <algorithm>
#include <limits>

namespace plc::kit {

namespace {

bool startsWord(QStringView name, qsizetype at) {
    if (at == 0) return true;
    const QChar before = name[at - 1], here = name[at];
    return !before.isLetterOrNumber() || (before.isLower() && here.isUpper()) || (before.isLetter() && here.isDigit());
}

} // namespace

std::optional<FuzzyMatch> fuzzyMatch(QStringView pattern, QStringView name) {
    QString letters;
    for (QChar c : pattern)
        if (!c.isSpace()) letters += c.toLower();
    const int n = static_cast<int>(letters.size()), m = static_cast<int>(name.size());
    if (n == 0) return FuzzyMatch{};
    if (n > m) return std::nullopt;

    // best[i][j]: score of matching the first i+1 letters with letter i placed at j.
    constexpr int None = std::numeric_limits<int>::min() / 2;
    std::vector<int> best(static_cast<size_t>(n) * m, None), from(static_cast<size_t>(n) * m, -1);
    auto at = [m](int i, int j) { return static_cast<size_t>(i) * m + j; };
    for (int i = 0; i < n; ++i) {
        int running = None, runningFrom = -1; // best of the row above, some way to the left
        for (int j = i; j < m; ++j) {
            if (i > 0 && j >= 1) {
                const int above = best[at(i - 1, j - 1)];
                if (above > running) {
                    running = above;
                    runningFrom = j - 1;
                }
            }
            if (name[j].toLower() != letters[i]) continue;
            const int place = (startsWord(name, j) ? 10 : 0) + (j == 0 ? 6 : 0);
            if (i == 0) {
                best[at(i, j)] = 4 + place - std::min(j, 8);
                continue;
            }
            const int touching = best[at(i - 1, j - 1)];
            if (touching > None && touching + 8 >= running - 2) {
                best[at(i, j)] = touching + 4 + 8 + place / 2;
                from[at(i, j)] = j - 1;
            } else if (running > None) {
                best[at(i, j)] = running + 4 + place - 2;
                from[at(i, j)] = runningFrom;
            }
        }
    }
    int end = -1;
    for (int j = 0; j < m; ++j)
        if (best[at(n - 1, j)] > None && (end < 0 || best[at(n - 1, j)] > best[at(n - 1, end)])) end = j;
    if (end < 0) return std::nullopt;
    FuzzyMatch match;
    match.score = best[at(n - 1, end)] - m / 8;
    for (int i = n - 1, j = end; i >= 0; --i) {
        match.positions.push_back(j);
        j = from[at(i, j)];
    }
    std::reverse(match.positions.begin(), match.positions.end());
    return match;
}

} // namespace plc::kit
