#include "editor/debug/watch_view.h"

#include "editor/debug/watch_rows.h"
#include "editor/kit/icons.h"
#include "editor/kit/inputs/expression_edit.h"
#include "editor/kit/inputs/text_question.h"
#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "editor/workspace/path_completion.h"

#include <QAction>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QMimeData>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <map>

namespace plc::editor {

namespace {
const QChar kRowEnd(0x1e), kPartEnd(0x1f); // in the settings

/// Rows are dragged as the variables that they watch: onto a panel, a chart or an entry.
class WatchTree final : public QTreeWidget {
public:
    using QTreeWidget::QTreeWidget;
    /// True: a double click there has done its work, nothing opens.
    std::function<bool(QTreeWidgetItem* item, int column)> onDoubleClick;
    /// Down or up only: the columns stay under the pointer between the two clicks of a double click.
    void scrollTo(const QModelIndex& index, ScrollHint hint) override {
        const int left = horizontalScrollBar()->value();
        QTreeWidget::scrollTo(index, hint);
        horizontalScrollBar()->setValue(left);
    }

protected:
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override {
        if (trigger == DoubleClicked && onDoubleClick && onDoubleClick(itemFromIndex(index), index.column()))
            return true;
        return QTreeWidget::edit(index, trigger, event);
    }
    QStringList mimeTypes() const override { return {kit::VariableMime}; }
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
        QStringList paths;
        for (const QTreeWidgetItem* item : items)
            if (const QString path = WatchView::expressionOf(item); !path.isEmpty()) paths += path;
        return paths.isEmpty() ? nullptr : kit::makeVariableMime(paths);
    }
};

/// Values and types are read; what is typed is an expression or a prepared value.
class WatchDelegate final : public QStyledItemDelegate {
public:
    WatchDelegate(QObject* parent, int name, int prepared)
        : QStyledItemDelegate(parent), m_name(name), m_prepared(prepared) {}
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        const bool isTyped = index.column() == m_prepared || (index.column() == m_name && !index.parent().isValid());
        return isTyped ? QStyledItemDelegate::createEditor(parent, option, index) : nullptr;
    }

private:
    int m_name, m_prepared;
};

} // namespace

WatchView::WatchView(RunControl& control, Workspace& workspace, QWidget* parent) : QWidget(parent), m_control(control) {
    auto* tree = new WatchTree(this);
    m_tree = tree;
    tree->onDoubleClick = [this](QTreeWidgetItem* item, int column) {
        if (column != Prepared) return false;
        const RunControl::Shown shown = m_control.value(expressionOf(item));
        if (shown.isBool) togglePrepared(item, shown.isTrue);
        return shown.isBool;
    };
    m_tree->setDragEnabled(true);
    m_tree->setColumnCount(Column::Count);
    m_tree->setHeaderLabels({tr("Expression"), tr("Value"), tr("Type"), tr("Prepared"), tr("Comment")});
    m_tree->setAlternatingRowColors(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_tree->setAccessibleName(tr("Watch list"));
    m_tree->setItemDelegate(new WatchDelegate(m_tree, Name, Prepared));
    auto* remove = new QAction(kit::icon(kit::Icon::Delete), tr("Remove"), m_tree);
    remove->setShortcut(QKeySequence::Delete);
    remove->setShortcutContext(Qt::WidgetShortcut);
    connect(remove, &QAction::triggered, this, &WatchView::removeSelected);
    m_tree->addAction(remove);
    connect(m_tree, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item, int column) {
        if (column == Value) prepare(item);
    });
    m_tree->header()->setStretchLastSection(true);
    m_tree->header()->moveSection(Prepared, Type); // in sight beside the value
    m_tree->setColumnWidth(Name, 150);
    m_tree->setColumnWidth(Value, 90);
    m_tree->setColumnWidth(Prepared, 80);
    m_tree->setColumnWidth(Type, 70);
    m_input = new kit::ExpressionEdit(this);
    m_input->setCompletionSource(pathCompletions(workspace));
    m_input->setEndsWithCompletion(true);
    m_input->setPlaceholderText(tr("Add an expression: Main.x, a[i] * 2, fb.Q AND NOT done"));
    m_input->setClearButtonEnabled(true);
    m_input->setAccessibleName(tr("New watch expression"));
    auto* bar = new QToolBar(this);
    bar->setIconSize({16, 16});
    bar->addWidget(makeListChoice());
    const auto action = [&](kit::Icon icon, const QString& text, auto run) {
        QAction* a = bar->addAction(kit::icon(icon), text);
        connect(a, &QAction::triggered, this, run);
        return a;
    };
    action(kit::Icon::Write, tr("Write prepared values"), &WatchView::writePrepared);
    action(kit::Icon::Force, tr("Force prepared values"), &WatchView::forcePrepared);
    action(kit::Icon::Unforce, tr("Release the selected forces"), [this] {
        for (QTreeWidgetItem* item : m_tree->selectedItems()) m_control.unforce(expressionOf(item));
    });
    bar->addSeparator();
    auto* format = new QComboBox(bar);
    format->addItems({tr("Decimal"), tr("Hexadecimal"), tr("Binary"), tr("Time", "number format")});
    format->setToolTip(tr("Numbers as decimals, in hexadecimal or binary, or milliseconds as a time"));
    format->setAccessibleName(tr("Number format"));
    format->setObjectName("numberFormat");
    bar->addWidget(format);
    connect(format, &QComboBox::currentIndexChanged, this,
            [this](int index) { setFormat(static_cast<types::NumberFormat>(index)); });

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(m_tree);
    layout->addWidget(m_input);
    setAcceptDrops(true);

    connect(m_input, &QLineEdit::returnPressed, this, [this] {
        add(m_input->text());
        m_input->clear();
    });
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &WatchView::showMenu);
    connect(m_tree, &QTreeWidget::itemExpanded, this, &WatchView::unfold);
    connect(m_tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (column == Name && !item->parent() && item->text(Name) != expressionOf(item)) {
            item->setData(Name, kExpressionRole, item->text(Name).trimmed());
            qDeleteAll(item->takeChildren());
            item->setData(Name, kUnfoldedRole, 0);
            fillRow(item);
            emit expressionsChanged();
        }
        if (column == Prepared) checkPrepared(item);
    });
    connect(&control, &RunControl::refreshed, this, [this] {
        const bool runs = m_control.status().state == controller::State::Running && !m_control.viewed();
        if (!runs || ++m_frames % 3 == 0) refresh(); // ten times a second can be read
    });
    connect(&control, &RunControl::sessionChanged, this, &WatchView::refresh);
}

