#include "hmi/recipes/recipe_file.h"

#include "hmi/model/errors.h"
#include "hmi/texts/csv.h"
#include "runtime/base/read_json.h"

#include <algorithm>

namespace plc::hmi {

namespace {

Error wrong(const QString& place, Message message) { return {std::move(message), place.toStdString()}; }

QString field(const Json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end()) return {};
    return found->is_string() ? toQString(*found) : QString::fromStdString(found->dump());
}

std::optional<double> number(const Json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) return {};
    return found->get<double>();
}

void put(Json& object, const char* key, const QString& value) {
    if (!value.isEmpty()) object[key] = toUtf8(value);
}

Result<std::vector<RecipeVariable>> variablesOf(const Json& rows, const QString& place) {
    std::vector<RecipeVariable> out;
    for (const Json& row : rows) {
        RecipeVariable one;
        if (row.is_object())
            one = {field(row, "variable"), field(row, "title"), field(row, "unit"),
                   field(row, "format"),   number(row, "min"),  number(row, "max")};
        if (one.variable.isEmpty()) return wrong(place, errors::RecipeVariableMissing());
        const bool isTwice = std::any_of(out.begin(), out.end(),
                                         [&](const RecipeVariable& other) { return other.variable == one.variable; });
        if (isTwice) return wrong(place, errors::RecipeVariableTwice(toUtf8(one.variable)));
        out.push_back(std::move(one));
    }
    return out;
}

Result<std::vector<RecipeSet>> setsOf(const Json& rows, const QString& place) {
    std::vector<RecipeSet> out;
    for (const Json& row : rows) {
        RecipeSet one;
        if (row.is_object()) one.name = field(row, "name");
        if (one.name.isEmpty()) return wrong(place, errors::RecipeSetWithoutName());
        if (std::any_of(out.begin(), out.end(), [&](const RecipeSet& other) { return other.name == one.name; }))
            return wrong(place, errors::RecipeSetTwice(toUtf8(one.name)));
        if (const auto values = row.find("values"); values != row.end() && values->is_object())
            for (const auto& [path, value] : values->items())
                one.values.insert(QString::fromStdString(path),
                                  value.is_string() ? toQString(value) : QString::fromStdString(value.dump()));
        out.push_back(std::move(one));
    }
    return out;
}

} // namespace

const RecipeSet* Recipe::find(const QString& set) const {
    const auto found = std::find_if(sets.begin(), sets.end(), [&](const RecipeSet& one) { return one.name == set; });
    return found == sets.end() ? nullptr : &*found;
}

RecipeSet* Recipe::find(const QString& set) { return const_cast<RecipeSet*>(std::as_const(*this).find(set)); }

const RecipeVariable* Recipe::variable(const QString& path) const {
    const auto found = std::find_if(variables.begin(), variables.end(), [&](const RecipeVariable& one) {
        return one.variable.compare(path, Qt::CaseInsensitive) == 0;
    });
    return found == variables.end() ? nullptr : &*found;
}

QString Recipe::freeName(const QString& like) const {
    for (int n = 2;; ++n)
        if (const QString name = like + QString::number(n); !find(name)) return name;
}

Result<RecipeFile> RecipeFile::parse(const std::string& utf8, const QString& place) {
    const JsonText<Json> json = readJson<Json>(utf8);
    if (!json.isGood()) return wrong(place + u':' + QString::number(json.line), errors::RecipesNotJson());
    const Json& root = json.value;
    if (!root.is_object()) return wrong(place, errors::RecipesNotJson());
    RecipeFile out;
    for (const auto& [key, value] : root.items())
        if (key != "version" && key != "recipes") out.m_rest[key] = value;
    const Json rows = root.value("recipes", Json::array());
    if (!rows.is_array()) return wrong(place, errors::MustBeList(Verbatim("recipes")));
    for (const Json& row : rows) {
        Recipe recipe;
        if (row.is_object()) recipe.name = field(row, "name");
        if (recipe.name.isEmpty()) return wrong(place, errors::RecipeWithoutName());
        if (out.find(recipe.name)) return wrong(place, errors::RecipeTwice(toUtf8(recipe.name)));
        recipe.title = field(row, "title");
        auto variables = variablesOf(row.value("variables", Json::array()), place);
        if (!variables) return variables.error();
        auto sets = setsOf(row.value("sets", Json::array()), place);
        if (!sets) return sets.error();
        recipe.variables = std::move(*variables);
        recipe.sets = std::move(*sets);
        out.m_recipes.push_back(std::move(recipe));
    }
    return out;
}

