#include "projects/exchange/graphs/macro_steps.h"

#include "runtime/base/text.h"

#include <functional>
#include <set>

namespace plc::exchange {
namespace {

constexpr int kMostMacros = 10000; // of one chart, those within others included

void forEachBelow(pugi::xml_node node, const char* name, const std::function<void(pugi::xml_node)>& use) {
    for (const pugi::xml_node child : node.children()) {
        if (is(child, name)) use(child);
        forEachBelow(child, name, use);
    }
}

void setAttribute(pugi::xml_node node, const char* name, const std::string& value) {
    pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute) attribute = node.append_attribute(name);
    attribute.set_value(value.c_str());
}

class Expansion {
public:
    Expansion(pugi::xml_node sfc, pugi::xml_node macro)
        : m_sfc(sfc), m_macro(macro), m_inner(descendantOf(macro, "body/SFC")) {}

    /// False: it holds no chart.
    bool run() {
        chooseEnds();
        if (!m_entry) return false;
        renameSteps();
        keepOneInitialStep();
        const std::string ownId = attribute(m_macro, "localId"), prefix = ownId + ".";
        const auto prefixed = [&](const char* name) {
            return [&, name](pugi::xml_node node) { setAttribute(node, name, prefix + attribute(node, name)); };
        };
        forEachBelow(m_inner, "connection", prefixed("refLocalId"));
        for (const pugi::xml_node node : m_inner.children())
            if (node.attribute("localId")) prefixed("localId")(node);
        const std::string exitId = attribute(m_exit, "localId");
        forEachBelow(m_sfc, "connection", [&](pugi::xml_node connection) {
            if (attribute(connection, "refLocalId") == ownId) setAttribute(connection, "refLocalId", exitId);
        });
        for (const pugi::xml_node point : m_macro.children())
            if (is(point, "connectionPointIn")) m_entry.append_copy(point);
        retarget(m_sfc, attribute(m_macro, "name"), attribute(m_entry, "name"));
        while (const pugi::xml_node node = m_inner.first_child()) m_sfc.insert_move_before(node, m_macro);
        m_sfc.remove_child(m_macro);
        return true;
    }

private:
    /// It begins with the step that nothing leads to and ends with the one that nothing follows.
    void chooseEnds() {
        std::set<std::string> followed;
        for (const pugi::xml_node node : m_inner.children())
            if (!is(node, "actionBlock"))
                forEachBelow(node, "connection",
                             [&](pugi::xml_node each) { followed.insert(attribute(each, "refLocalId")); });
        pugi::xml_node first, last, begin, end;
        for (const pugi::xml_node node : m_inner.children()) {
            if (!is(node, "step")) continue;
            if (!first) first = node;
            last = node;
            bool isReached = false;
            forEachBelow(node, "connection", [&](pugi::xml_node) { isReached = true; });
            if (!begin && (!isReached || isTrue(node, "initialStep"))) begin = node;
            if (!followed.count(attribute(node, "localId"))) end = node;
        }
        m_entry = begin ? begin : first;
        m_exit = end ? end : last;
    }

    void renameSteps() {
        std::set<std::string> taken;
        for (const pugi::xml_node node : m_sfc.children())
            if (is(node, "step")) taken.insert(foldCase(attribute(node, "name")));
        for (const pugi::xml_node node : m_inner.children()) {
            if (!is(node, "step")) continue;
            const std::string name = attribute(node, "name");
            std::string unique = name;
            for (int number = 1; !taken.insert(foldCase(unique)).second; ++number)
                unique = attribute(m_macro, "name") + "_" + name + (number > 1 ? "_" + std::to_string(number) : "");
            if (unique == name) continue;
            retarget(m_inner, name, unique);
            setAttribute(node, "name", unique);
        }
    }
    static void retarget(pugi::xml_node chart, const std::string& from, const std::string& to) {
        for (const pugi::xml_node node : chart.children())
            if (is(node, "jumpStep") && equalsIgnoringCase(attribute(node, "targetName"), from))
                setAttribute(node, "targetName", to);
    }

    /// The chart around it says where it begins.
    void keepOneInitialStep() {
        bool hasInitial = false;
        for (const pugi::xml_node node : m_sfc.children())
            hasInitial |= is(node, "step") && isTrue(node, "initialStep");
        for (const pugi::xml_node node : m_inner.children())
            if (hasInitial && is(node, "step") && node.attribute("initialStep"))
                setAttribute(node, "initialStep", "false");
    }

    pugi::xml_node m_sfc, m_macro, m_inner, m_entry, m_exit;
};

pugi::xml_node nextMacro(pugi::xml_node sfc, const std::set<pugi::xml_node>& left) {
    for (const pugi::xml_node node : sfc.children())
        if (is(node, "macroStep") && !left.count(node)) return node;
    return {};
}

} // namespace

void expandMacroSteps(pugi::xml_node sfc, const XmlFile& file, const std::string& unit, Report& report) {
    std::set<pugi::xml_node> left; // without a chart
    for (int count = 0; count < kMostMacros; ++count) {
        const pugi::xml_node macro = nextMacro(sfc, left);
        if (!macro) return;
        const std::string name = attribute(macro, "name"),
                          place = file.place() + ":" + std::to_string(file.lineOf(macro)) + " (" + unit + ")";
        expandMacroSteps(descendantOf(macro, "body/SFC"), file, unit,
                         report); // where it ends may be within another one
        if (Expansion(sfc, macro).run())
            report.add(place, remarks::MacroStepExpanded(name));
        else
            left.insert(macro);
    }
}

} // namespace plc::exchange
