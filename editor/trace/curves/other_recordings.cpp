#include "editor/trace/curves/other_recordings.h"

#include "editor/trace/curves/trace_plot.h"

#include <set>

namespace plc::trace {

void OtherRecordings::follow(const TraceSetup& setup, const Open& open) {
    std::set<std::string> wanted;
    for (const ChannelSetup& channel : setup.channels)
        if (!channel.recording.empty()) wanted.insert(channel.recording);
    std::erase_if(m_files, [&](const auto& file) { return !wanted.count(file.first); });
    for (const std::string& name : wanted) {
        File& file = m_files[name];
        if (!file.recording && file.problem.isEmpty()) {
            auto opened = open(name);
            if (!opened)
                file.problem = opened.error().message;
            else
                file.recording = std::move(*opened);
            if (file.recording) file.feed = std::make_unique<TraceFeed>(*file.recording, m_store);
        }
        if (file.feed) file.feed->setExpressions(expressionsOf(setup, name));
    }
}

const TraceFeed* OtherRecordings::feedOf(const std::string& file) const {
    const auto it = m_files.find(file);
    return it == m_files.end() ? nullptr : it->second.feed.get();
}

Message OtherRecordings::problemOf(const std::string& file) const {
    const auto it = m_files.find(file);
    return it == m_files.end() ? Message() : it->second.problem;
}

void OtherRecordings::pump(std::chrono::steady_clock::duration budget) {
    for (auto& [name, file] : m_files)
        if (file.feed) (void)file.feed->pump(budget);
}

void OtherRecordings::pumpAll() {
    for (auto& [name, file] : m_files)
        if (file.feed) file.feed->pumpAll();
}

} // namespace plc::trace
