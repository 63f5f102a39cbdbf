// Results of find in project, find all uses (cross reference: reads and writes), as lines to jump to; replaces in the
// whole project. Owned by its dock; GUI thread.
#pragma once
#include "editor/workspace/workspace.h"

#include <QTreeWidget>
#include <QWidget>

class QCheckBox;
class QLabel;
class QLineEdit;

#include <functional>
#include <map>

namespace plc::app {

class SearchView : public QWidget {
    Q_OBJECT
public:
    explicit SearchView(editor::Workspace& workspace, QWidget* parent = nullptr);
    void openSearch(const QString& text);
    void search();
    int replaceAll();
    /// A use in a panel or an alarm.
    struct PanelUse {
        QString file, element, text;
        bool isWrite = false;
    };
    void showUses(const QString& name, const std::vector<analysis::Use>& uses, const SourceSet& sources,
                  const std::vector<PanelUse>& inPanels = {});
    /// What is searched besides the sources: panels and alarms as they are edited, by file.
    void setPanelTexts(std::function<std::map<QString, std::string>()> texts) { m_panelTexts = std::move(texts); }
    [[nodiscard]] QTreeWidget& results() { return *m_results; }

signals:
    void placeRequested(const QString& file, uint32_t offset, uint32_t length);
    void panelPlaceRequested(const QString& file, const QString& element);
    void message(const QString& text, bool isError);
    /// The new texts of all files in which something is replaced.
    void textsReplaced(const std::map<QString, std::string>& texts);

private:
    void addLine(const QString& file, const SourceText& source, SourceRange range, const QString& kind);

    std::function<std::map<QString, std::string>()> m_panelTexts;
    editor::Workspace& m_workspace;
    QLineEdit *m_text, *m_replacement;
    QCheckBox *m_regex, *m_case;
    QLabel* m_summary;
    QTreeWidget* m_results;
};

} // namespace plc::app
