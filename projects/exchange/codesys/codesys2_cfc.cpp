#include "projects/exchange/codesys/codesys2_cfc.h"

#include "runtime/base/text.h"

#include <charconv>

namespace plc::exchange {
namespace {

struct UnknownPart {}; // stops the reading: nothing is converted half

/// A pin, or what an element says of itself: "_KEY: value" by key.
using Settings = std::map<std::string, std::string, std::less<>>;

struct CfcElement {
    Settings settings;
    std::vector<Settings> inputs, outputs;

    [[nodiscard]] std::string text(std::string_view key) const {
        const auto it = settings.find(key);
        return it == settings.end() ? std::string() : it->second;
    }
    [[nodiscard]] bool isBox() const { return text("_TYPE") == "_BOX"; }
};

std::string textIn(const Settings& settings, std::string_view key) {
    const auto it = settings.find(key);
    return it == settings.end() ? std::string() : it->second;
}

int numberIn(const Settings& settings, std::string_view key) {
    const std::string text = textIn(settings, key);
    int number = -1;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
}

bool isNegated(const Settings& settings) { return numberIn(settings, "_NEGATE") == 1; }

/// The lines of the export: an element has settings, a box pins of its own as well.
class ElementReader {
public:
    explicit ElementReader(std::string_view text) {
        for (size_t at = 0; at < text.size();) {
            const size_t end = std::min(text.find('\n', at), text.size());
            if (std::string line = trimmed(text.substr(at, end - at)); !line.empty())
                m_lines.push_back(std::move(line));
            at = end + 1;
        }
    }

    std::vector<CfcElement> read() {
        if (next() != "_CFC_BODY") throw UnknownPart();
        std::vector<CfcElement> out;
        while (m_at < m_lines.size()) {
            if (next() != "_ELEMENT") throw UnknownPart();
            out.push_back(element());
        }
        return out;
    }

private:
    const std::string& next() {
        if (m_at == m_lines.size()) throw UnknownPart();
        return m_lines[m_at++];
    }

    CfcElement element() {
        CfcElement out;
        for (;;) {
            const std::string& line = next();
            if (line == "_END") return out;
            if (line == "_IN")
                out.inputs.push_back(pin());
            else if (line == "_OUT")
                out.outputs.push_back(pin());
            else
                set(out.settings, line);
        }
    }
    Settings pin() {
        Settings out;
        for (;;) {
            const std::string& line = next();
            if (line == "_END") return out;
            set(out, line);
        }
    }
    static void set(Settings& settings, const std::string& line) {
        const size_t colon = line.find(':');
        if (line.front() != '_' || colon == std::string::npos) throw UnknownPart();
        settings[trimmed(std::string_view(line).substr(0, colon))] = trimmed(std::string_view(line).substr(colon + 1));
    }

    std::vector<std::string> m_lines;
    size_t m_at = 0;
};

/// The elements follow each other as they are executed; lines may lead to what comes before.
class CfcWriter {
public:
    CfcWriter(std::vector<CfcElement> elements, const PinsOfType& pinsOf, pugi::xml_document& document)
        : m_elements(std::move(elements)), m_pinsOf(pinsOf), m_body(document.append_child("CFC")) {
        for (const CfcElement& each : m_elements) m_byId[numberIn(each.settings, "_ID")] = &each;
    }

    void write() {
        for (const CfcElement& each : m_elements)
            if (!isBorder(each)) writeElement(each);
    }

private:
    /// A macro and its pins: what is inside stands beside what is around, and lines lead through.
    static bool isBorder(const CfcElement& element) {
        const std::string type = element.text("_TYPE");
        if (type != "_MACRO" && type != "_INPIN" && type != "_OUTPIN") return false;
        if (!element.text("_CONNECTOR").empty()) throw UnknownPart();
        for (const Settings& each : element.outputs)
            if (!textIn(each, "_CONNECTOR").empty()) throw UnknownPart();
        return true;
    }