QString WatchView::expressionOf(const QTreeWidgetItem* item) { return item->data(Name, kExpressionRole).toString(); }

void WatchView::add(const QString& expression) {
    const QString trimmed = expression.trimmed();
    if (trimmed.isEmpty()) return;
    auto* item = new QTreeWidgetItem(m_tree, {trimmed});
    item->setData(Name, kExpressionRole, trimmed);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    fillRow(item);
    emit expressionsChanged();
}

QStringList WatchView::expressions() const {
    QStringList out;
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) out << expressionOf(m_tree->topLevelItem(i));
    return out;
}

std::vector<WatchView::Row> WatchView::rows() const {
    std::vector<Row> out;
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) {
        const QTreeWidgetItem* item = m_tree->topLevelItem(i);
        const QVariant format = item->data(Name, kFormatRole);
        out.push_back(
            {expressionOf(item), item->text(Prepared), item->isExpanded(),
             format.isValid() ? std::optional(static_cast<types::NumberFormat>(format.toInt())) : std::nullopt});
    }
    return out;
}

void WatchView::setRows(const std::vector<Row>& rows) {
    m_tree->clear();
    for (const Row& row : rows) {
        add(row.expression);
        QTreeWidgetItem* item = m_tree->topLevelItem(m_tree->topLevelItemCount() - 1);
        item->setText(Prepared, row.prepared);
        if (row.format) setRowFormat(item, row.format);
        item->setExpanded(row.isUnfolded);
    }
}

void WatchView::setExpressions(const QStringList& expressions) {
    m_tree->clear();
    for (const QString& each : expressions) add(each);
}

void WatchView::setFormat(types::NumberFormat format) {
    const auto index = static_cast<int>(format);
    if (auto* choice = findChild<QComboBox*>("numberFormat"); choice && choice->currentIndex() != index)
        return choice->setCurrentIndex(index); // comes back here
    m_format = format;
    refresh();
}

types::NumberFormat WatchView::formatOf(const QTreeWidgetItem* item) const {
    for (const QTreeWidgetItem* each = item; each; each = each->parent()) // parts are shown as the whole
        if (const QVariant own = each->data(Name, kFormatRole); own.isValid())
            return static_cast<types::NumberFormat>(own.toInt());
    return m_format;
}

void WatchView::setRowFormat(QTreeWidgetItem* item, std::optional<types::NumberFormat> format) {
    item->setData(Name, kFormatRole, format ? QVariant(static_cast<int>(*format)) : QVariant());
    fillRow(item);
}

// ------------------------------------------------------------------ lists

