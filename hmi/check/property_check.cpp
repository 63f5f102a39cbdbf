#include "hmi/check/property_check.h"

#include "hmi/check/property_fix.h"
#include "hmi/model/array_index.h"
#include "hmi/model/errors.h"
#include "hmi/model/walk.h"
#include "runtime/base/text.h"

#include <cmath>

namespace plc::hmi {

namespace {

QString nameOf(const PropertyDescriptor& property) {
    return QString::fromUtf8(property.key.data(), static_cast<qsizetype>(property.key.size()));
}

std::string shownNumber(double number) { return toUtf8(QString::number(number, 'g', 12)); }

bool isListOfNumbers(const Json& value, size_t length) {
    return value.is_array() && value.size() == length &&
           std::all_of(value.begin(), value.end(), [](const Json& one) { return one.is_number(); });
}

bool areStrings(const Json& value) {
    return value.is_object() &&
           std::all_of(value.begin(), value.end(), [](const Json& one) { return one.is_string(); });
}

bool areObjects(const Json& value) {
    return value.is_array() && std::all_of(value.begin(), value.end(), [](const Json& one) { return one.is_object(); });
}

bool arePoints(const Json& value) {
    return value.is_array() &&
           std::all_of(value.begin(), value.end(), [](const Json& one) { return isListOfNumbers(one, 2); });
}

bool isWhole(const Json& value) { return value.is_number() && std::floor(value.get<double>()) == value.get<double>(); }

/// How the values of a type are written in the file; types that are not here are checked elsewhere.
struct Writing {
    PropertyType type;
    bool (*fits)(const Json& value);
    Message (*complaint)();
};

const Writing* writingOf(PropertyType type) {
    static constexpr auto isText = [](const Json& value) { return value.is_string(); };
    static constexpr auto mustBeText = [] { return errors::MustBeText(); };
    static const Writing all[] = {
        {PropertyType::Bool, [](const Json& v) { return v.is_boolean(); }, [] { return errors::MustBeTrueOrFalse(); }},
        {PropertyType::Integer, isWhole, [] { return errors::MustBeWholeNumber(); }},
        {PropertyType::Number, [](const Json& v) { return v.is_number(); }, [] { return errors::MustBeNumber(); }},
        {PropertyType::Rect, [](const Json& v) { return isListOfNumbers(v, 4); },
         [] { return errors::MustBeFourNumbers(); }},
        {PropertyType::Size, [](const Json& v) { return isListOfNumbers(v, 2); },
         [] { return errors::MustBeTwoNumbers(); }},
        {PropertyType::Points, arePoints, [] { return errors::MustBePoints(); }},
        {PropertyType::Bindings, areStrings, [] { return errors::MustBeExpressions(); }},
        {PropertyType::Records, areObjects, [] { return errors::MustBeObjects(); }},
        {PropertyType::Name, isText, mustBeText},
        {PropertyType::Element, isText, mustBeText},
        {PropertyType::Choice, isText, mustBeText},
        {PropertyType::Symbol, isText, mustBeText},
        {PropertyType::Color, isText, mustBeText},
        {PropertyType::String, isText, mustBeText},
        {PropertyType::Text, isText, mustBeText},
        {PropertyType::TextList, isText, mustBeText},
        {PropertyType::File, isText, mustBeText},
        {PropertyType::Panel, isText, mustBeText},
        {PropertyType::Expression, isText, mustBeText},
        {PropertyType::Target, isText, mustBeText},
    };
    const auto found =
        std::find_if(std::begin(all), std::end(all), [&](const Writing& one) { return one.type == type; });
    return found == std::end(all) ? nullptr : &*found;
}

/// "$limit", in a panel with parameters.
bool isParameter(const Json& value) {
    return value.is_string() && value.get_ref<const std::string&>().starts_with("$");
}

bool isColor(const QString& name) {
    if (name.isEmpty() || name == QStringLiteral("none") || name.contains(u'$')) return true; // $: given elsewhere
    return PanelTheme::of(PanelThemeKind::Light).color(name).isValid();
}

std::vector<std::string> keysOf(const std::vector<PropertyDescriptor>& properties) {
    std::vector<std::string> out;
    for (const PropertyDescriptor& one : properties) out.emplace_back(one.key);
    return out;
}

bool needsWords(const Element& element) {
    static constexpr ElementKind kOperated[] = {
        ElementKind::Button, ElementKind::Switch,    ElementKind::CheckBox,    ElementKind::Slider,
        ElementKind::Knob,   ElementKind::TextEntry, ElementKind::MaskedEntry, ElementKind::NumericEntry,
    };
    if (element.kind() == ElementKind::CellGrid) return element.text("action") != QStringLiteral("none");
    return std::find(std::begin(kOperated), std::end(kOperated), element.kind()) != std::end(kOperated);
}

bool saysWhatItDoes(const Element& element) {
    if (element.kind() == ElementKind::Button && element.text("icon") != QStringLiteral("none")) return true;
    for (const char* const words : {"text", "onText", "offText", "title"})
        if (!element.text(words).trimmed().isEmpty()) return true;
    return false;
}

/// A head of the column above or of the row before, however far.
bool heads(const QRectF& caption, const QRectF& element) {
    const bool isAbove =
        caption.bottom() <= element.top() && caption.left() < element.right() && caption.right() > element.left();
    const bool isBefore =
        caption.right() <= element.left() && caption.top() < element.bottom() && caption.bottom() > element.top();
    return isAbove || isBefore;
}

class PropertyChecker {
public:
    PropertyChecker(const CheckInput& input, const Panel& panel) : m_input(input), m_panel(panel) {}

