#include "editor/kit/inputs/property_grid.h"

#include "editor/kit/inputs/color_popup.h"
#include "editor/kit/inputs/property_delegate.h"
#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/theme.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QStyle>

namespace plc::kit {

QString propertyText(const PropertyDescriptor& descriptor, const QVariant& value) {
    if (!value.isValid()) return {};
    switch (descriptor.kind) {
    case PropertyKind::Integer:
        return QString::number(value.toLongLong()) + descriptor.suffix;
    case PropertyKind::Number:
        return QString::number(value.toDouble(), 'g', 10) + descriptor.suffix;
    case PropertyKind::Bool:
        return value.toBool() ? PropertyGrid::tr("Yes") : PropertyGrid::tr("No");
    case PropertyKind::Enumeration:
        for (const PropertyChoice& choice : descriptor.choices)
            if (choice.value == value) return choice.label;
        if (value.typeId() == QMetaType::QSize) // one that is not among the choices
            return QStringLiteral("%1 × %2").arg(value.toSize().width()).arg(value.toSize().height());
        return value.toString();
    case PropertyKind::Color: {
        const auto color = value.value<QColor>();
        if (!color.isValid()) return PropertyGrid::tr("None");
        return color.alpha() == 255 ? color.name() : color.name(QColor::HexArgb);
    }
    case PropertyKind::LongText:
        return value.toString().section(QLatin1Char('\n'), 0, 0);
    case PropertyKind::Text:
    case PropertyKind::Expression:
    case PropertyKind::File:
    case PropertyKind::Action:
        return value.toString();
    }
    return {};
}

PropertyGrid::PropertyGrid(QWidget* parent) : QTreeWidget(parent) {
    setColumnCount(2);
    setHeaderLabels({tr("Property"), tr("Value")});
    setRootIsDecorated(false);
    setIndentation(14);
    setUniformRowHeights(true);
    setAccessibleName(tr("Properties"));
    setSelectionBehavior(SelectRows);
    setEditTriggers(NoEditTriggers);
    setVerticalScrollMode(ScrollPerPixel);
    header()->setStretchLastSection(true);
    connect(header(), &QHeaderView::sectionResized, this, [this](int column) {
        if (column == 0 && !m_isFitting) m_namesAreSized = true;
    });
    setItemDelegate(new PropertyDelegate(*this));
    setAcceptDrops(true);
    viewport()->setAcceptDrops(true);
    connect(this, &QTreeWidget::itemCollapsed, this, [this](QTreeWidgetItem* item) { m_folded[item->text(0)] = true; });
    connect(this, &QTreeWidget::itemExpanded, this, [this](QTreeWidgetItem* item) { m_folded[item->text(0)] = false; });
    connect(&Theme::current(), &Theme::changed, this, [this] {
        for (Entry& e : m_entries) showValue(e);
    });
}

void PropertyGrid::setDescriptors(std::vector<PropertyDescriptor> descriptors) {
    bool same = descriptors.size() == m_entries.size();
    for (size_t i = 0; same && i < descriptors.size(); ++i) same = descriptors[i] == m_entries[i].descriptor;
    if (same) return;
    endEditing();
    clear();
    m_entries.clear();
    std::map<QString, QTreeWidgetItem*> groups;
    for (PropertyDescriptor& descriptor : descriptors) m_entries.push_back({std::move(descriptor), {}, false, nullptr});
    for (Entry& e : m_entries) {
        QTreeWidgetItem*& group = groups[e.descriptor.group];
        if (!group) {
            group = new QTreeWidgetItem(this, {e.descriptor.group});
            group->setFlags(Qt::ItemIsEnabled);
            group->setFirstColumnSpanned(true);
            QFont bold = font();
            bold.setWeight(QFont::DemiBold);
            group->setFont(0, bold);
        }
        e.item = new QTreeWidgetItem(group, {e.descriptor.label});
        e.item->setData(0, PropertyDelegate::IdRole, e.descriptor.id);
        e.item->setToolTip(0, e.descriptor.toolTip.isEmpty() ? e.descriptor.label : e.descriptor.toolTip);
        e.item->setFlags(e.descriptor.isReadOnly ? Qt::ItemIsEnabled | Qt::ItemIsSelectable
                                                 : Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
        showValue(e);
    }
    for (auto& [name, group] : groups) group->setExpanded(!m_folded[name]);
    fitNames();
}

void PropertyGrid::fitNames() {
    if (m_namesAreSized) return;
    int widest = 130;
    for (const Entry& e : m_entries)
        widest = std::max(widest, fontMetrics().horizontalAdvance(e.descriptor.label) + indentation() + 12);
    m_isFitting = true;
    header()->resizeSection(0, std::min(widest, std::max(130, viewport()->width() * 55 / 100)));
    m_isFitting = false;
}

void PropertyGrid::resizeEvent(QResizeEvent* event) {
    QTreeWidget::resizeEvent(event);
    fitNames();
}

PropertyGrid::Entry* PropertyGrid::entry(const QString& id) {
    for (Entry& e : m_entries)
        if (e.descriptor.id == id) return &e;
    return nullptr;
}

const PropertyGrid::Entry* PropertyGrid::entry(const QString& id) const {
    return const_cast<PropertyGrid*>(this)->entry(id);
}

PropertyGrid::Entry* PropertyGrid::entryOf(const QTreeWidgetItem* item) {
    return item && item->parent() ? entry(item->data(0, PropertyDelegate::IdRole).toString()) : nullptr;
}

const PropertyDescriptor* PropertyGrid::descriptor(const QString& id) const {
    const Entry* e = entry(id);
    return e ? &e->descriptor : nullptr;
}

void PropertyGrid::showValue(Entry& e) {
    e.item->setText(1, e.isVarious ? tr("various") : propertyText(e.descriptor, e.value));
    const bool plain = e.descriptor.defaultValue.isValid() && e.value == e.descriptor.defaultValue;
    e.item->setForeground(1, e.isVarious || e.descriptor.isReadOnly || plain ? colors().muted : colors().text);
    e.item->setToolTip(1, e.isVarious ? QString() : e.item->text(1));
}

void PropertyGrid::setValue(const QString& id, const QVariant& value) {
    Entry* e = entry(id);
    if (!e) return;
    e->value = value;
    e->isVarious = false;
    showValue(*e);
}

void PropertyGrid::setValues(const std::map<QString, QVariant>& values) {
    for (const auto& [id, value] : values) setValue(id, value);
}

QVariant PropertyGrid::value(const QString& id) const {
    const Entry* e = entry(id);
    return e ? e->value : QVariant();
}

void PropertyGrid::setVarious(const QString& id) {
    Entry* e = entry(id);
    if (!e) return;
    e->isVarious = true;
    e->value = {};
    showValue(*e);
}

bool PropertyGrid::isVarious(const QString& id) const {
    const Entry* e = entry(id);
    return e && e->isVarious;
}

QTreeWidgetItem* PropertyGrid::row(const QString& id) const {
    const Entry* e = entry(id);
    return e ? e->item : nullptr;
}

void PropertyGrid::setFilter(const QString& text) {
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = topLevelItem(i);
        bool any = false;
        for (int j = 0; j < group->childCount(); ++j) {
            QTreeWidgetItem* item = group->child(j);
            const bool shown = text.isEmpty() || item->text(0).contains(text, Qt::CaseInsensitive) ||
                               item->text(1).contains(text, Qt::CaseInsensitive) ||
                               item->data(0, PropertyDelegate::IdRole).toString().contains(text, Qt::CaseInsensitive);
            item->setHidden(!shown);
            any |= shown;
        }
        group->setHidden(!any);
    }
}

void PropertyGrid::endEditing() { static_cast<PropertyDelegate*>(itemDelegate())->finishOpen(); }

void PropertyGrid::commit(const QString& id, const QVariant& value) {
    Entry* e = entry(id);
    if (!e || e->descriptor.isReadOnly) return;
    if (!e->isVarious && e->value == value) return emit previewWithdrawn(id);
    e->value = value;
    e->isVarious = false;
    showValue(*e);
    emit committed(id, value);
}

void PropertyGrid::editProperty(const QString& id) {
    endEditing();
    Entry* e = entry(id);
    if (!e || e->descriptor.isReadOnly) return;
    setCurrentItem(e->item, 1); // the cell that is edited: another row that becomes the current one ends that
    switch (e->descriptor.kind) {
    case PropertyKind::Bool:
        commit(id, !e->value.toBool());
        return;
    case PropertyKind::Action:
        emit actionRequested(id);
        return;
    case PropertyKind::Color: {
        const QVariant before = e->value;
        auto* popup = new ColorPopup(before.value<QColor>(), e->descriptor.canBeNone, this);
        bool* done = new bool(false);
        connect(popup, &ColorPopup::hovered, this, [this, id](const QColor& color) { emit previewed(id, color); });
        connect(popup, &ColorPopup::chosen, this, [this, id, done](const QColor& color) {
            *done = true;
            commit(id, color);
        });
        connect(popup, &QObject::destroyed, this, [this, id, before, done] {
            if (!*done) {
                emit previewed(id, before);
                emit previewWithdrawn(id);
            }
            delete done;
        });
        const QRect cell = visualItemRect(e->item);
        popup->openBelow(QRect(viewport()->mapToGlobal(QPoint(columnViewportPosition(1), cell.top())),
                               QSize(columnWidth(1), cell.height())));
        return;
    }
    default:
        editItem(e->item, 1);
    }
}

/// A press on a heading folds it: without an arrow its rows would seem to be missing.
void PropertyGrid::drawArrow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& heading) const {
    QStyleOptionViewItem arrow = option;
    const QRect atEnd(option.rect.right() - 20, option.rect.top(), 16, option.rect.height());
    arrow.rect = QStyle::visualRect(layoutDirection(), option.rect, atEnd);
    arrow.state = QStyle::State_Enabled | QStyle::State_Children;
    if (isExpanded(heading)) arrow.state |= QStyle::State_Open;
    style()->drawPrimitive(QStyle::PE_IndicatorBranch, &arrow, painter, this);
}

