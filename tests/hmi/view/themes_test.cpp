// Themes of a project: read, shown, checked; states of symbols and movement: each seen, the same at the same moment.
#include "hmi/check/panel_check.h"
#include "hmi/check/standard_check.h"
#include "hmi/view/element_factory.h"
#include "hmi/view/scene/panel_scene.h"
#include "runtime/base/messages.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace plc::hmi {
namespace {

Panel panelOf(const std::string& elements) {
    Result<Panel> panel = Panel::parse("{\"size\": [200, 120], \"elements\": [" + elements + "]}", QStringLiteral("p"));
    EXPECT_TRUE(panel) << (panel ? "" : panel.error().english());
    return panel ? *panel : Panel();
}

TEST(PanelThemes, AFileNamesItsBaseAndWhatIsOther) {
    const auto theme =
        PanelTheme::parse(R"({"base":"dark","colors":{"background":"#102030"}})", QStringLiteral("night"));
    ASSERT_TRUE(theme);
    EXPECT_EQ(theme->color("background").name().toStdString(), "#102030");
    EXPECT_EQ(theme->color("text"), PanelTheme::named(QStringLiteral("dark")).color("text"));
    const std::pair<const char*, const char*> wrong[] = {
        {"{", "JSON"},
        {"[]", "JSON"},
        {R"({"base":"night"})", "night"},
        {R"({"colors":{"backgroud":"#102030"}})", "did you mean background"},
        {R"({"colors":{"background":"reddish"}})", "#2A6CA6"},
        {R"({"colors":{"background":3}})", "background"},
    };
    for (const auto& [text, part] : wrong) {
        const auto bad = PanelTheme::parse(text, QStringLiteral("hmi/themes/x.json"));
        ASSERT_FALSE(bad) << text;
        EXPECT_NE(bad.error().english().find(part), std::string::npos) << bad.error().english();
    }
}

TEST(PanelThemes, WhatIsWrittenIsReadBackAndNamesWhatIsOtherThanTheBase) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto upTo = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    for (int round = 0; round < 200; ++round) {
        PanelTheme theme = PanelTheme::of(static_cast<PanelThemeKind>(upTo(3)));
        std::set<QString> own;
        for (int i = upTo(10); i > 0; --i) {
            const QString role = PanelTheme::roles()[upTo(static_cast<int>(PanelTheme::roles().size()))];
            const QColor color(upTo(255), 1 + upTo(254), upTo(255), upTo(4) ? 255 : upTo(256)); // none of a base
            theme.setColor(role, color);
            own.insert(role);
        }
        const auto kind = static_cast<PanelThemeKind>(upTo(3));
        theme.setBase(kind);
        const std::string text = theme.write();
        const auto read = PanelTheme::parse(text, QStringLiteral("t.json"));
        ASSERT_TRUE(read) << text << read.error().english();
        EXPECT_EQ(*read, theme) << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '#'), static_cast<long>(own.size())) << text;
        for (const QString& role : PanelTheme::roles())
            EXPECT_TRUE(own.contains(role) || theme.color(role) == PanelTheme::of(kind).color(role)) << text;
        for (const QString& role : own) theme.setColor(role, QColor());
        EXPECT_EQ(theme, PanelTheme::of(kind)) << text;
    }
}

