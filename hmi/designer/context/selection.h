// Which elements are selected, shared by canvas, outline and property sheet. Owned by the designer; main thread.
#pragma once
#include "hmi/designer/context/arrange.h"

#include <QObject>

namespace plc::hmi {

class Selection final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    const ElementIds& ids() const { return m_ids; }
    bool isEmpty() const { return m_ids.empty(); }
    bool contains(const ElementId& id) const { return std::find(m_ids.begin(), m_ids.end(), id) != m_ids.end(); }
    void set(ElementIds ids) {
        if (ids == m_ids) return;
        m_ids = std::move(ids);
        emit changed();
    }
    void toggle(const ElementId& id) {
        ElementIds ids = m_ids;
        const auto found = std::find(ids.begin(), ids.end(), id);
        if (found == ids.end())
            ids.push_back(id);
        else
            ids.erase(found);
        set(std::move(ids));
    }
    void clear() { set({}); }
    /// Forgets elements that the panel no longer has.
    void prune(const Panel& panel) {
        ElementIds ids;
        for (const ElementId& id : m_ids)
            if (panel.find(id)) ids.push_back(id);
        set(std::move(ids));
    }

signals:
    void changed();

private:
    ElementIds m_ids;
};

} // namespace plc::hmi
