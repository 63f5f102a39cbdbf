// The recording of a served controller on disk: files one after the other, each complete in itself, the oldest deleted
// when all together are larger than allowed. The newest is written again every second, so that a power cut costs one.
// The pieces with the scans that ended latest are kept beside them, however old. Has a thread of its own; the scan
// never waits for a disk. The session must outlive it.
#pragma once
#include "projects/session/session.h"

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>

namespace plc::serve {

struct RingSettings {
    std::filesystem::path folder;
    uint64_t limit = uint64_t(256) << 20; // bytes of all files
    uint64_t fileSize = uint64_t(8) << 20;
    std::chrono::milliseconds interval{1000};
    size_t worstFiles = 30; // of this start and of those before, together
};

class RecordingRing {
public:
    RecordingRing(const session::Session& session, RingSettings settings);
    ~RecordingRing(); // writes what is missing
    struct Figures {
        uint64_t bytes = 0, files = 0;
        std::string problem; // why the last write failed; empty: it did not
    };
    [[nodiscard]] Figures figures() const;
    /// The scans of a trial make in a second what real time makes in hours: the calling scan thread waits here while
    /// more than a file of it is not yet written.
    void letCatchUp();

private:
    void run(const std::stop_token& stop);
    void write();
    void begin(history::Position first);
    void deleteOldest();
    [[nodiscard]] bool isBehind() const;
    void keepWorst();
    void deleteOldestWorst();
    const session::Session& m_session;
    RingSettings m_settings;
    std::filesystem::path m_file;
    uint64_t m_number = 0, m_start = 0; // of files; of the first of this start
    std::set<uint64_t> m_kept;          // numbers of scans
    history::Position m_first = 0, m_written = 0;
    std::atomic<history::Position> m_tried = 0; // written, or refused by the disk
    std::atomic<bool> m_isHurried = false;
    mutable std::mutex m_mutex;
    std::condition_variable_any m_wake;
    Figures m_figures;
    std::jthread m_thread; // last: it uses the others
};

} // namespace plc::serve
