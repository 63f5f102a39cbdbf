// Edits of a panel as data: applying one returns its inverse, and the two together change no byte of the file.
// Values; nothing here holds the panel.
#pragma once
#include "hmi/model/panel.h"

#include <variant>

namespace plc::hmi {

struct Edit;

/// Sets (or, without a value, removes) one field of an element; of the panel where the element is empty.
struct SetField {
    ElementId element;
    std::string key;
    std::optional<Json> value;
    std::optional<size_t> place; // where a new field is put; the canonical place if not said
};
struct InsertElement {
    int index = 0;
    Json fields;
};
struct RemoveElement {
    ElementId element;
};
struct MoveElement {
    ElementId element;
    int index = 0;
};
struct EditList {
    std::vector<Edit> edits;
};

struct Edit {
    std::variant<EditList, SetField, InsertElement, RemoveElement, MoveElement> what;
    bool isEmpty() const;
};

/// What an applied edit touched, for views.
struct Touched {
    std::vector<ElementId> elements;
    bool structure = false; // elements came, went or changed their order
    bool panel = false;
    void add(const Touched& other);
};

/// Applies the edit and returns the inverse. A part that names an element that is not there is left out.
Edit applyTo(Panel& panel, const Edit& edit, Touched* touched = nullptr);

/// The edit that gives `key` this value: a value equal to the default removes the field, so that files stay short.
Edit setProperty(const Panel& panel, const ElementId& element, std::string_view key, const Json& value);
/// Removes elements with all that lies in them.
Edit removeElements(const Panel& panel, const std::vector<ElementId>& elements);
/// Moves elements (and what lies in them) by an offset.
Edit moveBy(const Panel& panel, const std::vector<ElementId>& elements, QPointF offset);
/// Gives an element a new rectangle; what lies in a group is scaled with it.
Edit resizeTo(const Panel& panel, const ElementId& element, const QRectF& rect);

} // namespace plc::hmi
