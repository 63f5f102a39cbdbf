// What a person does on panels of any shape, in a browser and on the screen of the machine, while the program runs. The
// bodies, included once per program; a broken promise aborts. Needs a QApplication; main thread.
#pragma once
#include "hmi/web/web_panel.h"
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/fuzz/promise.h"
#include "tests/fuzz/scripts.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <cstdlib>
#include <memory>
#include <optional>

namespace plc::fuzz {

/// A script (tests/fuzz/panels): first the panels, alarms, recipes and people as they are in a project's files, then
/// what a browser says, {"t": "scan", "n": 5} for scans and {"t": "position", "n": 3} for the time slider. Whoever is
/// not logged in writes nothing, whatever the panels are.
void operatePanels(const std::string& script);

namespace operated {

using hmi::web::ClientWord;
using Json = testing::Damage::Json;

/// Only panels write what is in `set`.
inline const char* const kMachine = R"(
TYPE
    Mode : (Idle, Hand, Auto);
    Row : STRUCT amount : INT := 7; name : STRING(10); on : BOOL; END_STRUCT;
    Settings : STRUCT
        start, stop, overload : BOOL;
        level : REAL := 12.5;
        small : SINT;
        whole : DINT := 50;
        divisor : INT := 1;
        mode : Mode;
        name : STRING(5);
        wait : TIME := T#1s;
        rows : ARRAY[1..5] OF Row;
        speed : ARRAY[1..2] OF REAL;
    END_STRUCT;
END_TYPE
FUNCTION_BLOCK Drive
VAR_INPUT go : BOOL; speed : REAL; END_VAR
VAR_OUTPUT runs : BOOL; hours : REAL; END_VAR
runs := go;
hours := hours + speed / 3600.0;
END_FUNCTION_BLOCK
VAR_GLOBAL Language : INT; END_VAR
PROGRAM Main
VAR
    set : Settings;
    running, flash : BOOL;
    count : DINT;
    quotient : INT;
    now : DT := DT#2026-05-04-08:00:00;
    curve : ARRAY[1..5] OF REAL := [1.0, 4.0, 9.0, 16.0, 25.0];
    drives : ARRAY[1..2] OF Drive;
END_VAR
running := (running OR set.start) AND NOT set.stop;
count := count + 1;
flash := count MOD 8 = 3;
quotient := 100 / set.divisor;
curve[1 + DINT_TO_INT(count MOD 5)] := set.level * DINT_TO_REAL(count MOD 7);
drives[1](go := running, speed := set.speed[1]);
drives[2](go := set.mode = Mode#Auto, speed := set.speed[2]);
END_PROGRAM
)";

inline const driver::Built& machine() {
    static const driver::Built built = [] {
        jit::setRuntimeSymbols(controller::runtimeSymbols());
        driver::BuildInput input;
        input.files.push_back({"main.st", kMachine});
        driver::Built made = driver::build(input);
        promise(made.program != nullptr);
        return made;
    }();
    return built;
}

inline hmi::PanelProject emptyProject(const QString& folder) {
    hmi::PanelProject project;
    project.folder = folder;
    hmi::LanguageSettings settings;
    settings.languages = QStringList{"en", "de", "ar"};
    settings.variable = QStringLiteral("Language");
    const auto texts =
        hmi::TextTable::parse("key,comment,en,de,ar\nstart,,Start,Start,بدء\nover,,Overload at {n:%d},Überlast bei "
                              "{n:%d},حمل زائد {n:%d}\nmode.0,,Idle,Halt,توقف\nmode.1,,Hand,Hand,يدوي\n",
                              QStringLiteral("texts.csv"));
    promise(bool(texts));
    project.texts = hmi::TextCatalog(*texts, settings);
    return project;
}

/// A file of the project; false: it is none.
inline bool takeFile(hmi::PanelProject& project, const Json& json, const std::string& text) {
    const QString place = QStringLiteral("script");
    if (json.contains("elements")) {
        const Json name = json.value("panel", Json("main"));
        const auto panel = hmi::Panel::parse(text, place);
        if (!panel) return true;
        const QString called = name.is_string() ? QString::fromStdString(name.get<std::string>()) : place;
        if (hmi::NamedPanel* known = project.find(called))
            known->panel = *panel;
        else
            project.panels.push_back({called, *panel});
        if (project.startPanel.isEmpty()) project.startPanel = called;
        if (called == QStringLiteral("frame")) project.frame = called;
    } else if (json.contains("alarms")) {
        const auto file = hmi::AlarmFile::parse(text, place);
        if (file) project.alarms = *file;
        project.hasAlarms = bool(file);
    } else if (json.contains("recipes")) {
        if (const auto file = hmi::RecipeFile::parse(text, place)) project.recipes = *file;
    } else if (json.contains("users") || json.contains("roles")) {
        const auto file = hmi::PeopleFile::parse(text, place);
        project.people = file ? *file : hmi::PeopleFile::nobody();
    } else {
        return false;
    }
    return true;
}

inline session::Settings smallSettings() {
    session::Settings settings;
    settings.historyBudget = size_t(4) << 20;
    return settings;
}

/// One browser in front of the panels.
class Person {
public:
    explicit Person(const hmi::PanelProject& project)
        : m_session(machine(), smallSettings()), m_keeper(project, &m_session),
          m_panel(project, m_session, m_store, m_keeper) {
        m_session.controller().start();
        scan(2);
        m_settings = settings();
        hmi::web::ClientMessage hello;
        hello.word = ClientWord::Hello;
        hello.number = 1;
        promise(m_panel.take(hello));
    }

