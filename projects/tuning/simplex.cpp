#include "projects/tuning/simplex.h"

#include <algorithm>

namespace plc::tuning {

namespace {

/// On the line from `from` through `to`: 1 is `to`.
std::vector<double> along(const std::vector<double>& from, const std::vector<double>& to, double share) {
    std::vector<double> out(from.size());
    for (size_t i = 0; i < out.size(); ++i) out[i] = from[i] + share * (to[i] - from[i]);
    return out;
}

} // namespace

Lowest leastOf(const std::function<double(const std::vector<double>&)>& function, const std::vector<double>& start,
               const std::vector<double>& steps, size_t evaluations) {
    const size_t size = start.size();
    size_t left = evaluations;
    const auto at = [&](std::vector<double> point) {
        left -= left > 0;
        const double value = function(point);
        return Lowest{std::move(point), value};
    };
    std::vector<Lowest> corners{at(start)};
    for (size_t i = 0; i < size; ++i) {
        std::vector<double> point = start;
        point[i] += steps[i];
        corners.push_back(at(std::move(point)));
    }
    const auto less = [](const Lowest& a, const Lowest& b) { return a.value < b.value; };
    while (left > 0) {
        std::sort(corners.begin(), corners.end(), less);
        Lowest& worst = corners.back();
        constexpr double kAlike = 1e-4;
        if (worst.value - corners.front().value <= kAlike * corners.front().value) break;
        std::vector<double> middle(size);
        for (size_t i = 0; i < size; ++i)
            for (size_t k = 0; k < size; ++k) middle[i] += corners[k].point[i] / static_cast<double>(size);
        const Lowest mirrored = at(along(worst.point, middle, 2));
        if (mirrored.value < corners.front().value) {
            const Lowest further = at(along(worst.point, middle, 3));
            worst = further.value < mirrored.value ? further : mirrored;
        } else if (mirrored.value < corners[size - 1].value) {
            worst = mirrored;
        } else {
            const bool isOutside = mirrored.value < worst.value;
            const Lowest nearer = at(along(worst.point, middle, isOutside ? 1.5 : 0.5));
            if (nearer.value < std::min(mirrored.value, worst.value)) {
                worst = nearer;
                continue;
            }
            for (size_t i = 1; i <= size; ++i) corners[i] = at(along(corners[0].point, corners[i].point, 0.5));
        }
    }
    return *std::min_element(corners.begin(), corners.end(), less);
}

} // namespace plc::tuning