    pugi::xml_node add(const char* kind, const CfcElement& element) {
        pugi::xml_node node = m_body.append_child(kind);
        node.append_attribute("localId") = numberIn(element.settings, "_ID");
        if (std::string_view(kind) != "inVariable") node.append_attribute("executionOrderId") = ++m_order;
        return node;
    }
    static void setText(pugi::xml_node node, const std::string& text) {
        node.append_child(pugi::node_pcdata).set_value(text.c_str());
    }

    void writeElement(const CfcElement& element) {
        const std::string type = element.text("_TYPE");
        if (!element.text("_CONNECTOR").empty()) throw UnknownPart(); // marks instead of lines
        if (type == "_INPUT")
            setText(add("inVariable", element).append_child("expression"), element.text("_TEXT"));
        else if (type == "_OUTPUT")
            writeTarget(element);
        else if (type == "_BOX")
            writeBox(element);
        else if (type == "_JUMP")
            writeJump(element, "jump");
        else if (type == "_RETURN")
            writeJump(element, "return");
        else if (type == "_LABEL")
            add("label", element).append_attribute("label") = element.text("_TEXT").c_str();
        else if (type == "_COMMENT")
            setText(add("comment", element).append_child("content").append_child("xhtml"), element.text("_TEXT"));
        else
            throw UnknownPart();
    }

    void writeTarget(const CfcElement& element) {
        pugi::xml_node node = add("outVariable", element);
        connect(node, element.settings);
        const std::string storage = element.text("_SETRESET");
        if (storage == "_SET" || storage == "_RESET")
            node.append_attribute("storage") = storage == "_SET" ? "set" : "reset";
        else if (!storage.empty() && storage != "_NONE" && storage != "_NOSETRESET" && storage != "_NO_SET")
            throw UnknownPart();
        setText(node.append_child("expression"), element.text("_TEXT"));
    }
    void writeJump(const CfcElement& element, const char* kind) {
        pugi::xml_node node = add(kind, element);
        if (std::string_view(kind) == "jump") node.append_attribute("label") = element.text("_TEXT").c_str();
        connect(node, element.settings);
    }

    struct Names {
        std::vector<std::string> inputs, outputs;
    };
    /// EN and ENO stand before the pins of the type, which the export only counts.
    Names namesOf(const CfcElement& box) const {
        Names out;
        const bool isEnabled = numberIn(box.settings, "_ENENO") == 1;
        if (isEnabled) out = {{"EN"}, {"ENO"}};
        if (numberIn(box.settings, "_INSTANCE") == 1) {
            const std::optional<BlockPins> pins = m_pinsOf(box.text("_TYPENAME"));
            if (!pins) throw UnknownPart();
            out.inputs.insert(out.inputs.end(), pins->inputs.begin(), pins->inputs.end());
            out.outputs.insert(out.outputs.end(), pins->outputs.begin(), pins->outputs.end());
        }
        for (size_t i = out.inputs.size(); i < box.inputs.size(); ++i)
            out.inputs.push_back("In" + std::to_string(i + 1 - (isEnabled ? 1 : 0)));
        for (size_t i = out.outputs.size(); i < box.outputs.size(); ++i)
            out.outputs.push_back("Out" + std::to_string(i));
        return out;
    }
    void writeBox(const CfcElement& element) {
        if (numberIn(element.settings, "_PARAMETERS") > 0) throw UnknownPart();
        const Names names = namesOf(element);
        pugi::xml_node block = add("block", element);
        block.append_attribute("typeName") = element.text("_TYPENAME").c_str();
        if (numberIn(element.settings, "_INSTANCE") == 1)
            block.append_attribute("instanceName") = element.text("_INSTANCENAME").c_str();
        pugi::xml_node pins = block.append_child("inputVariables");
        for (size_t i = 0; i < element.inputs.size(); ++i) {
            pugi::xml_node pin = pins.append_child("variable");
            pin.append_attribute("formalParameter") = names.inputs[i].c_str();
            connect(pin, element.inputs[i]);
        }
        block.append_child("inOutVariables");
        pins = block.append_child("outputVariables");
        for (size_t i = 0; i < element.outputs.size(); ++i) {
            if (!textIn(element.outputs[i], "_CONNECTOR").empty()) throw UnknownPart();
            pugi::xml_node pin = pins.append_child("variable");
            pin.append_attribute("formalParameter") = names.outputs[i].c_str();
            pin.append_child("connectionPointOut");
        }
    }

