#include "editor/debug/run_control.h"

#include "editor/kit/errors.h"
#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "projects/session/value_text.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/debug/sites.h"
#include "runtime/types/conversion.h"

#include <QDir>

#include <algorithm>

namespace plc::editor {

namespace {
constexpr int kFrameMs = 33;
QString text(const std::string& s) { return QString::fromStdString(s); }
} // namespace

RunControl::RunControl(Workspace& workspace, QObject* parent) : QObject(parent), m_workspace(workspace) {
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
        if (good) adopt(built, false);
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
        kit::post(self, [self] {
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
        if (before->isCancelled()) emit messageAdded(tr("Not optimised: the quick code goes on"), false);
    }
    if (m_optimising) emit workBegan(tr("Optimising"), m_optimising);
}

void RunControl::adopt(std::shared_ptr<driver::Built> built, bool changeRunning) {
    if (changeRunning && m_session) {
        m_session->changeProgram(
            *built,
            [this](const controller::OnlineChangeReport& report) {
                const QString summary = tr("Online change: %1 kept, %2 new, %3 lost")
                                            .arg(report.kept.size())
                                            .arg(report.initialised.size())
                                            .arg(report.lost.size());
                kit::post(this, [this, summary] { emit onlineChangeFinished(summary); });
            },
            breakpointsFor(*built->program));
        return;
    }
    m_viewed.reset();
    session::Settings settings;
    settings.historyBudget = m_historyBudget;
    if (!retainFile().isEmpty()) {
        QDir().mkpath(m_workspace.folder() + "/.stepwise");
        settings.retainFile = retainFile().toStdString();
    }
    endSession();
    m_session = std::make_unique<session::Session>(*built, settings);
    m_haltsSeen = 0;
    postBreakpoints();
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
    m_viewed.reset();
    m_image.clear();
    m_imageProgram.reset();
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

void RunControl::showRecorded(std::optional<RecordedRun> recorded) {
    m_recorded = std::move(recorded);
    m_recordedExpressions.clear();
    m_viewed.reset();
    m_image.clear();
    m_imageProgram.reset();
    refreshImage();
    emit viewedChanged();
    emit statusChanged();
    emit refreshed();
}

const history::History* RunControl::shownHistory() const {
    return m_recorded ? m_recorded->history : m_session ? &m_session->history() : nullptr;
}

void RunControl::leaveRecorded() {
    if (!m_recorded) return;
    emit recordedMustClose();
    if (m_recorded) showRecorded(std::nullopt);
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
    const bool stands = m_session && (m_status.state == controller::State::Paused ||
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
            wanted = static_cast<uint32_t>(LineMap(textOf(file, built), built.text()).nearest(line));
        }
        if (debug::sitesOfLine(*program, id, wanted).sites.empty())
            emit messageAdded(tr("There is no code at or below line %1 of %2").arg(line).arg(file), true);
        else
            m_session->runTo(id, wanted);
    };
    if (isRunning()) return go();
    startThen(true, go);
}

void RunControl::onlineChange() {
    if (!isRunning()) return start();
    if (m_building) return;
    buildAside([this](const std::shared_ptr<driver::Built>& built) {
        if (built->program) adopt(built, true);
        emit buildFinished(built->program != nullptr,
                           built->program ? tr("The change waits for the end of the scan")
                                          : tr("The program has errors; the controller goes on with the old one"));
    });
}

void RunControl::setMode(session::RunMode mode) {
    m_mode = mode;
    if (m_session) m_session->setMode(mode);
    emit statusChanged();
}

// ------------------------------------------------------------------ breakpoints

bool RunControl::hasBreakpoint(const QString& place) const {
    return std::any_of(m_breakpoints.begin(), m_breakpoints.end(), [&](const EditorBreakpoint& each) {
        return each.isEnabled && QString("%1:%2").arg(each.file).arg(each.line) == place;
    });
}

void RunControl::setBreakpoints(std::vector<EditorBreakpoint> breakpoints) {
    m_breakpoints = std::move(breakpoints);
    postBreakpoints();
    emit breakpointsChanged();
}

void RunControl::toggleBreakpoint(const QString& file, int line) {
    const auto it = std::find_if(m_breakpoints.begin(), m_breakpoints.end(),
                                 [&](const EditorBreakpoint& b) { return b.file == file && b.line == line; });
    if (it != m_breakpoints.end())
        m_breakpoints.erase(it);
    else
        m_breakpoints.push_back({file, line});
    postBreakpoints();
    emit breakpointsChanged();
}

void RunControl::moveBreakpoints(const QString& file, const std::map<int, int>& lines) {
    std::vector<EditorBreakpoint> moved;
    for (EditorBreakpoint each : m_breakpoints) {
        if (const auto it = lines.find(each.line); each.file == file && it != lines.end()) each.line = it->second;
        const bool isDouble = std::any_of(moved.begin(), moved.end(), [&](const EditorBreakpoint& other) {
            return other.file == each.file && other.line == each.line;
        });
        if (!isDouble) moved.push_back(std::move(each));
    }
    if (moved == m_breakpoints) return;
    m_breakpoints = std::move(moved); // in the program that runs they stand where they stood
    emit breakpointsChanged();
}

void RunControl::postBreakpoints() {
    if (!m_session) return;
    m_session->setBreakpoints(breakpointsFor(*m_session->program()));
}

std::string RunControl::textOf(const QString& file, const SourceText& built) const {
    return m_workspace.files().contains(file) ? m_workspace.text(file) : std::string(built.text());
}

std::vector<session::Breakpoint> RunControl::breakpointsFor(const image::CompiledProgram& program) {
    struct Maps {
        LineMap toProgram, toText;
    };
    std::map<QString, Maps> maps;
    const std::vector<EditorBreakpoint> before = m_breakpoints;
    std::vector<session::Breakpoint> posted;
    for (EditorBreakpoint& each : m_breakpoints) {
        const FileId file = debug::fileOfPath(program, each.file.toStdString());
        each.hasCode = false;
        if (!file.isValid()) continue;
        const SourceText& built = program.sources[file];
        if (!maps.contains(each.file)) {
            const std::string now = textOf(each.file, built);
            maps.emplace(each.file, Maps{{now, built.text()}, {built.text(), now}});
        }
        const Maps& map = maps.at(each.file);
        auto line = static_cast<uint32_t>(map.toProgram.nearest(each.line));
        const debug::SitesOfLine found = debug::sitesOfLine(program, file, line);
        each.hasCode = !found.sites.empty();
        if (!each.hasCode) continue;
        line = found.line;
        if (map.toProgram.exact(each.line)) // a new line waits for its build
            each.line = map.toText.exact(static_cast<int>(line)).value_or(each.line);
        posted.push_back({file, line, each.condition.toStdString(), static_cast<uint32_t>(each.hitCount),
                          each.instance.toStdString(), each.isEnabled});
    }
    if (before != m_breakpoints) {
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
    if (!range.file.isValid() || range.file.index() >= program.sources.files.size()) return std::nullopt;
    const SourceText& built = program.sources[range.file];
    TextPlace place;
    place.file = text(built.path());
    place.line = static_cast<int>(built.lineColumn(range.begin).line);
    place.offset = range.begin;
    place.length = range.length();
    const std::string now = textOf(place.file, built);
    if (now == built.text()) return place;
    const uint32_t column = range.begin - built.lineBegin(static_cast<uint32_t>(place.line));
    const LineMap map(built.text(), now);
    const bool isSame = map.exact(place.line).has_value();
    place.line = map.nearest(place.line);
    size_t begin = 0;
    for (int line = 1; line < place.line && begin != std::string::npos; ++line) begin = now.find('\n', begin) + 1;
    place.offset = static_cast<uint32_t>(begin) + (isSame ? column : 0);
    if (!isSame) place.length = 0;
    return place;
}

// ------------------------------------------------------------------ the 30 Hz look

void RunControl::tick() {
    if (!m_session) return;
    const controller::State before = m_status.state;
    const uint64_t scansBefore = m_status.scans;
    const Message retainProblem = m_status.retainProblem;
    m_status = m_session->status();
    takeSample();
    if (!m_status.retainProblem.isEmpty() && !(m_status.retainProblem == retainProblem))
        emit messageAdded(kit::messageText(m_status.retainProblem), true);
    for (const Error& refusal : m_session->takeRefusals()) emit messageAdded(kit::messageText(refusal), true);
    m_forced.clear();
    for (const controller::Forced& forced : m_session->forces()) m_forced.insert(foldCase(forced.path));
    watchOptimising(m_session->optimising());
    const bool stateChanged = before != m_status.state;
    // A step may end before anybody looked: halts are counted.
    const bool haltedAnew = m_status.state == controller::State::Halted && m_status.halts != m_haltsSeen;
    if (haltedAnew) m_haltsSeen = m_status.halts;
    if (m_status.state == controller::State::Halted)
        m_frames = m_session->haltFrames();
    else
        m_frames.clear();
    if (!m_viewed && !m_recorded) refreshImage();
    if (stateChanged || haltedAnew) {
        emit statusChanged();
        if (haltedAnew) {
            for (size_t i = m_frames.size(); i-- > 0;) // the text shows the instances of the call path
                if (!m_frames[i].instance.empty())
                    m_preferredInstance[text(m_frames[i].function).section('.', 0, 0).toLower()] =
                        text(m_frames[i].instance);
            if (const Message problem = m_session->haltProblem(); !problem.isEmpty())
                emit messageAdded(tr("The condition of the breakpoint: %1").arg(kit::messageText(problem)), true);
            emit halted();
        }
    } else if (scansBefore != m_status.scans) {
        emit statusChanged();
    }
    emit refreshed();
}

void RunControl::refreshImage() {
    if (m_recorded) {
        const history::Statistics statistics = m_recorded->history->statistics();
        if (statistics.end > statistics.first)
            m_image = m_recorded->history->seek(m_viewed.value_or(statistics.end - 1), &m_imageProgram);
        return;
    }
    if (!m_session) return;
    if (m_viewed) {
        m_image = m_session->history().seek(*m_viewed, &m_imageProgram);
        return;
    }
    m_image = m_session->snapshot();
    m_imageProgram = m_session->program();
}

// ------------------------------------------------------------------ values

RunControl::Shown RunControl::value(const QString& expression, const QString& scope, types::NumberFormat format) const {
    Shown shown;
    if (!hasValues() || m_image.empty() || !m_imageProgram) return shown;
    expression::Expression present;
    if (m_recorded) {
        const std::string key =
            scope.toStdString() + "\n" + expression.toStdString() + "\n" + std::to_string(m_imageProgram->version);
        auto known = m_recordedExpressions.find(key);
        if (known == m_recordedExpressions.end()) {
            const auto compiled = m_recorded->compile(expression.toStdString(), scope.toStdString(), *m_imageProgram);
            if (!compiled) {
                shown.reason = kit::messageText(compiled.error().message);
                return shown;
            }
            known = m_recordedExpressions.emplace(key, *compiled).first;
        }
        present = known->second;
    } else {
        const auto compiled = m_session->expression(expression.toStdString(), scope.toStdString());
        if (!compiled) {
            shown.reason = kit::messageText(compiled.error().message);
            return shown;
        }
        // A recorded image of an older version has another layout: the expression is made anew for it.
        present = *compiled;
        if (m_imageProgram->version != m_session->program()->version)
            present = m_session->recompile(expression.toStdString(), scope.toStdString())(*m_imageProgram);
    }
    if (!present.isValid()) {
        shown.reason = tr("did not exist in this scan");
        return shown;
    }
    const expression::Outcome outcome = present.evaluate(m_image);
    shown.type = present.type();
    if (!outcome.hasValue()) {
        shown.reason = kit::messageText(outcome.reason);
        return shown;
    }
    shown.value = outcome.value;
    shown.text = text(types::toText(present.types(), outcome.value, format));
    shown.isBool = present.types().storageKind(present.type()) == types::TypeKind::Bool;
    shown.isTrue = shown.isBool && outcome.value.isTrue();
    const std::string path =
        scope.isEmpty() ? expression.toStdString() : scope.toStdString() + "." + expression.toStdString();
    shown.isForced =
        !m_recorded && (m_forced.contains(foldCase(path)) || m_forced.contains(foldCase(expression.toStdString())));
    return shown;
}

void RunControl::takeSample() {
    constexpr qint64 kSampleMs = 100;
    const bool isRunning = m_status.state == controller::State::Running;
    if (isRunning && m_sinceSample.isValid() && m_sinceSample.elapsed() < kSampleMs) return;
    const history::Statistics all = m_session->history().statistics();
    m_sampled = all.end - std::min<history::Position>(all.end, 1);
    m_sinceSample.start();
}

history::Position RunControl::sampled() const {
    const history::History* history = shownHistory();
    if (!history) return 0;
    const history::Statistics all = history->statistics();
    const history::Position newest = all.end - std::min<history::Position>(all.end, 1);
    return m_recorded || m_sampled < all.first ? newest : std::min(m_sampled, newest); // of a session before
}

void RunControl::atMoment(Moment& moment, const std::function<void()>& read) {
    std::swap(m_image, moment.image);
    std::swap(m_imageProgram, moment.program);
    read();
    std::swap(m_image, moment.image);
    std::swap(m_imageProgram, moment.program);
}

std::vector<QString> RunControl::instancesOf(const QString& pou) const {
    if (!m_imageProgram) return {};
    if (m_instancesOf != m_imageProgram) { // the walk is long, and asked for with every value
        m_instances.clear();
        m_instancesOf = m_imageProgram;
    }
    const auto [known, isNew] = m_instances.try_emplace(pou);
    std::vector<QString>& out = known->second;
    if (!isNew) return out;
    const image::Layout& layout = m_imageProgram->layout;
    const std::string wanted = foldCase(pou.section('.', 0, 0).toStdString());
    // Walks instances down to a few levels; arrays of blocks count their first elements.
    const auto walk = [&](auto&& self, const std::string& path, types::TypeId type, int depth) -> void {
        const types::Type& t = (*layout.types)[type];
        if (t.kind == types::TypeKind::Array && depth < 6) {
            const types::TypeKind element = layout.types->kind(t.element);
            if ((element != types::TypeKind::Block && element != types::TypeKind::Struct) || t.dimensions.size() != 1)
                return;
            for (int64_t i = t.dimensions[0].low; i <= t.dimensions[0].high && i < t.dimensions[0].low + 64; ++i)
                self(self, path + "[" + std::to_string(i) + "]", t.element, depth + 1);
            return;
        }
        if (t.kind != types::TypeKind::Block && t.kind != types::TypeKind::Struct) return;
        for (types::TypeId each = type; each.isValid(); each = (*layout.types)[each].base)
            if (foldCase((*layout.types)[each].name) == wanted) {
                out.push_back(text(path));
                break;
            }
        if (depth >= 6) return;
        for (const types::Field& field : t.fields)
            if (field.section != types::FieldSection::InOut && field.section != types::FieldSection::External)
                self(self, path + "." + field.name, field.type, depth + 1);
    };
    for (const image::Root& root : layout.roots)
        if (!root.isHidden) walk(walk, root.list.empty() ? root.name : root.list + "." + root.name, root.type, 0);
    return out;
}

void RunControl::setPreferredInstance(const QString& pou, const QString& instance) {
    m_preferredInstance[pou.toLower()] = instance;
    emit refreshed();
}

QString RunControl::preferredInstance(const QString& pou) const {
    const QString block = pou.section('.', 0, 0);
    const auto it = m_preferredInstance.find(block.toLower());
    if (it != m_preferredInstance.end()) return it->second;
    const std::vector<QString> all = instancesOf(block);
    return all.empty() ? QString() : all.front();
}

RunControl::Shown RunControl::valueIn(const QString& name, const QString& pou) const {
    if (!m_frames.empty() && !m_viewed && !m_recorded) // halted: the locals of a frame of this POU come first
        for (size_t i = 0; i < m_frames.size(); ++i) {
            if (text(m_frames[i].function).compare(pou, Qt::CaseInsensitive) != 0) continue;
            if (const QString of = text(m_frames[i].instance); !of.isEmpty() && of != preferredInstance(pou))
                continue; // another one was chosen
            for (const auto& [local, value] : m_session->frameVariables(i))
                if (text(local).compare(name, Qt::CaseInsensitive) == 0 && m_imageProgram) {
                    Shown shown;
                    shown.value = value;
                    shown.type = value.type;
                    shown.text = text(types::toText(*m_imageProgram->layout.types, value));
                    shown.isBool = value.type.isValid() &&
                                   m_imageProgram->layout.types->storageKind(value.type) == types::TypeKind::Bool;
                    shown.isTrue = shown.isBool && value.isTrue();
                    return shown;
                }
            if (!m_frames[i].instance.empty()) return value(name, text(m_frames[i].instance));
        }
    const QString instance = pou.isEmpty() ? QString() : preferredInstance(pou);
    return value(name, instance);
}

Result<types::Value> RunControl::parse(const QString& path, const QString& valueText) const {
    if (!m_session) return Error{errors::ControllerNotRunning(), ""};
    const auto place = m_session->program()->layout.find(path.toStdString());
    if (!place) return place.error();
    return session::parseValue(m_session->built().checked, place->type, valueText.toStdString(), path.toStdString());
}

Result<void> RunControl::write(const QString& path, const QString& valueText) {
    const auto value = parse(path, valueText);
    if (!value) return value.error();
    if (m_recorded) return Error{errors::RecordingReadOnly(), path.toStdString()};
    if (m_viewed) return Error{errors::PastReadOnly(), path.toStdString()};
    m_session->write(path.toStdString(), *value, "studio");
    return {};
}

Result<void> RunControl::force(const QString& path, const QString& valueText) {
    if (m_viewed && !m_recorded) return Error{errors::PastNotForced(), path.toStdString()};
    if (m_recorded) return Error{errors::RecordingReadOnly(), path.toStdString()};
    const auto value = parse(path, valueText);
    if (!value) return value.error();
    m_session->force(path.toStdString(), *value, "studio");
    return {};
}

void RunControl::unforce(const QString& path) {
    if (m_session) m_session->unforce(path.toStdString());
}

// ------------------------------------------------------------------ time

void RunControl::view(std::optional<history::Position> position) {
    if (m_viewed == position) return;
    if (const history::History* history = shownHistory(); position && history) {
        const history::Statistics statistics = history->statistics();
        if (statistics.end == statistics.first) return;
        position = std::clamp(*position, statistics.first, statistics.end - 1);
    }
    m_viewed = position;
    refreshImage();
    emit viewedChanged();
    emit refreshed();
    if (!m_viewed && std::exchange(m_pausedToLook, false) && m_session) m_session->start(); // as before one looked back
}

void RunControl::stepView(int scans) {
    const history::History* history = shownHistory();
    if (!history) return;
    const history::Statistics statistics = history->statistics();
    if (statistics.end == statistics.first) return;
    const auto from = static_cast<int64_t>(m_viewed.value_or(statistics.end - 1));
    const int64_t to = from + scans;
    if (to >= static_cast<int64_t>(statistics.end)) return view(std::nullopt);
    if (!m_viewed && !m_recorded && isRunning() && m_status.state == controller::State::Running) {
        pause();
        m_pausedToLook = true;
    }
    view(static_cast<history::Position>(std::max<int64_t>(to, static_cast<int64_t>(statistics.first))));
}

Result<void> RunControl::resumeFromView() {
    if (m_recorded) return Error{errors::RecordingNotResumed(), ""};
    if (!m_session || !m_viewed) return {};
    const history::Position from = *m_viewed;
    if (auto resumed = m_session->resumeFrom(from); !resumed) return resumed;
    m_pausedToLook = false;
    view(std::nullopt);
    return {};
}

} // namespace plc::editor
