#include "editor/debug/run_control.h"

#include "editor/debug/fault_scan.h"
#include "editor/debug/line_map.h"
#include "editor/kit/errors.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "editor/kit/texts.h"
#include "projects/session/value_text.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/debug/sites.h"

#include <QDir>

#include <algorithm>
#include <mutex>
#include <set>

namespace plc::editor {

namespace {
constexpr int kFrameMs = 33;
/// The controls that live: another thread may let go of what it holds when the window is gone already.
class LivingControls {
public:
    static LivingControls& all() {
        static LivingControls instance;
        return instance;
    }
    void add(RunControl& control) {
        const std::lock_guard lock(m_mutex);
        m_controls.insert(&control);
    }
    void remove(RunControl& control) {
        const std::lock_guard lock(m_mutex);
        m_controls.erase(&control);
    }
    /// On the control's thread, and not at all if it is gone.
    template <class Call> void post(RunControl* control, Call call) {
        const std::lock_guard lock(m_mutex);
        if (m_controls.count(control)) kit::post(control, std::move(call));
    }

private:
    std::mutex m_mutex;
    std::set<const RunControl*> m_controls;
};
} // namespace

RunControl::RunControl(Workspace& workspace, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_faultScan(std::make_unique<FaultScan>(*this)) {
    LivingControls::all().add(*this);
    m_timer.setInterval(kFrameMs);
    connect(&m_timer, &QTimer::timeout, this, &RunControl::tick);
    followWorkspace();
    connect(&m_archive, &RunArchive::failed, this,
            [this](const QString& message) { emit messageAdded(message, true); });
}

void RunControl::followWorkspace() {
    const auto keepThere = [this] {
        const QString folder = m_workspace.folder();
        m_archive.setFolder(folder.isEmpty() ? QString() : folder + "/.stepwise/runs");
    };
    connect(&m_workspace, &Workspace::opened, this, keepThere);
    connect(&m_workspace, &Workspace::closed, this, &RunControl::disconnectSession);
    keepThere();
}

RunControl::~RunControl() {
    LivingControls::all().remove(*this);
    if (m_building) m_building->cancel();
    if (m_builder.joinable()) m_builder.join();
}

bool RunControl::isRunning() const {
    return m_session && (m_status.state == controller::State::Running || m_status.state == controller::State::Paused ||
                         m_status.state == controller::State::Halted);
}

QString RunControl::retainFile() const {
    return m_workspace.folder().isEmpty() ? QString() : m_workspace.folder() + "/.stepwise/retain.json";
}

// ------------------------------------------------------------------ building

void RunControl::buildAside(std::function<void(std::shared_ptr<driver::Built>)> then) {
    m_building = std::make_shared<Progress>();
    emit buildStarted();
    emit workBegan(tr("Building"), m_building);
    if (m_builder.joinable()) m_builder.join();
    // not what the editor checked: that holds the tests as well, and would have another layout
    if (!m_built) m_built = std::make_shared<driver::KeptFiles>();
    m_builder = std::thread(
        [this, progress = m_building, kept = m_built, input = m_workspace.buildInput(), then = std::move(then)] {
            QElapsedTimer clock;
            clock.start();
            const driver::Checked checked = driver::check(input, *kept);
            const auto checkMs = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
            auto built = std::make_shared<driver::Built>(driver::build(checked, input, progress.get()));
            driver::nameReferences(*built); // `checked` is this build's alone
            built->checkMs = checkMs;
            const auto finish = [this, progress, built, then] {
                m_building = nullptr;
                emit workEnded(progress);
                if (progress->isCancelled()) return emit buildCancelled();
                then(built);
            };
            kit::post(this, [this, finish] { m_hold.expired() ? finish() : m_afterHold.push_back(finish); });
        });
}

void RunControl::build(std::function<void(bool)> then) {
    if (m_building || !m_workspace.isOpen()) return;
    buildAside([this, then = std::move(then)](const std::shared_ptr<driver::Built>& built) {
        const bool good = built->program != nullptr;
        size_t errors = 0;
        for (const diagnostics::Diagnostic& d : built->checked.analysis->diagnostics)
            errors += d.severity == diagnostics::Severity::Error;
        const bool isElsewhere = m_session && m_session->isMirror(); // a build is no reason to leave it
        if (good && !isElsewhere) adopt(built);
        emit buildFinished(good, good ? tr("Built in %1 ms").arg(built->checkMs + built->codeMs, 0, 'f', 0)
                                 : !built->failure.isEmpty()
                                     ? kit::messageText(built->failure)
                                     : tr("%n error(s): the program was not built", nullptr, static_cast<int>(errors)));
        if (then) then(good);
    });
}

RunControl::Hold RunControl::hold() {
    if (auto held = m_hold.lock()) return held;
    const Hold made(this, [](RunControl* self) {
        LivingControls::all().post(self, [self] {
            for (const auto& each : std::exchange(self->m_afterHold, {})) each();
        });
    });
    m_hold = made;
    return made;
}

void RunControl::watchOptimising(std::shared_ptr<Progress> now) {
    if (now == m_optimising) return;
    const std::shared_ptr<Progress> before = std::exchange(m_optimising, std::move(now));
    if (before) {
        emit workEnded(before);
        if (before->isCancelled()) emit messageAdded(tr("Not optimised: the quick code keeps running"), false);
    }
    if (m_optimising) emit workBegan(tr("Optimising"), m_optimising);
}

void RunControl::change(const driver::Built& built, const WritesFor& writes) {
    m_session->changeProgram(
        built,
        [this](const controller::OnlineChangeReport& report) {
            const QString summary = tr("Online change: %1 kept, %2 new, %3 lost")
                                        .arg(report.kept.size())
                                        .arg(report.initialised.size())
                                        .arg(report.lost.size());
            kit::post(this, [this, summary] { emit onlineChangeFinished(summary); });
        },
        breakpointsFor(*built.program), writes ? writes(*built.program) : session::Together());
}

void RunControl::adopt(std::shared_ptr<driver::Built> built) {
    (void)m_shown.view(std::nullopt);
    session::Settings settings;
    settings.historyBudget = m_historyBudget;
    if (!retainFile().isEmpty()) {
        QDir().mkpath(m_workspace.folder() + "/.stepwise");
        settings.retainFile = retainFile().toStdString();
    }
    endSession();
    m_session = std::make_unique<session::Session>(*built, settings);
    m_shown.setLive(m_session.get());
    m_haltsSeen = 0;
    postBreakpoints();
    m_timer.start();
    tick();
    emit sessionChanged();
}

void RunControl::showElsewhere(std::unique_ptr<session::Session> mirror) {
    if (m_building) m_building->cancel();
    leaveRecorded();
    if (!mirror) return disconnectSession();
    endSession();
    m_shown.clear();
    m_session = std::move(mirror);
    m_shown.setLive(m_session.get());
    m_haltsSeen = 0;
    m_timer.start();
    tick();
    emit sessionChanged();
}

void RunControl::endSession() {
    if (!m_session) return;
    m_isEnding = true;
    emit sessionAboutToEnd();
    m_isEnding = false;
    m_frames.clear(); // they are the session's
    if (m_optimising) emit workEnded(std::exchange(m_optimising, nullptr));
    m_shown.setLive(nullptr);
    m_archive.keep(std::move(m_session));
}

void RunControl::setHistoryBudget(size_t bytes) {
    m_historyBudget = bytes;
    if (m_session) m_session->history().setBudget(bytes);
}

void RunControl::disconnectSession() {
    if (m_building) m_building->cancel();
    m_timer.stop();
    endSession();
    m_shown.clear();
    m_status = {};
    emit sessionChanged();
    emit statusChanged();
    emit refreshed();
}

void RunControl::announce() {
    if (m_building) emit workBegan(tr("Building"), m_building);
    if (m_optimising) emit workBegan(tr("Optimising"), m_optimising);
    emit breakpointsChanged();
    emit statusChanged();
    emit viewedChanged();
    emit refreshed();
}

// ------------------------------------------------------------------ a recording in the place of the controller

void RunControl::showRecorded(std::shared_ptr<const session::RecordedRun> recorded, const QString& name) {
    m_shown.setRecorded(std::move(recorded), name);
    emit viewedChanged();
    emit statusChanged();
    emit refreshed();
}

void RunControl::leaveRecorded() {
    if (!showsRecorded()) return;
    emit recordedMustClose();
    if (showsRecorded()) showRecorded(nullptr);
}

// ------------------------------------------------------------------ commands

void RunControl::start() {
    leaveRecorded();
    view(std::nullopt);
    if (m_session && m_status.state == controller::State::Halted) return resume();
    startThen(false, {});
}

/// Goes on with the controller as it stands; builds when there is none, after a fault and where the text has changed.
void RunControl::startThen(bool paused, std::function<void()> then) {
    const bool stands = m_session && (m_session->isMirror() || m_status.state == controller::State::Paused ||
                                      (m_status.state == controller::State::Stopped && isUpToDate()));
    if (stands) {
        m_session->startThread(m_mode, paused);
        if (then) then();
        return tick();
    }
    build([this, paused, then = std::move(then)](bool good) {
        if (good) m_session->startThread(m_mode, paused);
        if (good && then) then();
        tick();
    });
}

bool RunControl::isUpToDate() const {
    if (!m_session || !m_session->built().input) return false;
    const driver::BuildInput &built = *m_session->built().input, now = m_workspace.buildInput();
    return built.libraries == now.libraries &&
           std::equal(built.files.begin(), built.files.end(), now.files.begin(), now.files.end(),
                      [](const driver::SourceFile& a, const driver::SourceFile& b) {
                          return a.path == b.path && a.text == b.text;
                      });
}

void RunControl::pause() {
    m_pausedToLook = false; // it is meant to stand
    if (m_session) m_session->pause();
}
void RunControl::stop() {
    m_pausedToLook = false;
    if (m_session) m_session->stop();
}
void RunControl::resume() {
    if (m_session) m_session->resume();
}
void RunControl::reset(controller::ResetKind kind) {
    m_pausedToLook = false;
    leaveRecorded();
    view(std::nullopt);
    if (m_session) m_session->reset(kind);
}

void RunControl::singleScan() {
    m_pausedToLook = false;
    leaveRecorded();
    view(std::nullopt);
    if (m_session && isRunning()) return m_session->singleScan();
    startThen(true, [this] { m_session->singleScan(); });
}

void RunControl::step(session::Step kind) {
    m_pausedToLook = false;
    leaveRecorded();
    view(std::nullopt);
    if (isRunning()) return m_session->step(kind);
    startThen(true, [this] { m_session->step(session::Step::In); }); // to the first statement
}

void RunControl::runTo(const QString& file, int line) {
    leaveRecorded();
    view(std::nullopt);
    const auto go = [this, file, line] {
        const auto program = m_session->program();
        const FileId id = debug::fileOfPath(*program, file.toStdString());
        uint32_t wanted = 0;
        if (id.isValid()) {
            const SourceText& built = program->sources[id];
            wanted = static_cast<uint32_t>(LineMap(textNow()(file, built), built.text()).nearest(line));
        }
        if (debug::sitesOfLine(*program, id, wanted).sites.empty())
            emit messageAdded(
                tr("There is no code at or below line %1 of %2; choose an earlier line").arg(line).arg(file), true);
        else
            m_session->runTo(id, wanted);
    };
    if (isRunning()) return go();
    startThen(true, go);
}

void RunControl::onlineChange(WritesFor writes) {
    if (!isRunning()) return start();
    if (m_building) return;
    buildAside([this, writes = std::move(writes)](const std::shared_ptr<driver::Built>& built) {
        if (built->program && m_session)
            change(*built, writes);
        else if (built->program)
            adopt(built); // it was let go meanwhile
        emit buildFinished(built->program != nullptr,
                           built->program
                               ? tr("The change waits for the end of the scan")
                               : tr("The program has errors; the controller continues with the old program"));
    });
}

void RunControl::setMode(session::RunMode mode) {
    m_mode = mode;
    if (m_session) m_session->setMode(mode);
    emit statusChanged();
}

// ------------------------------------------------------------------ breakpoints

void RunControl::setBreakpoints(std::vector<EditorBreakpoint> breakpoints) {
    m_breakpoints.set(std::move(breakpoints));
    postBreakpoints();
    emit breakpointsChanged();
}

void RunControl::toggleBreakpoint(const QString& file, int line) {
    m_breakpoints.toggle(file, line);
    postBreakpoints();
    emit breakpointsChanged();
}

void RunControl::moveBreakpoints(const QString& file, const std::map<int, int>& lines) {
    if (m_breakpoints.move(file, lines)) emit breakpointsChanged();
}

void RunControl::postBreakpoints() {
    if (!m_session) return;
    m_session->setBreakpoints(breakpointsFor(*m_session->program()));
}

TextNow RunControl::textNow() const {
    return [this](const QString& file, const SourceText& built) {
        return m_workspace.files().contains(file) ? m_workspace.text(file) : std::string(built.text());
    };
}

std::vector<session::Breakpoint> RunControl::breakpointsFor(const image::CompiledProgram& program) {
    const std::vector<EditorBreakpoint> before = breakpoints();
    std::vector<session::Breakpoint> posted = m_breakpoints.forProgram(program, textNow());
    if (before != breakpoints()) {
        moveBreakpoints({}, {}); // two may have come to one line
        kit::post(this, [this] { emit breakpointsChanged(); });
    }
    return posted;
}

std::optional<RunControl::TextPlace> RunControl::placeInText(SourceRange range) const {
    if (!m_session) return std::nullopt;
    return placeInText(range, *m_session->program());
}

std::optional<RunControl::TextPlace> RunControl::placeInText(SourceRange range,
                                                             const image::CompiledProgram& program) const {
    return editor::placeInText(range, program, textNow());
}

// ------------------------------------------------------------------ the 30 Hz look

void RunControl::tick() {
    if (!m_session) return;
    const session::Status before = std::exchange(m_status, m_session->status());
    m_shown.takeSample(m_status.state == controller::State::Running);
    if (!m_status.retainProblem.isEmpty() && !(m_status.retainProblem == before.retainProblem))
        emit messageAdded(kit::messageText(m_status.retainProblem), true);
    for (const Error& refusal : m_session->takeRefusals()) emit messageAdded(kit::messageText(refusal), true);
    std::set<std::string> forced;
    for (const controller::Forced& each : m_session->forces()) forced.insert(foldCase(each.path));
    m_shown.setForced(std::move(forced));
    watchOptimising(m_session->optimising());
    if (m_status.state == controller::State::Halted)
        m_frames = m_session->haltFrames();
    else
        m_frames.clear();
    if (!viewed() && !showsRecorded()) m_shown.refresh();
    tellChange(before);
    emit refreshed();
}

void RunControl::tellChange(const session::Status& before) {
    // A step may end before anybody looked: halts are counted.
    const bool haltedAgain = m_status.state == controller::State::Halted && m_status.halts != m_haltsSeen;
    if (haltedAgain) m_haltsSeen = m_status.halts;
    if (before.state != m_status.state || haltedAgain || before.scans != m_status.scans) emit statusChanged();
    if (haltedAgain) tellHalt();
}

void RunControl::tellHalt() {
    for (size_t i = m_frames.size(); i-- > 0;) // the text shows the instances of the call path
        if (!m_frames[i].instance.empty())
            m_instances.prefer(kit::fromView(m_frames[i].function).section('.', 0, 0),
                               kit::fromView(m_frames[i].instance));
    if (const Message problem = m_session->haltProblem(); !problem.isEmpty())
        emit messageAdded(tr("The condition of the breakpoint: %1").arg(kit::messageText(problem)), true);
    emit halted();
}

// ------------------------------------------------------------------ values

void RunControl::setPreferredInstance(const QString& pou, const QString& instance) {
    m_instances.prefer(pou, instance);
    emit refreshed();
}

std::optional<RunControl::Shown> RunControl::localOf(size_t frame, const QString& name) const {
    if (!m_shown.program()) return std::nullopt;
    for (const auto& [local, value] : m_session->frameVariables(frame))
        if (kit::fromView(local).compare(name, Qt::CaseInsensitive) == 0) return m_shown.shown(value);
    return std::nullopt;
}

RunControl::Shown RunControl::valueIn(const QString& name, const QString& pou) const {
    if (!m_frames.empty() && !viewed() && !showsRecorded()) // halted: the locals of a frame of this POU come first
        for (size_t i = 0; i < m_frames.size(); ++i) {
            if (kit::fromView(m_frames[i].function).compare(pou, Qt::CaseInsensitive) != 0) continue;
            if (const QString of = kit::fromView(m_frames[i].instance); !of.isEmpty() && of != preferredInstance(pou))
                continue; // another one was chosen
            if (auto local = localOf(i, name)) return *local;
            if (!m_frames[i].instance.empty()) return value(name, kit::fromView(m_frames[i].instance));
        }
    return value(name, pou.isEmpty() ? QString() : preferredInstance(pou));
}

Result<RunControl::Entry> RunControl::entry(const QString& path, const QString& valueText) const {
    if (!m_session) return Error{errors::ControllerNotRunning(), ""};
    auto target = m_session->target(path.toStdString());
    if (!target) return target.error();
    auto value =
        session::parseValue(m_session->built().checked, target->place.type, valueText.toStdString(), target->path);
    if (!value) return value.error();
    return Entry{std::move(*target), std::move(*value)};
}

Result<types::Value> RunControl::parse(const QString& path, const QString& valueText) const {
    auto typed = entry(path, valueText);
    if (!typed) return typed.error();
    return std::move(typed->value);
}

Result<void> RunControl::write(const QString& path, const QString& valueText) {
    auto typed = entry(path, valueText);
    if (!typed) return typed.error();
    if (showsRecorded()) return Error{errors::RecordingReadOnly(), path.toStdString()};
    if (viewed()) return Error{errors::PastReadOnly(), path.toStdString()};
    m_session->write(std::move(typed->target), std::move(typed->value), "studio");
    return {};
}

Result<void> RunControl::force(const QString& path, const QString& valueText) {
    if (showsRecorded()) return Error{errors::RecordingReadOnly(), path.toStdString()};
    if (viewed()) return Error{errors::PastNotForced(), path.toStdString()};
    auto typed = entry(path, valueText);
    if (!typed) return typed.error();
    m_session->force(path.toStdString(), std::move(typed->value), "studio");
    return {};
}

void RunControl::unforce(const QString& path) {
    if (m_session) m_session->unforce(path.toStdString());
}

// ------------------------------------------------------------------ time

void RunControl::view(std::optional<history::Position> position) {
    if (!m_shown.view(position)) return;
    emit viewedChanged();
    emit refreshed();
    if (!viewed() && std::exchange(m_pausedToLook, false) && m_session) m_session->start(); // as before one looked back
}

void RunControl::stepView(int scans) {
    const history::History* history = shownHistory();
    if (!history) return;
    const history::Statistics statistics = history->statistics();
    if (statistics.end == statistics.first) return;
    const auto from = static_cast<int64_t>(viewed().value_or(statistics.end - 1));
    const int64_t to = from + scans;
    if (to >= static_cast<int64_t>(statistics.end)) return view(std::nullopt);
    if (!viewed() && !showsRecorded() && isRunning() && m_status.state == controller::State::Running) {
        pause();
        m_pausedToLook = true;
    }
    view(static_cast<history::Position>(std::max<int64_t>(to, static_cast<int64_t>(statistics.first))));
}

Result<void> RunControl::resumeFromView() {
    if (showsRecorded()) return Error{errors::RecordingNotResumed(), ""};
    if (!m_session || !viewed()) return {};
    const history::Position from = *viewed();
    if (auto resumed = m_session->resumeFrom(from); !resumed) return resumed;
    m_pausedToLook = false;
    view(std::nullopt);
    return {};
}

} // namespace plc::editor
