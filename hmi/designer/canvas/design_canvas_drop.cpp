// What is dropped on the canvas of the panel designer: elements of the palette, variables of the project.
#include "hmi/designer/canvas/design_canvas.h"

#include "editor/kit/inputs/variable_picker.h"
#include "editor/kit/message_text.h"
#include "hmi/check/property_check.h"
#include "hmi/designer/canvas/palette.h"
#include "hmi/designer/context/applicable.h"
#include "hmi/designer/context/arrange.h"
#include "hmi/designer/context/dropped_variable.h"
#include "hmi/model/errors.h"
#include "hmi/model/faceplate.h"
#include "hmi/model/property_literals.h"
#include "runtime/base/read_json.h"

#include <QDragEnterEvent>
#include <QMimeData>

#include <algorithm>
#include <cmath>

namespace plc::hmi {

void DesignCanvas::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasFormat(kElementMime) || !droppedVariables(event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

/// Variables of the picker or the watch list, or words dragged out of the code that name variables.
QStringList DesignCanvas::droppedVariables(const QMimeData* mime) const {
    if (mime->hasFormat(kit::VariableMime)) return kit::variablesOf(mime);
    QStringList out;
    if (!mime->hasText() || mime->text().size() > 2000) return out;
    for (const QString& line : kit::variablesOf(mime))
        if (const std::optional<QString> path = m_context.variableNamed(line)) out += *path;
    return out;
}

void DesignCanvas::dragMoveEvent(QDragMoveEvent* event) {
    QSizeF size(140, 40);
    if (event->mimeData()->hasFormat(kElementMime)) {
        const Json list = readJson<Json>(event->mimeData()->data(kElementMime).toStdString()).value;
        if (list.is_array() && !list.empty()) size = Element(list[0]).rect().size();
    }
    const QPointF at = toPanel(event->position());
    QRectF rect(at - QPointF(size.width() / 2, size.height() / 2), size);
    m_guides.clear();
    if (m_snaps) {
        const Snapped snapped = snapMove(rect, snapField({}));
        rect.translate(snapped.offset);
        m_guides = snapped.guides;
    }
    rect.moveTopLeft(onPanel(rect).topLeft());
    const bool isNew = event->modifiers() & Qt::ShiftModifier; // an element that operates
    const QStringList variables = isNew ? QStringList() : droppedVariables(event->mimeData());
    const ElementId trend = trendUnder(at, variables);
    if (const ElementId bound = trend.isEmpty() ? bindingUnder(at, variables).first : trend; !bound.isEmpty()) {
        rect = m_document.panel().find(bound)->rect(); // that is what the drop changes
        m_guides.clear();
    }
    m_dropRect = rect;
    viewport()->update();
    event->acceptProposedAction();
}

std::pair<ElementId, std::string> DesignCanvas::bindingUnder(QPointF at, const QStringList& variables) const {
    const ElementId id = variables.size() == 1 ? elementAt(at, true) : ElementId();
    const Element* element = m_document.panel().find(id);
    if (!element || element->isSet("locked"_flag)) return {};
    for (const PropertyDescriptor* property : mainBindings(*element)) {
        Found place;
        place.property = property->key;
        place.hint = property->hint;
        if (PanelVariables(m_context, m_document)
                .complaint(variables.front(), wantedType(*element, place), property->type == PropertyType::Target)
                .isEmpty())
            return {id, std::string(property->key)};
    }
    return {};
}

ElementId DesignCanvas::trendUnder(QPointF at, const QStringList& variables) const {
    const ElementId id = variables.isEmpty() ? ElementId() : elementAt(at, true);
    const Element* element = m_document.panel().find(id);
    if (!element || element->kind() != ElementKind::TrendChart || element->isSet("locked"_flag)) return {};
    const PanelVariables known(m_context, m_document);
    const bool areCurves = std::ranges::all_of(variables, [&](const QString& path) {
        return structureType(path, known).isEmpty() && known.complaint(path, "number", false).isEmpty();
    });
    return areCurves ? id : ElementId();
}

void DesignCanvas::addCurves(const ElementId& trend, const QStringList& variables) {
    Json curves = m_document.panel().find(trend)->at("series");
    if (!curves.is_array()) curves = Json::array();
    for (const QString& path : variables) curves.push_back(Json{{"value", toUtf8(path)}});
    m_document.perform(tr("Bind"), hmi::setProperty(m_document.panel(), trend, "series", std::move(curves)));
    m_selection.set({trend});
}

void DesignCanvas::dragLeaveEvent(QDragLeaveEvent*) {
    m_dropRect.reset();
    m_guides.clear();
    viewport()->update();
}

void DesignCanvas::dropEvent(QDropEvent* event) {
    const QStringList variables = droppedVariables(event->mimeData());
    const bool isNew = event->modifiers() & Qt::ShiftModifier;
    const QStringList bindable = isNew ? QStringList() : variables;
    const ElementId trend = trendUnder(toPanel(event->position()), bindable);
    const auto [bound, property] = bindingUnder(toPanel(event->position()), bindable);
    const QPointF at = m_dropRect ? m_dropRect->center() : toPanel(event->position());
    m_dropRect.reset();
    m_guides.clear();
    if (event->mimeData()->hasFormat(kElementMime)) {
        const Json list = readJson<Json>(event->mimeData()->data(kElementMime).toStdString()).value;
        if (list.is_array()) insertElements(list, at);
    } else if (!trend.isEmpty()) {
        addCurves(trend, variables);
    } else if (!bound.isEmpty()) {
        m_document.perform(tr("Bind"),
                           hmi::setProperty(m_document.panel(), bound, property, toUtf8(variables.front())));
        m_selection.set({bound});
    } else {
        insertVariables(variables, at, event->modifiers() & Qt::ShiftModifier);
    }
    event->acceptProposedAction();
    setFocus();
}

namespace {

/// A navigation bar as the palette has it leads to the panels that there are.
void leadToPanels(Json& fields, const PanelProject& project) {
    if (!fields.is_object() || Element(fields).kind() != ElementKind::NavigationBar || fields.contains("entries"))
        return;
    Json entries = Json::array();
    for (const NamedPanel& panel : project.panels) {
        if (!parametersOf(panel.panel).empty()) continue; // of another panel
        Json entry = Json::object();
        entry["panel"] = entry["text"] = toUtf8(panel.name);
        entries.push_back(std::move(entry));
    }
    if (entries.size() > 1) fields["entries"] = std::move(entries);
}

} // namespace

QRectF DesignCanvas::onPanel(QRectF rect) const {
    const QSizeF panel = m_scene.size();
    rect.moveLeft(std::max(0.0, std::min(rect.left(), panel.width() - rect.width())));
    rect.moveTop(std::max(0.0, std::min(rect.top(), panel.height() - rect.height())));
    return rect;
}

void DesignCanvas::insertElements(const Json& elements, QPointF at) {
    const PanelLookup panels = m_context.project().panelLookup();
    for (const Json& fields : elements) {
        if (!fields.is_object() || Element(fields).kind() != ElementKind::Faceplate) continue;
        const QString placed = Element(fields).text("panel"_text);
        const hmi::Panel* panel = panels(placed);
        if (panel && (placed == m_panelName || placesPanel(*panel, m_panelName, panels))) {
            emit refused(kit::messageText(errors::FaceplateContainsItself(toUtf8(placed))));
            return;
        }
    }
    const QRectF bounds = boundsOf(elements);
    QPointF corner = at - QPointF(bounds.width() / 2, bounds.height() / 2);
    corner = QPointF(std::round(corner.x()), std::round(corner.y()));
    if (m_snaps) corner += snapMove(QRectF(corner, bounds.size()), snapField({})).offset;
    corner = onPanel(QRectF(corner, bounds.size())).topLeft();
    Json placed = elements;
    int page = 0;
    const ElementId tab = tabAt(at, &page);
    for (Json& fields : placed) {
        leadToPanels(fields, m_context.project());
        if (!fields.is_object() || tab.isEmpty() || fields.contains("parent")) continue;
        Element element{fields};
        element.set("parent"_field, toUtf8(tab));
        if (page) element.set("page"_field, page);
        fields = element.fields();
    }
    ElementIds added;
    const Edit edit = pasted(m_document.panel(), placed, corner, &added);
    m_document.perform(tr("Insert"), withCells(edit, added, at));
    m_selection.set(added);
}

void DesignCanvas::insertVariables(const QStringList& paths, QPointF at, bool operates) {
    const PanelVariables variables(m_context, m_document);
    Json list = Json::array();
    double y = 0;
    int number = 0;
    for (const QString& path : paths) {
        std::vector<Element> made;
        if (const QString type = structureType(path, variables); type.isEmpty())
            made = elementsForVariable(path, variables, operates);
        else if (auto faceplate = faceplateFor(path, variables, m_panelName))
            made.push_back(std::move(*faceplate));
        else
            emit refused(tr("%1 has no single value: drop one of its members, or first draw a panel with a parameter "
                            "of the type %2")
                             .arg(path, type));
        for (Element& element : made) {
            element.setField("id", "new" + std::to_string(++number), 0);
            element.set("rect"_field, rectToJson(element.rect().translated(0, y)));
            y += element.rect().height() + 12;
            list.push_back(element.fields());
        }
    }
    if (!list.empty()) insertElements(list, at);
}

} // namespace plc::hmi
