#include "projects/remote/door.h"

#include "projects/remote/errors.h"
#include "projects/session/value_text.h"
#include "runtime/base/text.h"
#include "runtime/debug/sites.h"
#include "runtime/image/variable_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace plc::remote {

namespace {

using Clock = std::chrono::steady_clock;
using controller::State;

Json good(const Json& id) { return {{"id", id}, {"ok", true}}; }
Json refusal(const Json& id, const Error& why) { return {{"id", id}, {"ok", false}, {"error", why.english()}}; }
Json refusal(const Json& id, const Message& why) { return refusal(id, Error{why, {}}); }

Json idOf(const Json& request) {
    const auto it = request.find("id");
    return it != request.end() && it->is_number_unsigned() ? *it : Json(0);
}

/// A pair of path and text, as a program holds it.
Result<session::Assignment> assignmentFor(const driver::Built& built, const Json& pair) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string())
        return Error{errors::NotUnderstood(), {}};
    auto path = pair[0].get<std::string>();
    const auto place = built.program->layout.find(path);
    if (!place) return place.error();
    auto value = session::parseValue(built.checked, place->type, pair[1].get<std::string>(), path);
    if (!value) return value.error();
    return session::Assignment{std::move(path), std::move(*value)};
}

} // namespace

Door::Door(session::Session& session, std::string origin, Rights rights)
    : m_session(session), m_origin(std::move(origin)), m_rights(rights), m_journal(session.history()) {}

Door::~Door() {
    for (const std::string& path : m_held) m_session.release(path);
    if (m_haltsHere) { // nobody is there any more to let it go on
        m_session.setBreakpoints({});
        m_session.resume();
    }
    std::error_code ignored;
    if (m_fetch) {
        if (m_fetch->saving.valid()) m_fetch->saving.wait();
        std::filesystem::remove(m_fetch->file, ignored);
    }
}

std::optional<Json> Door::answer(const Json& request) {
    if (!request.is_object()) return refusal(0, errors::NotUnderstood());
    const Json id = idOf(request);
    const std::string wish = textAt(request, "do");
    if (wish == "state") {
        Json out = good(id);
        out["state"] = stateJson(m_session);
        return out;
    }
    if (wish == "program") {
        Json out = good(id);
        out["version"] = m_session.program()->version;
        out["layout"] = layoutSum(*m_session.program());
        out["sources"] = sourcesJson(*m_session.built().input);
        return out;
    }
    if (wish == "list") return list(request);
    if (wish == "read") return values(request);
    if (wish == "follow") {
        m_follows = true;
        m_writer.restart();
        m_journal.restart();
        m_next = m_session.history().statistics().end;
        m_next -= std::min<history::Position>(m_next, 1);
        m_stateSent.clear();
        m_version = 0;
        return good(id);
    }
    if (wish == "recording") return fetch(request);
    Json done;
    if (wish == "write" || wish == "write_together")
        done = write(request, wish == "write_together");
    else if (wish == "press")
        done = press(request);
    else if (wish == "release") {
        m_session.release(textAt(request, "path"));
        m_held.erase(textAt(request, "path"));
    } else if (wish == "force")
        done = force(request);
    else if (wish == "unforce")
        done = unforce(request);
    else if (wish == "unforce_all")
        m_session.unforceAll();
    else if (wish == "start")
        m_session.start();
    else if (wish == "pause")
        m_session.pause();
    else if (wish == "scan")
        m_session.singleScan();
    else if (wish == "stop")
        m_session.stop();
    else if (wish == "reset")
        done = reset(request);
    else if (wish == "reset_statistics")
        m_session.resetStatistics();
    else if (wish == "change")
        return change(request);
    else if (wish == "breakpoints")
        done = breakpoints(request);
    else if (wish == "go")
        done = go(request);
    else
        return refusal(id, errors::NoSuchRequest(wish));
    if (!done.is_null()) return done;
    return afterScan(id);
}

