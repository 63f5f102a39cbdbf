// stepwise recipe: named sets of values, checked, listed, exchanged as CSV, filled from a run.
#include "app/cli/panels/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/run/timed_write.h"
#include "hmi/model/errors.h"
#include "hmi/station/panel_project.h"
#include "hmi/station/recipe_transfer.h"
#include "projects/storage/project_file.h"

#include <iostream>

namespace plc::cli {

namespace {

int list(const hmi::RecipeFile& file) {
    for (const hmi::Recipe& recipe : file.recipes()) {
        std::cout << recipe.name.toStdString() << ": " << recipe.variables.size() << " variables";
        for (const hmi::RecipeSet& set : recipe.sets)
            std::cout << (&set == &recipe.sets.front() ? "; " : ", ") << set.name.toStdString();
        std::cout << "\n";
    }
    return kGood;
}

int check(const projects::Project& project, const hmi::RecipeFile& file) {
    const auto found = hmi::checkRecipes(file, driver::check(project.buildInput()));
    for (const hmi::RecipeFinding& one : found) {
        std::cout << "hmi/recipes.json: " << one.recipe.toStdString();
        if (!one.set.isEmpty()) std::cout << "/" << one.set.toStdString();
        std::cout << ": " << one.variable.toStdString() << ": " << one.message.english() << "\n";
    }
    if (found.empty()) std::cout << project.name << ": the recipes are good\n";
    return found.empty() ? kGood : kProgramWrong;
}

/// The recipe of --recipe, or the only one.
Result<hmi::Recipe*> chosen(const Arguments& arguments, hmi::RecipeFile& file) {
    std::vector<std::string> names;
    for (const hmi::Recipe& one : file.recipes()) names.push_back(one.name.toStdString());
    const auto name = arguments.value("--recipe");
    if (!name && names.size() == 1) return &file.recipes().front();
    hmi::Recipe* found = name ? file.find(QString::fromStdString(*name)) : nullptr;
    if (!found) return Error{errors::RecipeNeedsName(names), name.value_or("")};
    return found;
}

/// Runs the project and takes what the recipe's variables hold then.
int read(const Arguments& arguments, const projects::Project& project, const hmi::PanelProject& panels,
         hmi::RecipeFile& file, hmi::Recipe& recipe, const std::string& name) {
    driver::Built built = driver::build(project.buildInput());
    if (printDiagnostics(built.checked, false, false)) return kProgramWrong;
    if (!built.program)
        return wrongUse({built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project.name});
    catchInterrupt();
    session::Session session(std::move(built));
    if (auto ran = runProject(arguments, session.built(), session, std::chrono::nanoseconds(0), "--at"); !ran)
        return wrongUse(ran.error());
    auto values = hmi::readRecipe(session, recipe);
    if (!values) return wrongUse(values.error());
    const QString set = QString::fromStdString(name);
    if (hmi::RecipeSet* present = recipe.find(set))
        present->values = std::move(*values);
    else
        recipe.sets.push_back({set, std::move(*values)});
    if (auto saved = hmi::saveRecipes(panels, file); !saved) return wrongUse(saved.error());
    std::cout << hmi::recipeToText(recipe, *recipe.find(set));
    return kGood;
}

int runRecipe(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::RecipeNeedsProject(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const hmi::PanelProject panels = hmi::loadPanelProject(*project);
    for (const Error& problem : panels.problems)
        if (problem.place.starts_with("hmi/recipes.json")) return wrongUse(problem);
    hmi::RecipeFile file = panels.recipes;
    if (arguments.has("--list")) return list(file);
    const auto exported = arguments.value("--export"), imported = arguments.value("--import"),
               text = arguments.value("--text"), set = arguments.value("--read");
    if (!exported && !imported && !text && !set) return check(*project, file);
    const auto recipe = chosen(arguments, file);
    if (!recipe) return wrongUse(recipe.error());
    if (exported) {
        const auto written = projects::writeFileAtomically(*exported, hmi::recipeToCsv(**recipe));
        return written ? kGood : wrongUse(written.error());
    }
    if (text) {
        const hmi::RecipeSet* one = (*recipe)->find(QString::fromStdString(*text));
        if (!one) return wrongUse({errors::NoSuchRecipeSet((*recipe)->name.toStdString(), *text), project->name});
        std::cout << hmi::recipeToText(**recipe, *one);
        return kGood;
    }
    if (set) return read(arguments, *project, panels, file, **recipe, *set);
    const auto bytes = projects::readFile(*imported);
    if (!bytes) return wrongUse(bytes.error());
    if (auto taken = hmi::recipeFromCsv(**recipe, *bytes, QString::fromStdString(*imported)); !taken)
        return wrongUse(taken.error());
    if (const int wrong = check(*project, file); wrong != kGood) return wrong; // nothing is written then
    const auto saved = hmi::saveRecipes(panels, file);
    return saved ? kGood : wrongUse(saved.error());
}

} // namespace

Command recipeCommand() {
    return {{"recipe",
             "PROJECT [OPTIONS]",
             "Checks, lists, imports and exports the recipes of a project, or takes a set from a run.",
             {{"--list", "", "the recipes and their sets"},
              {"--recipe", "NAME", "the recipe, if there are several"},
              {"--export", "FILE", "writes the recipe as CSV: a row per variable, a column per set"},
              {"--import", "FILE", "takes sets from such a CSV file, all or none"},
              {"--text", "SET", "prints the set as assignments in ST"},
              {"--read", "SET", "runs the project and saves the values at the time --at as this set"},
              {"--at", "10s", "the time in the run"},
              {"--set", "PATH=VALUE[@TIME]", "write before the first scan at or after TIME (repeatable)"},
              {"--force", "PATH=VALUE[@TIME]", "force likewise (repeatable)"}},
             "stepwise recipe projects/examples/bottling --text large"},
            runRecipe};
}

} // namespace plc::cli
