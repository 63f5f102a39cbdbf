#include "app/pages/online_marks.h"

#include "app/pages/editor_tabs.h"
#include "app/pages/fault_cause.h"
#include "app/pages/instance_bar.h"
#include "editor/kit/inputs/text_question.h"
#include "editor/kit/message_text.h"
#include "runtime/compiler/driver/driver.h"

#include <QApplication>
#include <QPointer>

#include <algorithm>

namespace plc::app {

using editor::StEditor;

OnlineMarks::OnlineMarks(EditorTabs& tabs, editor::Workspace& workspace, editor::RunControl& control)
    : QObject(&tabs), m_tabs(tabs), m_workspace(workspace), m_control(control) {
    connect(&control, &editor::RunControl::breakpointsChanged, this, &OnlineMarks::showBreakpoints);
    connect(&control, &editor::RunControl::statusChanged, this, &OnlineMarks::showExecutedLine);
    connect(&control, &editor::RunControl::halted, this, &OnlineMarks::showExecutedLine);
    connect(&control, &editor::RunControl::refreshed, this, &OnlineMarks::refreshValues);
}

void OnlineMarks::refreshValues() {
    // Ten times a second while it runs: more nobody reads.
    if (m_control.status().state == controller::State::Running && !m_control.viewed() && ++m_frames % 3 != 0) return;
    if (StPage* page = m_tabs.currentPage()) {
        for (StEditor* editor : page->editors()) editor->refreshOnlineValues();
        if (page->beside()) page->beside()->refreshOnlineValues();
        page->active().atShownMoment([page] { page->table().refreshOnlineValues(); });
        showInstance(*page);
        for (editor::GraphView* graph : page->graphs()) {
            graph->setPast(m_control.viewed().has_value());
            graph->refreshOnline();
        }
    }
}

/// A local of the instance that the text shows, else a global; "" when it is neither.
QString OnlineMarks::pathOf(const QString& name, const QString& pou) const {
    if (!m_workspace.model()) return {};
    const auto& checked = m_workspace.model()->checked();
    const QString block = pou.section('.', 0, 0), instance = m_control.preferredInstance(block);
    for (const QString& path : {(instance.isEmpty() ? block : instance) + '.' + name, name})
        if (driver::compileExpression(checked, path.toStdString())) return path;
    return {};
}

QString OnlineMarks::pathOrComplain(const QString& name, const QString& pou) const {
    const QString path = pathOf(name, pou);
    if (path.isEmpty())
        emit m_tabs.message(
            EditorTabs::tr(
                "%1 is not a variable of the running program; check the name, or press F5 to build the program")
                .arg(name),
            true);
    return path;
}

void OnlineMarks::askForValue(const QString& name, const QString& pou, bool force) {
    const QString path = pathOrComplain(name, pou);
    if (path.isEmpty()) return;
    const auto shown = m_control.value(path);
    const QString present = shown.isBool ? (shown.isTrue ? "FALSE" : "TRUE") : shown.text; // a BOOL is to be the other
    const auto take = [&](const QString& text) {
        const auto done = force ? m_control.force(path, text) : m_control.write(path, text);
        return done ? QString() : kit::messageText(done.error());
    };
    kit::TextQuestion(force ? EditorTabs::tr("Force") : EditorTabs::tr("Write"), path, present, take, &m_tabs).ask();
}

void OnlineMarks::showInstance(StPage& page) {
    const auto model = m_workspace.model();
    const auto file = model ? model->fileOf(page.file().toStdString()) : std::nullopt;
    QString block;
    QStringList instances;
    if (file && m_control.hasValues()) {
        block = QString::fromStdString(model->pouAt(*file, page.active().cursorOffset())).section('.', 0, 0);
        for (const QString& each : m_control.instancesOf(block)) instances << each;
        if (instances.size() == 1 && instances.front().compare(block, Qt::CaseInsensitive) == 0)
            instances.clear(); // a program is its own
    }
    page.instanceBar().show(block, instances, m_control.preferredInstance(block));
}

editor::OnlineValues OnlineMarks::values() {
    return [this](const std::vector<std::pair<QString, QString>>& names) {
        std::vector<editor::OnlineValue> out;
        if (!m_control.hasValues()) return out;
        for (const auto& [name, pou] : names) {
            const auto shown = m_control.valueIn(name, pou);
            const auto* program = m_control.imageProgram();
            if (shown.text.isEmpty() || !program || !shown.type.isValid() ||
                program->layout.types->isAggregate(shown.type))
                continue;
            out.push_back({name, shown.text.left(40), shown.isBool, shown.isTrue, shown.isForced});
        }
        return out;
    };
}

void OnlineMarks::showBreakpoints() {
    for (StEditor* editor : m_tabs.editors()) {
        std::set<int> lines, disabled;
        for (const editor::EditorBreakpoint& b : m_control.breakpoints()) {
            if (b.file != editor->file()) continue;
            lines.insert(b.line);
            if (!b.isEnabled || !b.hasCode) disabled.insert(b.line);
        }
        editor->setBreakpoints(lines, disabled);
        if (StPage* page = m_tabs.pageOf(editor->file()))
            for (editor::GraphView* graph : page->graphs()) graph->setBreakpoints(lines, disabled);
    }
}

void OnlineMarks::showWalk(std::optional<editor::RunControl::TextPlace> place) {
    m_walk = std::move(place);
    showExecutedLine();
}

/// What a question about the fault is about, so that Why? asks just that.
void OnlineMarks::selectCause(uint32_t statement, uint32_t length) {
    StEditor* editor = m_tabs.currentEditor();
    if (!editor) return;
    const std::string text = editor->utf8();
    if (statement + length > text.size()) return;
    const IsFollowed isFollowed = [&](uint32_t begin, uint32_t end) {
        return isFollowedAt(editor->file(), statement + begin, statement + end);
    };
    const auto cause =
        causeOfFault(m_control.status().fault->code, std::string_view(text).substr(statement, length), isFollowed);
    if (cause) editor->goTo(statement + cause->first, cause->second);
}

/// The name at that place is of a REFERENCE or interface, which leads elsewhere without a `^`.
bool OnlineMarks::isFollowedAt(const QString& file, uint32_t begin, uint32_t end) const {
    const auto model = m_workspace.model();
    const std::optional<FileId> id = model ? model->fileOf(file.toStdString()) : std::nullopt;
    if (!id || !model->checked().analysis->program) return false;
    const sema::Analysis& analysis = *model->checked().analysis;
    const types::TypeTable& types = *analysis.program->layout.types;
    return std::any_of(analysis.references.begin(), analysis.references.end(), [&](const sema::Reference& each) {
        if (each.range.file != *id || each.range.begin != begin || each.range.end != end || !each.symbol.isValid())
            return false;
        const types::TypeKind kind = types.kind(analysis.symbols[each.symbol.index()].type);
        return kind == types::TypeKind::Reference || kind == types::TypeKind::Interface;
    });
}

/// Where the controller stands: at a breakpoint, after a step, or where a fault has stopped it.
void OnlineMarks::showExecutedLine() {
    using controller::State;
    const State state = m_walk ? State::Halted : m_control.status().state;
    SourceRange range;
    if (m_walk) {
        range.begin = m_walk->offset;
    } else if (m_control.session() && state == State::Halted) {
        const auto frames = m_control.session()->haltFrames();
        if (!frames.empty()) range = frames.front().range;
    } else if (m_control.session() && state == State::Fault && m_control.status().fault) {
        range = m_control.status().fault->range;
    }
    const auto place = m_walk ? m_walk : m_control.placeInText(range);
    const QString file = place ? place->file : QString();
    const int line = place ? place->line : 0;
    const QString shown = QString("%1:%2:%3").arg(file).arg(range.begin).arg(static_cast<int>(state));
    const bool isNew = std::exchange(m_shownPlace, shown) != shown;
    if (line && isNew) {
        const QPointer<QWidget> focus = QApplication::focusWidget(); // who types elsewhere goes on there
        m_tabs.goToLine(file, line);
        if (state == State::Fault) selectCause(place->offset, range.end - range.begin);
        if (focus && !m_tabs.isAncestorOf(focus)) focus->setFocus();
    }
    for (StEditor* editor : m_tabs.editors()) {
        const int here = editor->file() == file ? line : 0;
        editor->setExecutedLine(state == State::Halted ? here : 0);
        editor->setFaultLine(state == State::Fault ? here : 0);
    }
    for (StPage* page : m_tabs.pages()) {
        const bool isHere = state == State::Halted && line && page->file() == file;
        for (editor::GraphView* graph : page->graphs())
            graph->setStanding(isHere ? std::optional(place->offset) : std::nullopt);
    }
    if (line && isNew && m_tabs.currentEditor()) m_tabs.currentEditor()->ensureLineVisible(line - 1);
}

} // namespace plc::app