/// The order has been carried out when the scan after the present one is made, or none is coming.
std::optional<Json> Door::afterScan(const Json& id) {
    m_waiting.push_back({good(id), m_session.status().scans + 2, Clock::now() + std::chrono::seconds(2)});
    return {};
}

/// Single values and whole arrays, without constants.
Json Door::list(const Json& request) const {
    using Next = image::VariableTree::Next;
    constexpr size_t kMost = 20'000;
    const image::Layout& layout = m_session.program()->layout;
    const std::string filter = foldCase(textAt(request, "filter"));
    Json all = Json::array();
    const image::VariableTree tree(layout);
    tree.visit(
        tree.roots(),
        [&](const image::VariableNode& node, int) {
            if (all.size() >= kMost) return Next::Stop;
            if (node.isGroup()) return Next::Into;
            if (node.isConstant || node.isInOut) return Next::Over;
            const types::Type& type = (*layout.types)[node.type];
            if (layout.types->isAggregate(node.type) && type.kind != types::TypeKind::Array) return Next::Into;
            if (filter.empty() || foldCase(node.path).find(filter) != std::string::npos)
                all.push_back({node.path, type.name});
            return Next::Over;
        },
        false);
    Json out = good(idOf(request));
    out["variables"] = std::move(all);
    return out;
}

Json Door::values(const Json& request) const {
    session::Snapshot now;
    m_session.latest(now);
    Json values = Json::array();
    const auto watch = request.find("watch");
    if (watch != request.end() && watch->is_array())
        for (const Json& each : *watch) {
            if (!each.is_string()) continue;
            const auto expression = m_session.expression(each.get<std::string>());
            if (!expression) {
                values.push_back({{"reason", expression.error().english()}});
                continue;
            }
            const expression::Outcome outcome = expression->evaluate(now.image);
            if (outcome.hasValue())
                values.push_back({{"value", types::toText(expression->types(), outcome.value)}});
            else
                values.push_back({{"reason", outcome.reason.english()}});
        }
    Json out = good(idOf(request));
    out["scan"] = now.scan;
    out["time_ns"] = now.time.count();
    out["values"] = std::move(values);
    return out;
}

Result<session::Assignment> Door::assignment(const Json& pair) const { return assignmentFor(m_session.built(), pair); }

Json Door::write(const Json& request, bool isTogether) {
    std::vector<session::Assignment> values;
    const auto list = request.find("values");
    if (list == request.end() || !list->is_array()) return refusal(idOf(request), errors::NotUnderstood());
    const std::vector<controller::Forced> forces = m_session.forces();
    for (const Json& each : *list) {
        auto one = assignment(each);
        if (!one) return refusal(idOf(request), one.error());
        for (const controller::Forced& forced : forces)
            if (foldCase(forced.path) == foldCase(one->path))
                return refusal(idOf(request), errors::IsForced(one->path));
        values.push_back(std::move(*one));
    }
    if (isTogether)
        m_session.writeTogether(std::move(values), m_origin);
    else
        for (session::Assignment& each : values) m_session.write(std::move(each.path), std::move(each.value), m_origin);
    return {};
}

Json Door::force(const Json& request) {
    const auto list = request.find("values");
    if (list == request.end() || !list->is_array() || list->size() != 1)
        return refusal(idOf(request), errors::NotUnderstood());
    auto one = assignment((*list)[0]);
    if (!one) return refusal(idOf(request), one.error());
    m_session.force(std::move(one->path), std::move(one->value), m_origin);
    return {};
}

Json Door::unforce(const Json& request) {
    const std::string path = textAt(request, "path");
    const std::vector<controller::Forced> forces = m_session.forces();
    const bool isForced = std::any_of(forces.begin(), forces.end(), [&](const controller::Forced& forced) {
        return foldCase(forced.path) == foldCase(path);
    });
    if (!isForced) return refusal(idOf(request), errors::NotForced(path));
    m_session.unforce(path);
    return {};
}

