// What a mouse does at the head of a table, as a menu: width, order and sorting of each column. For the command of the
// window, which shows it for the table that has the keyboard; GUI thread.
#pragma once
#include <QCoreApplication>

class QAbstractItemView;
class QHeaderView;
class QMenu;

namespace plc::kit {

class ColumnMenu {
    Q_DECLARE_TR_FUNCTIONS(plc::kit::ColumnMenu)
public:
    /// The head of the table around `inside`; null when there is none to be seen.
    [[nodiscard]] static QHeaderView* headOf(QWidget* inside);
    /// One entry a column, in the order they are shown, that of the current cell in front. The caller owns it.
    [[nodiscard]] static QMenu* make(QHeaderView& head, QWidget* parent);

private:
    static void addColumn(QMenu& menu, QHeaderView& head, int column);
};

} // namespace plc::kit
