// `stepwise serve` below its command line: the controller in real time on its scan thread, the recording on disk, the
// server, until somebody asks it to stop. Main thread, an application object must exist.
#pragma once
#include "app/serve/real_time.h"
#include "app/serve/recording_ring.h"
#include "app/serve/server.h"

namespace plc::serve {

/// A session in virtual time: no faster than its recording gets to disk, and stopped at the scan with which the trial
/// is over. Must outlive the session.
class Trial final : public controller::ScanObserver {
public:
    /// Before the scan thread starts.
    void watch(session::Session& session, std::chrono::nanoseconds length);
    void waitFor(RecordingRing& ring) { m_ring = &ring; } // the same; the ring must outlive the scans
    [[nodiscard]] bool isOver(const session::Status& now) const;

private:
    void scanFinished(std::span<const std::byte> image, uint64_t scan, std::chrono::nanoseconds time) override;
    void programChanged(std::shared_ptr<const image::CompiledProgram>) override {}
    void eventHappened(const controller::Event&) override {}
    session::Session* m_session = nullptr; // none: over
    RecordingRing* m_ring = nullptr;       // none: nothing is recorded on disk
    std::chrono::nanoseconds m_length{};
};

struct ServeSettings {
    ServerSettings server;
    std::string stateFolder;                       // retained variables, access code, recording
    std::string tokenFile;                         // empty: "access-code" in the state folder, made when missing
    uint64_t recordingLimit = uint64_t(256) << 20; // 0: nothing is recorded on disk
    std::optional<RealTimeWishes> realTime;
    bool allowsBreakpoints = false; // for attached studios
    /// Virtual time as fast as the machine can, and the end after that much of it; none: real time.
    std::optional<std::chrono::nanoseconds> trialLength;
    Trial* trial = nullptr;                   // which watches the session when there is a length
    const devices::Engine* devices = nullptr; // none are connected
};

/// The state folder, created when missing, for this process alone as long as this lives.
class StateFolder {
public:
    [[nodiscard]] static Result<std::unique_ptr<StateFolder>> open(const std::string& folder);
    ~StateFolder();
    StateFolder(const StateFolder&) = delete;
    StateFolder& operator=(const StateFolder&) = delete;

private:
    explicit StateFolder(int lock) : m_lock(lock) {}
    int m_lock;
};
[[nodiscard]] std::string retainFileOf(const ServeSettings& settings);
/// Serves until `isStopping`; says on stdout where, once it can be reached.
[[nodiscard]] Result<void> serve(const hmi::PanelProject& project, session::Session& session,
                                 const ServeSettings& settings, const std::function<bool()>& isStopping);

} // namespace plc::serve
