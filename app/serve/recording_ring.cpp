#include "app/serve/recording_ring.h"

#include <algorithm>

namespace plc::serve {

namespace {

namespace fs = std::filesystem;
constexpr const char* kEnding = ".rec";

/// "00000042.rec": by number, oldest first.
std::vector<std::pair<uint64_t, fs::path>> files(const fs::path& folder) {
    std::vector<std::pair<uint64_t, fs::path>> out;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string stem = entry.path().stem().string();
        const bool isNumber =
            !stem.empty() && std::all_of(stem.begin(), stem.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (entry.path().extension() != kEnding || !isNumber || stem.size() > 18) continue;
        out.emplace_back(std::stoull(stem), entry.path());
    }
    std::sort(out.begin(), out.end());
    return out;
}

uint64_t sizeOf(const fs::path& file) {
    std::error_code problem;
    const uint64_t size = fs::file_size(file, problem);
    return problem ? 0 : size;
}

} // namespace

RecordingRing::RecordingRing(const session::Session& session, RingSettings settings)
    : m_session(session), m_settings(std::move(settings)) {
    const auto known = files(m_settings.folder);
    if (!known.empty()) m_number = known.back().first;
    begin(0);
    m_start = m_number;
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

RecordingRing::~RecordingRing() {
    m_thread.request_stop();
    m_thread.join();
    write();
}

RecordingRing::Figures RecordingRing::figures() const {
    const std::lock_guard lock(m_mutex);
    return m_figures;
}

void RecordingRing::begin(history::Position first) {
    std::string name = std::to_string(++m_number);
    name.insert(0, name.size() < 8 ? 8 - name.size() : 0, '0');
    m_file = m_settings.folder / (name + kEnding);
    m_first = first;
}

void RecordingRing::run(const std::stop_token& stop) {
    std::mutex waiting;
    std::unique_lock lock(waiting);
    std::chrono::steady_clock::duration wait = m_settings.interval;
    while (!stop.stop_requested()) {
        m_wake.wait_for(lock, stop, wait, [this] { return m_isHurried.exchange(false); });
        if (stop.stop_requested()) return;
        const auto begin = std::chrono::steady_clock::now();
        write();
        // A slow disk, or very much to write, gets a fifth of the time at most.
        wait = std::max<std::chrono::steady_clock::duration>(m_settings.interval,
                                                             4 * (std::chrono::steady_clock::now() - begin));
    }
}

void RecordingRing::write() {
    const history::Position end = m_session.history().statistics().end;
    if (end == m_written) return;
    const Result<history::Position> saved = m_session.history().saveRange(m_file.string(), {m_first, end});
    m_tried = end;
    if (saved) {
        m_written = end;
        // A piece of the recording is in one file as a whole: the next file begins with the one that still grows.
        if (sizeOf(m_file) >= m_settings.fileSize && *saved > m_first) begin(*saved);
        deleteOldest();
    }
    keepWorst();
    const std::lock_guard lock(m_mutex);
    m_figures.problem = saved ? std::string() : saved.error().english();
}

/// By the bytes of an average scan.
bool RecordingRing::isBehind() const {
    const history::Statistics now = m_session.history().statistics();
    const history::Position tried = m_tried;
    if (now.end <= tried || now.end <= now.first) return false;
    const double perScan = static_cast<double>(now.bytes) / static_cast<double>(now.end - now.first);
    return perScan * static_cast<double>(now.end - tried) > static_cast<double>(m_settings.fileSize);
}

void RecordingRing::letCatchUp() {
    while (isBehind()) {
        m_isHurried = true;
        m_wake.notify_one();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// One file a second at most: of the first scans after a start each is among the worst for a while.
void RecordingRing::keepWorst() {
    const fs::path folder = m_settings.folder / "worst";
    const auto fileOf = [&](uint64_t scan) {
        return folder / (std::to_string(m_start) + "-scan-" + std::to_string(scan) + kEnding);
    };
    std::set<uint64_t> worst;
    for (const session::ScanTime& each : m_session.scanTimes().worst) worst.insert(each.scan);
    std::error_code ignored;
    for (auto it = m_kept.begin(); it != m_kept.end();) {
        if (!worst.contains(*it)) fs::remove(fileOf(*it), ignored);
        it = worst.contains(*it) ? std::next(it) : m_kept.erase(it);
    }
    const auto fresh = std::find_if(worst.begin(), worst.end(), [&](uint64_t scan) { return !m_kept.contains(scan); });
    if (fresh == worst.end()) return;
    m_kept.insert(*fresh); // also when it cannot be written: it is not tried for ever
    const auto position = m_session.history().positionOfScan(*fresh);
    if (!position) return;
    fs::create_directories(folder, ignored);
    (void)m_session.history().saveRange(fileOf(*fresh).string(), {*position, *position + 1});
    deleteOldestWorst();
}

/// Those of earlier starts: the ones of this start are few, and go by themselves.
void RecordingRing::deleteOldestWorst() {
    const std::string ours = std::to_string(m_start) + "-";
    std::vector<std::pair<fs::file_time_type, fs::path>> all;
    std::error_code ignored;
    size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(m_settings.folder / "worst", ignored)) {
        if (entry.path().extension() != kEnding) continue;
        ++count;
        if (!entry.path().filename().string().starts_with(ours))
            all.emplace_back(entry.last_write_time(ignored), entry);
    }
    std::sort(all.begin(), all.end());
    for (auto it = all.begin(); it != all.end() && count > m_settings.worstFiles; ++it, --count)
        fs::remove(it->second, ignored);
}

void RecordingRing::deleteOldest() {
    auto known = files(m_settings.folder);
    uint64_t bytes = 0;
    for (const auto& [number, path] : known) bytes += sizeOf(path);
    while (bytes > m_settings.limit && known.size() > 1) {
        std::error_code ignored;
        bytes -= std::min(bytes, sizeOf(known.front().second));
        fs::remove(known.front().second, ignored);
        known.erase(known.begin());
    }
    const std::lock_guard lock(m_mutex);
    m_figures.bytes = bytes;
    m_figures.files = known.size();
}

} // namespace plc::serve
