// The watch: any ST expression, structures and arrays unfold, values in the chosen format, prepared values written or
// forced in one click. Owned by its dock; GUI thread; reads through RunControl at its pace, only the rows that are
// shown.
#pragma once
#include "editor/debug/run_control.h"
#include "editor/kit/ask_why.h"

#include <QTreeWidget>
#include <QWidget>

class QComboBox;

namespace plc::kit {
class ExpressionEdit;
}
namespace plc::editor {

class WatchView : public QWidget {
    Q_OBJECT
public:
    WatchView(RunControl& control, Workspace& workspace, QWidget* parent = nullptr);
    void add(const QString& expression);
    [[nodiscard]] QStringList expressions() const;
    void setExpressions(const QStringList& expressions);
    /// The list with what was typed into it, for the watch of another window on the same controller.
    struct Row {
        QString expression, prepared;
        bool isUnfolded = false;
        std::optional<types::NumberFormat> format; // its own; none: that of the list
    };
    [[nodiscard]] std::vector<Row> rows() const;
    void setRows(const std::vector<Row>& rows);
    struct List {
        QString name;
        std::vector<Row> rows; // of those that are not shown
    };
    struct Kept {
        std::vector<List> lists;
        size_t shown = 0;
    };
    [[nodiscard]] Kept kept();
    void restore(Kept kept);
    /// The lists by name, each of its own rows; one of them is shown.
    [[nodiscard]] QStringList listNames() const;
    [[nodiscard]] QString shownList() const { return m_lists[m_shown].name; }
    void addList(const QString& name); // and shows it
    void showList(const QString& name);
    void renameList(const QString& name);
    /// A variable has another name in the program: the rows of all lists follow.
    void renameExpressions(const std::function<QString(const QString& expression)>& renamed);
    [[nodiscard]] QStringList allExpressions() const; // of all lists
    void removeList();                                // the one that is shown; the last one is emptied
    /// For the settings of the project: all lists, and back.
    [[nodiscard]] QStringList stored() const;
    void restore(const QStringList& stored);

    void setRowFormat(QTreeWidgetItem* item, std::optional<types::NumberFormat> format);
    void setFormat(types::NumberFormat format);
    [[nodiscard]] types::NumberFormat format() const { return m_format; }
    [[nodiscard]] QTreeWidget& tree() { return *m_tree; }
    [[nodiscard]] static QString expressionOf(const QTreeWidgetItem* item);

    void refresh();
    void writePrepared();
    void forcePrepared();

signals:
    void expressionsChanged();
    void traceRequested(const QString& expression);
    /// The source of a block with the values of this instance: "MotorControl", "Main.pump[2]".
    void instanceRequested(const QString& block, const QString& instance);
    void whyRequested(plc::kit::AskWhy question, const QString& expression);

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    enum Column { Name, Value, Type, Prepared, Comment, Count };
    void fillRow(QTreeWidgetItem* item);
    void unfold(QTreeWidgetItem* item);
    void unfoldArray(QTreeWidgetItem* item, const types::Type& type, const QString& base, uint64_t from);
    QTreeWidgetItem* addPart(QTreeWidgetItem* parent, const QString& name, const QString& expression,
                             types::TypeId type);
    void prepare(QTreeWidgetItem* item); // by a double click on the value
    void togglePrepared(QTreeWidgetItem* item, bool isTrue);
    [[nodiscard]] types::NumberFormat formatOf(const QTreeWidgetItem* item) const;
    QWidget* makeListChoice();
    void keepShownRows();
    void showLists();
    void checkPrepared(QTreeWidgetItem* item);
    void removeSelected();
    void applyPrepared(bool force);
    void showMenu(const QPoint& position);

    RunControl& m_control;
    QTreeWidget* m_tree;
    kit::ExpressionEdit* m_input;
    std::vector<List> m_lists;
    size_t m_shown = 0;
    QComboBox* m_listChoice;
    unsigned m_frames = 0;
    types::NumberFormat m_format = types::NumberFormat::Decimal;
};

} // namespace plc::editor