    std::vector<PropertyFinding> run() {
        checkFields({}, m_panel.fields(), panelDescriptor().properties, {}, {"version", "elements"});
        for (const Element& element : m_panel.elements()) {
            if (element.kind() == ElementKind::Unknown) continue; // nobody knows what its properties mean
            checkFields(element.id(), element.fields(), element.descriptor().properties, {}, {});
            checkLimits(element);
            checkPlace(element);
            checkPicture(element);
            checkFormats(element);
            checkName(element);
        }
        return std::move(m_found);
    }

private:
    void add(FindingKind kind, bool isError, const ElementId& id, const QString& property, Message message,
             Edit fix = {}) {
        m_found.push_back({kind, isError, id, property, std::move(message), std::move(fix)});
    }

    /// What it most probably was meant to be.
    Edit nearest(const ElementId& id, const QString& place, const std::string& text,
                 const std::vector<std::string>& choices) const {
        const std::optional<std::string> near = nearestName(text, choices);
        return near ? valueAt(m_panel, id, place, *near) : Edit();
    }

    void checkFields(const ElementId& id, const Json& fields, const std::vector<PropertyDescriptor>& known,
                     const QString& prefix, std::initializer_list<std::string_view> alsoKnown) {
        if (!fields.is_object()) return;
        for (const auto& [key, value] : fields.items()) {
            const QString place = prefix + QString::fromStdString(key);
            const auto property =
                std::find_if(known.begin(), known.end(), [&](const PropertyDescriptor& one) { return one.key == key; });
            if (property != known.end())
                checkValue(id, *property, value, place);
            else if (std::find(alsoKnown.begin(), alsoKnown.end(), key) == alsoKnown.end())
                reportUnknown(id, key, known, place);
        }
    }

    void reportUnknown(const ElementId& id, const std::string& key, const std::vector<PropertyDescriptor>& known,
                       const QString& place) {
        if (const std::optional<std::string> near = nearestName(key, keysOf(known)))
            add(FindingKind::UnknownProperty, false, id, place, errors::PropertyUnknownSuggest(key, *near),
                nameAt(m_panel, id, place, *near));
        else
            add(FindingKind::UnknownProperty, false, id, place, errors::PropertyUnknown(key));
    }

    void checkValue(const ElementId& id, const PropertyDescriptor& property, const Json& value, const QString& place) {
        const Writing* writing = writingOf(property.type);
        if (!writing || (value.is_null() && property.fallback.is_null())) return;
        if (isParameter(value)) return; // given where the panel is placed
        if (!writing->fits(value)) {
            const std::optional<Json> meant = asType(property.type, value);
            add(FindingKind::WrongPropertyType, true, id, place, writing->complaint(),
                meant ? valueAt(m_panel, id, place, *meant) : Edit());
            return;
        }
        if (property.limits && value.is_number()) checkRange(id, property, value.get<double>(), place);
        const QString text = toQString(value);
        if (property.type == PropertyType::Color && !isColor(text))
            add(FindingKind::BadColor, true, id, place, badColor(text), nearest(id, place, toUtf8(text), roles()));
        if (property.type == PropertyType::Choice || property.type == PropertyType::Symbol)
            checkChoice(id, property, toUtf8(text), place);
        if (property.hint == "theme" && !text.isEmpty()) checkTheme(id, text, place);
        if (property.type != PropertyType::Records) return;
        for (size_t row = 0; row < value.size(); ++row)
            checkFields(id, value[row], recordFields(property.hint), place + QStringLiteral("[%1].").arg(row), {});
    }

