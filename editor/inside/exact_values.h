// Exact values in the text: asks what the scan that is shown did in the visible part of an editor, in the past and at a
// breakpoint at once, live as a sample ten times a second at most and never more than a tenth of a core. What else the
// editor shows is of the same moment. Owned by the window; GUI thread.
#pragma once
#include "editor/inside/inside_desk.h"
#include "editor/text/st_editor.h"
#include "runtime/inside/scan_text.h"
#include "runtime/inside/slow_scan.h"
#include "runtime/inside/standing.h"

#include <QElapsedTimer>

namespace plc::editor {

class ExactValues : public QObject {
    Q_OBJECT
public:
    ExactValues(Workspace& workspace, RunControl& control, InsideDesk& desk, QObject* parent = nullptr);

    void add(StEditor& editor);
    /// Shows in this editor what is to be seen now; asks only where something is another.
    void refresh(StEditor& editor);
    /// While a scan is walked through: what came before this moment has happened; null: none is.
    void setWalk(std::shared_ptr<const inside::Look> look, const inside::SlowScan* scan);

private:
    struct Wanted {
        const history::History* history = nullptr;
        history::Position at = 0;
        uint64_t halt = 0;     // which one the scan stands at; 0: none
        inside::TextPart part; // its file is found with the program
        std::string path;
        std::shared_ptr<const analysis::CodeModel> model;
        bool operator==(const Wanted& other) const;
    };
    struct State {
        std::optional<Wanted> shown; // or asked for
        bool isOpen = false;
        QElapsedTimer since;
        qint64 cost = 0; // ms of the last answer
        std::map<uint32_t, uint64_t> passes;
    };
    [[nodiscard]] std::optional<Wanted> wanted(StEditor& editor, const State& state) const;
    void ask(StEditor& editor, State& state, Wanted wanted);
    void showWalk(StEditor& editor, const std::optional<Wanted>& wanted) const;
    [[nodiscard]] bool isLive() const;
    [[nodiscard]] std::optional<inside::Standing> standing() const;
    [[nodiscard]] StEditor::AtMoment momentOf(const inside::Look& look, std::span<const std::byte> image) const;

    Workspace& m_workspace;
    RunControl& m_control;
    InsideDesk& m_desk;
    std::shared_ptr<const inside::Look> m_walk;
    inside::EventIndex m_until = inside::kNone;
    StEditor::AtMoment m_walkMoment;
    std::map<StEditor*, State> m_states;
};

} // namespace plc::editor
