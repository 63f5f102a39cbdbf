#include "hmi/model/panel.h"

#include "hmi/model/errors.h"
#include "hmi/model/property_literals.h"
#include "runtime/base/read_json.h"

#include <QSet>
#include <cmath>

namespace plc::hmi {

const Json& Properties::at(std::string_view key) const {
    static const Json null;
    const auto found = m_fields.find(std::string(key));
    if (found != m_fields.end()) return *found;
    const PropertyDescriptor* property = m_descriptor->property(key);
    return property ? property->fallback : null;
}

namespace {
/// What the file says, or what holds without it: also when the file says something of another type.
const Json& ofType(const Properties& properties, std::string_view key, bool (Json::*isOfType)() const) {
    const Json& own = properties.at(key);
    const PropertyDescriptor* property = properties.descriptor().property(key);
    return (own.*isOfType)() || !property ? own : property->fallback;
}
} // namespace

double Properties::number(std::string_view key) const {
    const Json& value = ofType(*this, key, &Json::is_number);
    if (!value.is_number()) return 0;
    const double number = value.get<double>();
    const PropertyDescriptor* property = m_descriptor->property(key);
    if (!property || !property->limits) return number;
    return std::clamp(number, property->limits->first, property->limits->second);
}

int Properties::integer(std::string_view key) const { return static_cast<int>(std::clamp(number(key), -1e9, 1e9)); }

std::optional<double> Properties::optionalNumber(std::string_view key) const {
    const Json& value = at(key);
    if (!value.is_number()) return {};
    return value.get<double>();
}

bool Properties::isSet(std::string_view key) const {
    const Json& value = ofType(*this, key, &Json::is_boolean);
    return value.is_boolean() && value.get<bool>();
}

QRectF Properties::rect(std::string_view key) const {
    const Json& value = at(key);
    double part[4] = {0, 0, 0, 0};
    if (value.is_array())
        for (size_t i = 0; i < 4 && i < value.size(); ++i)
            if (value[i].is_number()) part[i] = value[i].get<double>();
    for (double& at : part) at = std::clamp(at, -kFurthestElement, kFurthestElement);
    return {part[0], part[1], std::clamp(part[2], 0.0, kLargestElement), std::clamp(part[3], 0.0, kLargestElement)};
}

QSize Properties::size(std::string_view key) const {
    const Json& value = at(key);
    if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) return {1024, 600};
    const auto pixels = [](const Json& number) { // any number, also one beyond int
        return static_cast<int>(std::clamp(number.get<double>(), 16.0, 16384.0));
    };
    return {pixels(value[0]), pixels(value[1])};
}

QList<QPointF> Properties::points(std::string_view key) const {
    QList<QPointF> out;
    const Json& value = at(key);
    if (!value.is_array()) return out;
    for (const Json& point : value)
        if (point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number())
            out += QPointF(point[0].get<double>(), point[1].get<double>());
    return out;
}

size_t Properties::place(std::string_view key) const {
    const std::optional<size_t> own = m_descriptor->rank(key);
    size_t index = 0, best = 0;
    for (const auto& [field, value] : m_fields.items()) {
        if (field == key) return index;
        ++index;
        const std::optional<size_t> rank = m_descriptor->rank(field);
        if (own && rank && *rank < *own) best = index;
    }
    return own ? best : index;
}

void Properties::setField(std::string_view key, const std::optional<Json>& value, size_t place) {
    const std::string name(key);
    auto& fields = m_fields.get_ref<Json::object_t&>();
    const auto found = fields.find(name);
    if (!value) {
        if (found != fields.end()) fields.erase(found);
        return;
    }
    if (found != fields.end()) {
        found->second = canonicalNumbers(*value);
        return;
    }
    // The ordered map's pairs have a constant key, so a field is put between others by building the map again.
    Json::object_t rebuilt;
    size_t index = 0;
    bool put = false;
    for (auto& [field, old] : fields) {
        if (index++ == place) {
            rebuilt.emplace(name, canonicalNumbers(*value));
            put = true;
        }
        rebuilt.emplace(field, std::move(old));
    }
    if (!put) rebuilt.emplace(name, canonicalNumbers(*value));
    fields = std::move(rebuilt);
}

Element::Element(Json fields) : Properties(descriptorOf(ElementKind::Unknown), std::move(fields)) {
    m_descriptor = &descriptorOf(kindOf(toUtf8(text("kind"_text))));
}

Element Element::make(ElementKind kind, const ElementId& id, const QRectF& rect) {
    Json fields = Json::object();
    fields["id"] = toUtf8(id);
    fields["kind"] = std::string(descriptorOf(kind).key);
    fields["rect"] = rectToJson(rect);
    return Element(std::move(fields));
}

QString Element::caption() const {
    const QString name = text("name"_text);
    return name.isEmpty() ? id() : name;
}

Json inCanonicalOrder(const Json& fields, const ElementDescriptor& descriptor, std::string_view alsoKnown) {
    struct Entry {
        size_t rank;
        std::string key;
        Json value;
    };
    std::vector<Entry> entries;
    size_t last = 0;
    for (const auto& [key, value] : fields.items()) {
        const std::optional<size_t> rank = descriptor.rank(key);
        if (rank)
            last = *rank + 1;
        else if (key == alsoKnown)
            last = descriptor.properties.size() + 1;
        entries.push_back({last, key, canonicalNumbers(value)});
    }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.rank < b.rank; });
    Json out = Json::object();
    for (Entry& entry : entries) out[entry.key] = std::move(entry.value);
    return out;
}

