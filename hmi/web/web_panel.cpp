#include "hmi/web/web_panel.h"

#include "hmi/model/property_literals.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPointer>
#include <QWheelEvent>
#include <nlohmann/json.hpp>

namespace plc::hmi::web {

namespace {

using Json = nlohmann::json;

QByteArray packed(const Json& json) {
    return QByteArray::fromStdString(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

struct NamedKey {
    const char* name;
    Qt::Key key;
};
constexpr std::array kKeys = {NamedKey{"Enter", Qt::Key_Return}, NamedKey{"Backspace", Qt::Key_Backspace},
                              NamedKey{"Escape", Qt::Key_Escape}, NamedKey{"Tab", Qt::Key_Tab}};

void sendMouse(QWidget& to, QEvent::Type type, QPointF atOverlay, const QWidget& overlay) {
    const QPointF local = to.mapFrom(&overlay, atOverlay);
    const bool isDown = type == QEvent::MouseButtonPress;
    QMouseEvent event(type, local, local, type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      isDown || type == QEvent::MouseMove ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&to, &event);
}

} // namespace

QStringList pagesOf(const PanelProject& project) {
    QStringList out;
    for (const NamedPanel& panel : project.panels)
        if (panel.name != project.frame && parametersOf(panel.panel).empty()) out += panel.name;
    if (const auto start = out.indexOf(project.startPanel); start > 0) out.move(start, 0);
    return out;
}

WebPanel::WebPanel(const PanelProject& project, session::Run& run, PaintStore& store, OperatorStation& keeper)
    : m_project(project), m_player(project, &run), m_station(m_player.station()), m_stream(store, m_player) {
    m_player.setStepped();
    m_station.shareAlarms(keeper);
    m_station.setLocked(true);
    m_station.setOwnLanguage(true);
    connect(&m_station, &OperatorStation::writeRefused, this, [this](const QString& reason) { m_refusal = reason; });
    connect(&m_player, &PanelPlayer::panelChanged, this, [this] {
        m_player.resize(m_player.scene().size());
        m_stream.restart();
        m_isNew = true;
        m_isTouched = false;
    });
    if (hasPeople()) connect(&m_station, &OperatorStation::userChanged, this, &WebPanel::setOperator);
    // Other views with other colours.
    connect(&m_player, &PanelPlayer::themeChanged, this, [this] {
        m_stream.restart();
        m_isNew = true;
    });
    connect(&m_player, &PanelPlayer::languageChanged, this, [this] { m_isNew = true; });
    if (m_station.panelName().isEmpty() && !project.panels.empty()) m_player.showPanel(project.panels.front().name);
}

WebPanel::~WebPanel() { letGo(); }

void WebPanel::setOperator(const QString& name) {
    letGo();
    m_operator = name;
    m_station.setLocked(name.isEmpty());
    m_isNew = true;
}

void WebPanel::logOut() {
    if (hasPeople())
        m_station.logOut();
    else
        setOperator({});
}

void WebPanel::tell(const QString& reason) {
    if (isOperator()) m_refusal = reason;
}

void WebPanel::letGo() {
    m_held.clear();
    if (m_player.scene().pressedView()) m_player.scene().release(QPointF(-1e6, -1e6));
}

bool WebPanel::isInside(QPointF at) const {
    constexpr double kAround = 1e5; // a finger may leave the panel while it holds a button
    return std::abs(at.x()) < kAround && std::abs(at.y()) < kAround;
}

bool WebPanel::take(const ClientMessage& message) {
    if (!m_isStarted && message.word != ClientWord::Hello) return false;
    if (message.word != ClientWord::Drawn)
        m_station.touch(std::chrono::steady_clock::now()); // pictures come and are drawn without anybody there
    switch (message.word) {
    case ClientWord::Hello:
        if (m_isStarted) return false;
        m_isStarted = true;
        if (!message.text.isEmpty()) (void)m_player.showPanel(message.text);
        if (m_project.texts.settings().languages.contains(message.more)) m_station.setLanguage(message.more);
        [[fallthrough]];
    case ClientWord::Scale:
        m_sharpness = std::clamp(static_cast<int>(std::ceil(std::clamp(message.number, 0.1, 4.0) - 0.01)), 1, 4);
        m_stream.setSharpness(m_sharpness);
        return true;
    case ClientWord::Down:
    case ClientWord::Move:
    case ClientWord::Up:
    case ClientWord::Wheel:
        return point(message);
    case ClientWord::Cancel:
        letGo();
        return true;
    case ClientWord::Key:
        key(message.text);
        return true;
    case ClientWord::Activate:
        if (message.number < 0) return false;
        activate(static_cast<size_t>(message.number));
        return true;
    case ClientWord::Panel:
        letGo();
        (void)m_player.showPanel(message.text);
        return true;
    case ClientWord::Language:
        if (m_project.texts.settings().languages.contains(message.text)) m_station.setLanguage(message.text);
        return true;
    case ClientWord::Motion:
        m_player.setReducedMotion(message.number == 0);
        return true;
    case ClientWord::Drawn:
    case ClientWord::LogIn:
    case ClientWord::LogOut:
        return true; // the server's business
    }
    return false;
}

bool WebPanel::point(const ClientMessage& message) {
    if (!isInside(message.at)) return false;
    catchUp();
    if (Overlay* overlay = m_player.overlay(); overlay && !overlay->isHidden()) {
        pointOverlay(message, *overlay);
        return true;
    }
    PanelScene& scene = m_player.scene();
    switch (message.word) {
    case ClientWord::Down:
        letGo();
        scene.press(message.at);
        break;
    case ClientWord::Move:
        scene.move(message.at);
        break;
    case ClientWord::Up:
        scene.release(message.at);
        break;
    default:
        scene.wheel(message.at, std::clamp(message.number, -10.0, 10.0));
    }
    return true;
}

void WebPanel::pointOverlay(const ClientMessage& message, Overlay& overlay) {
    QWidget* below = overlay.childAt(message.at.toPoint());
    if (!below) below = &overlay;
    switch (message.word) {
    case ClientWord::Down:
        m_held = below;
        return sendMouse(*below, QEvent::MouseButtonPress, message.at, overlay);
    case ClientWord::Move:
        if (m_held) sendMouse(*m_held, QEvent::MouseMove, message.at, overlay);
        return;
    case ClientWord::Up:
        if (QWidget* held = m_held) {
            m_held.clear();
            sendMouse(*held, QEvent::MouseButtonRelease, message.at, overlay);
        }
        return;
    default: {
        const QPointF local = below->mapFrom(&overlay, message.at);
        const int turn = static_cast<int>(std::clamp(message.number, -10.0, 10.0) * 120);
        QWheelEvent event(local, local, {}, {0, turn}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(below, &event);
    }
    }
}

void WebPanel::catchUp() {
    m_isTouched = true;
    if (!std::exchange(m_isBehind, false)) return;
    m_player.frame();
    m_stream.catchUp(m_at);
}

QString WebPanel::viewName() const {
    const bool hasOverlay = m_player.overlay() && !m_player.overlay()->isHidden();
    if (m_isTouched || isOperator() || hasOverlay) return {};
    const PanelScene& scene = m_player.scene();
    QStringList place{m_station.navigation().current().panel};
    for (auto one = m_station.navigation().current().arguments.cbegin();
         one != m_station.navigation().current().arguments.cend(); ++one)
        place += one.key() + u'=' + one.value();
    return QStringList{place.join(u'\t'), m_station.language(), scene.themeName(), QString::number(m_sharpness),
                       QString::number(scene.isMotionReduced())}
        .join(u'\n');
}

void WebPanel::key(const QString& name) {
    catchUp();
    QWidget* overlay = m_player.overlay();
    if (!overlay || overlay->isHidden()) return;
    int code = 0;
    QString text;
    for (const NamedKey& one : kKeys)
        if (name == QLatin1String(one.name)) code = one.key;
    if (code == 0) {
        if (name.size() != 1) return;
        text = name;
    }
    QKeyEvent event(QEvent::KeyPress, code, Qt::NoModifier, text);
    QApplication::sendEvent(overlay, &event);
}

/// As a finger does in its middle; a momentary button holds for as long as the scan needs to see it.
void WebPanel::activate(size_t index) {
    catchUp();
    PanelScene& scene = m_player.scene();
    if (index >= scene.views().size() || (m_player.overlay() && !m_player.overlay()->isHidden())) return;
    const QPointF middle = scene.shownRect(*scene.views()[index]).center();
    letGo();
    scene.press(middle);
    scene.release(middle);
}

QByteArray WebPanel::describe() {
    const PanelScene& scene = m_player.scene();
    const QColor ground = scene.theme().color(scene.panel().text("background"_text));
    Json panels = Json::array(), languages = Json::array();
    QStringList pages = pagesOf(m_project);
    if (!pages.contains(m_station.panelName())) pages += m_station.panelName(); // opened by its address
    for (const QString& page : pages) panels.push_back(page.toStdString());
    for (const QString& tag : m_project.texts.settings().languages) {
        // Qt calls plain English American.
        const QString native =
            tag == QStringLiteral("en") ? QStringLiteral("English") : localeOf(tag).nativeLanguageName();
        languages.push_back({tag.toStdString(), (native.isEmpty() ? tag : native).toStdString()});
    }
    const auto say = [&](SystemText text) { return words(text).toStdString(); };
    const auto hex = [](const QColor& color) { return color.name().toStdString(); };
    return packed({{"t", "panel"},
                   {"name", m_station.panelName().toStdString()},
                   {"width", scene.size().width()},
                   {"height", scene.size().height()},
                   {"ground", hex(ground.isValid() ? ground : scene.theme().color("background"))},
                   {"dark", scene.theme().isDark()},
                   {"language", m_station.language().toStdString()},
                   {"rtl", isRightToLeft(m_station.language())},
                   {"panels", panels},
                   {"languages", languages},
                   {"operator", m_operator.toStdString()},
                   {"people", hasPeople()},
                   {"words",
                    {{"logIn", say(SystemText::LogIn)},
                     {"logOut", say(SystemText::LogOut)},
                     {"code", say(hasPeople() ? SystemText::Password : SystemText::AccessCode)},
                     {"user", say(SystemText::UserName)},
                     {"lost", say(SystemText::ConnectionLost)},
                     {"readOnly", say(SystemText::LogInFirst)},
                     {"cancel", say(SystemText::Cancel)}}}});
}

void WebPanel::tellState(const QString& state, bool isBad, Output& out) {
    m_isBad = isBad;
    if (state == m_state) return;
    m_state = state;
    out.texts += packed({{"t", "state"}, {"text", state.toStdString()}, {"bad", isBad}});
}

WebPanel::Output WebPanel::next(qint64 milliseconds) {
    Output out;
    if (!m_isStarted) return out;
    constexpr qint64 kWordsEvery = 1000;
    const QString view = viewName();
    const bool isRecorded = m_stream.isRecorded(view, milliseconds);
    m_at = milliseconds;
    m_isBehind = isRecorded;
    if (!isRecorded) m_player.frame();
    if (std::exchange(m_isNew, false)) {
        out.texts += describe();
        m_wordsAt = -1;
        m_state = QChar(0);
    }
    if (!isRecorded) {
        const Freshness freshness = m_station.values() ? m_station.values()->freshness() : Freshness::Disconnected;
        tellState(m_player.stateText(), freshness == Freshness::Stopped || freshness == Freshness::Fault, out);
    } else {
        tellState(m_stream.shared(view).state, m_stream.shared(view).isBad, out);
    }
    if (!m_refusal.isEmpty())
        out.texts += packed({{"t", "refused"}, {"text", std::exchange(m_refusal, {}).toStdString()}});
    out.frame = m_stream.frame(milliseconds, view);
    if (!isRecorded) m_stream.share(view, m_state, m_isBad);
    if (m_wordsAt < 0 || milliseconds - m_wordsAt >= kWordsEvery) {
        m_wordsAt = milliseconds;
        if (const QByteArray words = m_stream.words(); !words.isEmpty()) out.texts += words;
    }
    return out;
}

} // namespace plc::hmi::web
