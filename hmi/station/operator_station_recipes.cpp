// What an operator does with recipes. A change is in the file before it is seen.
#include "hmi/station/operator_station.h"

#include "editor/kit/message_text.h"
#include "hmi/station/recipe_transfer.h"

namespace plc::hmi {

bool OperatorStation::keepRecipes(RecipeFile changed) {
    if (const auto saved = saveRecipes(m_project, changed); !saved) {
        refuse(kit::messageText(saved.error(), m_language));
        return false;
    }
    m_recipes = std::move(changed);
    emit recipesChanged();
    emit recipesSaved();
    return true;
}

std::optional<ChoiceRequest> OperatorStation::setsOf(const RecipeRequest& request) const {
    const Recipe* recipe = m_recipes.find(request.recipe);
    if (!recipe || recipe->sets.empty()) return std::nullopt;
    ChoiceRequest choice;
    for (const RecipeSet& set : recipe->sets) {
        if (set.name == request.set) choice.present = static_cast<int>(choice.texts.size());
        choice.texts += set.name;
        choice.values.push_back(Value::ofText(set.name));
    }
    return choice;
}

std::optional<EntryRequest> OperatorStation::entryFor(const RecipeRequest& request) {
    const Recipe* recipe = m_recipes.find(request.recipe);
    const RecipeVariable* variable = recipe ? recipe->variable(request.variable) : nullptr;
    const RecipeSet* set = recipe ? recipe->find(request.set) : nullptr;
    if (!variable || !set || !m_run) return std::nullopt;
    const auto target = m_run->expression(request.variable.toStdString());
    if (!target) {
        refuse(kit::messageText(target.error().message, m_language));
        return std::nullopt;
    }
    const ValueFacts facts = factsOf(target->types(), target->type(), true);
    const bool isNumber =
        facts.kind == ValueKind::Integer || facts.kind == ValueKind::Unsigned || facts.kind == ValueKind::Real;
    EntryRequest entry;
    entry.kind = isNumber && facts.enumValues.empty() ? EntryKind::Number : EntryKind::Text;
    entry.title = variable->title.isEmpty() ? variable->variable : m_project.texts.text(variable->title, m_language);
    entry.unit = variable->unit;
    entry.minimum = variable->minimum ? variable->minimum : facts.minimum;
    entry.maximum = variable->maximum ? variable->maximum : facts.maximum;
    entry.valueKind = facts.kind;
    const QString present = set->values.value(variable->variable);
    entry.present = entry.kind == EntryKind::Number ? Value::ofReal(present.toDouble()) : Value::ofText(present);
    return entry;
}

void OperatorStation::enterValue(const RecipeRequest& request, const EntryRequest& asked, const Value& value) {
    RecipeFile changed = m_recipes;
    Recipe* recipe = changed.find(request.recipe);
    RecipeSet* set = recipe ? recipe->find(request.set) : nullptr;
    const RecipeVariable* row = recipe ? recipe->variable(request.variable) : nullptr;
    if (!set || !row || !m_run) return;
    const QString text = asked.kind == EntryKind::Text ? value.text() : value.toLiteral();
    if (const auto good = recipeValue(driver::checkedOf(m_run->program()), *row, text); !good)
        return refuse(kit::messageText(good.error().message, m_language));
    const QString before = set->values.value(row->variable);
    set->values.insert(row->variable, text);
    if (keepRecipes(std::move(changed)))
        record(QStringLiteral("recipe edit"),
               request.recipe + u'/' + request.set + QStringLiteral(": ") + request.variable, before, text,
               m_panelName);
}

void OperatorStation::writeSet(const RecipeRequest& request) {
    const Recipe* recipe = m_recipes.find(request.recipe);
    const RecipeSet* set = recipe ? recipe->find(request.set) : nullptr;
    if (!set) return;
    if (!m_run || !m_values) return refuse(say(SystemText::NoController));
    if (m_values->isPast()) return refuse(say(SystemText::InThePast));
    const controller::State state = m_run->status().state;
    if (state == controller::State::Stopped || state == controller::State::Fault)
        return refuse(say(SystemText::NotRunning));
    const QString name = request.recipe + u'/' + request.set;
    const auto done = writeRecipe(*m_run, *recipe, *set, ("recipe " + name).toStdString());
    if (!done) return refuse(kit::messageText(done.error(), m_language));
    record(QStringLiteral("recipe write"), name, {}, {}, m_panelName + QStringLiteral(", ") + request.element);
}

void OperatorStation::readSet(const RecipeRequest& request) {
    if (!m_run) return refuse(say(SystemText::NoController));
    RecipeFile changed = m_recipes;
    Recipe* recipe = changed.find(request.recipe);
    RecipeSet* set = recipe ? recipe->find(request.set) : nullptr;
    if (!set) return;
    auto values = readRecipe(*m_run, *recipe);
    if (!values) return refuse(kit::messageText(values.error(), m_language));
    set->values = std::move(*values);
    if (keepRecipes(std::move(changed)))
        record(QStringLiteral("recipe read"), request.recipe + u'/' + request.set, {}, {}, m_panelName);
}

/// A new set is a copy of the one that is shown; the last one stays.
QString OperatorStation::changeSets(const RecipeRequest& request) {
    RecipeFile changed = m_recipes;
    Recipe* recipe = changed.find(request.recipe);
    if (!recipe) return {};
    const bool isAdd = request.kind == RecipeRequestKind::Add;
    if (!isAdd && recipe->sets.size() < 2) return {};
    QString name;
    if (isAdd) {
        const RecipeSet* like = recipe->find(request.set);
        RecipeSet copy = like ? *like : RecipeSet{};
        copy.name = name = recipe->freeName(like ? like->name : request.recipe);
        recipe->sets.push_back(std::move(copy));
    } else {
        std::erase_if(recipe->sets, [&](const RecipeSet& one) { return one.name == request.set; });
        name = recipe->sets.front().name;
    }
    if (!keepRecipes(std::move(changed))) return {};
    record(isAdd ? QStringLiteral("recipe add") : QStringLiteral("recipe remove"),
           request.recipe + u'/' + (isAdd ? name : request.set), {}, {}, m_panelName);
    return name;
}

} // namespace plc::hmi