namespace {

Error errorAt(const QString& place, Message message) { return Error{std::move(message), place.toStdString()}; }

} // namespace

Result<Panel> Panel::parse(const std::string& utf8, const QString& place, std::vector<Error>* problems) {
    const std::string_view text = utf8.starts_with("\xEF\xBB\xBF") ? std::string_view(utf8).substr(3) : utf8;
    JsonText<Json> json = readJson<Json>(text);
    if (!json.isGood()) return errorAt(place + u':' + QString::number(json.line), errors::PanelNotJson());
    Json& root = json.value;
    if (!root.is_object()) return errorAt(place, errors::PanelNotObject());
    if (root.contains("version") && root["version"].is_number() && root["version"].get<double>() > 1)
        return errorAt(place, errors::PanelTooNew());
    Panel panel;
    if (!root.contains("elements")) root["elements"] = Json::array();
    if (!root["elements"].is_array()) return errorAt(place, errors::MustBeList(Verbatim("elements")));
    QSet<QString> ids, all;
    for (const Json& item : root["elements"])
        if (item.is_object() && item.contains("id")) all += toQString(item["id"]);
    const auto freeId = [&](std::string_view stem) {
        for (int each = 1;; ++each)
            if (const QString id =
                    QString::fromUtf8(stem.data(), static_cast<qsizetype>(stem.size())) + QString::number(each);
                !all.contains(id) && !ids.contains(id))
                return toUtf8(id);
    };
    std::vector<Error> found;
    int number = 0;
    for (const Json& item : root["elements"]) {
        ++number;
        const bool isObject = item.is_object();
        if (!isObject || (item.contains("kind") && !item["kind"].is_string())) {
            found.push_back(
                errorAt(place, isObject ? errors::ElementKindNotText(number) : errors::ElementNotObject(number)));
            panel.m_unread.emplace_back(panel.m_elements.size(), item);
            continue;
        }
        const Element raw{item};
        Element element{inCanonicalOrder(item, raw.descriptor())};
        const ElementId id = element.id();
        const bool isTaken = ids.contains(id);
        if (isTaken) found.push_back(errorAt(place, errors::ElementIdTwice(toUtf8(id))));
        if (id.isEmpty() || isTaken)
            element.setField("id", freeId(element.descriptor().key.empty() ? "element" : element.descriptor().key), 0);
        ids += element.id();
        panel.m_elements.push_back(std::move(element));
    }
    if (!found.empty() && !problems) return found.front();
    if (problems) problems->insert(problems->end(), found.begin(), found.end());
    panel.m_fields = inCanonicalOrder(root, panelDescriptor(), "elements");
    panel.m_fields["elements"] = nullptr;
    return panel;
}

std::string Panel::write() const {
    std::string out = "{";
    for (const auto& [key, value] : m_fields.items()) {
        out += (out.size() > 1 ? ",\n  " : "\n  ") + Json(key).dump() + ": ";
        if (key != "elements") {
            out += writeCompact(value);
            continue;
        }
        std::vector<Json> list;
        for (const Element& element : m_elements) list.push_back(element.fields());
        for (size_t i = m_unread.size(); i-- > 0;)
            list.insert(list.begin() + static_cast<std::ptrdiff_t>(std::min(m_unread[i].first, list.size())),
                        m_unread[i].second);
        out += writeList(list, 2);
    }
    return out + "\n}\n";
}

const Element* Panel::find(const ElementId& id) const {
    const int index = indexOf(id);
    return index < 0 ? nullptr : &m_elements[static_cast<size_t>(index)];
}

Element* Panel::find(const ElementId& id) {
    const int index = indexOf(id);
    return index < 0 ? nullptr : &m_elements[static_cast<size_t>(index)];
}

int Panel::indexOf(const ElementId& id) const {
    const std::string key = toUtf8(id);
    for (size_t i = 0; i < m_elements.size(); ++i) {
        const Json& other = m_elements[i].at("id"_field);
        if (other.is_string() && other.get_ref<const std::string&>() == key) return static_cast<int>(i);
    }
    return -1;
}

std::vector<ElementId> Panel::childrenOf(const ElementId& id) const {
    std::vector<ElementId> out;
    for (const Element& element : m_elements)
        if (!id.isEmpty() && element.parent() == id && element.id() != id) out.push_back(element.id());
    return out;
}

std::vector<ElementId> Panel::withDescendants(const ElementId& id) const {
    QSet<ElementId> inside{id};
    for (bool grew = true; grew;) {
        grew = false;
        for (const Element& element : m_elements)
            if (!inside.contains(element.id()) && inside.contains(element.parent())) {
                inside += element.id();
                grew = true;
            }
    }
    std::vector<ElementId> out;
    for (const Element& element : m_elements)
        if (inside.contains(element.id())) out.push_back(element.id());
    return out;
}

ElementId Panel::freeId(std::string_view stem) const {
    for (int number = 1;; ++number) {
        const ElementId id =
            QString::fromUtf8(stem.data(), static_cast<qsizetype>(stem.size())) + QString::number(number);
        if (!find(id)) return id;
    }
}

Json rectToJson(const QRectF& rect) {
    const auto tidy = [](double value) { return Json(std::round(value * 1000) / 1000); };
    return canonicalNumbers(Json::array({tidy(rect.x()), tidy(rect.y()), tidy(rect.width()), tidy(rect.height())}));
}

} // namespace plc::hmi