void PropertyGrid::drawRow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    if (!index.parent().isValid()) painter->fillRect(option.rect, colors().window);
    QTreeWidget::drawRow(painter, option, index);
    if (!index.parent().isValid()) drawArrow(painter, option, index);
    painter->save();
    painter->setPen(colors().divider);
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    if (index.parent().isValid()) {
        const int x = columnViewportPosition(1) - 1;
        painter->drawLine(x, option.rect.top(), x, option.rect.bottom());
    }
    painter->restore();
}

void PropertyGrid::mousePressEvent(QMouseEvent* event) {
    endEditing(); // what is committed may bring other rows: not while Qt goes from one to the other
    QTreeWidget::mousePressEvent(event);
    if (event->button() != Qt::LeftButton) return;
    QTreeWidgetItem* item = itemAt(event->pos());
    if (item && !item->parent()) {
        item->setExpanded(!item->isExpanded());
        return;
    }
    if (const Entry* e = entryOf(item); e && columnAt(event->pos().x()) == 1) editProperty(e->descriptor.id);
}

// The keys that go to another row; an open editor hands on others too, as Shift before a capital.
QModelIndex PropertyGrid::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) {
    endEditing(); // as for the mouse
    return QTreeWidget::moveCursor(action, modifiers);
}

void PropertyGrid::keyboardSearch(const QString& text) {
    endEditing(); // as for the mouse
    QTreeWidget::keyboardSearch(text);
}

