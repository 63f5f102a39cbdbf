#include "app/pages/computed_places.h"

#include "editor/debug/line_map.h"

#include <algorithm>

namespace plc::app {

namespace {

/// Places of one text in another: exact for what lies in lines that both have.
class PlaceMap {
public:
    PlaceMap(std::string_view from, std::string_view to) : m_isSame(from == to) {
        if (m_isSame) return;
        m_lines.emplace(from, to);
        m_from = lineBegins(from);
        m_to = lineBegins(to);
    }
    [[nodiscard]] std::optional<SourceRange> map(SourceRange range) const {
        if (m_isSame) return range;
        const auto begin = map(range.begin), end = map(range.end);
        if (!begin || !end || *end < *begin || *end - *begin != range.length()) return std::nullopt;
        return SourceRange{range.file, *begin, *end};
    }

private:
    static std::vector<uint32_t> lineBegins(std::string_view text) {
        std::vector<uint32_t> out{0};
        for (size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') out.push_back(static_cast<uint32_t>(i) + 1);
        return out;
    }
    [[nodiscard]] std::optional<uint32_t> map(uint32_t offset) const {
        const auto behind = std::upper_bound(m_from.begin(), m_from.end(), offset);
        const auto line = static_cast<int>(behind - m_from.begin());
        const std::optional<int> to = m_lines->exact(line);
        if (!to || *to < 1 || static_cast<size_t>(*to) > m_to.size()) return std::nullopt;
        return m_to[static_cast<size_t>(*to) - 1] + (offset - *std::prev(behind));
    }

    bool m_isSame;
    std::optional<editor::LineMap> m_lines;
    std::vector<uint32_t> m_from, m_to;
};

class ComputedPlaces final : public editor::ComputedValues {
public:
    ComputedPlaces(editor::ComputedScan::Values values, std::shared_ptr<const PlaceMap> map)
        : m_values(std::move(values)), m_map(std::move(map)) {}

    [[nodiscard]] bool covers(SourceRange range) const override {
        return range.length() > 0 && m_map->map(range).has_value();
    }
    [[nodiscard]] std::optional<editor::GraphValue> at(SourceRange range) const override {
        const auto there = m_map->map(range);
        const auto* found = there ? m_values->at(*there) : nullptr;
        if (!found || !found->value.type.isValid()) return std::nullopt;
        const types::TypeTable& types = *m_values->look().program().layout.types;
        const types::TypeKind kind = types.storageKind(found->value.type);
        editor::GraphValue value;
        value.text = QString::fromStdString(types::toText(types, found->value));
        value.isTrue = kind == types::TypeKind::Bool && found->value.isTrue();
        if (kind == types::TypeKind::Time) value.nanoseconds = found->value.integer();
        return value;
    }
    [[nodiscard]] bool isExecuted(SourceRange statement) const override {
        const auto there = m_map->map(statement);
        return there && m_values->isExecuted(*there);
    }

private:
    editor::ComputedScan::Values m_values;
    std::shared_ptr<const PlaceMap> m_map;
};

} // namespace

editor::ComputedSource computedPlaces(editor::ComputedScan& scan, const QString& file,
                                      std::function<std::string()> text, std::function<QString()> instance) {
    struct Kept { // the map is made again only for another text
        std::string from;
        editor::ComputedScan::Values of; // holds the program, so that no other one comes to its address
        std::shared_ptr<const PlaceMap> map;
    };
    auto kept = std::make_shared<Kept>();
    return [&scan, file, kept, text = std::move(text),
            instance = std::move(instance)]() -> std::shared_ptr<const editor::ComputedValues> {
        const editor::ComputedScan::Values values = scan.of(file, instance());
        if (!values) return nullptr;
        const image::CompiledProgram& program = values->look().program();
        std::string now = text();
        if (!kept->map || &kept->of->look().program() != &program || kept->from != now) {
            kept->map = std::make_shared<PlaceMap>(now, program.sources[values->file()].text());
            kept->of = values;
            kept->from = std::move(now);
        }
        return std::make_shared<ComputedPlaces>(values, kept->map);
    };
}

} // namespace plc::app
