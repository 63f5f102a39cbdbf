#include "projects/exchange/twincat/stored_chart.h"

#include "projects/exchange/twincat/network_list.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <map>

namespace plc::exchange {
namespace {

using namespace archive;

constexpr const char* kSchema = "http://www.3s-software.com/plcopenxml/attributes";

/// What elements of a chart are described by; an archive lists the ones it uses, older ones list none.
const std::map<std::string, std::string, std::less<>> kKnown = {
    {"38391c6d-6d4a-42f8-8ee7-9f45e5adafa8", "Name"},        {"700a583f-b4d4-43e4-8c14-629c7cd3bec8", "MainAction"},
    {"a6b08bd8-b696-47e3-9cbf-7408b61c9ff8", "EntryAction"}, {"a2621e18-7de3-4ea6-ae6d-89e9e0b7befd", "ExitAction"},
    {"6844a48e-46c2-4cc8-a185-a478f3b99cc0", "InitStep"},    {"23bdaa98-72ec-41f7-817b-9dede5697086", "Parallel"},
    {"7d894980-aeea-405c-a0f6-e2b26429c58f", "Comment"},     {"cacf1a68-236e-47c2-b7b1-1cf9199718cb", "MinTime"},
    {"b693554c-1b01-4a8d-afde-9e3a46f7465d", "MaxTime"},     {"e174fc0d-80b0-4a9e-a530-ca239c249a50", "Qualifier"}};

std::string withoutBraces(std::string text) {
    if (text.size() >= 2 && text.front() == '{' && text.back() == '}') text = text.substr(1, text.size() - 2);
    return foldCase(text);
}

bool isName(std::string_view text) {
    return !text.empty() && !(text[0] >= '0' && text[0] <= '9') &&
           std::all_of(text.begin(), text.end(),
                       [](unsigned char c) { return std::isalnum(c) || c == '_' || c >= 0x80; });
}

class ChartConverter {
public:
    explicit ChartConverter(ArchiveBody& out) : m_out(out) {}

    void read(pugi::xml_node chart) {
        gatherDescriptions(memberOf(chart, "Attributes"));
        for (const pugi::xml_node child : chart.children()) gatherDescriptions(memberOf(child, "Attributes"));
        m_sfc = m_out.document.append_child("SFC");
        readSegment(memberOf(chart, "Root"), {});
        if (!m_hasInitial && m_firstStep) m_firstStep.append_attribute("initialStep") = "true";
    }

private:
    using Attributes = std::map<std::string, std::string>;

    /// A dictionary: keys and objects in turn.
    void gatherDescriptions(pugi::xml_node dictionary) {
        if (localName(dictionary) != "d2") return;
        std::string key;
        for (const pugi::xml_node child : dictionary.children())
            if (localName(child) == "v")
                key = withoutBraces(trimmed(exchange::textOf(child)));
            else if (std::string name = valueOf(child, "Identifier"); localName(child) == "o" && !name.empty())
                m_described[key] = name;
    }

    Attributes attributesOf(pugi::xml_node element) const {
        Attributes out;
        for (const Element& each : elementsOf(memberOf(element, "Attributes"))) {
            const std::string id = withoutBraces(valueOf(each.node, "AttributeId"));
            const auto described = m_described.find(id);
            const auto known = kKnown.find(id);
            const std::string name = described != m_described.end() ? described->second
                                     : known != kKnown.end()        ? known->second
                                                                    : id;
            out[name] = valueOf(memberOf(each.node, "Value"), "Value");
        }
        return out;
    }

    void remark(pugi::xml_node node, const std::string& what) {
        m_out.remarks.push_back({node, remarks::ElementNotRead(what)});
    }

    // ------------------------------------------------------------ the graph

    pugi::xml_node add(const char* kind) {
        pugi::xml_node node = m_sfc.append_child(kind);
        node.append_attribute("localId") = ++m_last;
        return node;
    }
    static void connect(pugi::xml_node node, const std::string& from) {
        pugi::xml_node point = node.append_child("connectionPointIn");
        if (!from.empty()) point.append_child("connection").append_attribute("refLocalId") = from.c_str();
    }
    static void setText(pugi::xml_node node, const std::string& text) {
        node.append_child(pugi::node_pcdata).set_value(text.c_str());
    }
    static std::string idOf(pugi::xml_node node) { return attribute(node, "localId"); }
    static void comment(pugi::xml_node node, const Attributes& attributes) {
        const auto text = attributes.find("Comment");
        if (text != attributes.end() && !text->second.empty())
            setText(node.append_child("documentation").append_child("xhtml"), text->second);
    }

