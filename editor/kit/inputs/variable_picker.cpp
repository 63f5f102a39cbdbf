#include "editor/kit/inputs/variable_picker.h"

#include "editor/kit/theme.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QStackedWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <set>

namespace plc::kit {

namespace {

constexpr int PathRole = Qt::UserRole + 1, LoadedRole = Qt::UserRole + 2;

/// A tree whose rows can be dragged as variable paths.
class VariableTree : public QTreeWidget {
public:
    explicit VariableTree(QWidget* parent) : QTreeWidget(parent) {
        setColumnCount(3);
        setHeaderLabels({VariablePicker::tr("Name"), VariablePicker::tr("Type"), VariablePicker::tr("Comment")});
        setSelectionMode(ExtendedSelection);
        setDragEnabled(true);
        setUniformRowHeights(true);
        setAlternatingRowColors(true);
        header()->setStretchLastSection(true);
        header()->resizeSection(0, 220);
        header()->resizeSection(1, 110);
    }

protected:
    QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
        QStringList paths;
        for (const QTreeWidgetItem* item : items)
            if (item->flags() & Qt::ItemIsSelectable) paths += item->data(0, PathRole).toString();
        return paths.isEmpty() ? nullptr : makeVariableMime(paths);
    }
};

QTreeWidgetItem* makeItem(const VariableNode& node, bool wholePath) {
    auto* item = new QTreeWidgetItem;
    item->setText(0, wholePath ? node.path : node.name);
    item->setText(1, node.type);
    item->setText(2, node.comment);
    item->setToolTip(0, node.path);
    item->setToolTip(2, node.comment);
    item->setIcon(0, icon(node.icon));
    item->setData(0, PathRole, node.path);
    item->setForeground(1, colors().muted);
    item->setForeground(2, colors().muted);
    if (!node.isSelectable) item->setFlags(Qt::ItemIsEnabled);
    if (node.hasChildren && !wholePath) item->setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
    return item;
}

void collectUnfolded(const QTreeWidgetItem* item, std::set<QString>& out) {
    if (item->isExpanded()) out.insert(item->data(0, PathRole).toString());
    for (int i = 0; i < item->childCount(); ++i) collectUnfolded(item->child(i), out);
}

} // namespace

QMimeData* makeVariableMime(const QStringList& paths) {
    auto* mime = new QMimeData;
    mime->setData(VariableMime, paths.join(QLatin1Char('\n')).toUtf8());
    mime->setText(paths.join(QLatin1Char('\n')));
    return mime;
}

QStringList variablesOf(const QMimeData* mime) {
    QStringList result;
    const QString text = mime->hasFormat(VariableMime) ? QString::fromUtf8(mime->data(VariableMime)) : mime->text();
    for (const QString& line : text.split(QLatin1Char('\n')))
        if (const QString path = line.trimmed(); !path.isEmpty()) result += path;
    return result;
}

VariablePicker::VariablePicker(const VariableProvider& provider, QWidget* parent)
    : QWidget(parent), m_provider(provider) {
    m_search = new QLineEdit(this);
    m_search->setPlaceholderText(tr("Search variables"));
    m_search->setAccessibleName(tr("Search variables"));
    m_search->setClearButtonEnabled(true);
    m_search->addAction(icon(Icon::Find), QLineEdit::LeadingPosition);
    m_search->installEventFilter(this);
    m_tree = new VariableTree(this);
    m_tree->setAccessibleName(tr("Variables"));
    m_results = new VariableTree(this);
    m_results->setRootIsDecorated(false);
    m_results->setAccessibleName(tr("Found variables"));
    m_pages = new QStackedWidget(this);
    m_pages->addWidget(m_tree);
    m_pages->addWidget(m_results);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_search);
    layout->addWidget(m_pages);
    for (QTreeWidget* tree : {m_tree, m_results}) {
        connect(tree, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) {
            if (item->flags() & Qt::ItemIsSelectable) emit picked(item->data(0, PathRole).toString());
        });
        connect(tree, &QTreeWidget::itemSelectionChanged, this, &VariablePicker::selectionChanged);
    }
    connect(m_tree, &QTreeWidget::itemExpanded, this, &VariablePicker::unfold);
    connect(m_search, &QLineEdit::textChanged, this, &VariablePicker::showResults);
    reload();
}

QTreeWidget* VariablePicker::present() const { return static_cast<QTreeWidget*>(m_pages->currentWidget()); }