Json Door::press(const Json& request) {
    const auto list = request.find("values");
    if (list == request.end() || !list->is_array() || list->size() != 2)
        return refusal(idOf(request), errors::NotUnderstood());
    auto pressed = assignment((*list)[0]), released = assignment((*list)[1]);
    if (!pressed) return refusal(idOf(request), pressed.error());
    if (!released) return refusal(idOf(request), released.error());
    constexpr size_t kMostHeld = 64;
    if (m_held.size() < kMostHeld) m_held.insert(pressed->path);
    m_session.press(std::move(pressed->path), std::move(pressed->value), std::move(released->value), m_origin);
    return {};
}

Json Door::reset(const Json& request) {
    const std::string kind = textAt(request, "kind");
    if (kind == "warm")
        m_session.reset(controller::ResetKind::Warm);
    else if (kind == "cold")
        m_session.reset(controller::ResetKind::Cold);
    else if (kind == "origin")
        m_session.reset(controller::ResetKind::Origin);
    else
        return refusal(idOf(request), errors::NotUnderstood());
    return {};
}

// ---------------------------------------------------------------- debugging

Json Door::breakpoints(const Json& request) {
    if (!m_rights.mayHalt) return refusal(idOf(request), errors::NoHalting());
    const auto list = request.find("places");
    if (list == request.end() || !list->is_array()) return refusal(idOf(request), errors::NotUnderstood());
    const auto program = m_session.program();
    std::vector<session::Breakpoint> wanted;
    for (const Json& each : *list) {
        const std::string name = textAt(each, "file");
        const FileId file = debug::fileOfPath(*program, name);
        if (!file.isValid()) return refusal(idOf(request), errors::NoSuchFile(name));
        wanted.push_back({file, static_cast<uint32_t>(numberAt(each, "line")), textAt(each, "condition"),
                          static_cast<uint32_t>(numberAt(each, "hits")), textAt(each, "instance"),
                          !each.contains("enabled") || each["enabled"] != false});
    }
    m_haltsHere = true;
    m_session.setBreakpoints(std::move(wanted));
    return {};
}

Json Door::go(const Json& request) {
    if (!m_rights.mayHalt) return refusal(idOf(request), errors::NoHalting());
    const std::string how = textAt(request, "how");
    m_haltsHere = true;
    if (how == "on")
        m_session.resume();
    else if (how == "in")
        m_session.step(session::Step::In);
    else if (how == "over")
        m_session.step(session::Step::Over);
    else if (how == "out")
        m_session.step(session::Step::Out);
    else if (how == "to") {
        const FileId file = debug::fileOfPath(*m_session.program(), textAt(request, "file"));
        if (!file.isValid()) return refusal(idOf(request), errors::NoSuchFile(textAt(request, "file")));
        m_session.runTo(file, static_cast<uint32_t>(numberAt(request, "line")));
    } else
        return refusal(idOf(request), errors::NotUnderstood());
    return good(idOf(request));
}

// ---------------------------------------------------------------- another program

std::optional<Json> Door::change(const Json& request) {
    if (m_change) return refusal(idOf(request), errors::IsBuilding());
    const auto sources = request.find("sources");
    if (sources == request.end()) return refusal(idOf(request), errors::NotUnderstood());
    m_change.emplace();
    m_change->id = idOf(request);
    m_change->values = request.value("values", Json::array());
    m_change->building = std::async(std::launch::async, [input = readSources(*sources)] {
        return std::make_shared<driver::Built>(driver::build(input));
    });
    return {};
}

