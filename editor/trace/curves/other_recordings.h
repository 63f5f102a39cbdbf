// Recordings and tables that single channels are read from, beside the one that is shown: measured values beside live
// ones. Opens what a set-up names and keeps why one could not be opened. Owned by the trace view; its thread.
#pragma once

#include "editor/trace/curves/trace_feed.h"
#include "editor/trace/recording/run_recording.h"
#include "editor/trace/setup/trace_setup.h"

#include <functional>

namespace plc::trace {

class OtherRecordings {
public:
    using Open = std::function<Result<std::shared_ptr<RunRecording>>(const std::string& file)>;
    explicit OtherRecordings(std::shared_ptr<history::ColumnStore> store) : m_store(std::move(store)) {}

    /// Opens the files that channels name and lets go of the others.
    void follow(const TraceSetup& setup, const Open& open);
    /// Null where the file is not open; its problem then says why.
    [[nodiscard]] const TraceFeed* feedOf(const std::string& file) const;
    [[nodiscard]] Message problemOf(const std::string& file) const;
    [[nodiscard]] bool isEmpty() const { return m_files.empty(); }
    void pump(std::chrono::steady_clock::duration budget);
    void pumpAll();

private:
    struct File {
        std::shared_ptr<RunRecording> recording;
        std::unique_ptr<TraceFeed> feed; // reads the recording: gone before it
        Message problem;
    };
    std::shared_ptr<history::ColumnStore> m_store;
    std::map<std::string, File> m_files;
};

} // namespace plc::trace