std::string RecipeFile::write() const {
    std::vector<Json> rows;
    for (const Recipe& recipe : m_recipes) {
        Json row = Json::object();
        put(row, "name", recipe.name);
        put(row, "title", recipe.title);
        row["variables"] = Json::array();
        for (const RecipeVariable& one : recipe.variables) {
            Json variable = Json::object();
            put(variable, "variable", one.variable);
            put(variable, "title", one.title);
            put(variable, "unit", one.unit);
            put(variable, "format", one.format);
            if (one.minimum) variable["min"] = canonicalNumbers(Json(*one.minimum));
            if (one.maximum) variable["max"] = canonicalNumbers(Json(*one.maximum));
            row["variables"].push_back(std::move(variable));
        }
        row["sets"] = Json::array();
        for (const RecipeSet& set : recipe.sets) {
            Json values = Json::object();
            // In the order of the variables, then what none of them is.
            for (const RecipeVariable& one : recipe.variables)
                if (set.values.contains(one.variable)) values[toUtf8(one.variable)] = toUtf8(set.values[one.variable]);
            for (auto it = set.values.begin(); it != set.values.end(); ++it)
                if (!values.contains(toUtf8(it.key()))) values[toUtf8(it.key())] = toUtf8(it.value());
            row["sets"].push_back(Json{{"name", toUtf8(set.name)}, {"values", std::move(values)}});
        }
        rows.push_back(std::move(row));
    }
    std::string out = "{\n  \"version\": 1,\n  \"recipes\": " + writeList(rows, 2);
    for (const auto& [key, value] : m_rest.items()) out += ",\n  " + Json(key).dump() + ": " + writeCompact(value);
    return out + "\n}\n";
}

const Recipe* RecipeFile::find(const QString& name) const {
    const auto found =
        std::find_if(m_recipes.begin(), m_recipes.end(), [&](const Recipe& one) { return one.name == name; });
    return found == m_recipes.end() ? nullptr : &*found;
}

Recipe* RecipeFile::find(const QString& name) { return const_cast<Recipe*>(std::as_const(*this).find(name)); }

std::string recipeToCsv(const Recipe& recipe) {
    const auto limit = [](const std::optional<double>& value) {
        return value ? QString::number(*value, 'g', 12) : QString();
    };
    std::vector<QStringList> rows{{"variable", "unit", "min", "max"}};
    for (const RecipeSet& set : recipe.sets) rows.front() += set.name;
    for (const RecipeVariable& one : recipe.variables) {
        QStringList row{one.variable, one.unit, limit(one.minimum), limit(one.maximum)};
        for (const RecipeSet& set : recipe.sets) row += set.values.value(one.variable);
        rows.push_back(std::move(row));
    }
    return writeCsv(rows);
}

Result<void> recipeFromCsv(Recipe& recipe, const std::string& bytes, const QString& place) {
    const auto table = parseCsv(bytes, place);
    if (!table) return table.error();
    const auto at = [&](size_t row) { return place + u':' + QString::number(table->lines[row]); };
    if (table->rows.empty() || table->rows.front().value(0) != QStringLiteral("variable"))
        return wrong(place, errors::RecipeCsvHeader());
    const QStringList& header = table->rows.front();
    const QStringList known{"unit", "min", "max"};
    std::vector<std::pair<qsizetype, RecipeSet>> sets;
    for (qsizetype column = 1; column < header.size(); ++column)
        if (!known.contains(header[column]) && !header[column].isEmpty())
            sets.emplace_back(column, RecipeSet{header[column], {}});
    for (size_t row = 1; row < table->rows.size(); ++row) {
        const QString path = table->rows[row].value(0);
        const RecipeVariable* variable = recipe.variable(path);
        if (!variable) return wrong(at(row), errors::RecipeHasNoVariable(toUtf8(recipe.name), toUtf8(path)));
        for (auto& [column, set] : sets)
            if (const QString value = table->rows[row].value(column); !value.isEmpty())
                set.values.insert(variable->variable, value);
    }
    for (auto& [column, set] : sets)
        if (RecipeSet* present = recipe.find(set.name))
            present->values = std::move(set.values);
        else
            recipe.sets.push_back(std::move(set));
    return {};
}

std::string recipeToText(const Recipe& recipe, const RecipeSet& set) {
    std::string out = "// " + toUtf8(recipe.name) + ": " + toUtf8(set.name) + "\n";
    for (const RecipeVariable& one : recipe.variables)
        if (const QString value = set.values.value(one.variable); !value.isEmpty())
            out += toUtf8(one.variable) + " := " + toUtf8(value) + ";" +
                   (one.unit.isEmpty() ? "" : " // " + toUtf8(one.unit)) + "\n";
    return out;
}

} // namespace plc::hmi
