// A panel: its own properties and its elements in drawing order, as they stand in hmi/*.panel.json. Unknown fields and
// unknown element kinds are kept where they stood. A value; whoever holds it owns it.
#pragma once
#include "hmi/model/descriptor.h"
#include "runtime/base/result.h"

#include <QPointF>
#include <QRectF>
#include <QSize>

#include <utility>
#include <vector>

namespace plc::hmi {

using ElementId = QString;

/// No element is larger, and none lies further out: a picture of it must fit into memory.
inline constexpr double kLargestElement = 16384, kFurthestElement = 1e6;

/// Fields in the order of the file, read with the defaults of a descriptor.
class Properties {
public:
    Properties() : m_descriptor(&panelDescriptor()) {}
    Properties(const ElementDescriptor& descriptor, Json fields)
        : m_fields(std::move(fields)), m_descriptor(&descriptor) {}

    const Json& fields() const { return m_fields; }
    const ElementDescriptor& descriptor() const { return *m_descriptor; }
    /// The field's value, else the default of its descriptor, else null.
    const Json& at(std::string_view key) const;
    bool has(std::string_view key) const { return m_fields.contains(std::string(key)); }
    QString text(std::string_view key) const { return toQString(at(key)); }
    /// Never outside the range that elements.def gives, whatever the file says; what is no number there is as if it
    /// were missing.
    double number(std::string_view key) const;
    std::optional<double> optionalNumber(std::string_view key) const;
    /// Within ±1,000,000,000, so that an index can be added to it.
    int integer(std::string_view key) const;
    bool isSet(std::string_view key) const;
    QRectF rect(std::string_view key) const;
    QSize size(std::string_view key) const;
    QList<QPointF> points(std::string_view key) const;

    /// Where `key` stands or would be inserted in the canonical order.
    size_t place(std::string_view key) const;
    /// Writes or (without a value) removes the field; a new one is put at `place`.
    void setField(std::string_view key, const std::optional<Json>& value, size_t place);
    void set(std::string_view key, const Json& value) { setField(key, value, place(key)); }

protected:
    Json m_fields = Json::object();
    const ElementDescriptor* m_descriptor;
};

class Element : public Properties {
public:
    Element() : Properties(descriptorOf(ElementKind::Unknown), Json::object()) {}
    explicit Element(Json fields);
    static Element make(ElementKind kind, const ElementId& id, const QRectF& rect);

    ElementKind kind() const { return m_descriptor->kind; }
    ElementId id() const { return text("id"); }
    /// The name given by the engineer, else the id.
    QString caption() const;
    ElementId parent() const { return text("parent"); }
    QRectF rect() const { return Properties::rect("rect"); }
    bool isContainer() const { return kind() == ElementKind::Group || kind() == ElementKind::Tab; }
    /// What is drawn in it moves and hides with it.
    bool hasContents() const { return isContainer() || showsPanel(); }
    /// Another panel is drawn in it.
    bool showsPanel() const { return kind() == ElementKind::Faceplate || kind() == ElementKind::PanelArea; }
};

class Panel : public Properties {
public:
    Panel() : Properties(panelDescriptor(), Json{{"version", 1}, {"elements", nullptr}}) {}

    /// With `problems`, an element that is wrong costs only itself: it is named there, stays in the file where it was,
    /// and an id that is taken is replaced. Without, the first of them is the error.
    static Result<Panel> parse(const std::string& utf8, const QString& place, std::vector<Error>* problems = nullptr);
    std::string write() const;

    QSize size() const { return Properties::size("size"); }
    const std::vector<Element>& elements() const { return m_elements; }
    std::vector<Element>& elements() { return m_elements; }
    const Element* find(const ElementId& id) const;
    Element* find(const ElementId& id);
    int indexOf(const ElementId& id) const;
    std::vector<ElementId> childrenOf(const ElementId& id) const;
    /// The element and all that lies in it, in drawing order.
    std::vector<ElementId> withDescendants(const ElementId& id) const;
    /// "motor3": the kind's key with the first free number.
    ElementId freeId(std::string_view stem) const;

private:
    std::vector<Element> m_elements;
    std::vector<std::pair<size_t, Json>> m_unread; // what is no element, before the element of that number
};

/// Known fields in the descriptor's order; an unknown field stays behind the known one that it followed.
Json inCanonicalOrder(const Json& fields, const ElementDescriptor& descriptor, std::string_view alsoKnown = {});
Json rectToJson(const QRectF& rect);

} // namespace plc::hmi
