#include "app/serve/serve.h"

#include "app/serve/errors.h"
#include "app/serve/service_notes.h"
#include "runtime/platform/files.h"

#include <QCoreApplication>
#include <QRandomGenerator>

#include <cerrno>
#include <fstream>
#include <iostream>

namespace plc::serve {

namespace {

namespace fs = std::filesystem;
constexpr size_t kShortestCode = 8;

std::string tokenPath(const ServeSettings& settings) {
    return settings.tokenFile.empty() ? (fs::path(settings.stateFolder) / "access-code").string() : settings.tokenFile;
}

/// Letters and digits that are not mistaken for each other: 16 of 32 are 80 bits.
std::string newCode() {
    constexpr std::string_view kLetters = "abcdefghjkmnpqrstuvwxyz123456789";
    std::string out;
    for (int i = 0; i < 16; ++i)
        out += kLetters[QRandomGenerator::system()->bounded(static_cast<quint32>(kLetters.size()))];
    return out;
}

/// For its owner only.
Result<void> writeCode(const std::string& path, const std::string& code) {
    const int file = platform::openToWrite(path, platform::Existing::Refused, platform::Readers::OwnerOnly);
    const bool isWritten = file >= 0 && platform::writeAll(file, code + "\n");
    const int problem = errno;
    if (file >= 0) (void)platform::closeFile(file);
    if (!isWritten) return Error{errors::TokenNotRead(path, errors::ofSystem(problem)), {}};
    return {};
}

/// `isOurs`: made when it is missing.
Result<QByteArray> codeIn(const std::string& path, bool isOurs) {
    std::error_code ignored;
    if (isOurs && !fs::exists(path, ignored))
        if (auto written = writeCode(path, newCode()); !written) return written.error();
    std::ifstream file(path);
    std::string code;
    if (!file || !std::getline(file, code)) return Error{errors::TokenNotRead(path, errors::ofSystem(errno)), {}};
    while (!code.empty() && (code.back() == '\r' || code.back() == ' ')) code.pop_back();
    if (code.size() < kShortestCode) return Error{errors::TokenTooShort(path), {}};
    return QByteArray::fromStdString(code);
}

/// Whether scans go on: a watchdog restarts a controller that does not finish them.
class Liveness {
public:
    explicit Liveness(const image::CompiledProgram& program) {
        for (const image::Task& task : program.tasks)
            if (task.kind == image::TaskKind::Cyclic) m_longest = std::max(m_longest, 3 * task.interval);
    }
    bool isAlive(const session::Status& status, std::chrono::steady_clock::time_point now) {
        if (status.state != controller::State::Running || status.scans != m_scans) {
            m_scans = status.scans;
            m_since = now;
        }
        return now - m_since < m_longest;
    }

private:
    std::chrono::nanoseconds m_longest = std::chrono::seconds(5);
    uint64_t m_scans = ~uint64_t(0);
    std::chrono::steady_clock::time_point m_since{};
};

/// The outputs become safe; a scan that does not end is not waited for.
void stopOf(session::Session& session) {
    session.stop();
    for (int tries = 0; tries < 200 && session.status().state == controller::State::Running; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

} // namespace

Result<std::unique_ptr<StateFolder>> StateFolder::open(const std::string& folder) {
    std::error_code problem;
    fs::create_directories(fs::path(folder) / "recording", problem);
    if (problem) return Error{errors::StateNotWritable(folder), {}};
    const int lock = platform::lockFile((fs::path(folder) / "lock").string());
    if (lock < 0)
        return Error{errno == EWOULDBLOCK ? errors::StateInUse(folder) : errors::StateNotWritable(folder), {}};
    return std::unique_ptr<StateFolder>(new StateFolder(lock));
}

StateFolder::~StateFolder() { (void)platform::closeFile(m_lock); }

void Trial::watch(session::Session& session, std::chrono::nanoseconds length) {
    m_session = &session;
    m_length = length;
    session.controller().addObserver(*this);
}

bool Trial::isOver(const session::Status& now) const {
    return now.time >= m_length || now.state == controller::State::Fault;
}

void Trial::scanFinished(std::span<const std::byte>, uint64_t scan, std::chrono::nanoseconds time) {
    constexpr uint64_t kSeldom = 256; // often enough: a file holds many more
    if (m_session && time >= m_length) std::exchange(m_session, nullptr)->stop();
    if (m_ring && scan % kSeldom == 0) m_ring->letCatchUp();
}

std::string retainFileOf(const ServeSettings& settings) {
    return (fs::path(settings.stateFolder) / "retained").string();
}

Result<void> serve(const hmi::PanelProject& project, session::Session& session, const ServeSettings& settings,
                   const std::function<bool()>& isStopping) {
    const bool hasPeople = !project.people.isEmpty();
    LogIn logIn;
    if (hasPeople) {
        logIn = byPeople(project.people);
    } else {
        Result<QByteArray> code = codeIn(tokenPath(settings), settings.tokenFile.empty());
        if (!code) return code.error();
        logIn = byAccessCode(*code);
    }
    const std::string attachFile = (fs::path(settings.stateFolder) / "attach-code").string();
    const Result<QByteArray> attachCode = codeIn(attachFile, true);
    if (!attachCode) return attachCode.error();
    ServerSettings forServer = settings.server;
    forServer.attach = AttachSettings{*attachCode, settings.allowsBreakpoints};
    Server server(project, session, std::move(logIn), std::move(forServer));
    if (auto started = server.start(); !started) return started;
    std::unique_ptr<RecordingRing> ring;
    if (settings.recordingLimit > 0)
        ring = std::make_unique<RecordingRing>(
            session, RingSettings{fs::path(settings.stateFolder) / "recording", settings.recordingLimit,
                                  std::clamp<uint64_t>(settings.recordingLimit / 8, 1 << 16, uint64_t(8) << 20)});
    server.describeRecording = [&ring, devices = settings.devices](ServerFigures& figures) {
        if (devices) figures.devices = devices->status();
        if (!ring) return;
        const RecordingRing::Figures now = ring->figures();
        figures.recordingBytes = now.bytes;
        figures.recordingFiles = now.files;
        figures.recordingProblem = now.problem;
    };
    if (settings.trial && ring) settings.trial->waitFor(*ring);
    session.startThread({settings.trial ? session::Pace::Fastest : session::Pace::Real}, settings.realTime.has_value());
    if (settings.realTime) {
        for (const std::string& line : askForRealTime(*settings.realTime)) std::cout << line << "\n";
        session.start();
    }
    std::cout << "serving " << settings.server.name << " at " << server.url().toStdString() << "\n"
              << (hasPeople ? std::string("the users of hmi/people.json log in to operate")
                            : "the access code to operate is in " + tokenPath(settings))
              << "\n"
              << "the code to attach a studio is in " << attachFile << "\n"
              << "retained variables and the recording are in " << settings.stateFolder << std::endl;
    const ServiceNotes notes;
    notes.ready("serving " + settings.server.name);
    Liveness liveness(*session.program());
    QTimer watch, watchdog;
    QObject::connect(&watch, &QTimer::timeout, &watch, [&] {
        const bool isOver = settings.trial && settings.trial->isOver(session.status());
        if (isOver || isStopping()) QCoreApplication::quit();
    });
    QObject::connect(&watchdog, &QTimer::timeout, &watchdog, [&] {
        if (liveness.isAlive(session.status(), std::chrono::steady_clock::now())) notes.alive();
    });
    watch.start(100);
    if (notes.watchdog()) watchdog.start(std::chrono::duration_cast<std::chrono::milliseconds>(*notes.watchdog() / 3));
    QCoreApplication::exec();
    notes.stopping();
    stopOf(session);
    session.end(); // the outputs are safe and what is retained is written before the recording ends
    ring.reset();
    std::cout << "stopped after " << session.status().scans << " scans" << std::endl;
    return {};
}

} // namespace plc::serve