    /// False: nobody of ours says that, and the server would drop it.
    bool say(const Json& json, const std::string& text) {
        const Json word = json.value("t", Json());
        const Json number = json.value("n", Json());
        const double n = number.is_number() ? number.get<double>() : 0;
        if (word == "scan") {
            scan(static_cast<int>(std::clamp(n, 0.0, 50.0)));
        } else if (word == "position") {
            const history::Statistics recorded = m_session.history().statistics();
            const bool isPast = n >= 0 && recorded.end > recorded.first;
            const auto newest = static_cast<double>(recorded.end - 1);
            m_panel.player().setPosition(
                isPast ? std::optional(std::max(recorded.first, static_cast<history::Position>(std::min(n, newest))))
                       : std::nullopt);
        } else if (const auto message =
                       hmi::web::parseClientMessage(QByteArrayView(text.data(), static_cast<qsizetype>(text.size())))) {
            if (!m_panel.take(*message)) return false;
            if (message->word == ClientWord::LogIn) logIn(*message);
            if (message->word == ClientWord::LogOut) m_panel.logOut();
        } else {
            return false;
        }
        look();
        return true;
    }

    /// Nobody was ever logged in: what panels write is as it was.
    void leave() {
        scan(2);
        promise(m_wasOperator || settings() == m_settings);
    }

private:
    void scan(int count) {
        const uint64_t until = m_session.controller().nextScan() + static_cast<uint64_t>(count);
        m_session.runHere([&](const controller::Controller& each) { return each.nextScan() >= until; });
        if (hmi::AlarmWatch* watch = m_keeper.alarmWatch()) watch->catchUp();
        m_keeper.frame(std::chrono::steady_clock::now());
    }
    void logIn(const hmi::web::ClientMessage& message) {
        if (m_panel.hasPeople())
            (void)m_panel.logIn(message.more, message.text);
        else
            m_panel.setOperator(message.more.isEmpty() ? QStringLiteral("operator") : message.more);
    }
    void look() {
        constexpr qsizetype kLargestFrame = 4 << 20;
        QCoreApplication::processEvents();
        m_wasOperator = m_wasOperator || m_panel.isOperator();
        const hmi::web::WebPanel::Output out = m_panel.next(m_now += 33);
        promise(out.frame.size() < kLargestFrame);
    }
    [[nodiscard]] std::string settings() {
        const image::Layout& layout = m_session.program()->layout;
        const auto set = layout.find("Main.set");
        promise(bool(set));
        std::string out;
        layout.forEachLeaf("", *set, [&](const std::string&, const image::Place& at) {
            out += types::toText(*layout.types,
                                 types::readValue(*layout.types, at.type,
                                                  m_session.controller().image().subspan(at.offset), at.bit)) +
                   "\n";
            return true;
        });
        return out;
    }

    session::Session m_session;
    hmi::web::PaintStore m_store;
    hmi::OperatorStation m_keeper; // of the alarms
    hmi::web::WebPanel m_panel;
    std::string m_settings;
    qint64 m_now = 0;
    bool m_wasOperator = false;
};

} // namespace operated

void operatePanels(const std::string& script) {
    using operated::Person;
    constexpr int kMostMessages = 80;
    const QTemporaryDir folder;
    hmi::PanelProject project = operated::emptyProject(folder.path());
    std::unique_ptr<Person> person;
    int messages = 0;
    for (const std::string& line : linesOf(script)) {
        const std::string text = line.substr(2);
        const auto json = testing::Damage::readable(text);
        if (!json || !json->is_object()) continue;
        if (!person && operated::takeFile(project, *json, text)) continue;
        if (project.panels.empty()) return;
        if (!person) person = std::make_unique<Person>(project);
        if (!person->say(*json, text) || ++messages == kMostMessages) break;
    }
    if (person) person->leave();
}

} // namespace plc::fuzz
