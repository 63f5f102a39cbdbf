#include "hmi/model/edit.h"

#include "hmi/model/property_literals.h"

#include <QSet>

namespace plc::hmi {

bool Edit::isEmpty() const {
    const auto* list = std::get_if<EditList>(&what);
    return list && std::all_of(list->edits.begin(), list->edits.end(), [](const Edit& edit) { return edit.isEmpty(); });
}

void Touched::add(const Touched& other) {
    for (const ElementId& id : other.elements)
        if (std::find(elements.begin(), elements.end(), id) == elements.end()) elements.push_back(id);
    structure |= other.structure;
    panel |= other.panel;
}

namespace {

Edit applyOne(Panel& panel, const SetField& edit, Touched& touched) {
    Properties* properties = &panel;
    if (!edit.element.isEmpty()) {
        properties = panel.find(edit.element);
        if (!properties) return {};
        touched.add({{edit.element}});
    } else {
        touched.panel = true;
    }
    const bool had = properties->has(edit.key);
    const size_t place = had ? properties->place(edit.key) : edit.place.value_or(properties->place(edit.key));
    SetField inverse{edit.element, edit.key,
                     had ? std::optional<Json>(properties->fields().at(edit.key)) : std::nullopt, place};
    if (!edit.element.isEmpty() && (edit.key == "parent" || edit.key == "page")) touched.structure = true;
    if (edit.key == "kind" && !edit.element.isEmpty()) {
        // Another kind has another descriptor, so the element is made again from its fields.
        Element& element = static_cast<Element&>(*properties);
        element.setField(edit.key, edit.value, place);
        element = Element(element.fields());
        touched.structure = true;
        return {inverse};
    }
    properties->setField(edit.key, edit.value, place);
    return {inverse};
}

Edit applyOne(Panel& panel, const InsertElement& edit, Touched& touched) {
    Element element{edit.fields};
    if (panel.find(element.id())) return {};
    auto& elements = panel.elements();
    const int index = std::clamp(edit.index, 0, static_cast<int>(elements.size()));
    touched.add({{element.id()}, true});
    RemoveElement inverse{element.id()};
    elements.insert(elements.begin() + index, std::move(element));
    return {inverse};
}

Edit applyOne(Panel& panel, const RemoveElement& edit, Touched& touched) {
    const int index = panel.indexOf(edit.element);
    if (index < 0) return {};
    auto& elements = panel.elements();
    InsertElement inverse{index, elements[static_cast<size_t>(index)].fields()};
    elements.erase(elements.begin() + index);
    touched.add({{edit.element}, true});
    return {inverse};
}

Edit applyOne(Panel& panel, const MoveElement& edit, Touched& touched) {
    const int from = panel.indexOf(edit.element);
    if (from < 0) return {};
    auto& elements = panel.elements();
    const int to = std::clamp(edit.index, 0, static_cast<int>(elements.size()) - 1);
    Element element = std::move(elements[static_cast<size_t>(from)]);
    elements.erase(elements.begin() + from);
    elements.insert(elements.begin() + to, std::move(element));
    touched.add({{edit.element}, true});
    return {MoveElement{edit.element, from}};
}

Edit applyOne(Panel& panel, const EditList& edit, Touched& touched) {
    EditList inverse;
    for (const Edit& one : edit.edits) inverse.edits.push_back(applyTo(panel, one, &touched));
    std::reverse(inverse.edits.begin(), inverse.edits.end());
    return {inverse};
}

} // namespace

Edit applyTo(Panel& panel, const Edit& edit, Touched* touched) {
    Touched own;
    Edit inverse = std::visit([&](const auto& what) { return applyOne(panel, what, own); }, edit.what);
    if (touched) touched->add(own);
    return inverse;
}

Edit setProperty(const Panel& panel, const ElementId& element, std::string_view key, const Json& value) {
    const Properties* properties = element.isEmpty() ? static_cast<const Properties*>(&panel) : panel.find(element);
    if (!properties) return {};
    const Json tidy = canonicalNumbers(value);
    const PropertyDescriptor* property = properties->descriptor().property(key);
    const bool isDefault = property && property->fallback == tidy && key != "rect" && key != "size";
    if (properties->has(key) ? (!isDefault && properties->fields().at(std::string(key)) == tidy) : isDefault) return {};
    return {SetField{element, std::string(key), isDefault ? std::nullopt : std::optional<Json>(tidy), {}}};
}

namespace {

std::vector<ElementId> closure(const Panel& panel, const std::vector<ElementId>& elements) {
    QSet<ElementId> inside;
    for (const ElementId& id : elements)
        for (const ElementId& one : panel.withDescendants(id)) inside += one;
    std::vector<ElementId> out;
    for (const Element& element : panel.elements())
        if (inside.contains(element.id())) out.push_back(element.id());
    return out;
}

} // namespace

Edit removeElements(const Panel& panel, const std::vector<ElementId>& elements) {
    EditList list;
    std::vector<ElementId> all = closure(panel, elements);
    std::reverse(all.begin(), all.end());
    for (const ElementId& id : all) list.edits.push_back({RemoveElement{id}});
    return {list};
}

Edit moveBy(const Panel& panel, const std::vector<ElementId>& elements, QPointF offset) {
    EditList list;
    if (offset.isNull()) return {list};
    for (const ElementId& id : closure(panel, elements))
        list.edits.push_back(
            setProperty(panel, id, "rect"_field, rectToJson(panel.find(id)->rect().translated(offset))));
    return {list};
}

Edit resizeTo(const Panel& panel, const ElementId& element, const QRectF& rect) {
    EditList list;
    const Element* outer = panel.find(element);
    if (!outer) return {};
    const QRectF from = outer->rect();
    const double sx = from.width() > 0 ? rect.width() / from.width() : 1,
                 sy = from.height() > 0 ? rect.height() / from.height() : 1;
    for (const ElementId& id : panel.withDescendants(element)) {
        const QRectF old = panel.find(id)->rect();
        const QRectF scaled(rect.x() + (old.x() - from.x()) * sx, rect.y() + (old.y() - from.y()) * sy,
                            old.width() * sx, old.height() * sy);
        const bool keeps = outer->kind() == ElementKind::Tab && id != element; // a tab's pages keep their size
        const QRectF moved = keeps ? old.translated(rect.topLeft() - from.topLeft()) : scaled;
        list.edits.push_back(setProperty(panel, id, "rect"_field, rectToJson(id == element ? rect : moved)));
    }
    return {list};
}

} // namespace plc::hmi