void VariablePicker::addChildren(QTreeWidgetItem* parent, const QString& path) {
    for (const VariableNode& node : m_provider.children(path)) {
        QTreeWidgetItem* item = makeItem(node, false);
        if (parent)
            parent->addChild(item);
        else
            m_tree->addTopLevelItem(item);
    }
}

void VariablePicker::unfold(QTreeWidgetItem* item) {
    if (item->data(0, LoadedRole).toBool()) return;
    item->setData(0, LoadedRole, true);
    addChildren(item, item->data(0, PathRole).toString());
}

void VariablePicker::reload() {
    std::set<QString> unfolded;
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) collectUnfolded(m_tree->topLevelItem(i), unfolded);
    m_tree->clear();
    addChildren(nullptr, QString());
    std::function<void(QTreeWidgetItem*)> restore = [&](QTreeWidgetItem* item) {
        if (!unfolded.count(item->data(0, PathRole).toString())) return;
        item->setExpanded(true);
        for (int i = 0; i < item->childCount(); ++i) restore(item->child(i));
    };
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i) restore(m_tree->topLevelItem(i));
    if (!m_search->text().isEmpty()) showResults(m_search->text());
}

void VariablePicker::showResults(const QString& text) {
    const QString wanted = text.trimmed();
    m_results->clear();
    if (wanted.isEmpty()) {
        m_pages->setCurrentWidget(m_tree);
        return;
    }
    for (const VariableNode& node : m_provider.search(wanted, 200)) m_results->addTopLevelItem(makeItem(node, true));
    if (m_results->topLevelItemCount() > 0) m_results->setCurrentItem(m_results->topLevelItem(0));
    m_pages->setCurrentWidget(m_results);
}

void VariablePicker::setFilter(const QString& text) { m_search->setText(text); }

QStringList VariablePicker::selectedPaths() const {
    QStringList result;
    for (const QTreeWidgetItem* item : present()->selectedItems()) result += item->data(0, PathRole).toString();
    return result;
}

bool VariablePicker::selectPath(const QString& path) {
    QTreeWidgetItem* found = nullptr;
    // Unfolds whatever is a beginning of the path.
    std::function<void(QTreeWidgetItem*)> descend = [&](QTreeWidgetItem* item) {
        const QString here = item->data(0, PathRole).toString();
        if (here.compare(path, Qt::CaseInsensitive) == 0 && item->flags() & Qt::ItemIsSelectable) {
            found = item;
            return;
        }
        const bool leads = here.isEmpty() || !(item->flags() & Qt::ItemIsSelectable) ||
                           (path.startsWith(here, Qt::CaseInsensitive) && path.size() > here.size() &&
                            (path[here.size()] == QLatin1Char('.') || path[here.size()] == QLatin1Char('[')));
        if (!leads) return;
        unfold(item);
        for (int i = 0; i < item->childCount() && !found; ++i) descend(item->child(i));
    };
    for (int i = 0; i < m_tree->topLevelItemCount() && !found; ++i) descend(m_tree->topLevelItem(i));
    if (!found) return false;
    m_search->clear();
    m_tree->setCurrentItem(found);
    m_tree->scrollToItem(found);
    return true;
}

bool VariablePicker::eventFilter(QObject* watched, QEvent* event) {
    if (watched != m_search || event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    auto* key = static_cast<QKeyEvent*>(event);
    switch (key->key()) {
    case Qt::Key_Down:
    case Qt::Key_Up:
    case Qt::Key_PageDown:
    case Qt::Key_PageUp:
        QApplication::sendEvent(present(), event);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (const QStringList paths = selectedPaths(); !paths.isEmpty()) {
            emit picked(paths.first());
            return true;
        }
        return false;
    default:
        return QWidget::eventFilter(watched, event);
    }
}

std::optional<QString> pickVariable(const VariableProvider& provider, const QString& current, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setWindowTitle(VariablePicker::tr("Choose a variable"));
    dialog.resize(560, 460);
    auto* picker = new VariablePicker(provider, &dialog);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    auto* layout = new QVBoxLayout(&dialog);
    layout->addWidget(picker);
    layout->addWidget(buttons);
    QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
    ok->setEnabled(false);
    QObject::connect(picker, &VariablePicker::selectionChanged, &dialog,
                     [&] { ok->setEnabled(!picker->selectedPaths().isEmpty()); });
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    std::optional<QString> result;
    QObject::connect(picker, &VariablePicker::picked, &dialog, [&](const QString& path) {
        result = path;
        dialog.accept();
    });
    if (!current.isEmpty()) picker->selectPath(current);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    if (!result && !picker->selectedPaths().isEmpty()) result = picker->selectedPaths().first();
    return result;
}

} // namespace plc::kit