std::optional<Json> Door::changeIsIn() {
    if (!m_change) return {};
    if (!m_change->isPosted) {
        if (m_change->building.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
        const std::shared_ptr<driver::Built> built = m_change->building.get();
        const Json id = m_change->id;
        if (!built->program) {
            m_change.reset();
            const auto& all = built->checked.analysis->diagnostics;
            const auto errors = std::count_if(all.begin(), all.end(), [](const diagnostics::Diagnostic& each) {
                return each.severity == diagnostics::Severity::Error;
            });
            return refusal(id, built->failure.isEmpty() ? errors::HasErrors(errors) : built->failure);
        }
        session::Together together{{}, m_origin};
        for (const Json& each : m_change->values) {
            auto one = assignmentFor(*built, each);
            if (!one) {
                m_change.reset();
                return refusal(id, one.error());
            }
            together.values.push_back(std::move(*one));
        }
        m_change->isPosted = true;
        m_change->entered = std::make_shared<std::promise<controller::OnlineChangeReport>>();
        m_change->report = m_change->entered->get_future();
        const auto enters = [entered = m_change->entered](const controller::OnlineChangeReport& report) {
            entered->set_value(report);
        };
        m_session.changeProgram(*built, enters, std::nullopt, std::move(together));
        return {};
    }
    if (m_change->report.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    const controller::OnlineChangeReport report = m_change->report.get();
    Json out = report.refusal.isEmpty() ? good(m_change->id) : refusal(m_change->id, report.refusal);
    out["kept"] = report.kept.size();
    out["new"] = report.initialised.size();
    out["lost"] = report.lost.size();
    m_change.reset();
    return out;
}

// ---------------------------------------------------------------- the recording

std::optional<Json> Door::fetch(const Json& request) {
    if (m_fetch) return refusal(idOf(request), errors::IsFetching());
    std::error_code problem;
    const auto folder = std::filesystem::temp_directory_path(problem);
    m_fetch.emplace();
    m_fetch->id = idOf(request);
    m_fetch->file = (folder / ("stepwise-" + std::to_string(reinterpret_cast<uintptr_t>(this)) + "-" +
                               std::to_string(Clock::now().time_since_epoch().count()) + ".rec"))
                        .string();
    m_fetch->saving = std::async(
        std::launch::async, [session = &m_session, file = m_fetch->file] { return session->history().save(file); });
    return {};
}

std::optional<Json> Door::fetchIsReady() {
    if (!m_fetch || m_fetch->isReady) return {};
    if (m_fetch->saving.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    const Result<void> saved = m_fetch->saving.get();
    const Json id = m_fetch->id;
    std::error_code problem;
    if (!saved) {
        std::filesystem::remove(m_fetch->file, problem);
        m_fetch.reset();
        return refusal(id, saved.error());
    }
    m_fetch->isReady = true;
    m_fetch->size = std::filesystem::file_size(m_fetch->file, problem);
    Json out = good(id);
    out["bytes"] = m_fetch->size;
    return out;
}

std::string Door::nextPiece(size_t most) {
    std::ifstream file(m_fetch->file, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(m_fetch->sent));
    std::string out(1, static_cast<char>(Piece::Recording));
    out.resize(1 + std::min<uint64_t>(most, m_fetch->size - m_fetch->sent));
    file.read(out.data() + 1, static_cast<std::streamsize>(out.size() - 1));
    m_fetch->sent += out.size() - 1;
    if (m_fetch->sent >= m_fetch->size) {
        std::error_code ignored;
        std::filesystem::remove(m_fetch->file, ignored);
        m_fetch.reset();
    }
    return out;
}

// ---------------------------------------------------------------- who follows

std::vector<Json> Door::due() {
    std::vector<Json> out;
    if (auto done = changeIsIn()) out.push_back(std::move(*done));
    if (auto ready = fetchIsReady()) out.push_back(std::move(*ready));
    const session::Status status = m_session.status();
    for (auto it = m_waiting.begin(); it != m_waiting.end();) {
        const bool isDone = status.state != State::Running || status.scans >= it->scans || Clock::now() >= it->latest;
        if (isDone) out.push_back(std::move(it->answer));
        it = isDone ? m_waiting.erase(it) : it + 1;
    }
    for (const std::string& why : std::exchange(m_refusals, {})) out.push_back({{"event", "refused"}, {"text", why}});
    if (!m_follows) return out;
    if (const uint64_t version = m_session.program()->version; version != m_version) {
        m_version = version;
        m_writer.restart();
        out.push_back({{"event", "program"}, {"version", version}});
    }
    const std::vector<controller::Event> events = m_session.eventsSince(m_events);
    m_events += events.size();
    const bool hasFault = std::ranges::any_of(
        events, [](const controller::Event& event) { return event.kind == controller::EventKind::Fault; });
    // In front of the events: the state says where a fault is.
    if (hasFault || status.halts != m_haltSeen || Clock::now() - m_stateAt >= std::chrono::milliseconds(100)) {
        m_stateAt = Clock::now();
        Json state{{"event", "state"}, {"state", stateJson(m_session)}};
        if (std::string text = state.dump(-1, ' ', false, Json::error_handler_t::replace); text != m_stateSent) {
            m_stateSent = std::move(text);
            out.push_back(std::move(state));
        }
    }
    constexpr size_t kMostEvents = 200;
    for (size_t i = events.size() > kMostEvents ? events.size() - kMostEvents : 0; i < events.size(); ++i)
        out.push_back({{"event", "happened"}, {"what", eventJson(events[i])}});
    return out;
}

/// What is written while no scan is made is in no recorded scan.
std::string Door::standingImage() {
    session::Snapshot now;
    m_session.latest(now);
    if (!now.program || now.program->version != m_version || now.image == m_standing) return {};
    m_standing = std::move(now.image);
    m_haltSeen = m_session.status().halts;
    std::string out(1, static_cast<char>(Piece::Standing));
    putNumber(out, m_version);
    putNumber(out, now.isHalted ? 1 : 0);
    out.append(reinterpret_cast<const char*>(m_standing.data()), m_standing.size());
    return out;
}

std::string Door::bytes(size_t most) {
    constexpr history::Position kMostScans = 4096; // whose journals are read ahead
    if (m_fetch && m_fetch->isReady) return nextPiece(most);
    if (!m_follows || m_version == 0) return {};
    const session::Status status = m_session.status();
    const history::Statistics recorded = m_session.history().statistics();
    const auto skipTo = [this](history::Position position) {
        m_next = position;
        m_journal.restart(); // what acted on those that are left out is not known there
    };
    if (m_next < recorded.first) skipTo(recorded.first);
    const history::Position end = std::min<history::Position>(recorded.end, m_next + kMostScans);
    m_journal.gather({m_next, end});
    std::string out(1, static_cast<char>(Piece::Scans));
    putNumber(out, m_version);
    const size_t head = out.size();
    const auto begin = Clock::now();
    while (m_next < end && out.size() < most && Clock::now() - begin < std::chrono::milliseconds(10)) {
        std::shared_ptr<const image::CompiledProgram> program;
        const std::vector<std::byte> image = m_session.history().seek(m_next, &program);
        const auto stamp = m_session.history().stamp(m_next);
        if (!program || !stamp || program->version != m_version) {
            skipTo(m_next + 1);
            continue;
        }
        m_writer.write(out, {stamp->scan, stamp->time, std::span(image).first(program->layout.dataEnd)},
                       m_journal.of(m_next));
        ++m_next;
    }
    // A second of scans is waited for; more is a line or a machine that cannot follow.
    const auto oldest = m_session.history().stamp(m_next);
    if (oldest && status.time - oldest->time > std::chrono::seconds(1)) skipTo(recorded.end - 1);
    if (out.size() > head) return out;
    if (status.state != State::Running) return standingImage();
    m_standing.clear();
    return {};
}

} // namespace plc::remote