    void checkRange(const ElementId& id, const PropertyDescriptor& property, double number, const QString& place) {
        const auto [low, high] = *property.limits;
        if (number >= low && number <= high) return;
        const double used = std::clamp(number, low, high);
        const bool isWhole = property.type == PropertyType::Integer;
        add(FindingKind::OutOfRange, false, id, place,
            errors::NumberOutOfRange(shownNumber(number), shownNumber(low), shownNumber(high), shownNumber(used)),
            valueAt(m_panel, id, place, isWhole ? Json(static_cast<int64_t>(used)) : Json(used)));
    }

    static std::vector<std::string> roles() {
        std::vector<std::string> out;
        for (const QString& role : PanelTheme::roles()) out.push_back(toUtf8(role));
        return out;
    }

    static Message badColor(const QString& text) {
        if (const std::optional<std::string> near = nearestName(toUtf8(text), roles()))
            return errors::ColorUnknownSuggest(toUtf8(text), *near);
        return errors::ColorUnknown(toUtf8(text), Verbatim("#2A6CA6"));
    }

    void checkChoice(const ElementId& id, const PropertyDescriptor& property, const std::string& text,
                     const QString& place) {
        std::vector<std::string> choices;
        for (const std::string_view one : property.choices()) choices.emplace_back(one);
        if (property.key == "theme")
            for (const auto& [name, theme] : m_input.themes.own()) choices.push_back(toUtf8(name));
        if (std::find(choices.begin(), choices.end(), text) == choices.end())
            add(FindingKind::WrongPropertyType, true, id, place, errors::ChoiceUnknown(text, choices),
                nearest(id, place, text, choices));
    }

    void checkTheme(const ElementId& id, const QString& name, const QString& place) {
        if (m_input.themes.has(name)) return;
        std::vector<std::string> names;
        for (const QString& one : m_input.themes.names()) names.push_back(toUtf8(one));
        add(FindingKind::WrongPropertyType, true, id, place, errors::NoSuchTheme(toUtf8(name), names),
            nearest(id, place, toUtf8(name), names));
    }

    /// `low` must be less than `high` where both are given.
    void checkOrder(const Element& element, std::string_view low, std::string_view high, bool mayBeEqual = false) {
        if (!element.descriptor().property(low) || !element.descriptor().property(high)) return;
        const std::optional<double> from = element.optionalNumber(low), to = element.optionalNumber(high);
        if (!from || !to || *from < *to || (mayBeEqual && *from == *to)) return;
        add(FindingKind::WrongLimits, true, element.id(), nameOf(*element.descriptor().property(high)),
            errors::LimitsWrongWay(std::string(high), shownNumber(*to), std::string(low), shownNumber(*from)));
    }

    void checkLimits(const Element& element) {
        checkOrder(element, "min", "max");
        checkOrder(element, "minX", "maxX");
        checkOrder(element, "minY", "maxY");
        checkOrder(element, "lowLow", "low", true);
        checkOrder(element, "low", "high");
        checkOrder(element, "high", "highHigh", true);
        if (element.kind() != ElementKind::NumericEntry) return;
        bool isLow = false, isHigh = false;
        const double low = element.text("minimum").toDouble(&isLow), high = element.text("maximum").toDouble(&isHigh);
        if (isLow && isHigh && low >= high)
            add(FindingKind::WrongLimits, true, element.id(), QStringLiteral("maximum"),
                errors::LimitsWrongWay(Verbatim("maximum"), shownNumber(high), Verbatim("minimum"), shownNumber(low)));
    }

    /// Groups and tabs exist, hold nothing else than what is in them, and no group is in itself.
    void checkPlace(const Element& element) {
        const ElementId outer = element.parent();
        if (outer.isEmpty()) return;
        const Element* container = m_panel.find(outer);
        const QString property = QStringLiteral("parent");
        if (!container || !container->isContainer()) {
            add(FindingKind::BadGroup, true, element.id(), property, errors::NoGroup(toUtf8(outer)));
            return;
        }
        ElementId at = outer;
        for (size_t steps = 0; !at.isEmpty() && steps <= m_panel.elements().size(); ++steps) {
            if (at == element.id()) {
                add(FindingKind::BadGroup, true, element.id(), property, errors::GroupInItself(toUtf8(at)));
                return;
            }
            const Element* next = m_panel.find(at);
            at = next ? next->parent() : ElementId();
        }
        const Json& pages = container->at("pages");
        if (container->kind() == ElementKind::Tab && pages.is_array() &&
            (element.integer("page") < 0 || element.integer("page") >= static_cast<int>(pages.size())))
            add(FindingKind::BadGroup, true, element.id(), QStringLiteral("page"),
                errors::NoTabPage(toUtf8(outer), element.integer("page"), static_cast<int64_t>(pages.size())));
    }

