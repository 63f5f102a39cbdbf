#include "hmi/station/recipe_transfer.h"

#include "hmi/model/errors.h"
#include "hmi/station/plc_convert.h"
#include "projects/session/value_text.h"

#include <limits>

namespace plc::hmi {

namespace {

std::string limitText(const std::optional<double>& limit) {
    return limit ? QString::number(*limit, 'g', 12).toStdString() : "-";
}

} // namespace

Result<types::Value> recipeValue(const driver::Checked& checked, const RecipeVariable& variable, const QString& text) {
    const std::string path = variable.variable.toStdString();
    const auto target = driver::compileExpression(checked, path);
    if (!target) return target.error();
    if (!target->place()) return Error{errors::TargetNotVariable(path), path};
    auto value = session::parseValue(checked, target->type(), text.toStdString(), path);
    if (!value) return value;
    if (!variable.minimum && !variable.maximum) return value;
    const double number = toPanel(target->types(), *value).toNumber();
    if (number < variable.minimum.value_or(-std::numeric_limits<double>::infinity()) ||
        number > variable.maximum.value_or(std::numeric_limits<double>::infinity()))
        return Error{errors::RecipeValueOutside(text.toStdString(), path, limitText(variable.minimum),
                                                limitText(variable.maximum)),
                     path};
    return value;
}

Result<std::vector<session::Assignment>> assignmentsOf(const driver::Checked& checked, const Recipe& recipe,
                                                       const RecipeSet& set) {
    std::vector<session::Assignment> out;
    for (const RecipeVariable& one : recipe.variables) {
        const QString text = set.values.value(one.variable);
        if (text.isEmpty()) return Error{errors::RecipeValueMissing(toUtf8(set.name), toUtf8(one.variable)), {}};
        auto value = recipeValue(checked, one, text);
        if (!value) return value.error();
        out.push_back({one.variable.toStdString(), std::move(*value)});
    }
    return out;
}

Result<void> writeRecipe(session::Run& run, const Recipe& recipe, const RecipeSet& set, const std::string& origin) {
    auto assignments = assignmentsOf(driver::checkedOf(run.program()), recipe, set);
    if (!assignments) return assignments.error();
    run.writeTogether(std::move(*assignments), origin);
    return {};
}

Result<QMap<QString, QString>> readRecipe(const session::Run& run, const Recipe& recipe) {
    const std::vector<std::byte> image = run.snapshot();
    QMap<QString, QString> out;
    for (const RecipeVariable& one : recipe.variables) {
        const auto expression = run.expression(one.variable.toStdString());
        if (!expression) return expression.error();
        const expression::Outcome outcome = expression->evaluate(image);
        if (!outcome.hasValue()) return Error{outcome.reason, one.variable.toStdString()};
        out.insert(one.variable, toPanel(expression->types(), outcome.value).toLiteral());
    }
    return out;
}

std::vector<RecipeFinding> checkRecipes(const RecipeFile& file, const driver::Checked& checked) {
    std::vector<RecipeFinding> out;
    for (const Recipe& recipe : file.recipes()) {
        for (const RecipeVariable& one : recipe.variables) {
            const auto target = driver::compileExpression(checked, one.variable.toStdString());
            if (!target || !target->place()) {
                out.push_back({recipe.name,
                               {},
                               one.variable,
                               target ? errors::TargetNotVariable(toUtf8(one.variable)) : target.error().message});
                continue;
            }
            for (const RecipeSet& set : recipe.sets) {
                const QString text = set.values.value(one.variable);
                if (text.isEmpty()) {
                    out.push_back({recipe.name, set.name, one.variable,
                                   errors::RecipeValueMissing(toUtf8(set.name), toUtf8(one.variable))});
                } else if (const auto value = recipeValue(checked, one, text); !value) {
                    out.push_back({recipe.name, set.name, one.variable, value.error().message});
                }
            }
        }
        for (const RecipeSet& set : recipe.sets)
            for (auto it = set.values.begin(); it != set.values.end(); ++it)
                if (!recipe.variable(it.key()))
                    out.push_back({recipe.name, set.name, it.key(),
                                   errors::RecipeHasNoVariable(toUtf8(recipe.name), toUtf8(it.key()))});
    }
    return out;
}

std::vector<Finding> recipeFindings(const RecipeFile& file, const driver::Checked& checked, const QString& place) {
    std::vector<Finding> out;
    if (!checked.analysis) return out;
    for (RecipeFinding& one : checkRecipes(file, checked))
        out.push_back({FindingKind::WrongRecipe,
                       true,
                       place,
                       0,
                       one.set.isEmpty() ? one.recipe : one.recipe + u'/' + one.set,
                       one.variable,
                       {},
                       std::move(one.message)});
    return out;
}

} // namespace plc::hmi
