#include "projects/debug_adapter/variables.h"

namespace plc::dap {

namespace {

constexpr size_t kLongestText = 2000; // of a whole array in one line
constexpr size_t kMostParts = 10'000;

/// "[2,3]": the index of the n-th element.
std::string indexText(const types::Type& array, size_t n) {
    std::string text;
    for (auto dimension = array.dimensions.rbegin(); dimension != array.dimensions.rend(); ++dimension) {
        const auto count = static_cast<size_t>(dimension->count());
        if (count == 0) return {};
        text = std::to_string(dimension->low + static_cast<int64_t>(n % count)) + (text.empty() ? "" : ",") + text;
        n /= count;
    }
    return "[" + text + "]";
}

bool isShown(const types::Field& field) {
    return !field.isPrivate && field.section != types::FieldSection::External &&
           field.section != types::FieldSection::InOut; // what it refers to is a variable elsewhere
}

} // namespace

std::vector<Variables::Line> partsOf(const types::TypeTable& types, const Variables::Line& line) {
    std::vector<Variables::Line> out;
    const auto* parts = std::get_if<std::vector<types::Value>>(&line.value.data);
    if (!parts) return out;
    const types::Type& type = types[line.value.type];
    const auto under = [&](const std::string& part) { return line.path.empty() ? std::string() : line.path + part; };
    for (size_t i = 0; i < parts->size() && i < kMostParts; ++i) {
        if (type.kind == types::TypeKind::Array) {
            const std::string index = indexText(type, i);
            out.push_back({index, (*parts)[i], under(index), false});
        } else if (i < type.fields.size() && isShown(type.fields[i])) {
            out.push_back({type.fields[i].name, (*parts)[i], under("." + type.fields[i].name), false});
        }
    }
    return out;
}

int64_t Variables::add(Lines lines) {
    m_parts.push_back(std::move(lines));
    return static_cast<int64_t>(m_parts.size());
}

std::optional<std::vector<Variables::Line>> Variables::lines(int64_t number) const {
    if (number < 1 || static_cast<size_t>(number) > m_parts.size()) return std::nullopt;
    const Lines make = m_parts[static_cast<size_t>(number) - 1]; // making may add others
    return make();
}

Json Variables::valueJson(const types::TypeTable& types, const Line& line, const char* key) {
    Json out;
    std::string text = line.value.hasValue() ? types::toText(types, line.value) : "–";
    if (text.size() > kLongestText) text = text.substr(0, kLongestText) + " …";
    out[key] = std::move(text);
    if (line.value.type.isValid()) out["type"] = types[line.value.type].name;
    const bool hasParts = !partsOf(types, line).empty();
    out["variablesReference"] = hasParts ? add([&types, line] { return partsOf(types, line); }) : 0;
    return out;
}

Json Variables::toJson(const types::TypeTable& types, const Line& line) {
    Json out{{"name", line.name}};
    out.update(valueJson(types, line, "value"));
    if (!line.path.empty()) out["evaluateName"] = line.path;
    return out;
}

} // namespace plc::dap
