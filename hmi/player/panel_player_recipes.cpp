// What the player does when a recipe is operated. A change is in the file before it is seen.
#include "hmi/player/panel_player.h"

#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "hmi/player/pop_up.h"
#include "hmi/player/recipe_transfer.h"
#include "hmi/view/recipe_view.h"

namespace plc::hmi {

void PanelPlayer::answerRecipe(const RecipeRequest& request, PanelScene& scene) {
    if (request.kind != RecipeRequestKind::Choose && refusesLocked()) return;
    switch (request.kind) {
    case RecipeRequestKind::Choose:
        return chooseSet(request, scene);
    case RecipeRequestKind::Edit:
        return editValue(request);
    case RecipeRequestKind::Write:
        return writeSet(request);
    case RecipeRequestKind::Read:
        return readSet(request);
    case RecipeRequestKind::Add:
    case RecipeRequestKind::Remove:
        return changeSets(request, scene);
    }
}

bool PanelPlayer::keepRecipes(RecipeFile changed) {
    if (const auto saved = saveRecipes(m_project, changed); !saved) {
        refuse(kit::messageText(saved.error(), language()));
        return false;
    }
    m_recipes = std::move(changed);
    scene().setRecipes(&m_recipes);
    for (PopUp* popUp : popUps()) popUp->scene().setRecipes(&m_recipes);
    emit recipesSaved();
    return true;
}

void PanelPlayer::chooseSet(const RecipeRequest& request, PanelScene& shownIn) {
    const Recipe* recipe = m_recipes.find(request.recipe);
    if (!recipe || recipe->sets.empty()) return;
    ChoiceRequest choice;
    for (const RecipeSet& set : recipe->sets) {
        if (set.name == request.set) choice.present = static_cast<int>(choice.texts.size());
        choice.texts += set.name;
        choice.values.push_back(Value::ofText(set.name));
    }
    auto* list = new ChoiceList(choice, look(), this);
    connect(list, &ChoiceList::chosen, &shownIn,
            [&shownIn, element = request.element](const ChoiceRequest& chosen, int index) {
                if (auto* view = dynamic_cast<RecipeTableView*>(shownIn.view(element)))
                    view->showSet(chosen.values[static_cast<size_t>(index)].text());
            });
}

void PanelPlayer::editValue(const RecipeRequest& request) {
    const Recipe* recipe = m_recipes.find(request.recipe);
    const RecipeVariable* variable = recipe ? recipe->variable(request.variable) : nullptr;
    const RecipeSet* set = recipe ? recipe->find(request.set) : nullptr;
    if (!variable || !set || !m_run) return;
    const auto target = m_run->expression(request.variable.toStdString());
    if (!target) return refuse(kit::messageText(target.error().message, language()));
    const ValueFacts facts = factsOf(target->types(), target->type(), true);
    const bool isNumber =
        facts.kind == ValueKind::Integer || facts.kind == ValueKind::Unsigned || facts.kind == ValueKind::Real;
    EntryRequest entry;
    entry.kind = isNumber && facts.enumValues.empty() ? EntryKind::Number : EntryKind::Text;
    entry.title = variable->title.isEmpty() ? variable->variable : m_project.texts.text(variable->title, language());
    entry.unit = variable->unit;
    entry.minimum = variable->minimum ? variable->minimum : facts.minimum;
    entry.maximum = variable->maximum ? variable->maximum : facts.maximum;
    entry.valueKind = facts.kind;
    const QString present = set->values.value(variable->variable);
    entry.present = entry.kind == EntryKind::Number ? Value::ofReal(present.toDouble()) : Value::ofText(present);
    auto* keypad = new Keypad(entry, look(), this);
    connect(keypad, &Keypad::accepted, this, [this, request](const EntryRequest& asked, const Value& value) {
        RecipeFile changed = m_recipes;
        Recipe* inner = changed.find(request.recipe);
        RecipeSet* taken = inner ? inner->find(request.set) : nullptr;
        const RecipeVariable* row = inner ? inner->variable(request.variable) : nullptr;
        if (!taken || !row || !m_run) return;
        const QString text = asked.kind == EntryKind::Text ? value.text() : value.toLiteral();
        if (const auto good = recipeValue(driver::checkedOf(m_run->program()), *row, text); !good)
            return refuse(kit::messageText(good.error().message, language()));
        const QString before = taken->values.value(row->variable);
        taken->values.insert(row->variable, text);
        if (keepRecipes(std::move(changed)))
            record(QStringLiteral("recipe edit"),
                   request.recipe + u'/' + request.set + QStringLiteral(": ") + request.variable, before, text,
                   m_panelName);
    });
}

void PanelPlayer::writeSet(const RecipeRequest& request) {
    const auto say = [&](SystemText text) { return systemText(m_project.texts, text, language()); };
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
    if (!done) return refuse(kit::messageText(done.error(), language()));
    record(QStringLiteral("recipe write"), name, {}, {}, m_panelName + QStringLiteral(", ") + request.element);
}

void PanelPlayer::readSet(const RecipeRequest& request) {
    if (!m_run) return refuse(systemText(m_project.texts, SystemText::NoController, language()));
    RecipeFile changed = m_recipes;
    Recipe* recipe = changed.find(request.recipe);
    RecipeSet* set = recipe ? recipe->find(request.set) : nullptr;
    if (!set) return;
    auto values = readRecipe(*m_run, *recipe);
    if (!values) return refuse(kit::messageText(values.error(), language()));
    set->values = std::move(*values);
    if (keepRecipes(std::move(changed)))
        record(QStringLiteral("recipe read"), request.recipe + u'/' + request.set, {}, {}, m_panelName);
}

/// A new set is a copy of the one that is shown; the last one stays.
void PanelPlayer::changeSets(const RecipeRequest& request, PanelScene& shownIn) {
    RecipeFile changed = m_recipes;
    Recipe* recipe = changed.find(request.recipe);
    if (!recipe) return;
    const bool isAdd = request.kind == RecipeRequestKind::Add;
    if (!isAdd && recipe->sets.size() < 2) return;
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
    if (!keepRecipes(std::move(changed))) return;
    record(isAdd ? QStringLiteral("recipe add") : QStringLiteral("recipe remove"),
           request.recipe + u'/' + (isAdd ? name : request.set), {}, {}, m_panelName);
    if (auto* view = dynamic_cast<RecipeTableView*>(shownIn.view(request.element))) view->showSet(name);
}

} // namespace plc::hmi
