// Recipes and a controller: what a set writes, checked as a whole and written in one scan or not at all; what one scan
// holds, as a set. Functions; main thread.
#pragma once
#include "hmi/check/panel_check.h"
#include "hmi/recipes/recipe_file.h"
#include "projects/session/run.h"
#include "runtime/compiler/driver/driver.h"

namespace plc::hmi {

/// The value as the variable takes it; an error where it is none, or outside the limits of the recipe.
Result<types::Value> recipeValue(const driver::Checked& checked, const RecipeVariable& variable, const QString& text);
/// Every variable of the recipe, in its order; the first thing that is wrong otherwise.
Result<std::vector<session::Assignment>> assignmentsOf(const driver::Checked& checked, const Recipe& recipe,
                                                       const RecipeSet& set);
/// Posts all of them for the start of one scan. What the scan refuses is among the run's refusals, nothing of the
/// set is written then.
Result<void> writeRecipe(session::Run& run, const Recipe& recipe, const RecipeSet& set, const std::string& origin);
/// The values of the newest scan.
Result<QMap<QString, QString>> readRecipe(const session::Run& run, const Recipe& recipe);

struct RecipeFinding {
    QString recipe, set, variable;
    Message message;
};
/// Unknown variables, values that do not fit, sets with gaps.
std::vector<RecipeFinding> checkRecipes(const RecipeFile& file, const driver::Checked& checked);
/// The same as the findings of panels have it; `place`: of the file, for them.
std::vector<Finding> recipeFindings(const RecipeFile& file, const driver::Checked& checked, const QString& place);

} // namespace plc::hmi