    /// The elements of a segment follow each other; gives what the next one is connected to, nothing behind a jump.
    std::string readSegment(pugi::xml_node segment, std::string from) {
        for (const Element& each : elementsIn(segment, "ElementList")) {
            if (!each.node) continue;
            if (each.type == "SFCStep")
                from = readStep(each.node, from);
            else if (each.type == "SFCTransition")
                from = readTransition(each.node, from);
            else if (each.type == "SFCBranch")
                from = readBranch(each.node, from);
            else if (each.type == "SFCJump")
                from = readJump(each.node, from);
            else if (each.type == "SFCMacro" && !elementsIn(each.node, "ElementList").empty())
                from = readSegment(each.node, from); // what a macro holds takes its place
            else
                remark(each.node, each.type);
        }
        return from;
    }

    std::string readStep(pugi::xml_node step, const std::string& from) {
        Attributes attributes = attributesOf(step);
        const std::string name = attributes["Name"];
        pugi::xml_node node = add("step");
        node.append_attribute("name") = name.c_str();
        if (equalsIgnoringCase(attributes["InitStep"], "true")) {
            node.append_attribute("initialStep") = "true";
            m_hasInitial = true;
        }
        if (!m_firstStep) m_firstStep = node;
        connect(node, from);
        comment(node, attributes);
        addTimes(node, attributes);
        addActions(step, node, attributes);
        return idOf(node);
    }

    static void addTimes(pugi::xml_node node, Attributes& attributes) {
        pugi::xml_node list;
        for (const auto& [from, to] : {std::pair("MinTime", "minTime"), {"MaxTime", "maxTime"}}) {
            if (attributes[from].empty()) continue;
            if (!list) {
                pugi::xml_node data = node.append_child("addData").append_child("data");
                data.append_attribute("name") = kSchema;
                list = data.append_child("Attributes");
            }
            pugi::xml_node one = list.append_child("Attribute");
            one.append_attribute("Name") = to;
            one.append_attribute("Value") = attributes[from].c_str();
        }
    }

    /// In the order of their execution: what runs once at the beginning, always, once at the end; then the associated.
    void addActions(pugi::xml_node step, pugi::xml_node node, Attributes& attributes) {
        pugi::xml_node block;
        for (const auto& [name, qualifier] :
             {std::pair("EntryAction", "P1"), {"MainAction", "N"}, {"ExitAction", "P0"}}) {
            if (!attributes[name].empty()) addAction(block, node, qualifier, attributes[name]);
            if (const pugi::xml_node embedded = memberOf(step, std::string("Embedded") + name))
                addEmbedded(block, node, qualifier, embedded, attributes["Name"]);
        }
        for (const Element& each : elementsIn(step, "ElementList")) {
            Attributes own = attributesOf(each.node);
            if (!isName(own["Name"])) {
                remark(each.node, each.type);
                continue;
            }
            addAssociation(block, node, own);
        }
    }
    /// "N", or "L T#2s" with its time.
    void addAssociation(pugi::xml_node& block, pugi::xml_node step, Attributes& attributes) {
        std::string qualifier = trimmed(attributes["Qualifier"]), duration;
        if (const size_t end = qualifier.find_first_of(" ,"); end != std::string::npos) {
            duration = trimmed(qualifier.substr(end + 1));
            qualifier.erase(end);
        }
        pugi::xml_node action = addAction(block, step, qualifier, attributes["Name"]);
        if (!duration.empty()) action.append_attribute("duration") = duration.c_str();
    }

