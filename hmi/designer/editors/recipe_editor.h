// The project's recipes as tables: a row for each variable with its limits, a column for each set; with undo, CSV, and
// what is wrong marked in its cell. Owned by its Qt parent; the context must outlive it. Main thread.
#pragma once
#include "hmi/designer/context/design_context.h"

#include <QUndoStack>
#include <QWidget>

class QLabel;
class QListWidget;
class QTableWidget;

namespace plc::hmi {

class RecipeEditor final : public QWidget {
    Q_OBJECT
public:
    enum Column { Variable, Title, Unit, Format, Minimum, Maximum, FirstSet };
    explicit RecipeEditor(DesignContext& context, QWidget* parent = nullptr);
    QUndoStack& undoStack() { return m_undo; }
    QTableWidget& table() { return *m_table; }
    QListWidget& list() { return *m_list; }
    QString problems() const;

    void select(const QString& recipe);
    void addRecipe();
    void addVariable(const QString& path);
    void addSet();
    /// What is wrong with the name, which is not empty and has no blanks around it; "" when the set has it.
    [[nodiscard]] QString renameSet(int column, const QString& name);
    /// The column of the current cell where that is a set's, else its row.
    void removeSelected();
    void removeRecipe();
    void importCsv(const QString& path);
    void exportCsv(const QString& path);

private:
    const Recipe* current() const;
    void edit(const QString& title, const std::function<void(Recipe&)>& change);
    void perform(const QString& title, RecipeFile after, const DesignContext::NamesInPanels& names = {});
    void commit(int row, int column, const QString& text);
    void renameRecipe(int row, const QString& name);
    void rebuild();
    void fillTable(const Recipe& recipe);
    void showProblems(const Recipe& recipe);
    void tell(const Error& problem);
    void refuse(const QString& why);
    void askForSetName(int column);

    DesignContext& m_context;
    QUndoStack m_undo;
    QListWidget* m_list;
    QTableWidget* m_table;
    QLabel* m_problems;
    QString m_current;
};

} // namespace plc::hmi
