// What one does with the units and names of the program: new, go to, find, rename, delete, convert, each with what
// refers to it in panels. Owned by the main window; GUI thread.
#pragma once
#include "app/pages/editor_tabs.h"
#include "app/panels/live_views.h"
#include "app/project/search_view.h"
#include "editor/debug/run_control.h"
#include "editor/debug/watch_view.h"
#include "editor/workspace/workspace.h"
#include "hmi/designer/context/design_context.h"
#include "projects/analysis/conversion.h"

#include <QObject>

namespace plc::app {

class UnitCommands : public QObject {
    Q_OBJECT
public:
    struct Parts {
        QWidget& window; // of questions
        editor::Workspace& workspace;
        editor::RunControl& control;
        EditorTabs& tabs;
        LiveViews& live;
        SearchView& search;
        editor::WatchView& watch;
    };
    UnitCommands(Parts parts, QObject* parent);

    /// Asks what; kind and file are preset, "" leaves the choice.
    void newUnit(const QString& kind = {}, const QString& file = {});
    void goToLine();
    void findDefinition(const QString& file, uint32_t offset);
    void findUses(const QString& file, uint32_t offset);
    /// Asks for the new name, with all places.
    void renameSymbol(const QString& file, uint32_t offset);
    /// In the code, the tests, panels, alarms, recipes, watch lists and traces; one undo takes all of it back.
    void renameTo(const QString& file, uint32_t offset, const QString& name);
    void definitionAtCursor();
    void usesAtCursor();
    void renameAtCursor();
    void deleteUnit(const QString& file, uint32_t begin, uint32_t end, const QString& name);
    /// The unit at the cursor in the other language, beside its text.
    void showConverted(analysis::TextLanguage to);
    /// The source of a block, with the values of one instance.
    void showInstance(const QString& block, const QString& instance);

signals:
    void message(const QString& text, bool isError = false);
    void usesShown(); // the search has them

private:
    /// How panels, alarms and recipes name it; only where there are panels.
    [[nodiscard]] hmi::DesignContext::NamedVariable inPanels(const sema::Symbol& symbol) const;
    [[nodiscard]] std::vector<SearchView::PanelUse> usesInPanels(const sema::Symbol& symbol) const;
    void addTo(const QString& file, const std::string& text);
    /// What names variables beside the code and the panels: watch lists and the set-up of the trace.
    [[nodiscard]] QStringList watched() const;
    /// Renames what names the variable beside the sources: panels, alarms, recipes, watch lists and the trace; or, with
    /// true, takes that back. Empty where its path does not end with its name.
    [[nodiscard]] std::function<void(bool)> followers(const hmi::DesignContext::NamedVariable& before,
                                                      const QString& name) const;
    /// What the running controller makes of the new name, in words; "" while none runs.
    [[nodiscard]] QString noteOnRunning(const sema::Symbol& symbol) const;

    Parts m_parts;
};

} // namespace plc::app
