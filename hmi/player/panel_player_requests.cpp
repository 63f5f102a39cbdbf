// What is drawn over a panel when it is operated: pop-ups and the frame, keypads, lists and questions. What comes of
// them is the station's.
#include "hmi/player/panel_player.h"

#include "editor/kit/post.h"
#include "hmi/model/property_literals.h"
#include "hmi/player/alarm_sheet.h"
#include "hmi/player/pop_up.h"
#include "hmi/view/lists/recipe_view.h"

#include <algorithm>

namespace plc::hmi {

OverlayLook PanelPlayer::look() { return {scene().theme(), &m_project.texts, language()}; }

/// All that a scene of this player shows, but for the panel itself.
void PanelPlayer::setUpScene(PanelScene& one) {
    one.setFolder(m_project.folder);
    one.setPicturesOutside(m_project.picturesOutside);
    one.setFaceplates(m_project.panelLookup());
    one.setThemes(m_project.themes);
    one.setReducedMotion(scene().isMotionReduced());
    one.setRecipes(&recipes());
    one.setTexts(&m_project.texts);
    one.setAlarms(&alarms());
    one.setAlarmPosition(m_station.alarmPosition());
    one.setLanguage(language());
    one.setUser(people().user());
    one.setValues(values());
    connectScene(one);
}

void PanelPlayer::connectScene(PanelScene& scene) {
    scene.setAccess([this](const QString& roles) { return people().isAllowed(roles); });
    connect(&scene, &PanelScene::writeRequested, &m_station, [this](const WriteRequest& write) { post(write); });
    connect(&scene, &PanelScene::confirmRequested, this, &PanelPlayer::confirm);
    connect(&scene, &PanelScene::entryRequested, this, [this](const EntryRequest& entry) {
        if (m_station.refusesLocked()) return;
        auto* keypad = new Keypad(entry, look(), this);
        connect(keypad, &Keypad::accepted, this, [this](const EntryRequest& request, const Value& value) {
            submit(WriteRequest{request.element, request.target, WriteKind::Write, value, {}});
        });
    });
    connect(&scene, &PanelScene::choiceRequested, this, [this](const ChoiceRequest& choice) {
        if (!choice.isLanguage && m_station.refusesLocked()) return;
        auto* list = new ChoiceList(choice, look(), this);
        connect(list, &ChoiceList::chosen, this, [this](const ChoiceRequest& request, int index) {
            const Value& value = request.values[static_cast<size_t>(index)];
            if (request.isLanguage)
                m_station.requestLanguage(value.text());
            else
                submit(WriteRequest{request.element, request.target, WriteKind::Write, value, {}});
        });
    });
    connect(&scene, &PanelScene::acknowledgeRequested, &m_station, &OperatorStation::acknowledge);
    // Later: the view that asks may go with its panel.
    connect(&scene, &PanelScene::panelRequested, this, [this](const QString& name) {
        kit::post(this, [this, name] { navigation().open({name, {}}); });
    });
    connect(&scene, &PanelScene::navigationRequested, this, [this](const NavigationRequest& request) {
        kit::post(this, [this, request] { navigation().perform(request); });
    });
    connect(&scene, &PanelScene::accessRequested, this, &PanelPlayer::answerAccess);
    connect(&scene, &PanelScene::alarmDetailRequested, this, &PanelPlayer::answerAlarm);
    connect(&scene, &PanelScene::recipeRequested, this,
            [this, &scene](const RecipeRequest& request) { answerRecipe(request, scene); });
    connect(&scene, &PanelScene::languageRequested, &m_station, &OperatorStation::requestLanguage);
    // Not while the button that asks for it is still at work: its view goes.
    connect(&scene, &PanelScene::themeRequested, this,
            [this](const QString& name) { kit::post(this, [this, name] { setTheme(name); }); });
}

// ---- several panels as one

void PanelPlayer::showCurrent() {
    const OperatorStation::Shown shown = m_station.shown(m_isPortrait);
    if (!shown.panel) return;
    const PanelPlace current = place();
    m_arguments = current.arguments;
    m_showsFrame = shown.frame != nullptr;
    scene().setCurrentPanel(current.panel);
    if (shown.frame) {
        scene().setArea(shown.name, current.arguments);
        scene().setPanel(shown.frame->panel);
    } else {
        scene().setArea({}, {});
        scene().setPanel(withArguments(*shown.panel, argumentsFor(*shown.panel)));
    }
    const bool isNew = m_station.setPanelName(current.panel);
    m_shown = shownState();
    updateStatus();
    if (isNew) emit panelChanged(current.panel);
}

std::vector<PopUp*> PanelPlayer::popUps() const {
    std::vector<PopUp*> out;
    for (PopUp* one : findChildren<PopUp*>(Qt::FindDirectChildrenOnly))
        if (!one->isClosing()) out.push_back(one);
    return out;
}

/// The boxes follow the list: those at its end come or go.
void PanelPlayer::syncPopUps() {
    const std::vector<PanelPlace>& wanted = navigation().popUps();
    std::vector<PopUp*> open = popUps();
    while (open.size() > wanted.size()) {
        open.back()->end();
        open.pop_back();
    }
    for (size_t i = open.size(); i < wanted.size(); ++i) {
        const Panel* panel = m_project.panelLookup()(wanted[i].panel);
        if (!panel) continue;
        auto* popUp = new PopUp(look(), wanted[i], this);
        setUpScene(popUp->scene());
        connect(popUp, &Overlay::cancelled, this, [this] { kit::post(this, [this] { navigation().closePopUp(); }); });
        Panel shown = withArguments(*panel, completed(parametersOf(*panel), wanted[i].arguments));
        shown.set("theme"_field, toUtf8(scene().themeName()));
        popUp->showPanel(shown);
    }
}

// ---- people

LogIn::Answer PanelPlayer::logIn(const QString& user, const QString& password) {
    return m_station.logIn(user, password, std::chrono::steady_clock::now());
}

/// What is locked and hidden follows, on every panel that is seen.
void PanelPlayer::showUser(const QString& name) {
    releasePress();
    onEachScene([&](PanelScene& one) { one.setUser(name); });
    emit userChanged(name);
}

void PanelPlayer::answerAccess(const AccessRequest& request) {
    if (request.isLogOut) return logOut();
    if (!request.roles.isEmpty())
        m_station.refuse(m_station.say(SystemText::OnlyFor).arg(m_station.titlesOf(request.roles)));
    const QStringList names = m_station.users();
    if (names.isEmpty()) return;
    if (names.size() == 1) return askForPassword(names.front());
    ChoiceRequest choice;
    choice.texts = names;
    for (const QString& name : names) choice.values.push_back(Value::ofText(name));
    auto* list = new ChoiceList(choice, look(), this);
    connect(list, &ChoiceList::chosen, this, [this](const ChoiceRequest& chosen, int index) {
        const QString name = chosen.values[static_cast<size_t>(index)].text();
        kit::post(this, [this, name] { askForPassword(name); });
    });
}

namespace {
EntryRequest passwordEntry(const OperatorStation& station, const QString& user) {
    EntryRequest entry;
    entry.kind = EntryKind::Text;
    entry.isHidden = true;
    entry.maxLength = 100;
    entry.title = user + QStringLiteral("  –  ") + station.say(SystemText::Password);
    return entry;
}
} // namespace

void PanelPlayer::askForPassword(const QString& user) {
    auto* keypad = new Keypad(passwordEntry(m_station, user), look(), this);
    connect(keypad, &Keypad::accepted, this,
            [this, user](const EntryRequest&, const Value& value) { (void)logIn(user, value.text()); });
}

// ---- writes that are asked for

const ElementView* PanelPlayer::viewOf(const ElementId& element, const PanelScene** shownIn) const {
    if (element.isEmpty()) return nullptr;
    const auto look = [&](const PanelScene& one) {
        const ElementView* view = one.view(element);
        if (view && shownIn) *shownIn = &one;
        return view;
    };
    const std::vector<PopUp*> open = popUps();
    for (size_t i = open.size(); i-- > 0;)
        if (const ElementView* view = look(open[i]->scene())) return view;
    return look(scene());
}

QString PanelPlayer::refusedRoles(const ElementId& element) const {
    const PanelScene* shownIn = nullptr;
    const ElementView* const view = viewOf(element, &shownIn);
    return view ? shownIn->rolesFor(*view) : QString();
}

void PanelPlayer::submit(const WriteRequest& write) {
    const ElementView* view = viewOf(write.element);
    if (view && view->element().isSet("critical"_flag))
        confirm(ConfirmRequest{{}, write, true});
    else
        post(write);
}

void PanelPlayer::confirm(const ConfirmRequest& request) {
    if (m_station.refusesLocked()) return;
    ConfirmRequest shown = request;
    shown.question = m_station.questionFor(request);
    auto* question = new Question(shown, look(), this);
    connect(question, &Question::confirmed, this, [this, isCritical = request.isCritical](const WriteRequest& write) {
        if (isCritical && people().isLoggedIn())
            kit::post(this, [this, write] { askForSignature(write); });
        else
            m_station.confirmed(write, QStringLiteral("confirmed"));
    });
}

void PanelPlayer::askForSignature(const WriteRequest& write) {
    auto* keypad = new Keypad(passwordEntry(m_station, people().user()), look(), this);
    connect(keypad, &Keypad::accepted, this, [this, write](const EntryRequest&, const Value& value) {
        m_station.sign(write, value.text(), std::chrono::steady_clock::now());
    });
}

// ---- alarms and recipes

void PanelPlayer::answerAlarm(const AlarmDetailRequest& request) {
    if (!m_station.mayAnswer(request)) return;
    const bool isOnScreen = m_timer.isActive(); // a browser's panel has no place for the answer
    auto* sheet = new AlarmSheet(liveAlarms(), request.alarm, look(), isOnScreen, this);
    connect(sheet, &AlarmSheet::whyAsked, this, [this](const QString& condition) {
        kit::post(this, [this, condition] { askWhy(kit::AskWhy::Why, condition); });
    });
    connect(sheet, &AlarmSheet::chosen, this, [this](AlarmAction action, const QString& alarm) {
        kit::post(this, [this, action, alarm] { m_station.act(action, alarm); });
    });
}

void PanelPlayer::answerRecipe(const RecipeRequest& request, PanelScene& scene) {
    if (request.kind != RecipeRequestKind::Choose && m_station.refusesLocked()) return;
    switch (request.kind) {
    case RecipeRequestKind::Choose:
        return chooseSet(request, scene);
    case RecipeRequestKind::Edit:
        return editValue(request);
    case RecipeRequestKind::Write:
        return m_station.writeSet(request);
    case RecipeRequestKind::Read:
        return readSet(request);
    case RecipeRequestKind::Add:
    case RecipeRequestKind::Remove:
        return changeSets(request, scene);
    }
}

namespace {
void showSet(PanelScene& scene, const ElementId& element, const QString& set) {
    if (auto* view = dynamic_cast<RecipeTableView*>(scene.view(element))) view->showSet(set);
}
} // namespace

void PanelPlayer::chooseSet(const RecipeRequest& request, PanelScene& shownIn) {
    const std::optional<ChoiceRequest> choice = m_station.setsOf(request);
    if (!choice) return;
    auto* list = new ChoiceList(*choice, look(), this);
    connect(list, &ChoiceList::chosen, &shownIn,
            [&shownIn, element = request.element](const ChoiceRequest& chosen, int index) {
                showSet(shownIn, element, chosen.values[static_cast<size_t>(index)].text());
            });
}

void PanelPlayer::editValue(const RecipeRequest& request) {
    const std::optional<EntryRequest> entry = m_station.entryFor(request);
    if (!entry) return;
    auto* keypad = new Keypad(*entry, look(), this);
    connect(keypad, &Keypad::accepted, this, [this, request](const EntryRequest& asked, const Value& value) {
        m_station.enterValue(request, asked, value);
    });
}

/// What was in the set does not come back either.
void PanelPlayer::readSet(const RecipeRequest& request) {
    if (!m_station.shownRun()) return m_station.readSet(request); // refused: there is nothing to be asked about
    auto* question = new Question({m_station.say(SystemText::ConfirmRead).arg(request.set), {}, false}, look(), this);
    connect(question, &Question::confirmed, this, [this, request] { m_station.readSet(request); });
}

/// A set that is gone does not come back: who touched the wrong key is asked.
void PanelPlayer::changeSets(const RecipeRequest& request, PanelScene& shownIn) {
    const auto change = [this, request, &shownIn] {
        if (const QString set = m_station.changeSets(request); !set.isEmpty()) showSet(shownIn, request.element, set);
    };
    const Recipe* recipe = recipes().find(request.recipe);
    if (request.kind != RecipeRequestKind::Remove || !recipe || recipe->sets.size() < 2) return change();
    auto* question = new Question({m_station.say(SystemText::ConfirmRemove).arg(request.set), {}, false}, look(), this);
    connect(question, &Question::confirmed, &shownIn, change);
}

} // namespace plc::hmi
