// What the window shows of the inside of recorded scans: asks why a value is as it is, and goes to the places and scans
// of the answers. Owned by the main window; GUI thread.
#pragma once
#include "editor/inside/exact_values.h"
#include "editor/inside/slow_scan_view.h"
#include "editor/inside/why_view.h"
#include "editor/text/st_editor.h"
#include "runtime/inside/coverage.h"

namespace plc::app {

class EditorTabs;

class InsideViews : public QObject {
    Q_OBJECT
public:
    InsideViews(editor::Workspace& workspace, editor::RunControl& control, EditorTabs& tabs, QObject* parent);

    [[nodiscard]] editor::WhyView& whyView() { return *m_why; }
    [[nodiscard]] editor::InsideDesk& desk() { return m_desk; }
    [[nodiscard]] editor::ExactValues& exactValues() { return m_exact; }
    [[nodiscard]] editor::SlowScanView& slowScan() { return *m_slow; }
    /// Walks through the scan that is shown, from its first statement on.
    void walk();
    /// In the margins of the texts; nothing: no more.
    void showCoverage(const std::shared_ptr<const image::CompiledProgram>& program,
                      const std::vector<inside::FunctionCoverage>& all);
    void hideCoverage();
    /// Of the newest scans of the recording that is shown, as many as a few seconds allow.
    void coverRecording();
    /// As seen from a unit of the program, "" = top; `at`: none: the scan that is shown.
    void ask(kit::AskWhy question, const QString& expression, const QString& pou = {},
             std::optional<history::Position> at = {});
    /// Asks about what has the focus: a row of the watch or of an answer, a variable of the tree, the text.
    void askAboutFocus(kit::AskWhy question);
    /// What a widget with the focus is about: expression and unit; null: nothing.
    using FocusedValue = std::function<std::optional<editor::StEditor::NamedValue>()>;
    void addFocus(FocusedValue value) { m_focused.push_back(std::move(value)); }

signals:
    void dockRequested(const QString& name);
    void message(const QString& text, bool isError);

private:
    void showWalk();
    void showCoverageIn(editor::StEditor& editor) const;

    std::map<QString, std::map<int, editor::LineCoverage>> m_coverage; // by file, by line from 1
    editor::RunControl& m_control;
    EditorTabs& m_tabs;
    editor::InsideDesk m_desk;
    editor::ExactValues m_exact;
    editor::WhyView* m_why;       // its dock owns it
    editor::SlowScanView* m_slow; // likewise
    std::vector<FocusedValue> m_focused;
};

} // namespace plc::app
