// What the elements of panels show while a recorded run is looked through: which of them change. Made by a test for one
// session, after its run, on the test's thread.
#pragma once

#include "hmi/model/faceplate.h"
#include "hmi/model/walk.h"
#include "hmi/station/panel_project.h"
#include "hmi/station/plc_values.h"
#include "projects/session/session.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace plc {

/// The values of an element's expressions, changed or not, whatever they move, fill, light or hide.
class ShownElements {
public:
    ShownElements(const hmi::PanelProject& panels, session::Session& session) : m_session(session), m_values(session) {
        m_lookup = [&panels](const QString& name) -> const hmi::Panel* {
            const hmi::NamedPanel* found = panels.find(name);
            return found ? &found->panel : nullptr;
        };
    }

    void add(const hmi::NamedPanel& panel) {
        if (!hmi::parametersOf(panel.panel).empty()) return; // a faceplate is looked at where it is placed
        for (const hmi::Element& element : panel.panel.elements()) {
            if (element.kind() != hmi::ElementKind::Faceplate)
                add(panel.name, element);
            else
                for (const hmi::Element& inner : hmi::contentsOf(element, m_lookup)) add(panel.name, inner);
        }
    }

    /// Looks at the recording four times a second, of a long one at 4,000 moments. The name of an element that shows
    /// nothing, or nothing.
    std::string watch(std::chrono::nanoseconds length) {
        const auto step = std::max<std::chrono::nanoseconds>(std::chrono::milliseconds(250), length / 4'000);
        for (std::chrono::nanoseconds at{0}; at < length; at += step) {
            m_values.setPosition(m_session.history().positionAt(at));
            m_values.refresh();
            for (const auto& [name, bindings] : m_elements)
                for (const hmi::BindingId binding : bindings) {
                    const hmi::Value& value = m_values.value(binding);
                    if (value.isNone()) return name + ": " + value.text().toStdString();
                    Seen& seen = m_seen.try_emplace(binding.index, Seen{value, false}).first->second;
                    seen.moved = seen.moved || !(value == seen.first);
                }
        }
        return {};
    }

    /// How many expressions had more than one value.
    size_t movedValues() const {
        size_t moved = 0;
        for (const auto& [expression, seen] : m_seen) moved += seen.moved;
        return moved;
    }

    size_t count() const { return m_elements.size(); }

    std::set<std::string> moved() const { return named(true); }
    std::set<std::string> still() const { return named(false); }

private:
    struct Seen {
        hmi::Value first;
        bool moved = false; // it was something else later
    };

    void add(const QString& panel, const hmi::Element& element) {
        hmi::forEachBinding(element, [&](const hmi::Found& found) {
            if (found.type != hmi::PropertyType::Target)
                m_elements[(panel + "/" + element.caption()).toStdString()].push_back(m_values.bind(found.text));
        });
    }

    std::set<std::string> named(bool hasMoved) const {
        std::set<std::string> out;
        for (const auto& [name, bindings] : m_elements)
            if (std::ranges::any_of(bindings, [this](hmi::BindingId binding) {
                    const auto seen = m_seen.find(binding.index);
                    return seen != m_seen.end() && seen->second.moved;
                }) == hasMoved)
                out.insert(name);
        return out;
    }

    session::Session& m_session;
    hmi::PlcValues m_values;
    hmi::PanelLookup m_lookup;
    std::map<std::string, std::vector<hmi::BindingId>> m_elements; // what each has
    std::unordered_map<size_t, Seen> m_seen;                       // by binding
};

} // namespace plc
