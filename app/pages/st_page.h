// One ST file in a tab: editor, second view when split, find bar, table of declarations, chart, and what is to be known
// about the file. A library's source is such a page, read-only. Owned by the tabs; GUI thread.
#pragma once
#include "editor/graph/chart/chart_view.h"
#include "editor/graph/ladder/ladder_view.h"
#include "editor/text/declaration_table.h"
#include "editor/text/find_bar.h"
#include "editor/text/st_editor.h"

#include <QPointer>
#include <QSplitter>
#include <QWidget>

#include <vector>

class QLabel;

namespace plc::app {

class InstanceBar;

class StPage : public QWidget {
    Q_OBJECT
public:
    enum class Kind : uint8_t { Project, Library };
    StPage(const QString& file, QWidget* parent, Kind kind = Kind::Project);
    /// The side that had the focus last.
    [[nodiscard]] editor::StEditor& active() { return *m_active; }
    [[nodiscard]] editor::StEditor& first() { return *m_first; }
    [[nodiscard]] editor::FindBar& findBar() { return *m_find; }
    [[nodiscard]] InstanceBar& instanceBar() { return *m_instances; }
    [[nodiscard]] editor::DeclarationTable& table() { return *m_table; }
    [[nodiscard]] const QString& file() const { return m_file; }
    [[nodiscard]] bool isLibrary() const { return m_kind == Kind::Library; }
    void toggleSplit();
    /// Another file at the right of this one, over the same text as its own page; null takes it away.
    void showBeside(StPage* other);
    [[nodiscard]] editor::StEditor* beside() { return m_beside; }
    void toggleTable();
    /// The chart of a unit beside the text, null when the unit has none; "" = the unit at the cursor, or none any more
    /// when it is shown.
    editor::ChartView* showChart(const QString& unit);
    [[nodiscard]] editor::ChartView* chart() { return m_chart; }
    /// The ladder or function block diagram of a unit beside the text; null and hidden for "".
    editor::LadderView* showLadder(const QString& unit);
    [[nodiscard]] editor::LadderView* ladder() { return m_ladder; }
    /// The drawings there are, shown or not.
    [[nodiscard]] std::vector<editor::GraphView*> graphs();
    /// Shows the unit at the cursor as a chart or as the diagram that it prefers, or hides what is shown.
    void toggleGraph();
    /// As {attribute 'view'} of the file's first unit that has one says.
    void showPreferred();
    /// The chart around the cursor, of a unit or of an action in it; else the unit at the cursor.
    [[nodiscard]] QString chartAtCursor();
    [[nodiscard]] std::vector<editor::StEditor*> editors();
    /// The file's mode has no w: a line above the text says so.
    void showReadOnly(bool isReadOnly);
    [[nodiscard]] bool saysReadOnly() const;

signals:
    void editorMade(plc::editor::StEditor* editor);
    void chartMade(plc::editor::ChartView* chart);
    void ladderMade(plc::editor::LadderView* ladder);
    void writableRequested(const QString& file);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setActive(editor::StEditor& editor);
    [[nodiscard]] QWidget* makeNotice();

    QString m_file;
    Kind m_kind;
    QWidget* m_notice = nullptr;
    InstanceBar* m_instances = nullptr;
    QSplitter* m_sides = nullptr;
    QSplitter* m_splitter = nullptr;
    editor::ChartView* m_chart = nullptr;
    editor::LadderView* m_ladder = nullptr;
    editor::StEditor* m_first = nullptr;
    editor::StEditor* m_second = nullptr;
    QPointer<QWidget> m_besideFrame;
    QPointer<editor::StEditor> m_beside;
    editor::StEditor* m_active = nullptr;
    editor::FindBar* m_find = nullptr;
    editor::DeclarationTable* m_table = nullptr;
};

} // namespace plc::app
