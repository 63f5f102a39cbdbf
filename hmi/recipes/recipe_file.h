// hmi/recipes.json: named sets of values for lists of variables, with limits and units. Values are ST literals, as they
// would stand behind `:=`. A value; whoever holds it owns it.
#pragma once
#include "hmi/model/json.h"
#include "runtime/base/result.h"

#include <QMap>
#include <QStringList>

#include <optional>
#include <vector>

namespace plc::hmi {

struct RecipeVariable {
    QString variable;    // path
    QString title, unit; // "@key" or the text itself
    QString format;      // as a numeric display has it
    std::optional<double> minimum, maximum;
    bool operator==(const RecipeVariable&) const = default;
};

struct RecipeSet {
    QString name;
    QMap<QString, QString> values; // path → literal
    bool operator==(const RecipeSet&) const = default;
};

struct Recipe {
    QString name, title;
    std::vector<RecipeVariable> variables;
    std::vector<RecipeSet> sets;

    const RecipeSet* find(const QString& set) const;
    RecipeSet* find(const QString& set);
    const RecipeVariable* variable(const QString& path) const;
    /// "white2", if there is a "white".
    QString freeName(const QString& like) const;
    bool operator==(const Recipe&) const = default;
};

class RecipeFile {
public:
    static Result<RecipeFile> parse(const std::string& utf8, const QString& place);
    std::string write() const;

    const std::vector<Recipe>& recipes() const { return m_recipes; }
    std::vector<Recipe>& recipes() { return m_recipes; }
    const Recipe* find(const QString& name) const;
    Recipe* find(const QString& name);

private:
    std::vector<Recipe> m_recipes;
    Json m_rest = Json::object();
};

/// A row per variable, a column per set.
std::string recipeToCsv(const Recipe& recipe);
/// Sets of the table take the place of those of the same name; rows of variables that the recipe does not have are
/// refused.
Result<void> recipeFromCsv(Recipe& recipe, const std::string& bytes, const QString& place);
/// `Main.Temp := 180.0;` for each value of the set.
std::string recipeToText(const Recipe& recipe, const RecipeSet& set);

} // namespace plc::hmi
