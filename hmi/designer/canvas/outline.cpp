#include "hmi/designer/canvas/outline.h"

#include "editor/kit/icons.h"
#include "editor/kit/theme.h"
#include "hmi/designer/canvas/palette.h"
#include "hmi/model/property_literals.h"

#include <QCoreApplication>
#include <QDropEvent>
#include <QHeaderView>
#include <QLocale>
#include <QPainter>

namespace plc::hmi {

namespace {
constexpr int kIdRole = Qt::UserRole;

/// Which of the placed faceplates it is: its title, else what it is placed for.
QString placedFor(const Element& element, const DesignContext& context) {
    const Arguments given = argumentsOf(element.at("arguments"_field));
    const Panel* placed = context.project().panelLookup()(element.text("panel"_text));
    QString out;
    for (const Parameter& one : placed ? parametersOf(*placed) : std::vector<Parameter>()) {
        const QString argument = given.value(one.name.toLower());
        if (argument.isEmpty()) continue;
        if (one.isText()) return context.shownText(argument);
        if (out.isEmpty()) out = argument;
    }
    return out;
}

/// The name given by the engineer, else what it is and what it says or shows.
QString titleOf(const Element& element, const DesignContext& context) {
    if (const QString name = element.text("name"_text); !name.isEmpty()) return name;
    const QString kind = QCoreApplication::translate("Hmi", element.descriptor().title);
    for (const char* const words : {"text", "title", "label", "onText"})
        if (const QString text = context.shownText(element.text(words)).simplified(); !text.isEmpty())
            return QStringLiteral("%1  %2").arg(kind, QLocale().quoteString(text.left(40)));
    if (element.kind() == ElementKind::Faceplate)
        if (const QString which = placedFor(element, context).simplified(); !which.isEmpty())
            return QStringLiteral("%1  %2").arg(element.text("panel"_text), which.left(40));
    for (const char* const bound : {"target", "value", "state", "file", "panel", "symbol"})
        if (const QString text = element.text(bound).simplified(); !text.isEmpty())
            return QStringLiteral("%1  %2").arg(kind, text.left(40));
    return QStringLiteral("%1  %2").arg(kind, element.id());
}
} // namespace

Outline::Outline(PanelDocument& document, Selection& selection, DesignContext& context, QWidget* parent)
    : QTreeWidget(parent), m_document(document), m_selection(selection), m_context(context) {
    connect(&context, &DesignContext::textsChanged, this, &Outline::rebuild);
    connect(&context, &DesignContext::languageChanged, this, &Outline::rebuild);
    setHeaderHidden(true);
    setColumnCount(2);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(0, QHeaderView::Stretch);
    header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setDragDropMode(QAbstractItemView::InternalMove);
    setIndentation(14);
    connect(&m_document, &PanelDocument::changed, this, [this](const Touched& touched) {
        const bool names = std::any_of(touched.elements.begin(), touched.elements.end(), [this](const ElementId& id) {
            const QTreeWidgetItem* item = itemOf(id);
            const Element* element = m_document.panel().find(id);
            return !item || !element || item->text(0) != titleOf(*element, m_context) ||
                   item->icon(1).isNull() == element->isSet("locked"_flag);
        });
        if (touched.structure || names) rebuild();
    });
    connect(&m_selection, &Selection::changed, this, &Outline::showSelection);
    connect(this, &QTreeWidget::itemSelectionChanged, this, [this] {
        if (m_updating) return;
        ElementIds ids;
        for (const QTreeWidgetItem* item : selectedItems()) ids.push_back(item->data(0, kIdRole).toString());
        m_selection.set(ids);
    });
    connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item, int column) {
        if (column != 1) return;
        const ElementId id = item->data(0, kIdRole).toString();
        m_document.perform(tr("Lock"),
                           setLocked(m_document.panel(), {id}, !m_document.panel().find(id)->isSet("locked"_flag)));
    });
    rebuild();
}

QTreeWidgetItem* Outline::itemOf(const ElementId& id) const {
    for (QTreeWidgetItemIterator it(const_cast<Outline*>(this)); *it; ++it)
        if ((*it)->data(0, kIdRole).toString() == id) return *it;
    return nullptr;
}

void Outline::rebuild() {
    m_updating = true;
    clear();
    QHash<ElementId, QTreeWidgetItem*> items;
    const auto& elements = m_document.panel().elements();
    for (const Element& element : elements) {
        auto* item = new QTreeWidgetItem({titleOf(element, m_context)});
        item->setData(0, kIdRole, element.id());
        item->setToolTip(0, QStringLiteral("%1  %2").arg(QCoreApplication::translate("Hmi", element.descriptor().title),
                                                         element.id()));
        if (element.isSet("locked"_flag)) item->setIcon(1, kit::icon(kit::Icon::Lock));
        if (!element.isContainer()) item->setFlags(item->flags() & ~Qt::ItemIsDropEnabled);
        items.insert(element.id(), item);
    }
    for (const Element& element : elements) {
        QTreeWidgetItem* outer = element.parent() == element.id() ? nullptr : items.value(element.parent());
        for (QTreeWidgetItem* up = outer; up; up = up->parent()) // a circle of groups in a file made by hand
            if (up == items.value(element.id())) outer = nullptr;
        if (outer)
            outer->insertChild(0, items.value(element.id()));
        else
            insertTopLevelItem(0, items.value(element.id()));
    }
    expandAll();
    m_updating = false;
    showSelection();
}

void Outline::paintEvent(QPaintEvent* event) {
    QTreeWidget::paintEvent(event);
    if (topLevelItemCount() > 0) return;
    QPainter painter(viewport());
    painter.setPen(kit::colors().muted);
    painter.drawText(viewport()->rect().adjusted(12, 12, -12, -12), Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap,
                     tr("No elements yet. Drag one from the palette onto the panel."));
}

void Outline::showSelection() {
    m_updating = true;
    clearSelection();
    for (const ElementId& id : m_selection.ids())
        if (QTreeWidgetItem* item = itemOf(id)) item->setSelected(true);
    if (m_selection.ids().size() == 1)
        if (QTreeWidgetItem* item = itemOf(m_selection.ids().front())) scrollToItem(item);
    m_updating = false;
}

void Outline::dropEvent(QDropEvent* event) {
    QTreeWidgetItem* target = itemAt(event->position().toPoint());
    const ElementIds moved = m_selection.ids();
    event->setDropAction(Qt::IgnoreAction);
    event->accept();
    if (moved.empty()) return;
    const hmi::Panel& panel = m_document.panel();
    const DropIndicatorPosition where = dropIndicatorPosition();
    const ElementId id = target ? target->data(0, kIdRole).toString() : ElementId();
    const Element* at = panel.find(id);
    const ElementId parent = !at ? ElementId() : where == OnItem ? id : at->parent();
    EditList list;
    for (const ElementId& one : moved) {
        const std::vector<ElementId> inside = panel.withDescendants(one);
        if (std::find(inside.begin(), inside.end(), parent) != inside.end()) return; // not into itself
        list.edits.push_back(hmi::setProperty(panel, one, "parent"_field, toUtf8(parent)));
        // The tree shows the topmost first: above an item is behind it in the panel's order.
        int index = at ? panel.indexOf(id) : 0;
        if (where == AboveItem || where == OnItem) ++index;
        if (panel.indexOf(one) < index) --index;
        list.edits.push_back({MoveElement{one, index}});
    }
    m_document.perform(tr("Reorder"), {list});
}

} // namespace plc::hmi
