#include "app/online/inside_views.h"

#include "app/pages/editor_tabs.h"
#include "app/pages/online_marks.h"
#include "editor/kit/message_text.h"
#include "editor/workspace/path_completion.h"
#include "runtime/inside/texts.h"

#include <QElapsedTimer>

namespace plc::app {

InsideViews::InsideViews(editor::Workspace& workspace, editor::RunControl& control, EditorTabs& tabs, QObject* parent)
    : QObject(parent), m_control(control), m_tabs(tabs), m_desk(control), m_exact(workspace, control, m_desk),
      m_why(new editor::WhyView(m_desk, control)), m_slow(new editor::SlowScanView(m_desk, control)) {
    connect(m_slow, &editor::SlowScanView::moved, this, &InsideViews::showWalk);
    connect(m_slow, &editor::SlowScanView::placeRequested, &tabs, &EditorTabs::goTo);

    m_why->setCompletionSource(editor::pathCompletions(workspace));
    connect(m_why, &editor::WhyView::scanRequested, &control,
            [&control](history::Position position) { control.view(position); });
    connect(m_why, &editor::WhyView::placeRequested, &tabs, &EditorTabs::goTo);
    connect(&control, &editor::RunControl::refreshed, this, [this] {
        if (StPage* page = m_tabs.currentPage())
            for (editor::StEditor* each : page->editors()) m_exact.refresh(*each);
    });
    connect(&tabs, &EditorTabs::editorMade, this, [this](editor::StEditor* made) {
        m_exact.add(*made);
        showCoverageIn(*made);
        connect(made, &editor::StEditor::whyRequested, this,
                [this](kit::AskWhy question, const QString& name, const QString& pou) { ask(question, name, pou); });
    });
}

void InsideViews::ask(kit::AskWhy question, const QString& expression, const QString& pou,
                      std::optional<history::Position> at) {
    emit dockRequested("why");
    // A name inside a unit is meant as seen from its instance; what is only known from the top is not.
    const QString instance = pou.isEmpty() ? QString() : m_control.preferredInstance(pou);
    const bool isLocal = !instance.isEmpty() && m_control.value(expression, instance).type.isValid();
    m_why->ask(question, expression, isLocal ? instance : QString(), at);
}

void InsideViews::walk() {
    emit dockRequested("slowScan");
    m_slow->open();
}

/// The text stands where the walk stands, with the values of that moment.
void InsideViews::showWalk() {
    const inside::SlowScan* scan = m_slow->scan();
    m_exact.setWalk(m_slow->look(), scan);
    std::optional<editor::RunControl::TextPlace> place;
    if (scan) place = m_control.placeInText(scan->range(), m_slow->look()->program());
    m_tabs.marks().showWalk(place);
    if (StPage* page = m_tabs.currentPage())
        for (editor::StEditor* each : page->editors()) m_exact.refresh(*each);
}

// ------------------------------------------------------------------ coverage

namespace {

editor::LineCoverage shownOf(const inside::LineCoverage& line) {
    using From = inside::LineCoverage::State;
    using To = editor::LineCoverage::State;
    editor::LineCoverage shown;
    shown.state = line.state() == From::NotRun ? To::NotRun : line.state() == From::Partly ? To::Partly : To::Run;
    QStringList said{kit::messageText(line.count ? inside::texts::RunTimes(line.count) : inside::texts::NotRun())};
    for (const Message& missing : line.missing) said << kit::messageText(missing);
    shown.text = said.join(u'\n');
    return shown;
}

} // namespace

void InsideViews::showCoverage(const std::shared_ptr<const image::CompiledProgram>& program,
                               const std::vector<inside::FunctionCoverage>& all) {
    m_coverage.clear();
    for (const inside::FunctionCoverage& function : all)
        for (const auto& [number, line] : inside::linesOf(*program, function))
            if (line.state() != inside::LineCoverage::State::None)
                m_coverage[QString::fromStdString(function.file)][static_cast<int>(number)] = shownOf(line);
    for (editor::StEditor* each : m_tabs.editors()) showCoverageIn(*each);
}

void InsideViews::hideCoverage() {
    m_coverage.clear();
    for (editor::StEditor* each : m_tabs.editors()) showCoverageIn(*each);
}

void InsideViews::showCoverageIn(editor::StEditor& editor) const {
    const auto found = m_coverage.find(editor.file());
    editor.setCoverage(found == m_coverage.end() ? std::map<int, editor::LineCoverage>() : found->second);
    if (StPage* page = m_tabs.pageOf(editor.file()))
        for (editor::GraphView* graph : page->graphs()) graph->coverageChanged();
}

void InsideViews::coverRecording() {
    constexpr int kLongestMs = 4000;
    const bool isAsked = m_desk.ask("coverage", [this](editor::InsideDesk::Bench& bench) -> editor::InsideDesk::Finish {
        QElapsedTimer spent;
        spent.start();
        const history::Statistics statistics = bench.history.statistics();
        std::shared_ptr<const image::CompiledProgram> program;
        if (bench.history.seek(statistics.end - 1, &program).empty() || !program) return {};
        inside::Coverage coverage(program);
        history::Position at = statistics.end;
        for (; at > statistics.first && spent.elapsed() < kLongestMs && !bench.insight.isCancelled(); --at)
            (void)coverage.add(bench.insight, at - 1); // what can be run again
        return [this, program, all = coverage.functions(), scans = statistics.end - at, of = statistics.scans] {
            showCoverage(program, all);
            emit message(tr("Coverage of the latest %1 of %2 recorded scans").arg(scans).arg(of), false);
        };
    });
    if (!isAsked) emit message(tr("There is no recording yet: run the program first."), true);
}

// ------------------------------------------------------------------ what is asked

void InsideViews::askAboutFocus(kit::AskWhy question) {
    for (const FocusedValue& each : m_focused)
        if (const auto value = each()) return ask(question, value->name, value->pou);
    const editor::StEditor* text = m_tabs.currentEditor();
    const auto value = text ? text->askedAbout() : std::nullopt;
    if (!value) {
        emit message(tr("Put the cursor on a variable, or select an expression, to ask about it"), false);
        return;
    }
    ask(question, value->name, value->pou);
}

} // namespace plc::app
