// What the player does when it is operated: pop-ups and the frame, who is logged in, questions before a write, the
// trail.
#include "hmi/player/panel_player.h"

#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "hmi/player/pop_up.h"

#include <QEvent>

#include <algorithm>

namespace plc::hmi {

OverlayLook PanelPlayer::look() { return {&scene().theme(), &m_project.texts, language()}; }

void PanelPlayer::connectScene(PanelScene& scene) {
    scene.setAccess([this](const QString& roles) { return m_logIn.isAllowed(roles); });
    connect(&scene, &PanelScene::writeRequested, this, [this](const WriteRequest& write) { post(write); });
    connect(&scene, &PanelScene::confirmRequested, this, &PanelPlayer::confirm);
    connect(&scene, &PanelScene::entryRequested, this, [this](const EntryRequest& entry) {
        if (refusesLocked()) return;
        auto* keypad = new Keypad(entry, look(), this);
        connect(keypad, &Keypad::accepted, this, [this](const EntryRequest& request, const Value& value) {
            submit(WriteRequest{request.element, request.target, WriteKind::Write, value, {}});
        });
    });
    connect(&scene, &PanelScene::choiceRequested, this, [this](const ChoiceRequest& choice) {
        if (!choice.isLanguage && refusesLocked()) return;
        auto* list = new ChoiceList(choice, look(), this);
        connect(list, &ChoiceList::chosen, this, [this](const ChoiceRequest& request, int index) {
            const Value& value = request.values[static_cast<size_t>(index)];
            if (request.isLanguage)
                requestLanguage(value.text());
            else
                submit(WriteRequest{request.element, request.target, WriteKind::Write, value, {}});
        });
    });
    connect(&scene, &PanelScene::acknowledgeRequested, this, [this](const AcknowledgeRequest& acknowledge) {
        if (m_recording) return refuse(systemText(m_project.texts, SystemText::InThePast, language()));
        AlarmWatch* const watch = alarmWatch();
        if (!watch || refusesLocked()) return;
        const QString what = acknowledge.all ? QStringLiteral("all")
                             : acknowledge.alarm < liveAlarms().definitions().size()
                                 ? liveAlarms().definitions()[acknowledge.alarm].id
                                 : QString();
        record(QStringLiteral("acknowledge"), what, {}, {}, m_panelName);
        if (acknowledge.all)
            watch->acknowledgeAll(acknowledge.classes, m_logIn.user());
        else
            watch->acknowledge(acknowledge.alarm, m_logIn.user());
    });
    // Later: the view that asks may go with its panel.
    connect(&scene, &PanelScene::panelRequested, this, [this](const QString& name) {
        kit::post(this, [this, name] { m_navigation.open({name, {}}); });
    });
    connect(&scene, &PanelScene::navigationRequested, this, [this](const NavigationRequest& request) {
        kit::post(this, [this, request] { m_navigation.perform(request); });
    });
    connect(&scene, &PanelScene::accessRequested, this, &PanelPlayer::answerAccess);
    connect(&scene, &PanelScene::alarmDetailRequested, this, &PanelPlayer::answerAlarm);
    connect(&scene, &PanelScene::recipeRequested, this,
            [this, &scene](const RecipeRequest& request) { answerRecipe(request, scene); });
    connect(&scene, &PanelScene::languageRequested, this, &PanelPlayer::requestLanguage);
    // Not while the button that asks for it is still at work: its view goes.
    connect(&scene, &PanelScene::themeRequested, this,
            [this](const QString& name) { kit::post(this, [this, name] { setTheme(name); }); });
}

// ---- several panels as one

/// The panel for a high screen where there is one and the screen is high.
QString PanelPlayer::onThisScreen(const QString& panel) const {
    const Panel* own = m_project.panelLookup()(panel);
    const QString other = own && m_isPortrait ? own->text("portrait") : QString();
    return !other.isEmpty() && m_project.find(other) ? other : panel;
}

void PanelPlayer::showCurrent() {
    const PanelPlace& place = m_navigation.current();
    const QString name = onThisScreen(place.panel);
    const Panel* panel = m_project.panelLookup()(name);
    if (!panel) return;
    const NamedPanel* frame =
        panel->isSet("framed") && name != m_project.frame ? m_project.find(m_project.frame) : nullptr;
    m_arguments = place.arguments;
    m_showsFrame = frame != nullptr;
    scene().setCurrentPanel(place.panel);
    if (frame) {
        scene().setArea(name, place.arguments);
        scene().setPanel(frame->panel);
    } else {
        scene().setArea({}, {});
        scene().setPanel(withArguments(*panel, argumentsFor(*panel)));
    }
    const bool isNew = std::exchange(m_panelName, place.panel) != place.panel;
    m_shown = shownState();
    updateStatus();
    if (isNew) emit panelChanged(place.panel);
}

std::vector<PopUp*> PanelPlayer::popUps() const {
    std::vector<PopUp*> out;
    for (PopUp* one : findChildren<PopUp*>(Qt::FindDirectChildrenOnly))
        if (!one->isClosing()) out.push_back(one);
    return out;
}

/// The boxes follow the list: those at its end come or go.
void PanelPlayer::syncPopUps() {
    const std::vector<PanelPlace>& wanted = m_navigation.popUps();
    std::vector<PopUp*> open = popUps();
    while (open.size() > wanted.size()) {
        open.back()->end();
        open.pop_back();
    }
    for (size_t i = open.size(); i < wanted.size(); ++i) {
        const Panel* panel = m_project.panelLookup()(wanted[i].panel);
        if (!panel) continue;
        auto* popUp = new PopUp(look(), wanted[i], this);
        PanelScene& inner = popUp->scene();
        inner.setFolder(m_project.folder);
        inner.setPicturesOutside(m_project.picturesOutside);
        inner.setFaceplates(m_project.panelLookup());
        inner.setThemes(m_project.themes);
        inner.setReducedMotion(scene().isMotionReduced());
        inner.setRecipes(&m_recipes);
        inner.setTexts(&m_project.texts);
        inner.setAlarms(&alarms());
        inner.setAlarmPosition(scene().alarmPosition());
        inner.setLanguage(language());
        inner.setUser(scene().user());
        inner.setValues(m_values.get());
        connectScene(inner);
        connect(popUp, &Overlay::cancelled, this, [this] { kit::post(this, [this] { m_navigation.closePopUp(); }); });
        Panel shown = withArguments(*panel, completed(parametersOf(*panel), wanted[i].arguments));
        shown.set("theme", toUtf8(scene().themeName()));
        popUp->showPanel(shown);
    }
}

// ---- people

void PanelPlayer::record(const QString& action, const QString& what, const QString& from, const QString& to,
                         const QString& place, const QString& comment) {
    // One writer: each line of the trail holds a sum over the one before.
    AuditTrail& trail = m_station ? m_station->m_audit : m_audit;
    if (!trail.isOpen()) return;
    const auto added =
        trail.add({QDateTime::currentDateTimeUtc(), m_logIn.user(), action, what, from, to, place, comment});
    if (!added) refuse(kit::messageText(added.error(), language()));
}

LogIn::Answer PanelPlayer::logIn(const QString& user, const QString& password) {
    const Moment now = std::chrono::steady_clock::now();
    LogIn::Answer answer = m_door ? m_door(user, password) : m_logIn.logIn(user, password, now);
    if (m_door && answer == LogIn::Answer::Good && !m_logIn.enter(user, now)) answer = LogIn::Answer::Wrong;
    if (answer != LogIn::Answer::Good) {
        // Who is shut out by a server goes on asking: that must not fill the disk.
        if (!m_door || answer != LogIn::Answer::Blocked)
            record(QStringLiteral("log in refused"), user, {}, {}, m_panelName);
        refuse(passwordRefusal(answer));
        return answer;
    }
    record(QStringLiteral("log in"), m_logIn.user(), {}, {}, m_panelName);
    showUser();
    if (const User* who = m_project.people.find(m_logIn.user())) {
        if (!who->language.isEmpty()) requestLanguage(who->language);
        if (const QString start = m_project.people.startPanelOf(*who); m_project.find(start))
            m_navigation.start({start, {}});
    }
    return answer;
}

void PanelPlayer::logOut(const QString& why) {
    if (!m_logIn.isLoggedIn()) return;
    record(QStringLiteral("log out"), m_logIn.user(), {}, {}, m_panelName, why);
    m_logIn.logOut();
    showUser();
}

/// What is locked and hidden follows, on every panel that is seen.
void PanelPlayer::showUser() {
    if (scene().pressedView()) scene().release(QPointF(-1e6, -1e6));
    scene().setUser(m_logIn.user());
    for (PopUp* popUp : popUps()) popUp->scene().setUser(m_logIn.user());
    emit userChanged(m_logIn.user());
}

QString PanelPlayer::passwordRefusal(LogIn::Answer answer) const {
    const SystemText text = answer == LogIn::Answer::Blocked ? SystemText::TooManyTries : SystemText::WrongPassword;
    return systemText(m_project.texts, text, language());
}

QString PanelPlayer::titlesOf(const QString& roles) const {
    QStringList out;
    for (const QString& name : LogIn::rolesOf(roles)) {
        const Role* role = m_project.people.role(name);
        out += role && !role->title.isEmpty() ? m_project.texts.text(role->title, language()) : name;
    }
    return out.join(QStringLiteral(", "));
}

void PanelPlayer::answerAccess(const AccessRequest& request) {
    if (request.isLogOut) return logOut();
    if (!request.roles.isEmpty())
        refuse(systemText(m_project.texts, SystemText::OnlyFor, language()).arg(titlesOf(request.roles)));
    QStringList names;
    for (const User& user : m_project.people.users())
        if (!user.password.isEmpty()) names += user.name;
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
EntryRequest passwordEntry(const QString& title) {
    EntryRequest entry;
    entry.kind = EntryKind::Text;
    entry.isHidden = true;
    entry.maxLength = 100;
    entry.title = title;
    return entry;
}
} // namespace

void PanelPlayer::askForPassword(const QString& user) {
    const QString title =
        user + QStringLiteral("  –  ") + systemText(m_project.texts, SystemText::Password, language());
    auto* keypad = new Keypad(passwordEntry(title), look(), this);
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

void PanelPlayer::submit(const WriteRequest& write) {
    const ElementView* view = viewOf(write.element);
    if (view && view->element().isSet("critical"))
        confirm(ConfirmRequest{{}, write, true});
    else
        post(write);
}

void PanelPlayer::confirm(const ConfirmRequest& request) {
    if (refusesLocked()) return;
    ConfirmRequest shown = request;
    if (shown.question.isEmpty())
        shown.question = systemText(m_project.texts, SystemText::ConfirmWrite, language())
                             .arg(request.write.target, request.write.value.toLiteral());
    auto* question = new Question(shown, look(), this);
    connect(question, &Question::confirmed, this, [this, isCritical = request.isCritical](const WriteRequest& write) {
        if (isCritical && m_logIn.isLoggedIn())
            kit::post(this, [this, write] { askForSignature(write); });
        else
            confirmed(write, QStringLiteral("confirmed"));
    });
}

void PanelPlayer::confirmed(const WriteRequest& write, const QString& comment) {
    post(write, comment);
    if (write.kind == WriteKind::Press)
        post(WriteRequest{write.element, write.target, WriteKind::Release, write.released, write.released});
}

/// The password of who is logged in is the signature.
void PanelPlayer::askForSignature(const WriteRequest& write) {
    auto* keypad = new Keypad(passwordEntry(m_logIn.user() + QStringLiteral("  –  ") +
                                            systemText(m_project.texts, SystemText::Password, language())),
                              look(), this);
    connect(keypad, &Keypad::accepted, this, [this, write](const EntryRequest&, const Value& value) {
        const LogIn::Answer answer = m_logIn.confirm(value.text(), std::chrono::steady_clock::now());
        if (answer == LogIn::Answer::Good) return confirmed(write, QStringLiteral("signed by ") + m_logIn.user());
        record(QStringLiteral("signature refused"), write.target, {}, write.value.toLiteral(), m_panelName);
        refuse(passwordRefusal(answer));
    });
}

} // namespace plc::hmi
