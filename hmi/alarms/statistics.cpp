#include "hmi/alarms/statistics.h"

#include <algorithm>
#include <deque>
#include <map>

namespace plc::hmi {

namespace {

constexpr size_t kMost = 10;

std::vector<AlarmCount> sorted(const std::map<QString, int>& counts, size_t most) {
    std::vector<AlarmCount> out;
    for (const auto& [alarm, count] : counts)
        if (count > 0) out.push_back({alarm, count});
    std::stable_sort(out.begin(), out.end(),
                     [](const AlarmCount& a, const AlarmCount& b) { return a.count > b.count; });
    if (out.size() > most) out.resize(most);
    return out;
}

/// Ten new alarms within ten minutes begin a flood; it ends where fewer than half as many came within that span.
std::vector<AlarmFlood> floodsOf(const std::vector<Nanoseconds>& raised, Nanoseconds to, const AlarmLimits& limits) {
    std::vector<AlarmFlood> out;
    std::deque<Nanoseconds> window;
    bool isFlood = false;
    const auto leave = [&](Nanoseconds now) {
        while (!window.empty() && now - window.front() >= limits.floodSpan) {
            const Nanoseconds gone = window.front() + limits.floodSpan;
            window.pop_front();
            if (!isFlood || static_cast<int>(window.size()) * 2 >= limits.floodCount) continue;
            out.back().to = gone;
            isFlood = false;
        }
    };
    for (const Nanoseconds at : raised) {
        leave(at);
        window.push_back(at);
        if (isFlood) ++out.back().count;
        if (isFlood || static_cast<int>(window.size()) < limits.floodCount) continue;
        out.push_back({window.front(), to, static_cast<int>(window.size())});
        isFlood = true;
    }
    leave(to);
    return out;
}

/// How often `count` raises of one alarm fell within the span, each raise counted once.
int chatterOf(const std::vector<Nanoseconds>& raised, const AlarmLimits& limits) {
    int out = 0;
    for (size_t begin = 0; begin < raised.size();) {
        size_t end = begin;
        while (end < raised.size() && raised[end] - raised[begin] < limits.chatterSpan) ++end;
        if (static_cast<int>(end - begin) < limits.chatterCount) {
            ++begin;
            continue;
        }
        ++out;
        begin = end;
    }
    return out;
}

} // namespace

AlarmStatistics statisticsOf(std::vector<AlarmRecord> records, Nanoseconds from, Nanoseconds to,
                             const AlarmLimits& limits) {
    AlarmStatistics out;
    out.from = from;
    out.to = std::max(from, to);
    std::stable_sort(records.begin(), records.end(),
                     [](const AlarmRecord& a, const AlarmRecord& b) { return a.at.time < b.at.time; });
    std::map<QString, int> counts, chatter;
    std::map<QString, std::vector<Nanoseconds>> raisedBy;
    std::map<QString, std::optional<Nanoseconds>> active, open; // since when; open: not acknowledged
    std::vector<Nanoseconds> raised;
    Nanoseconds waited{};
    for (const AlarmRecord& record : records) {
        if (record.at.time > out.to) break;
        const bool isInside = record.at.time >= from;
        switch (record.kind) {
        case AlarmEventKind::Raised:
            active[record.alarm] = record.at.time;
            open[record.alarm] = record.at.time;
            if (!isInside) break;
            ++counts[record.alarm];
            raisedBy[record.alarm].push_back(record.at.time);
            raised.push_back(record.at.time);
            break;
        case AlarmEventKind::Returned:
            active[record.alarm].reset();
            break;
        case AlarmEventKind::Acknowledged:
            if (auto& since = open[record.alarm]; since && isInside) {
                ++out.acknowledged;
                waited += record.at.time - *since;
                since.reset();
            }
            break;
        }
    }
    out.raised = static_cast<int>(raised.size());
    const double hours = std::chrono::duration<double, std::ratio<3600>>(out.to - from).count();
    if (hours > 0) out.perHour = out.raised / hours;
    if (out.acknowledged > 0)
        out.secondsToAcknowledge = std::chrono::duration<double>(waited).count() / out.acknowledged;
    out.floods = floodsOf(raised, out.to, limits);
    Nanoseconds flooded{};
    for (const AlarmFlood& flood : out.floods) flooded += flood.to - flood.from;
    if (out.to > from)
        out.shareInFlood = static_cast<double>(flooded.count()) / static_cast<double>((out.to - from).count());
    for (const auto& [alarm, times] : raisedBy) chatter[alarm] = chatterOf(times, limits);
    out.mostFrequent = sorted(counts, kMost);
    out.chattering = sorted(chatter, chatter.size());
    for (const auto& [alarm, since] : active)
        if (since && out.to - *since >= limits.standing) out.standing.push_back(alarm);
    return out;
}

} // namespace plc::hmi