QWidget* WatchView::makeListChoice() {
    m_lists.push_back({tr("Watch"), {}});
    auto* choice = new QWidget(this);
    auto* row = new QHBoxLayout(choice);
    row->setContentsMargins(0, 0, 4, 0);
    row->setSpacing(2);
    m_listChoice = new QComboBox(choice);
    m_listChoice->setObjectName("watchLists");
    m_listChoice->setAccessibleName(tr("Watch list"));
    auto* more = new QToolButton(choice);
    more->setIcon(kit::icon(kit::Icon::Add));
    more->setToolTip(tr("Add, rename or remove a list"));
    more->setAccessibleName(more->toolTip());
    more->setAutoRaise(true);
    more->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(more);
    const auto ask = [this](const QString& title, const QString& present, auto&& take) {
        const auto unlessUsed = [&](const QString& name) {
            if (name != present && listNames().contains(name))
                return tr("A list %1 already exists; choose another name").arg(name);
            take(name);
            return QString();
        };
        kit::TextQuestion(title, tr("Name of the list:"), present, unlessUsed, this).ask();
    };
    menu->addAction(kit::icon(kit::Icon::Add), tr("New List…"), this,
                    [this, ask] { ask(tr("New List"), {}, [this](const QString& name) { addList(name); }); });
    menu->addAction(kit::icon(kit::Icon::Rename), tr("Rename the List…"), this, [this, ask] {
        ask(tr("Rename the List"), shownList(), [this](const QString& name) { renameList(name); });
    });
    menu->addAction(kit::icon(kit::Icon::Delete), tr("Remove the List"), this, &WatchView::removeList);
    more->setMenu(menu);
    row->addWidget(m_listChoice);
    row->addWidget(more);
    connect(m_listChoice, &QComboBox::textActivated, this, &WatchView::showList);
    showLists();
    return choice;
}

void WatchView::showLists() {
    const QSignalBlocker blocker(m_listChoice);
    m_listChoice->clear();
    for (const List& list : m_lists) m_listChoice->addItem(list.name);
    m_listChoice->setCurrentIndex(static_cast<int>(m_shown));
}

QStringList WatchView::listNames() const {
    QStringList out;
    for (const List& list : m_lists) out << list.name;
    return out;
}

void WatchView::keepShownRows() { m_lists[m_shown].rows = rows(); }

void WatchView::addList(const QString& name) {
    if (name.isEmpty() || listNames().contains(name)) return showList(name);
    keepShownRows();
    m_lists.push_back({name, {}});
    m_shown = m_lists.size() - 1;
    m_tree->clear();
    showLists();
    emit expressionsChanged();
}

void WatchView::showList(const QString& name) {
    const auto at = listNames().indexOf(name);
    if (at < 0 || static_cast<size_t>(at) == m_shown) return;
    keepShownRows();
    m_shown = static_cast<size_t>(at);
    setRows(std::exchange(m_lists[m_shown].rows, {}));
    showLists();
}

void WatchView::renameList(const QString& name) {
    if (name.isEmpty() || listNames().contains(name)) return;
    m_lists[m_shown].name = name;
    showLists();
}

void WatchView::removeList() {
    if (m_lists.size() > 1)
        m_lists.erase(m_lists.begin() + static_cast<std::ptrdiff_t>(m_shown));
    else
        m_lists.front().rows.clear();
    m_shown = std::min(m_shown, m_lists.size() - 1);
    setRows(std::exchange(m_lists[m_shown].rows, {}));
    showLists();
    emit expressionsChanged();
}

WatchView::Kept WatchView::kept() {
    keepShownRows();
    return {m_lists, m_shown};
}

void WatchView::restore(Kept kept) {
    m_lists = std::move(kept.lists);
    m_shown = kept.shown;
    setRows(std::exchange(m_lists[m_shown].rows, {}));
    showLists();
}

QStringList WatchView::allExpressions() const {
    QStringList out = expressions();
    for (size_t i = 0; i < m_lists.size(); ++i)
        if (i != m_shown)
            for (const Row& row : m_lists[i].rows) out << row.expression;
    return out;
}

void WatchView::renameExpressions(const std::function<QString(const QString& expression)>& renamed) {
    Kept now = kept();
    bool any = false;
    for (List& list : now.lists)
        for (Row& row : list.rows) {
            const QString after = renamed(row.expression);
            any |= after != row.expression;
            row.expression = after;
        }
    if (!any) return; // the rows stay as they are, with what is selected and unfolded
    restore(std::move(now));
    emit expressionsChanged();
}

QStringList WatchView::stored() const {
    QStringList out{QString::number(m_shown)};
    for (size_t i = 0; i < m_lists.size(); ++i) {
        QStringList list{m_lists[i].name};
        for (const Row& row : i == m_shown ? rows() : m_lists[i].rows)
            list << row.expression + kPartEnd +
                        (row.format ? QString::number(static_cast<int>(*row.format)) : QString());
        out << list.join(kRowEnd);
    }
    return out;
}

