#include "editor/inside/exact_values.h"

#include "runtime/debug/sites.h"

#include <QPointer>
#include <QScrollBar>

#include <set>

namespace plc::editor {

namespace {

constexpr qint64 kShare = 10;      // a tenth of a core at most
constexpr qsizetype kLongest = 40; // characters of a value

/// What a scan did, as the editor draws it.
ExactText shownOf(const inside::Look& look, const inside::TextPart& part) {
    ExactText shown;
    const inside::ScanText did = inside::textOf(look, part);
    const types::TypeTable& types = *look.program().layout.types;
    for (const inside::ScanText::Value& value : did.values) {
        if (types.isAggregate(value.value.type)) continue;
        const bool isBool = types.storageKind(value.value.type) == types::TypeKind::Bool;
        shown.values.push_back({value.range.begin, value.range.end,
                                QString::fromStdString(types::toText(types, value.value)).left(kLongest), isBool,
                                isBool && value.value.isTrue()});
    }
    for (const inside::ScanText::Condition& each : did.conditions)
        shown.conditions.push_back({each.range.begin, each.range.end, each.isTrue});
    for (const SourceRange& range : did.notRun) shown.notRun.emplace_back(range.begin, range.end);
    for (const inside::ScanText::Loop& loop : did.loops)
        shown.loops.push_back({loop.range.begin, loop.pass, loop.count});
    for (const auto& [at, value] : did.results) {
        const bool isBool = types.storageKind(value.type) == types::TypeKind::Bool;
        shown.results[at] = {at, at, QString::fromStdString(types::toText(types, value)).left(kLongest), isBool,
                             isBool && value.isTrue()};
    }
    return shown;
}

/// What a scan did, and the scan.
struct Answer {
    std::optional<ExactText> text;
    std::shared_ptr<const inside::Look> look;
};

/// The same of a recorded scan; nothing where the text is another, the scan came out otherwise or its end is not known.
Answer answerOf(InsideDesk::Bench& bench, history::Position at, const std::string& path, std::string_view text,
                inside::TextPart part) {
    std::shared_ptr<const image::CompiledProgram> program;
    if (bench.history.seek(at, &program).empty() || !program) return {};
    const tree::Program* tree = driver::treeOf(program);
    part.file = debug::fileOfPath(*program, path);
    if (!tree || !part.file.isValid() || program->sources[part.file].text() != text) return {};
    inside::LookOptions options;
    options.functions = inside::functionsIn(*tree, part.file, part.begin, part.end);
    if (options.functions.empty()) return {ExactText(), nullptr};
    const auto look = bench.insight.look(at, options);
    if (!look || !(*look)->isExact() || (*look)->isCut()) return {};
    return {shownOf(**look, part), *look};
}

/// Of the scan that stands at a breakpoint: what it computed until there.
Answer answerOf(InsideDesk::Bench& bench, const inside::Standing& standing, const std::string& path,
                std::string_view text, inside::TextPart part) {
    part.file = debug::fileOfPath(*standing.program, path);
    if (!part.file.isValid() || standing.program->sources[part.file].text() != text) return {};
    const auto found = inside::lookAtStanding(bench.insight, standing);
    if (!found) return {};
    part.until = found->end;
    ExactText shown = shownOf(*found->look, part);
    shown.notRun.clear(); // what did not run may still do so
    return {std::move(shown), nullptr};
}

/// The units that lines of a part of a file belong to.
std::set<std::string> unitsIn(const analysis::CodeModel& model, FileId file, uint32_t begin, uint32_t end) {
    std::set<std::string> units;
    const std::string_view text = model.sources()[file].text();
    for (size_t at = begin; at < std::min<size_t>(end, text.size());) {
        const std::string unit = model.pouAt(file, static_cast<uint32_t>(at));
        if (!unit.empty()) units.insert(unit.substr(0, unit.find('.')));
        const size_t next = text.find('\n', at);
        if (next == std::string_view::npos) break;
        at = next + 1;
    }
    return units;
}

} // namespace

ExactValues::ExactValues(Workspace& workspace, RunControl& control, InsideDesk& desk, QObject* parent)
    : QObject(parent), m_workspace(workspace), m_control(control), m_desk(desk) {
    const auto forget = [this] {
        for (auto& [editor, state] : m_states) {
            state = {};
            editor->setExactText(std::nullopt);
        }
    };
    connect(&control, &RunControl::sessionAboutToEnd, this, forget);
    connect(&control, &RunControl::recordedMustClose, this, forget);
}

void ExactValues::add(StEditor& editor) {
    m_states.try_emplace(&editor);
    connect(editor.verticalScrollBar(), &QScrollBar::valueChanged, this, [this, &editor] { refresh(editor); });
    connect(&editor, &QObject::destroyed, this, [this, key = &editor] { m_states.erase(key); });
    // The editor has let go of what it showed; an undo may lead back to the very same text.
    connect(&editor, &StEditor::textChanged, this, [this, &editor] { m_states[&editor].shown.reset(); });
    connect(&editor, &StEditor::passRequested, this, [this, &editor](uint32_t loop, quint64 pass) {
        m_states[&editor].passes[loop] = pass;
        refresh(editor);
    });
}

bool ExactValues::Wanted::operator==(const Wanted& other) const {
    return history == other.history && at == other.at && halt == other.halt && path == other.path &&
           model == other.model && part.begin == other.part.begin && part.end == other.part.end &&
           part.instances == other.part.instances && part.passes == other.part.passes;
}

bool ExactValues::isLive() const {
    return !m_control.viewed() && !m_control.showsRecorded() && m_control.status().state == controller::State::Running;
}

/// The scan that stands at a breakpoint; none: it does not, or cannot be looked into.
std::optional<inside::Standing> ExactValues::standing() const {
    session::Snapshot now;
    m_control.session()->latest(now);
    std::vector<session::FaultFrame> frames = m_control.session()->haltFrames();
    if (!now.isHalted || frames.empty() || !now.program) return std::nullopt;
    return inside::Standing{now.program, std::move(now.image), std::move(frames.front())};
}

/// Everything else that an editor shows is to be of the same moment as what the look tells.
StEditor::AtMoment ExactValues::momentOf(const inside::Look& look, std::span<const std::byte> image) const {
    auto moment = std::make_shared<RunControl::Moment>();
    moment->image.assign(image.begin(), image.end());
    moment->program = look.input().program;
    return [&control = m_control, moment](const std::function<void()>& read) { control.atMoment(*moment, read); };
}

/// What the editor is to show; nothing: live values only.
std::optional<ExactValues::Wanted> ExactValues::wanted(StEditor& editor, const State& state) const {
    const history::History* history = m_control.shownHistory();
    const bool isPast = m_control.viewed() || m_control.showsRecorded();
    if (!history || !editor.showsValues()) return std::nullopt;
    const history::Statistics statistics = history->statistics();
    const bool stands = !isPast && m_control.status().state == controller::State::Halted;
    if (statistics.scans == 0 && !stands) return std::nullopt;
    Wanted wanted;
    wanted.history = history;
    wanted.at = m_control.viewed().value_or(m_control.sampled());
    if (stands) wanted.halt = m_control.status().halts;
    wanted.path = editor.file().toStdString();
    wanted.model = m_workspace.model();
    const auto file = wanted.model ? wanted.model->fileOf(wanted.path) : std::nullopt;
    if (!file || !editor.isAsAnalysed()) return std::nullopt;
    std::tie(wanted.part.begin, wanted.part.end) = editor.visibleRange();
    wanted.part.passes = state.passes;
    for (const analysis::AccumulatorPlace& each : editor.accumulators())
        if (each.at >= wanted.part.begin && each.at < wanted.part.end) wanted.part.results.insert(each.at);
    for (const std::string& unit : unitsIn(*wanted.model, *file, wanted.part.begin, wanted.part.end))
        if (const QString instance = m_control.preferredInstance(QString::fromStdString(unit)); !instance.isEmpty())
            wanted.part.instances[unit] = instance.toStdString();
    return wanted;
}

void ExactValues::refresh(StEditor& editor) {
    State& state = m_states[&editor];
    if (m_walk) {
        state.shown.reset();
        return showWalk(editor, wanted(editor, state));
    }
    if (isLive() && (state.isOpen || (state.since.isValid() && state.since.elapsed() < kShare * state.cost))) return;
    std::optional<Wanted> now = wanted(editor, state);
    if (!now) {
        state.shown.reset();
        return editor.setExactText(std::nullopt);
    }
    if (state.shown && *state.shown == *now) return;
    ask(editor, state, std::move(*now));
}

void ExactValues::setWalk(std::shared_ptr<const inside::Look> look, const inside::SlowScan* scan) {
    m_walk = std::move(look);
    m_until = scan ? scan->event() : inside::kNone;
    m_walkMoment = m_walk && scan ? momentOf(*m_walk, scan->image()) : StEditor::AtMoment();
}

void ExactValues::showWalk(StEditor& editor, const std::optional<Wanted>& wanted) const {
    if (!wanted) return editor.setExactText(std::nullopt);
    inside::TextPart part = wanted->part;
    part.until = m_until;
    part.file = debug::fileOfPath(m_walk->program(), wanted->path);
    const auto file = wanted->model->fileOf(wanted->path);
    const bool isSame = part.file.isValid() && file &&
                        m_walk->program().sources[part.file].text() == wanted->model->sources()[*file].text();
    if (!isSame) return editor.setExactText(std::nullopt, m_walkMoment);
    ExactText shown = shownOf(*m_walk, part);
    part.until = inside::kNone; // dimmed is what this scan never runs, and not what it has yet to run
    shown.notRun = shownOf(*m_walk, part).notRun;
    editor.setExactText(std::move(shown), m_walkMoment);
}

void ExactValues::ask(StEditor& editor, State& state, Wanted wanted) {
    state.shown = wanted;
    state.since.start();
    const QString key = QString("text %1").arg(reinterpret_cast<quintptr>(&editor));
    const std::optional<inside::Standing> standing = wanted.halt ? this->standing() : std::nullopt;
    if (wanted.halt && !standing) return editor.setExactText(std::nullopt);
    state.isOpen = m_desk.ask(
        key,
        [this, target = QPointer<StEditor>(&editor), wanted, standing](InsideDesk::Bench& bench) -> InsideDesk::Finish {
            QElapsedTimer spent;
            spent.start();
            const auto file = wanted.model->fileOf(wanted.path);
            const std::string_view text = wanted.model->sources()[*file].text();
            const Answer answer = standing ? answerOf(bench, *standing, wanted.path, text, wanted.part)
                                           : answerOf(bench, wanted.at, wanted.path, text, wanted.part);
            return [this, target, wanted, answer, cost = spent.elapsed()] {
                if (!target) return;
                State& state = m_states[target.data()];
                state.isOpen = false;
                state.cost = cost;
                if (!state.shown || !(*state.shown == wanted)) return; // another is asked for already
                if (!target->isAsAnalysed()) return target->setExactText(std::nullopt);
                target->setExactText(answer.text,
                                     answer.look ? momentOf(*answer.look, answer.look->image()) : StEditor::AtMoment());
            };
        },
        InsideDesk::Needs::Controller);
}

} // namespace plc::editor