    [[nodiscard]] const CfcElement* elementOf(const Settings& settings, std::string_view key) const {
        const auto found = m_byId.find(numberIn(settings, key));
        return found == m_byId.end() ? nullptr : found->second;
    }
    /// Inside a macro: what arrives at the macro's pin of that number.
    const Settings& pinAround(const CfcElement& inner) const {
        const CfcElement* macro = elementOf(inner.settings, "_MACROID");
        const int number = numberIn(inner.settings, "_MACROIDX");
        if (!macro || number < 1 || static_cast<size_t>(number) > macro->inputs.size()) throw UnknownPart();
        return macro->inputs[static_cast<size_t>(number - 1)];
    }
    /// Outside a macro: what arrives inside at the output that the line begins at.
    const Settings& pinInside(const CfcElement& macro, const Settings& pin, bool& negated) const {
        const int index = numberIn(pin, "_INPUTIDX");
        if (index < 0 || static_cast<size_t>(index) >= macro.outputs.size()) throw UnknownPart();
        if (isNegated(macro.outputs[static_cast<size_t>(index)])) negated = !negated;
        for (const CfcElement& each : m_elements)
            if (each.text("_TYPE") == "_OUTPIN" && elementOf(each.settings, "_MACROID") == &macro &&
                numberIn(each.settings, "_MACROIDX") == index + 1)
                return each.settings;
        throw UnknownPart();
    }

    /// A negation where a line begins is one where it ends.
    void connect(pugi::xml_node node, const Settings& written) {
        bool negated = isNegated(written);
        const Settings* pin = &written;
        const CfcElement* source = elementOf(*pin, "_INPUTID");
        for (size_t borders = 0; source && isBorder(*source); source = elementOf(*pin, "_INPUTID")) {
            if (++borders > m_elements.size()) throw UnknownPart(); // a circle of pins
            pin = source->text("_TYPE") == "_INPIN" ? &pinAround(*source) : &pinInside(*source, *pin, negated);
            if (isNegated(*pin)) negated = !negated;
        }
        pugi::xml_node point = node.append_child("connectionPointIn");
        if (source) {
            pugi::xml_node connection = point.append_child("connection");
            connection.append_attribute("refLocalId") = numberIn(source->settings, "_ID");
            if (source->isBox())
                connection.append_attribute("formalParameter") =
                    outputName(*source, numberIn(*pin, "_INPUTIDX"), negated).c_str();
            else if (isNegated(source->settings))
                negated = !negated;
        }
        if (negated) node.append_attribute("negated") = "true";
    }
    std::string outputName(const CfcElement& box, int index, bool& negated) const {
        if (index < 0 || static_cast<size_t>(index) >= box.outputs.size()) throw UnknownPart();
        if (isNegated(box.outputs[static_cast<size_t>(index)])) negated = !negated;
        return namesOf(box).outputs[static_cast<size_t>(index)];
    }

    std::vector<CfcElement> m_elements;
    const PinsOfType& m_pinsOf;
    pugi::xml_node m_body;
    std::map<int, const CfcElement*> m_byId;
    int m_order = 0;
};

} // namespace

bool readCodesys2Cfc(std::string_view text, const PinsOfType& pinsOf, pugi::xml_document& document) {
    try {
        CfcWriter(ElementReader(text).read(), pinsOf, document).write();
        return true;
    } catch (const UnknownPart&) {
        document.reset();
        return false;
    }
}

} // namespace plc::exchange
