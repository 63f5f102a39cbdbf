#include "editor/kit/column_menu.h"

#include <QHeaderView>
#include <QMenu>
#include <QTableView>
#include <QTreeView>

#include <algorithm>

namespace plc::kit {

namespace {

constexpr int kColumnStep = 24; // pixels that one choice of Wider or Narrower changes

void sortBy(QHeaderView& head, int column, Qt::SortOrder order) {
    head.setSortIndicator(column, order); // the view sorts by it
}

bool isSorted(const QHeaderView& head) {
    if (const auto* table = qobject_cast<const QTableView*>(head.parentWidget())) return table->isSortingEnabled();
    if (const auto* tree = qobject_cast<const QTreeView*>(head.parentWidget())) return tree->isSortingEnabled();
    return false;
}

int fittingSize(QHeaderView& head, int column) {
    // The views' sizeHintForColumn is protected; the slots that use it are not.
    const int before = head.sectionSize(column);
    if (auto* table = qobject_cast<QTableView*>(head.parentWidget())) table->resizeColumnToContents(column);
    if (auto* tree = qobject_cast<QTreeView*>(head.parentWidget())) tree->resizeColumnToContents(column);
    return std::max(1, head.sectionSize(column) ? head.sectionSize(column) : before);
}

} // namespace

QHeaderView* ColumnMenu::headOf(QWidget* inside) {
    for (QWidget* at = inside; at; at = at->parentWidget()) {
        QHeaderView* head = nullptr;
        if (auto* table = qobject_cast<QTableView*>(at)) head = table->horizontalHeader();
        if (auto* tree = qobject_cast<QTreeView*>(at)) head = tree->header();
        if (head) return head->isHidden() || head->count() == 0 ? nullptr : head;
        if (at->isWindow()) break;
    }
    return nullptr;
}

void ColumnMenu::addColumn(QMenu& menu, QHeaderView& head, int column) {
    QString title = head.model()->headerData(column, Qt::Horizontal).toString();
    if (title.isEmpty()) title = tr("Column %1").arg(column + 1);
    QMenu* of = menu.addMenu(title.replace('&', "&&"));
    QHeaderView* const at = &head;
    if (head.sectionResizeMode(column) == QHeaderView::Interactive) {
        of->addAction(tr("Fit to Contents"), at, [at, column] { at->resizeSection(column, fittingSize(*at, column)); });
        of->addAction(tr("Wider"), at,
                      [at, column] { at->resizeSection(column, at->sectionSize(column) + kColumnStep); });
        of->addAction(tr("Narrower"), at, [at, column] {
            at->resizeSection(column, std::max(at->minimumSectionSize(), at->sectionSize(column) - kColumnStep));
        });
    }
    if (head.sectionsMovable()) {
        const int place = head.visualIndex(column);
        QAction* left = of->addAction(tr("Move Left"), at, [at, place] { at->moveSection(place, place - 1); });
        left->setEnabled(place > (at->isFirstSectionMovable() ? 0 : 1));
        QAction* right = of->addAction(tr("Move Right"), at, [at, place] { at->moveSection(place, place + 1); });
        right->setEnabled(place + 1 < at->count() && (place > 0 || at->isFirstSectionMovable()));
    }
    if (isSorted(head)) {
        of->addAction(tr("Sort Ascending"), at, [at, column] { sortBy(*at, column, Qt::AscendingOrder); });
        of->addAction(tr("Sort Descending"), at, [at, column] { sortBy(*at, column, Qt::DescendingOrder); });
    }
    if (of->isEmpty()) of->menuAction()->setEnabled(false);
}

QMenu* ColumnMenu::make(QHeaderView& head, QWidget* parent) {
    auto* menu = new QMenu(parent);
    for (int place = 0; place < head.count(); ++place)
        if (const int column = head.logicalIndex(place); !head.isSectionHidden(column)) addColumn(*menu, head, column);
    const auto* view = qobject_cast<QAbstractItemView*>(head.parentWidget());
    const int current = view && view->currentIndex().isValid() ? head.visualIndex(view->currentIndex().column()) : 0;
    if (current >= 0 && current < menu->actions().size()) menu->setActiveAction(menu->actions()[current]);
    return menu;
}

} // namespace plc::kit