    pugi::xml_node newAction(pugi::xml_node& block, pugi::xml_node step, const std::string& qualifier) {
        if (!block) {
            block = add("actionBlock");
            connect(block, idOf(step));
        }
        pugi::xml_node action = block.append_child("action");
        action.append_attribute("qualifier") = qualifier.empty() ? "N" : qualifier.c_str();
        return action;
    }
    pugi::xml_node addAction(pugi::xml_node& block, pugi::xml_node step, const std::string& qualifier,
                             const std::string& name) {
        pugi::xml_node action = newAction(block, step, qualifier);
        action.append_child("reference").append_attribute("name") = name.c_str();
        return action;
    }
    /// An action that is written inside its step.
    void addEmbedded(pugi::xml_node& block, pugi::xml_node step, const char* qualifier, pugi::xml_node embedded,
                     const std::string& name) {
        pugi::xml_document body;
        if (!readEmbedded(embedded, body)) return remark(embedded, name + "." + attribute(embedded, "n"));
        newAction(block, step, qualifier).append_child("inline").append_copy(body.document_element());
    }
    /// False: in a form that is not known.
    bool readEmbedded(pugi::xml_node embedded, pugi::xml_document& body) {
        if (const pugi::xml_node text = objectOf(embedded, "STImplementationObject")) {
            setText(body.append_child("ST").append_child("xhtml"), textIn(text));
            return true;
        }
        ArchiveBody list = readNetworkList(embedded);
        if (!list.body()) return false;
        body.append_copy(list.body());
        m_out.remarks.insert(m_out.remarks.end(), list.remarks.begin(), list.remarks.end());
        return true;
    }
    static std::string textIn(pugi::xml_node holder) {
        for (const char* name : {"TextBlobForSerialisation", "TextBlobForSerialization", "Text"})
            if (const pugi::xml_node text = memberOf(holder, name); text && localName(text) == "v")
                return valueOf(holder, name);
        std::string out;
        for (const pugi::xml_node child : holder.children())
            if (child.type() == pugi::node_element) {
                const std::string more = textIn(child);
                out += out.empty() || more.empty() ? more : "\n" + more;
            }
        return out;
    }

    std::string readTransition(pugi::xml_node transition, const std::string& from) {
        Attributes attributes = attributesOf(transition);
        pugi::xml_node node = add("transition");
        connect(node, from);
        comment(node, attributes);
        pugi::xml_node condition = node.append_child("condition");
        const std::string text = attributes["Name"];
        const pugi::xml_node embedded = memberOf(transition, "EmbeddedTransition");
        if (embedded) {
            pugi::xml_document body;
            if (readEmbedded(embedded, body) && is(body.document_element(), "ST"))
                condition.append_child("inline").append_copy(body.document_element());
            else
                remark(embedded, "EmbeddedTransition " + text);
        } else if (isName(text)) { // a variable, or a transition of the unit
            condition.append_child("reference").append_attribute("name") = text.c_str();
        } else if (!text.empty()) {
            setText(condition.append_child("inline").append_child("ST").append_child("xhtml"), text);
        }
        return idOf(node);
    }

    std::string readJump(pugi::xml_node jump, const std::string& from) {
        pugi::xml_node node = add("jumpStep");
        node.append_attribute("targetName") = attributesOf(jump)["Name"].c_str();
        connect(node, from);
        return {};
    }

    std::string readBranch(pugi::xml_node branch, const std::string& from) {
        const bool isParallel = equalsIgnoringCase(attributesOf(branch)["Parallel"], "true");
        pugi::xml_node divergence = add(isParallel ? "simultaneousDivergence" : "selectionDivergence");
        connect(divergence, from);
        std::vector<std::string> ends;
        for (const Element& leg : elementsIn(branch, "ElementList"))
            if (leg.node)
                if (std::string end = readSegment(leg.node, idOf(divergence)); !end.empty())
                    ends.push_back(std::move(end));
        if (ends.empty()) return {};
        pugi::xml_node convergence = add(isParallel ? "simultaneousConvergence" : "selectionConvergence");
        for (const std::string& end : ends) connect(convergence, end);
        return idOf(convergence);
    }

    ArchiveBody& m_out;
    std::map<std::string, std::string> m_described;
    pugi::xml_node m_sfc, m_firstStep;
    int m_last = 0;
    bool m_hasInitial = false;
};

} // namespace

ArchiveBody readStoredChart(pugi::xml_node stored) {
    ArchiveBody out;
    if (const pugi::xml_node chart = objectOf(stored, "SFCImplementationObject")) ChartConverter(out).read(chart);
    return out;
}

} // namespace plc::exchange