TEST(PanelThemes, APanelIsShownInATheProjectsThemeAndInAnotherOnRequest) {
    PanelThemes themes;
    themes.set(QStringLiteral("night"), *PanelTheme::parse(R"({"base":"dark","colors":{"background":"#102030"}})", {}));
    PanelScene scene{makeElementView};
    scene.setThemes(themes);
    Panel panel = panelOf("");
    panel.set("theme", "night");
    scene.setPanel(panel);
    EXPECT_EQ(scene.picture().pixelColor(5, 5).name().toStdString(), "#102030");
    scene.setTheme(QStringLiteral("light"));
    EXPECT_EQ(scene.picture().pixelColor(5, 5), PanelTheme::of(PanelThemeKind::Light).color("background"));
    scene.setTheme({});
    EXPECT_EQ(scene.picture().pixelColor(5, 5).name().toStdString(), "#102030");
}

TEST(PanelThemes, TheBuiltInOnesCanBeReadAndAWeakOneIsFound) {
    for (const auto kind : {PanelThemeKind::Light, PanelThemeKind::Dark, PanelThemeKind::Contrast})
        for (const PanelTheme::Weak& weak : PanelTheme::of(kind).weaknesses())
            ADD_FAILURE() << static_cast<int>(kind) << ": " << weak.ink.toStdString() << " on "
                          << weak.ground.toStdString() << ' ' << weak.contrast << " < " << weak.needed;
    CheckInput input;
    input.standard.level = CheckLevel::Basic;
    input.themes.set(QStringLiteral("fog"), *PanelTheme::parse(R"({"colors":{"text":"#C8C8C8"}})", {}));
    int found = 0;
    for (const Finding& one : checkPanels(input)) found += one.file == QStringLiteral("hmi/themes/fog.json");
    EXPECT_EQ(found, 5) << "text on background, surface, raised, inset and button";
}

TEST(PanelThemes, WhatIsWrongWithAFileIsSaidWithItsLine) {
    const std::pair<const char*, const char*> wrong[] = {
        {"{\n \"base\": \"dusk\"}", "f.json:2"},
        {"{\n \"colors\": [1]}", "f.json:2"},
        {"{\"colors\": {\n\n \"backgrond\": \"#102030\"}}", "f.json:3"},
        {"{\"colors\": {\n \"text\": \"black\"}}", "f.json:2"},
        {"{\"colors\": {\n \"text\": 7}}", "f.json:2"},
        {"{\"base\": \"dark\",\n \"colors\": {\n", "f.json:3"},
        {"[]", "f.json"},
    };
    for (const auto& [text, place] : wrong) {
        const auto theme = PanelTheme::parse(text, QStringLiteral("f.json"));
        ASSERT_FALSE(theme) << text;
        EXPECT_EQ(theme.error().place, place) << text;
    }
}

TEST(PanelThemes, AThemeThatIsNotThereIsAFinding) {
    CheckInput input;
    Panel panel =
        panelOf(R"({"id":"b","kind":"button","rect":[0,0,128,56],"text":"x","action":"theme","theme":"fog"})");
    panel.set("theme", "mist");
    input.panels.push_back({QStringLiteral("main"), panel});
    int found = 0;
    for (const Finding& one : checkPanels(input)) found += one.kind == FindingKind::WrongPropertyType;
    EXPECT_EQ(found, 2);
    for (const char* name : {"fog", "mist"})
        input.themes.set(QLatin1String(name), PanelTheme::of(PanelThemeKind::Dark));
    for (const Finding& one : checkPanels(input))
        EXPECT_NE(one.kind, FindingKind::WrongPropertyType) << one.text().toStdString();
}

TEST(PanelThemes, AButtonAsksForATheme) {
    PanelScene scene{makeElementView};
    scene.setPanel(
        panelOf(R"({"id":"b","kind":"button","rect":[0,0,128,56],"text":"x","action":"theme","theme":"dark"})"));
    QString asked;
    QObject::connect(&scene, &PanelScene::themeRequested, [&](const QString& name) { asked = name; });
    scene.press({50, 20});
    scene.release({50, 20});
    EXPECT_EQ(asked.toStdString(), "dark");
}

// ---- states and movement

/// Pictures of one element at some moments, with what is true.
struct Shown {
    HeldValues values;
    PanelScene scene{makeElementView};
    Shown(const std::string& element, const QStringList& isTrue) {
        for (const char* name : {"run", "closed", "transit", "manual", "service", "fault", "warning"})
            values.set(QLatin1String(name), Value::ofBool(isTrue.contains(QLatin1String(name))));
        scene.setValues(&values);
        scene.setPanel(panelOf(element));
    }
    ~Shown() { scene.setValues(nullptr); }
    QImage at(qint64 milliseconds) {
        scene.refresh(milliseconds);
        return scene.picture();
    }
};

constexpr const char* kValve =
    R"({"id":"v","kind":"symbol","symbol":"valve","rect":[20,10,90,90],"state":"run","closed":"closed","transit":"transit","manual":"manual","service":"service","fault":"fault","warning":"warning"})";

TEST(SymbolStates, EachStateHasALookOfItsOwnAlsoWithoutColour) {
    const QStringList states[] = {{},
                                  {"run"},
                                  {"closed"},
                                  {"transit"},
                                  {"manual"},
                                  {"service"},
                                  {"fault"},
                                  {"warning"},
                                  {"run", "closed"},
                                  {"run", "manual"},
                                  {"closed", "transit"},
                                  {"closed", "service"}};
    std::vector<std::pair<std::string, QImage>> seen;
    for (const QStringList& state : states) {
        Shown shown(kValve, state);
        const QImage grey = shown.at(0).convertToFormat(QImage::Format_Grayscale8);
        for (const auto& [name, other] : seen)
            EXPECT_NE(grey, other) << state.join(u'+').toStdString() << " looks like " << name;
        seen.emplace_back(state.join(u'+').toStdString(), grey);
    }
}

TEST(Movement, TheSameMomentIsTheSamePictureAndTimeMovesIt) {
    const char* const moving[] = {
        R"({"id":"p","kind":"symbol","symbol":"fan","rect":[20,10,90,90],"state":"run"})",
        R"({"id":"p","kind":"symbol","symbol":"conveyor","rect":[20,10,90,90],"state":"run"})",
        R"({"id":"p","kind":"symbol","symbol":"pump","rect":[20,10,90,90],"state":"run"})",
        R"({"id":"p","kind":"pipe","rect":[10,10,180,60],"thickness":16,"flow":"run"})",
    };
    for (const char* element : moving) {
        Shown one(element, {"run"}), other(element, {"run"}), still(element, {});
        EXPECT_EQ(one.at(1200), other.at(1200)) << element << ": time is an argument, nothing else counts";
        (void)other.at(1700);
        EXPECT_EQ(one.at(1500), other.at(1500)) << element << ": whatever was shown between";
        EXPECT_NE(one.at(1500), one.at(1800)) << element;
        EXPECT_EQ(still.at(1500), still.at(1800)) << element << ": what stands does not move";
    }
}

TEST(Movement, WithLessMovementNothingMovesAndTheFlowStillHasADirection) {
    for (const char* element :
         {R"({"id":"p","kind":"symbol","symbol":"fan","rect":[20,10,90,90],"state":"run","fault":"run"})",
          R"({"id":"p","kind":"pipe","rect":[10,10,180,60],"thickness":16,"flow":"run"})"}) {
        Shown shown(element, {"run"}), still(element, {});
        shown.scene.setReducedMotion(true);
        still.scene.setReducedMotion(true);
        EXPECT_EQ(shown.at(0), shown.at(730)) << element << ": blinking counts as movement";
        EXPECT_NE(shown.at(0), still.at(0)) << element;
    }
    HeldValues values;
    PanelScene scene{makeElementView};
    scene.setReducedMotion(true);
    scene.setValues(&values);
    scene.setPanel(panelOf(R"({"id":"p","kind":"pipe","rect":[10,10,180,60],"thickness":16,"flow":"q"})"));
    values.set(QStringLiteral("q"), Value::ofReal(1));
    scene.refresh(0);
    const QImage forward = scene.picture();
    values.set(QStringLiteral("q"), Value::ofReal(-1));
    scene.refresh(0);
    EXPECT_NE(forward, scene.picture());
    scene.setValues(nullptr);
}

} // namespace
} // namespace plc::hmi