    void checkPicture(const Element& element) {
        if (m_input.folder.isEmpty()) return;
        for (const PropertyDescriptor& property : element.descriptor().properties) {
            const QString file = element.text(property.key);
            if (property.type != PropertyType::File || file.isEmpty()) continue;
            const Result<QPixmap> picture = loadPicture({m_input.folder, m_input.picturesOutside}, file, {64, 64});
            if (picture) continue;
            const bool isMissing = picture.error().message.form() == errors::FileMissing(toUtf8(file)).form();
            add(isMissing ? FindingKind::MissingImage : FindingKind::BadPicture, true, element.id(), nameOf(property),
                picture.error().message);
        }
    }

    /// What is operated says what it does, in words of its own or in a text beside it.
    void checkName(const Element& element) {
        if (!needsWords(element) || saysWhatItDoes(element) || hasTextBeside(element)) return;
        add(FindingKind::UnnamedControl, false, element.id(), {}, errors::ControlWithoutWords());
    }

    bool hasTextBeside(const Element& element) const {
        constexpr double Near = 72; // as far as a caption is from what it belongs to
        const QRectF around = element.rect().adjusted(-Near, -Near, Near, Near);
        return std::any_of(m_panel.elements().begin(), m_panel.elements().end(), [&](const Element& other) {
            const bool isCaption = other.kind() == ElementKind::Text && !other.text("text").trimmed().isEmpty();
            const bool isFrame = other.kind() == ElementKind::Group && !other.text("title").isEmpty();
            return (isCaption && (around.intersects(other.rect()) || heads(other.rect(), element.rect()))) ||
                   (isFrame && other.rect().contains(element.rect()));
        });
    }

    bool isNumber(const QString& expression) const {
        return !m_input.checkBinding(expression, "any", false).isEmpty() || // that is reported elsewhere
               m_input.checkBinding(expression, "number", false).isEmpty();
    }

    void checkFormat(const Element& element, const QString& format, const QString& expression, const QString& place) {
        const std::optional<NumberFormat> parsed = NumberFormat::parse(format);
        if (!parsed || parsed->conversion == 's' || expression.isEmpty() || isNumber(expression)) return;
        const bool isProperty = place.endsWith(QStringLiteral("format")); // else it is in a text, in some language
        add(FindingKind::BadFormat, true, element.id(), place,
            errors::FormatNeedsNumber(toUtf8(format), toUtf8(expression), Verbatim("%s")),
            isProperty ? valueAt(m_panel, element.id(), place, "%s") : Edit());
    }

    void checkFormats(const Element& element) {
        if (!m_input.checkBinding) return;
        const bool isDisplay = element.descriptor().property("value") != nullptr;
        if (element.has("format"))
            checkFormat(element, element.text("format"), element.text(isDisplay ? "value" : "target"),
                        QStringLiteral("format"));
        const Json& columns = element.at("columns");
        for (size_t row = 0; columns.is_array() && row < columns.size(); ++row) {
            if (!columns[row].is_object()) continue;
            const Properties column(descriptorOf(ElementKind::Unknown), columns[row]);
            const int first = element.integer("first");
            checkFormat(element, column.text("format"), withIndex(column.text("value"), first, first, first),
                        QStringLiteral("columns[%1].format").arg(row));
        }
        forEachText(element, [&](const Found& text) { checkPlaceholders(element, text); });
    }

    void checkPlaceholders(const Element& element, const Found& text) {
        const Json& values = element.at("values");
        if (!values.is_object()) return;
        const TextTable& table = m_input.texts.table();
        QStringList said;
        for (const QString& tag : isTextKey(text.text) ? table.tags() : QStringList{QString()}) {
            const QString words = isTextKey(text.text) ? table.text(keyOf(text.text), tag) : text.text;
            for (const TextTemplate::Part& part : TextTemplate::parse(words).parts) {
                const auto value = values.find(toUtf8(part.name));
                if (part.name.isEmpty() || value == values.end() || said.contains(part.name)) continue;
                said += part.name;
                checkFormat(element, part.format, toQString(*value), text.place());
            }
        }
    }

    const CheckInput& m_input;
    const Panel& m_panel;
    std::vector<PropertyFinding> m_found;
};

} // namespace

std::string_view wantedType(const Properties& element, const Found& binding) {
    if (binding.property != "target") return binding.hint;
    static constexpr std::string_view kOfBits[] = {"momentary", "toggle", "set", "reset"};
    const std::string action = toUtf8(element.text("action"));
    const bool isBit = std::find(std::begin(kOfBits), std::end(kOfBits), action) != std::end(kOfBits);
    return isBit ? std::string_view("bool") : binding.hint;
}

std::vector<PropertyFinding> checkProperties(const CheckInput& input, const Panel& panel) {
    return PropertyChecker(input, panel).run();
}

} // namespace plc::hmi
