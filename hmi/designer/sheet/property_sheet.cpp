#include "hmi/designer/sheet/property_sheet.h"

#include "editor/kit/edit_history.h"
#include "editor/kit/texts.h"
#include "hmi/designer/context/applicable.h"
#include "hmi/designer/sheet/records_dialog.h"
#include "hmi/model/property_literals.h"

#include <QColorDialog>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

namespace plc::hmi {

PropertySheet::PropertySheet(PanelDocument& document, Selection& selection, DesignContext& context, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_context(context), m_variables(context, document),
      m_title(new QLabel), m_filter(new QLineEdit), m_grid(new kit::PropertyGrid) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_filter->setPlaceholderText(tr("Search properties"));
    m_filter->setAccessibleName(m_filter->placeholderText());
    m_filter->setClearButtonEnabled(true);
    layout->addWidget(m_title);
    layout->addWidget(m_filter);
    layout->addWidget(m_grid, 1);
    m_grid->setBaseFolder(context.project().folder);
    offerVariables(*m_grid);
    m_grid->setCheck([this](const QString& id, const QString& text) {
        const PropertyDescriptor* property = descriptor().property(propertyOf(id));
        return property ? m_variables.complaint(text, property->hint, property->type == PropertyType::Target)
                        : QString();
    });
    connect(m_filter, &QLineEdit::textChanged, m_grid, &kit::PropertyGrid::setFilter);
    connect(m_grid, &kit::PropertyGrid::previewed, this, [this](const QString& id, const QVariant& value) {
        if (m_gestureId != id) m_gesture = m_document.newGesture();
        m_gestureId = id;
        apply(id, value, m_gesture);
    });
    connect(m_grid, &kit::PropertyGrid::previewWithdrawn, this, [this](const QString& id) {
        if (m_gestureId != id) return;
        m_gestureId.clear();
        m_document.takeBack(m_gesture);
        refresh();
    });
    connect(m_grid, &kit::PropertyGrid::committed, this, &PropertySheet::commit);
    connect(m_grid, &kit::PropertyGrid::resetRequested, this, [this](const QString& id) {
        const PropertyDescriptor* property = descriptor().property(propertyOf(id));
        if (!property) return;
        EditList list;
        for (const ElementId& one : targets())
            list.edits.push_back(hmi::setProperty(m_document.panel(), one, property->key,
                                                  property->type == PropertyType::Arguments
                                                      ? fromGrid(*property, valueOf(one, *property), id, QString())
                                                      : property->fallback));
        m_document.perform(tr("Reset"), {list});
    });
    connect(m_grid, &kit::PropertyGrid::actionRequested, this, &PropertySheet::editRecords);
    connect(&m_document, &PanelDocument::changed, this, &PropertySheet::refresh);
    connect(&m_selection, &Selection::changed, this, &PropertySheet::showSelection);
    connect(&m_context, &DesignContext::textsChanged, this, &PropertySheet::refresh);
    connect(&m_context, &DesignContext::languageChanged, this, &PropertySheet::refresh);
    connect(&m_context, &DesignContext::peopleChanged, this, &PropertySheet::refresh);
    connect(&m_context, &DesignContext::recipesChanged, this, &PropertySheet::refresh);
    showSelection();
}

void PropertySheet::showSelection() {
    m_grid->endEditing();
    m_shown = m_selection.isEmpty() ? ElementIds{ElementId()} : m_selection.ids();
    rebuild();
}

void PropertySheet::offerVariables(kit::PropertyGrid& grid) const {
    if (m_context.picker() || m_context.variables())
        grid.setPicker([this, &grid](const QString& present) { return m_variables.pick(present, grid.window()); });
    grid.setCompletionSource([this](const QString& text, int cursor) { return m_variables.complete(text, cursor); });
}

ElementIds PropertySheet::targets() const {
    ElementIds out;
    for (const ElementId& id : m_shown)
        if (id.isEmpty() || m_document.panel().find(id)) out.push_back(id);
    return out;
}

const ElementDescriptor& PropertySheet::descriptor() const {
    const ElementIds ids = targets();
    if (ids.empty() || ids.front().isEmpty()) return panelDescriptor();
    return m_document.panel().find(ids.front())->descriptor();
}

std::vector<const PropertyDescriptor*> PropertySheet::shared() const {
    // Of several elements those properties that all have, with the same type.
    std::vector<const PropertyDescriptor*> out;
    for (const PropertyDescriptor& property : descriptor().properties) {
        bool isShared = true;
        for (const ElementId& id : targets()) {
            if (id.isEmpty()) continue;
            const PropertyDescriptor* other = m_document.panel().find(id)->descriptor().property(property.key);
            isShared &= other && other->type == property.type && other->hint == property.hint &&
                        isApplicable(*m_document.panel().find(id), property.key);
        }
        if (isShared) out.push_back(&property);
    }
    return out;
}

/// What the rows depend on: the kinds that are selected, the panels that they place.
QString PropertySheet::shapeNow() const {
    QString shape = parametersOf(m_document.panel()).empty() ? QString() : QStringLiteral("$ ");
    shape += m_document.panel().text("theme"_text) + u' '; // colours are shown in it
    for (const auto& [name, theme] : m_context.project().themes.own()) shape += name + u' ';
    for (const ElementId& id : targets()) {
        if (id.isEmpty()) return shape + QStringLiteral("panel");
        const Element& element = *m_document.panel().find(id);
        shape += element.text("kind"_text) + u' ';
        if (const PropertyDescriptor* property = element.descriptor().property("arguments"_field))
            for (const kit::PropertyDescriptor& row : argumentRows(*property, element, m_context))
                shape += row.id + u':' + row.toolTip + u' ';
    }
    for (const PropertyDescriptor* property : shared()) // the action of a button hides some
        shape += u' ' + kit::fromView(property->key);
    const PanelProject& project = m_context.project(); // what rows offer by name
    for (const Role& role : project.people.roles()) shape += QStringLiteral(" role:") + role.name;
    for (const Recipe& recipe : project.recipes.recipes()) shape += QStringLiteral(" recipe:") + recipe.name;
    return shape;
}

std::vector<kit::PropertyDescriptor> PropertySheet::rowsOf(const PropertyDescriptor& property) const {
    const ElementIds ids = targets();
    if (property.type == PropertyType::Arguments)
        return argumentRows(property, *m_document.panel().find(ids.front()), m_context);
    return gridRows(property, m_context, {}, !parametersOf(m_document.panel()).empty() && !ids.front().isEmpty(),
                    m_document.panel().text("theme"_text));
}

void PropertySheet::rebuild() {
    QString shape = shapeNow();
    if (shape != m_shape) {
        m_grid->endEditing(); // its row goes
        shape = shapeNow();
    }
    const ElementIds ids = targets();
    const QString name = QCoreApplication::translate("Hmi", descriptor().title);
    if (ids.size() > 1)
        m_title->setText(tr("%n elements", nullptr, static_cast<int>(ids.size())));
    else if (ids.empty() || ids.front().isEmpty())
        m_title->setText(name);
    else
        m_title->setText(QStringLiteral("%1  –  %2").arg(name, m_document.panel().find(ids.front())->caption()));
    if (shape != m_shape) {
        m_gestureId.clear();
        m_shape = shape;
        std::vector<kit::PropertyDescriptor> rows;
        // What the element is about comes first; the place is mostly set with the mouse.
        std::vector<const PropertyDescriptor*> properties = shared();
        const auto rank = [](PropertyGroup group) {
            switch (group) {
            case PropertyGroup::Text:
                return 0;
            case PropertyGroup::Value:
                return 1;
            case PropertyGroup::Behaviour:
                return 2;
            case PropertyGroup::Look:
                return 3;
            case PropertyGroup::Geometry:
                return 4;
            case PropertyGroup::Condition:
                return 5;
            case PropertyGroup::Motion:
                return 6;
            }
            return 7;
        };
        std::stable_sort(properties.begin(), properties.end(),
                         [&](const PropertyDescriptor* a, const PropertyDescriptor* b) {
                             const bool aCommon = descriptorOf(ElementKind::Unknown).property(a->key),
                                        bCommon = descriptorOf(ElementKind::Unknown).property(b->key);
                             if (rank(a->group) != rank(b->group)) return rank(a->group) < rank(b->group);
                             return aCommon < bCommon;
                         });
        for (const PropertyDescriptor* property : properties)
            for (kit::PropertyDescriptor& row : rowsOf(*property)) rows.push_back(std::move(row));
        m_grid->setDescriptors(std::move(rows));
        m_grid->setFilter(m_filter->text());
    }
    refresh();
}

const Json& PropertySheet::valueOf(const ElementId& id, const PropertyDescriptor& property) const {
    return id.isEmpty() ? m_document.panel().at(property.key) : m_document.panel().find(id)->at(property.key);
}

void PropertySheet::refresh() {
    const ElementIds ids = targets();
    if (ids.empty() || m_shape.isEmpty()) return;
    // Not for what is only previewed: other rows would close the list in which somebody is choosing.
    if (m_gestureId.isEmpty() && shapeNow() != m_shape) return rebuild();
    for (const PropertyDescriptor* property : shared())
        for (const kit::PropertyDescriptor& row : rowsOf(*property)) {
            const QVariant first = gridValue(*property, valueOf(ids.front(), *property), row.id, m_context);
            bool isSame = true;
            for (const ElementId& id : ids)
                isSame &= gridValue(*property, valueOf(id, *property), row.id, m_context) == first;
            if (isSame)
                m_grid->setValue(row.id, first);
            else
                m_grid->setVarious(row.id);
        }
}

void PropertySheet::apply(const QString& id, const QVariant& value, int gesture) {
    const PropertyDescriptor* property = descriptor().property(propertyOf(id));
    if (!property || property->type == PropertyType::Text) return;
    EditList list;
    for (const ElementId& one : targets()) {
        const Json now = fromGrid(*property, valueOf(one, *property), id, value);
        if (property->type == PropertyType::Rect && !one.isEmpty()) {
            const Json& r = now;
            list.edits.push_back(
                resizeTo(m_document.panel(), one,
                         QRectF(r[0].get<double>(), r[1].get<double>(), r[2].get<double>(), r[3].get<double>())));
        } else {
            list.edits.push_back(hmi::setProperty(m_document.panel(), one, property->key, now));
        }
    }
    m_document.perform(QCoreApplication::translate("Hmi", property->title), {list}, gesture);
}

void PropertySheet::commit(const QString& id, const QVariant& value) {
    const PropertyDescriptor* property = descriptor().property(propertyOf(id));
    if (!property) return;
    if (property->type == PropertyType::Color && value.toString() == QStringLiteral("?")) {
        const QColor chosen = QColorDialog::getColor(QColor(toQString(valueOf(targets().front(), *property))), this);
        if (chosen.isValid())
            apply(id, chosen.name(), 0);
        else
            refresh();
        return;
    }
    const ElementId first = targets().empty() ? ElementId() : targets().front();
    const Element* element = first.isEmpty() ? nullptr : m_document.panel().find(first);
    const std::optional<Parameter> parameter = element ? parameterOf(*element, id, m_context) : std::nullopt;
    if (property->type == PropertyType::Text || (parameter && parameter->isText()))
        return storeTexts(*property, id, value.toString());
    const int gesture = m_gestureId == id ? m_gesture : 0;
    m_gestureId.clear();
    apply(id, value, gesture);
    refresh();
}

/// The key in the table and the property that names it are one step.
void PropertySheet::storeTexts(const PropertyDescriptor& property, const QString& id, const QString& typed) {
    const QString title = QCoreApplication::translate("Hmi", property.title);
    kit::MacroScope macro(m_document.undoStack(), title);
    for (const ElementId& one : targets()) {
        const Json& present = valueOf(one, property);
        const QString before = property.type == PropertyType::Arguments
                                   ? argumentsOf(present).value(id.section(u'.', 1).toLower())
                                   : toQString(present);
        const QString stored = parameterNames(typed).isEmpty()
                                   ? m_context.storeText(before, typed, m_panelName, m_document.undoStack())
                                   : typed; // what stands for a text is none
        m_document.perform(
            title, hmi::setProperty(m_document.panel(), one, property.key, fromGrid(property, present, id, stored)));
    }
}

void PropertySheet::editRecords(const QString& id) {
    const PropertyDescriptor* property = descriptor().property(propertyOf(id));
    const ElementIds ids = targets();
    if (!property || ids.empty()) return;
    // Texts typed in the dialog get their keys only when it is accepted.
    std::vector<std::pair<QString, QString>> typed;
    RecordsDialog dialog(*property, valueOf(ids.front(), *property), m_context, {}, this);
    offerVariables(dialog.grid());
    if (dialog.exec() != QDialog::Accepted) return;
    Json value = dialog.value();
    kit::MacroScope macro(m_document.undoStack(), QCoreApplication::translate("Hmi", property->title));
    if (property->type == PropertyType::Records)
        for (Json& row : value)
            for (const PropertyDescriptor& field : recordFields(property->hint)) {
                const auto found = row.find(std::string(field.key));
                if (field.type == PropertyType::Text && found != row.end())
                    *found = toUtf8(m_context.storeText({}, toQString(*found), m_panelName, m_document.undoStack()));
            }
    EditList list;
    for (const ElementId& one : ids)
        list.edits.push_back(hmi::setProperty(m_document.panel(), one, property->key, value));
    m_document.perform(QCoreApplication::translate("Hmi", property->title), {list});
}

} // namespace plc::hmi
