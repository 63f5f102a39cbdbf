// What an attached studio or command line may ask of a controller that is served (D16): each request is checked, posted
// with its origin and answered once the scan has had it. Knows no sockets. Owned by the connection; one thread.
#pragma once
#include "projects/remote/journal_sender.h"
#include "projects/remote/scan_stream.h"
#include "projects/remote/state_json.h"

#include <future>
#include <set>

namespace plc::remote {

struct Rights {
    bool mayHalt = false; // breakpoints and steps
};

// What a door has not answered yet.
struct WaitingAnswer {
    Json answer;
    uint64_t scans = 0; // it has been carried out when so many were made
    std::chrono::steady_clock::time_point latest;
};
struct RequestedChange {
    Json id;
    Json values; // pairs of path and text, written before the new program's first scan
    std::future<std::shared_ptr<driver::Built>> building;
    std::shared_ptr<std::promise<controller::OnlineChangeReport>> entered;
    std::future<controller::OnlineChangeReport> report;
    bool isPosted = false;
};
struct RequestedFile {
    Json id;
    std::string file;
    std::future<Result<void>> saving;
    uint64_t sent = 0, size = 0;
    bool isReady = false;
};

class Door {
public:
    /// `origin`: who it is, for the journal.
    Door(session::Session& session, std::string origin, Rights rights);
    ~Door(); // buttons that are held are let go, breakpoints taken away
    Door(const Door&) = delete;
    Door& operator=(const Door&) = delete;

    /// Nothing: the answer comes later, with `due`.
    [[nodiscard]] std::optional<Json> answer(const Json& request);
    /// Answers that had to wait, and news for who follows.
    [[nodiscard]] std::vector<Json> due();
    /// Bytes for who follows: the scans since, or where the controller stands; empty: nothing new. What is too much for
    /// `most` bytes or 10 ms comes the next time; who is more than a second behind goes on with the newest.
    [[nodiscard]] std::string bytes(size_t most);
    void tell(const std::string& refusal) { m_refusals.push_back(refusal); }
    [[nodiscard]] const std::string& origin() const { return m_origin; }

private:
    Json list(const Json& request) const;
    Json values(const Json& request) const;
    Json write(const Json& request, bool isTogether);
    Result<session::Assignment> assignment(const Json& pair) const;
    Json force(const Json& request);
    Json unforce(const Json& request);
    Json press(const Json& request);
    Json reset(const Json& request);
    Json breakpoints(const Json& request);
    Json go(const Json& request);
    std::optional<Json> change(const Json& request);
    std::optional<Json> changeIsIn();
    std::optional<Json> fetch(const Json& request);
    std::optional<Json> fetchIsReady();
    [[nodiscard]] std::string nextPiece(size_t most);
    [[nodiscard]] std::string standingImage();
    std::optional<Json> afterScan(const Json& id);

    session::Session& m_session;
    std::string m_origin;
    Rights m_rights;
    std::set<std::string> m_held;
    bool m_haltsHere = false;
    std::vector<WaitingAnswer> m_waiting;
    std::vector<std::string> m_refusals;
    // who follows
    bool m_follows = false;
    ScanWriter m_writer;
    JournalSender m_journal;
    history::Position m_next = 0;
    uint64_t m_version = 0, m_haltSeen = 0;
    size_t m_events = 0;
    std::vector<std::byte> m_standing; // as it was sent
    std::string m_stateSent;
    std::chrono::steady_clock::time_point m_stateAt{};
    // long work
    std::optional<RequestedChange> m_change;
    std::optional<RequestedFile> m_fetch;
};

} // namespace plc::remote