void PropertyGrid::keyPressEvent(QKeyEvent* event) {
    const Entry* e = entryOf(currentItem());
    if (e && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_F2 ||
              event->key() == Qt::Key_Space)) {
        editProperty(e->descriptor.id);
        return;
    }
    QTreeWidget::keyPressEvent(event);
}

void PropertyGrid::contextMenuEvent(QContextMenuEvent* event) {
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    QTreeWidgetItem* item = byKey ? currentItem() : itemAt(event->pos());
    Entry* e = entryOf(item);
    if (!e) return;
    const QString id = e->descriptor.id;
    QMenu menu(this);
    QAction* reset = menu.addAction(icon(Icon::Reset), tr("Reset"));
    reset->setEnabled(!e->descriptor.isReadOnly && e->descriptor.defaultValue.isValid() &&
                      (e->isVarious || e->value != e->descriptor.defaultValue));
    connect(reset, &QAction::triggered, this, [this, id] {
        emit resetRequested(id);
        if (Entry* now = entry(id)) commit(id, now->descriptor.defaultValue);
    });
    menu.exec(byKey ? viewport()->mapToGlobal(visualItemRect(item).bottomLeft()) : event->globalPos());
}

const PropertyGrid::Entry* PropertyGrid::entryUnder(const QDropEvent& event) {
    const Entry* e = entryOf(itemAt(event.position().toPoint()));
    return e && e->descriptor.kind == PropertyKind::Expression && !e->descriptor.isReadOnly &&
                   !variablesOf(event.mimeData()).isEmpty()
               ? e
               : nullptr;
}

void PropertyGrid::dragEnterEvent(QDragEnterEvent* event) {
    endEditing(); // as for the mouse
    if (!variablesOf(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void PropertyGrid::dragMoveEvent(QDragMoveEvent* event) {
    const Entry* under = entryUnder(*event);
    setCurrentItem(under ? under->item : nullptr);
    if (under)
        event->acceptProposedAction();
    else
        event->ignore();
}

void PropertyGrid::dropEvent(QDropEvent* event) {
    const Entry* under = entryUnder(*event);
    if (!under) return event->ignore();
    event->acceptProposedAction();
    commit(QString(under->descriptor.id), variablesOf(event->mimeData()).first());
}

} // namespace plc::kit
