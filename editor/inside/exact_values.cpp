#include "editor/inside/exact_values.h"

#include "runtime/debug/sites.h"

#include <QPointer>
#include <QScrollBar>

#include <set>

namespace plc::editor {

namespace {

constexpr qint64 kSampleMs = 100, kShare = 10; // a sample each 100 ms; a tenth of a core at most
constexpr qsizetype kLongest = 40;             // characters of a value

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
    return shown;
}

/// The same of a recorded scan; nothing where the text is another or the scan came out otherwise.
std::optional<ExactText> exactTextOf(InsideDesk::Bench& bench, history::Position at, const std::string& path,
                                     std::string_view text, inside::TextPart part) {
    std::shared_ptr<const image::CompiledProgram> program;
    if (bench.history.seek(at, &program).empty() || !program) return std::nullopt;
    const tree::Program* tree = driver::treeOf(program);
    part.file = debug::fileOfPath(*program, path);
    if (!tree || !part.file.isValid() || program->sources[part.file].text() != text) return std::nullopt;
    inside::LookOptions options;
    options.functions = inside::functionsIn(*tree, part.file, part.begin, part.end);
    if (options.functions.empty()) return ExactText();
    const auto look = bench.insight.look(at, options);
    if (!look || !(*look)->isExact()) return std::nullopt;
    return shownOf(**look, part);
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
    connect(&editor, &StEditor::passRequested, this, [this, &editor](uint32_t loop, quint64 pass) {
        m_states[&editor].passes[loop] = pass;
        refresh(editor);
    });
}

bool ExactValues::Wanted::operator==(const Wanted& other) const {
    return history == other.history && at == other.at && path == other.path && model == other.model &&
           part.begin == other.part.begin && part.end == other.part.end && part.instances == other.part.instances &&
           part.passes == other.part.passes;
}

bool ExactValues::isLive() const {
    return !m_control.viewed() && !m_control.showsRecorded() && m_control.status().state == controller::State::Running;
}

/// What the editor is to show; nothing: live values only.
std::optional<ExactValues::Wanted> ExactValues::wanted(StEditor& editor, const State& state) const {
    const history::History* history = m_control.shownHistory();
    const bool isPast = m_control.viewed() || m_control.showsRecorded();
    if (!history || !editor.showsValues() || (!isPast && m_control.status().state == controller::State::Halted))
        return std::nullopt;
    const history::Statistics statistics = history->statistics();
    if (statistics.scans == 0) return std::nullopt;
    Wanted wanted;
    wanted.history = history;
    wanted.at = m_control.viewed().value_or(statistics.end - 1);
    wanted.path = editor.file().toStdString();
    wanted.model = m_workspace.model();
    const auto file = wanted.model ? wanted.model->fileOf(wanted.path) : std::nullopt;
    if (!file || !editor.isAsAnalysed()) return std::nullopt;
    std::tie(wanted.part.begin, wanted.part.end) = editor.visibleRange();
    wanted.part.passes = state.passes;
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
    if (isLive() &&
        (state.isOpen || (state.since.isValid() && state.since.elapsed() < std::max(kSampleMs, kShare * state.cost))))
        return;
    std::optional<Wanted> now = wanted(editor, state);
    if (!now) {
        state.shown.reset();
        return editor.setExactText(std::nullopt);
    }
    if (state.shown && *state.shown == *now) return;
    ask(editor, state, std::move(*now));
}

void ExactValues::setWalk(std::shared_ptr<const inside::Look> look, inside::EventIndex until) {
    m_walk = std::move(look);
    m_until = until;
}

void ExactValues::showWalk(StEditor& editor, const std::optional<Wanted>& wanted) const {
    if (!wanted) return editor.setExactText(std::nullopt);
    inside::TextPart part = wanted->part;
    part.until = m_until;
    part.file = debug::fileOfPath(m_walk->program(), wanted->path);
    const auto file = wanted->model->fileOf(wanted->path);
    const bool isSame = part.file.isValid() && file &&
                        m_walk->program().sources[part.file].text() == wanted->model->sources()[*file].text();
    editor.setExactText(isSame ? std::optional(shownOf(*m_walk, part)) : std::nullopt);
}

void ExactValues::ask(StEditor& editor, State& state, Wanted wanted) {
    state.shown = wanted;
    state.since.start();
    const QString key = QString("text %1").arg(reinterpret_cast<quintptr>(&editor));
    state.isOpen = m_desk.ask(key, [this, target = QPointer<StEditor>(&editor), wanted](InsideDesk::Bench& bench) {
        QElapsedTimer spent;
        spent.start();
        const auto file = wanted.model->fileOf(wanted.path);
        auto text = exactTextOf(bench, wanted.at, wanted.path, wanted.model->sources()[*file].text(), wanted.part);
        return [this, target, wanted, text = std::move(text), cost = spent.elapsed()] {
            if (!target) return;
            State& state = m_states[target.data()];
            state.isOpen = false;
            state.cost = cost;
            if (!state.shown || !(*state.shown == wanted)) return; // another is asked for already
            target->setExactText(target->isAsAnalysed() ? text : std::nullopt);
        };
    });
}

} // namespace plc::editor
