#include "editor/remote/attached_run.h"

#include "editor/kit/post.h"
#include "projects/remote/errors.h"

namespace plc::editor {

namespace {

using remote::Json;
using session::OrderKind;
namespace errors = remote::errors;

const char* nameOf(controller::ResetKind kind) {
    switch (kind) {
    case controller::ResetKind::Warm:
        return "warm";
    case controller::ResetKind::Cold:
        return "cold";
    case controller::ResetKind::Origin:
        return "origin";
    }
    return "";
}

const char* nameOf(session::Step step) {
    switch (step) {
    case session::Step::In:
        return "in";
    case session::Step::Over:
        return "over";
    case session::Step::Out:
        return "out";
    }
    return "";
}

Json valuesJson(const types::TypeTable& types, const std::vector<session::Assignment>& values) {
    Json out = Json::array();
    for (const session::Assignment& each : values) out.push_back({each.path, types::toText(types, each.value)});
    return out;
}

Json placesJson(const image::CompiledProgram& program, const std::vector<session::Breakpoint>& breakpoints) {
    Json out = Json::array();
    for (const session::Breakpoint& each : breakpoints)
        out.push_back({{"file", program.sources[each.file].path()},
                       {"line", each.line},
                       {"condition", each.condition},
                       {"hits", each.hitCount},
                       {"instance", each.instance},
                       {"enabled", each.isEnabled}});
    return out;
}

/// As it goes over the wire; null: nothing has to be sent.
Json requestOf(const session::Order& order, const image::CompiledProgram& program, bool mayHalt) {
    const types::TypeTable& types = *program.layout.types;
    switch (order.kind) {
    case OrderKind::Start:
        return {{"do", "start"}};
    case OrderKind::Pause:
        return {{"do", "pause"}};
    case OrderKind::SingleScan:
        return {{"do", "scan"}};
    case OrderKind::Stop:
        return {{"do", "stop"}};
    case OrderKind::Reset:
        return {{"do", "reset"}, {"kind", nameOf(order.reset)}};
    case OrderKind::Write:
        return {{"do", "write"}, {"values", valuesJson(types, order.values)}};
    case OrderKind::WriteTogether:
        return {{"do", "write_together"}, {"values", valuesJson(types, order.values)}};
    case OrderKind::Press:
        return {{"do", "press"}, {"values", valuesJson(types, order.values)}};
    case OrderKind::Release:
        return {{"do", "release"}, {"path", order.path}};
    case OrderKind::Force:
        return {{"do", "force"}, {"values", valuesJson(types, order.values)}};
    case OrderKind::Unforce:
        return {{"do", "unforce"}, {"path", order.path}};
    case OrderKind::UnforceAll:
        return {{"do", "unforce_all"}};
    case OrderKind::ResetStatistics:
        return {{"do", "reset_statistics"}};
    case OrderKind::ChangeProgram:
        return {{"do", "change"},
                {"sources", remote::sourcesJson(*order.built->input)},
                {"values", valuesJson(*order.built->program->layout.types, order.values)}};
    case OrderKind::SetBreakpoints:
        if (order.breakpoints.empty() && !mayHalt) return {}; // there can be none
        return {{"do", "breakpoints"}, {"places", placesJson(program, order.breakpoints)}};
    case OrderKind::Resume:
        return {{"do", "go"}, {"how", "on"}};
    case OrderKind::Step:
        return {{"do", "go"}, {"how", nameOf(order.step)}};
    case OrderKind::RunTo:
        return {{"do", "go"}, {"how", "to"}, {"file", program.sources[order.file].path()}, {"line", order.line}};
    }
    return {};
}

} // namespace

/// Outlives the run in the hands of the session.
class AttachedRun::Orders final : public session::Outlet {
public:
    explicit Orders(AttachedRun& run) : m_run(&run) {}
    void post(session::Order order) override {
        const std::lock_guard lock(m_mutex);
        if (m_run)
            kit::post(m_run, [run = m_run, order = std::move(order)]() mutable { run->carry(std::move(order)); });
    }
    Error whyNotBack() const override { return {errors::NotPutBack(), {}}; }
    void end() {
        const std::lock_guard lock(m_mutex);
        m_run = nullptr;
    }

private:
    std::mutex m_mutex;
    AttachedRun* m_run;
};

AttachedRun::AttachedRun(QObject* parent) : QObject(parent), m_orders(std::make_shared<Orders>(*this)) {
    connect(&m_controller, &RemoteController::stateChanged, this, [this] {
        if (m_controller.state() == RemoteController::State::Attached) adopt();
    });
    connect(&m_controller, &RemoteController::eventArrived, this, &AttachedRun::hear);
    connect(&m_controller, &RemoteController::bytesArrived, this, &AttachedRun::takeBytes);
}

AttachedRun::~AttachedRun() { m_orders->end(); }

/// Also after the line was lost: the program may be another one by now.
void AttachedRun::adopt() {
    m_wanted = 0;
    m_version = 0;
    fetchProgram();
}

void AttachedRun::fetchProgram() {
    m_controller.ask({{"do", "program"}}, [this](const Result<Json>& answer) {
        if (!answer) return emit failed(answer.error().message);
        const There there{remote::numberAt(*answer, "version"), remote::numberAt(*answer, "layout")};
        const auto sources = answer->find("sources");
        if (sources == answer->end()) return emit failed(errors::ProgramDiffers());
        m_wanted = there.version;
        if (m_session && m_present == there.version) return built(nullptr, there);
        m_builder = std::jthread([this, there, input = remote::readSources(*sources)] {
            auto made = std::make_shared<driver::Built>(driver::build(input));
            kit::post(this, [this, made, there] { built(made, there); });
        });
    });
}

void AttachedRun::built(std::shared_ptr<driver::Built> made, There there) {
    if (there.version != m_wanted) return; // another one has come meanwhile
    if (made && (!made->program || remote::layoutSum(*made->program) != there.layout)) {
        m_controller.detach();
        return emit failed(errors::ProgramDiffers());
    }
    const bool isFirst = m_session == nullptr;
    if (isFirst) {
        if (!made) return adopt(); // it was let go meanwhile
        session::Settings settings;
        settings.historyBudget = m_historyBudget;
        m_made = session::Mirror::open(std::move(*made), settings, m_orders);
        m_session = m_made.get();
        m_mirror.emplace(*m_session);
    } else if (made) {
        m_mirror->programChanged(std::move(*made));
    }
    m_version = m_present = there.version;
    m_reader = remote::ScanReader(m_session->program());
    m_controller.ask({{"do", "follow"}});
    if (isFirst) emit sessionReady();
}

void AttachedRun::hear(const Json& event) {
    const std::string kind = remote::textAt(event, "event");
    if (kind == "program" && remote::numberAt(event, "version") != m_version) return fetchProgram();
    if (!m_mirror) return;
    if (kind == "refused") return m_mirror->refused({errors::Plainly(remote::textAt(event, "text")), {}});
    if (kind == "happened" && event.contains("what")) return m_mirror->happened(remote::readEvent(event["what"]));
    if (kind == "state" && event.contains("state") && event["state"].is_object())
        m_mirror->told(remote::readState(event["state"], m_session->built()));
}

void AttachedRun::takeBytes(const QByteArray& packed) {
    std::string_view bytes(packed.constData(), static_cast<size_t>(packed.size()));
    const auto piece = static_cast<remote::Piece>(bytes.front());
    bytes.remove_prefix(1);
    uint64_t version = 0, isHalted = 0;
    if (!m_mirror || piece == remote::Piece::Recording) return;
    if (!remote::takeNumber(bytes, version) || version != m_version) return;
    if (piece == remote::Piece::Standing) {
        if (!remote::takeNumber(bytes, isHalted)) return;
        return m_mirror->stands(std::as_bytes(std::span(bytes)), isHalted != 0);
    }
    const bool isGood = m_reader.read(bytes, [this](const remote::StreamedScan& scan) {
        m_mirror->scanned(scan.image, scan.scan, scan.time, scan.outside);
    });
    if (isGood) return;
    m_controller.detach();
    emit failed(errors::ProgramDiffers());
}

void AttachedRun::report(const Result<Json>& answer) {
    if (!answer && m_mirror) m_mirror->refused(answer.error());
}

void AttachedRun::carry(session::Order order) {
    if (!m_session) return;
    const Json request = requestOf(order, *m_session->program(), m_controller.mayHalt());
    if (request.is_null()) return;
    m_controller.ask(request, [this, done = order.done](const Result<Json>& answer) {
        report(answer);
        if (!done) return;
        controller::OnlineChangeReport summary;
        if (answer) {
            summary.kept.resize(remote::numberAt(*answer, "kept"));
            summary.initialised.resize(remote::numberAt(*answer, "new"));
            summary.lost.resize(remote::numberAt(*answer, "lost"));
        } else {
            summary.refusal = answer.error().message;
        }
        done(summary);
    });
}

} // namespace plc::editor