void WatchView::restore(const QStringList& stored) {
    if (stored.size() < 2) return;
    Kept kept;
    for (const QString& text : stored.mid(1)) {
        const QStringList parts = text.split(kRowEnd);
        List list{parts.front(), {}};
        for (const QString& row : parts.mid(1)) {
            bool hasFormat = false;
            const int format = row.section(kPartEnd, 1).toInt(&hasFormat);
            list.rows.push_back({row.section(kPartEnd, 0, 0),
                                 {},
                                 false,
                                 hasFormat ? std::optional(static_cast<types::NumberFormat>(format)) : std::nullopt});
        }
        kept.lists.push_back(std::move(list));
    }
    kept.shown = std::min(static_cast<size_t>(stored.front().toUInt()), kept.lists.size() - 1);
    restore(std::move(kept));
}

void WatchView::refresh() {
    if (!isVisible()) return;
    // Only what is in the viewport is read.
    QTreeWidgetItem* item = m_tree->itemAt(0, 0);
    const int bottom = m_tree->viewport()->height();
    while (item && m_tree->visualItemRect(item).top() <= bottom) {
        fillRow(item);
        item = m_tree->itemBelow(item);
    }
}

void WatchView::removeSelected() {
    for (QTreeWidgetItem* each : m_tree->selectedItems())
        if (!each->parent()) delete each;
    emit expressionsChanged();
}

void WatchView::writePrepared() { applyPrepared(false); }
void WatchView::forcePrepared() { applyPrepared(true); }

void WatchView::showMenu(const QPoint& position) {
    QTreeWidgetItem* item = m_tree->itemAt(position);
    QMenu menu(this);
    if (item) {
        const RunControl::Shown shown = m_control.value(expressionOf(item));
        if (shown.isBool)
            connect(
                menu.addAction(kit::icon(kit::Icon::Write), tr("Toggle")), &QAction::triggered, this,
                [this, item, shown] { (void)m_control.write(expressionOf(item), shown.isTrue ? "FALSE" : "TRUE"); });
        connect(menu.addAction(kit::icon(kit::Icon::Force), tr("Force to %1").arg(shown.text.left(30))),
                &QAction::triggered, this,
                [this, item, shown] { (void)m_control.force(expressionOf(item), shown.text); });
        connect(menu.addAction(kit::icon(kit::Icon::Unforce), tr("Release Force")), &QAction::triggered, this,
                [this, item] { m_control.unforce(expressionOf(item)); });
        connect(menu.addAction(kit::icon(kit::Icon::Trace), tr("Show in Trace")), &QAction::triggered, this,
                [this, item] { emit traceRequested(expressionOf(item)); });
        if (const auto [block, instance] = m_control.instanceAt(expressionOf(item)); !block.isEmpty())
            connect(menu.addAction(kit::icon(kit::Icon::Forward),
                                   tr("Source of %1 with the Values of %2").arg(block, instance)),
                    &QAction::triggered, this,
                    [this, block = block, instance = instance] { emit instanceRequested(block, instance); });
        kit::addWhyActions(menu, [this, expression = expressionOf(item)](kit::AskWhy question) {
            emit whyRequested(question, expression);
        });
        QMenu* format = menu.addMenu(tr("Number Format"));
        const QStringList names{tr("As in the list"), tr("Decimal"), tr("Hexadecimal"), tr("Binary"),
                                tr("Time", "number format")};
        const QVariant own = item->data(Name, kFormatRole);
        for (int i = 0; i < names.size(); ++i) {
            QAction* choice = format->addAction(names[i], this, [this, item, i] {
                setRowFormat(item, i ? std::optional(static_cast<types::NumberFormat>(i - 1)) : std::nullopt);
            });
            choice->setCheckable(true);
            choice->setChecked(own.isValid() ? own.toInt() == i - 1 : i == 0);
        }
        menu.addSeparator();
        connect(menu.addAction(kit::icon(kit::Icon::Delete), tr("Remove")), &QAction::triggered, this,
                &WatchView::removeSelected);
    }
    connect(menu.addAction(kit::icon(kit::Icon::Clear), tr("Remove All")), &QAction::triggered, this, [this] {
        m_tree->clear();
        emit expressionsChanged();
    });
    menu.exec(m_tree->viewport()->mapToGlobal(position));
}

void WatchView::dragEnterEvent(QDragEnterEvent* event) {
    if (event->source() != m_tree && (event->mimeData()->hasText() || event->mimeData()->hasFormat(kit::VariableMime)))
        event->acceptProposedAction();
}
void WatchView::dropEvent(QDropEvent* event) {
    const QStringList paths = event->mimeData()->hasFormat(kit::VariableMime)
                                  ? kit::variablesOf(event->mimeData())
                                  : event->mimeData()->text().split('\n', Qt::SkipEmptyParts);
    for (const QString& path : paths) add(path);
    event->acceptProposedAction();
}

} // namespace plc::editor
