#include "runtime/controller/retained_places.h"

#include <unordered_map>

namespace plc::controller {

using types::Field;
using types::Type;
using types::TypeId;
using types::TypeKind;

namespace {

class RetainedPlaces {
public:
    RetainedPlaces(const image::Layout& layout, bool persistentOnly,
                   const std::function<void(const std::string&, const image::Place&)>& visit)
        : m_layout(layout), m_types(*layout.types), m_persistentOnly(persistentOnly), m_visit(visit) {}

    void run() {
        for (const image::Root& root : m_layout.roots) {
            if (root.constant) continue;
            const image::Place place{root.type, root.offset, root.bit};
            std::string path = image::Layout::pathOf(root);
            if (isWanted(root.retain, root.persistent))
                m_visit(path, place);
            else
                inside(path, root.type, root.offset);
        }
    }

private:
    [[nodiscard]] bool isWanted(bool retain, bool persistent) const {
        return persistent || (retain && !m_persistentOnly);
    }

    /// Whether something within a variable of the type is retained by its own declaration.
    bool hasRetained(TypeId id) {
        if (const auto known = m_known.find(id.value); known != m_known.end()) return known->second;
        m_known[id.value] = false;
        const Type& type = m_types[id];
        bool has = false;
        if (type.kind == TypeKind::Array) has = hasRetained(type.element);
        if (type.kind == TypeKind::Struct || type.kind == TypeKind::Block)
            for (const Field& field : type.fields)
                has = has || isWanted(field.retain, field.persistent) || (isVariable(field) && hasRetained(field.type));
        return m_known[id.value] = has;
    }
    [[nodiscard]] static bool isVariable(const Field& field) {
        return field.section != types::FieldSection::InOut && field.section != types::FieldSection::External &&
               !field.constant;
    }

    void inside(std::string& path, TypeId id, uint32_t offset) {
        if (!hasRetained(id)) return;
        const Type& type = m_types[id];
        const size_t length = path.size();
        if (type.kind == TypeKind::Array) {
            const uint32_t size = m_types[type.element].size;
            for (uint32_t at = 0; size && at + size <= type.size; at += size) {
                path = m_layout.pathAt(offset + at, type.element);
                inside(path, type.element, offset + at);
            }
            path.resize(length);
            return;
        }
        for (const Field& field : type.fields) {
            if (!isVariable(field)) continue;
            path += "." + field.name;
            const image::Place place{field.bit >= 0 ? types::TypeTable::of(TypeKind::Bool) : field.type,
                                     offset + field.offset, field.bit};
            if (isWanted(field.retain, field.persistent))
                m_visit(path, place);
            else
                inside(path, field.type, place.offset);
            path.resize(length);
        }
    }

    const image::Layout& m_layout;
    const types::TypeTable& m_types;
    bool m_persistentOnly;
    const std::function<void(const std::string&, const image::Place&)>& m_visit;
    std::unordered_map<uint32_t, bool> m_known;
};

} // namespace

void forEachRetained(const image::Layout& layout, bool persistentOnly,
                     const std::function<void(const std::string&, const image::Place&)>& visit) {
    RetainedPlaces(layout, persistentOnly, visit).run();
}

} // namespace plc::controller
