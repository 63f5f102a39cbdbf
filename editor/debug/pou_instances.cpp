#include "editor/debug/pou_instances.h"

#include "runtime/base/text.h"

namespace plc::editor {

namespace {

constexpr int kDeepest = 6;
constexpr int64_t kMostElements = 64; // of an array of blocks

/// Walks instances down to a few levels.
class Search {
public:
    Search(const image::Layout& layout, std::string wanted, std::vector<QString>& found)
        : m_types(*layout.types), m_wanted(std::move(wanted)), m_found(found) {}

    void visit(const std::string& path, types::TypeId type, int depth) {
        const types::Type& t = m_types[type];
        if (t.kind == types::TypeKind::Array && depth < kDeepest) return visitElements(path, t, depth);
        if (t.kind != types::TypeKind::Block && t.kind != types::TypeKind::Struct) return;
        if (isWanted(type)) m_found.push_back(QString::fromStdString(path));
        if (depth >= kDeepest) return;
        for (const types::Field& field : t.fields)
            if (field.section != types::FieldSection::InOut && field.section != types::FieldSection::External)
                visit(path + "." + field.name, field.type, depth + 1);
    }

private:
    void visitElements(const std::string& path, const types::Type& array, int depth) {
        const types::TypeKind element = m_types.kind(array.element);
        if ((element != types::TypeKind::Block && element != types::TypeKind::Struct) || array.dimensions.size() != 1)
            return;
        const auto& [low, high] = std::pair(array.dimensions[0].low, array.dimensions[0].high);
        for (int64_t i = low; i <= high && i < low + kMostElements; ++i)
            visit(path + "[" + std::to_string(i) + "]", array.element, depth + 1);
    }
    /// It, or what it extends.
    [[nodiscard]] bool isWanted(types::TypeId type) const {
        for (types::TypeId each = type; each.isValid(); each = m_types[each].base)
            if (foldCase(m_types[each].name) == m_wanted) return true;
        return false;
    }

    const types::TypeTable& m_types;
    std::string m_wanted;
    std::vector<QString>& m_found;
};

} // namespace

const std::vector<QString>& PouInstances::of(const QString& pou,
                                             const std::shared_ptr<const image::CompiledProgram>& program) const {
    static const std::vector<QString> none;
    if (!program) return none;
    if (m_foundIn != program) { // the walk is long, and asked for with every value
        m_found.clear();
        m_foundIn = program;
    }
    const auto [known, isNew] = m_found.try_emplace(pou);
    if (!isNew) return known->second;
    const image::Layout& layout = program->layout;
    Search search(layout, foldCase(pou.section('.', 0, 0).toStdString()), known->second);
    for (const image::Root& root : layout.roots)
        if (!root.isHidden) search.visit(image::Layout::pathOf(root), root.type, 0);
    return known->second;
}

std::pair<QString, QString> PouInstances::at(const QString& expression,
                                             const std::shared_ptr<const image::CompiledProgram>& program) {
    for (QString path = expression.trimmed(); program && !path.isEmpty();
         path = path.contains('.') ? path.section('.', 0, -2) : QString()) {
        const auto place = program->layout.find(path.toStdString());
        if (!place) continue;
        const types::Type& type = (*program->layout.types)[place->type];
        if (type.kind == types::TypeKind::Block) return {QString::fromStdString(type.name), path};
    }
    return {};
}

QString PouInstances::preferred(const QString& pou,
                                const std::shared_ptr<const image::CompiledProgram>& program) const {
    const QString block = pou.section('.', 0, 0);
    if (const auto it = m_preferred.find(block.toLower()); it != m_preferred.end()) return it->second;
    const std::vector<QString>& all = of(block, program);
    return all.empty() ? QString() : all.front();
}

} // namespace plc::editor
