// The check of panels and texts: each rule with a project that breaks it, and one that does not.
#include "hmi/check/panel_check.h"
#include "runtime/base/messages.h"

#include <QStringList>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

CheckInput project(const std::string& elements, const std::string& csv) {
    CheckInput input;
    LanguageSettings settings;
    settings.languages = QStringList{"en", "de"};
    Result<TextTable> table = TextTable::parse(csv, QStringLiteral("hmi/texts.csv"));
    EXPECT_TRUE(table);
    input.texts = TextCatalog(*table, settings);
    Result<Panel> panel = Panel::parse("{\"elements\": [" + elements + "]}", QStringLiteral("main"));
    EXPECT_TRUE(panel) << panel.error().english();
    input.panels.push_back({QStringLiteral("main"), *panel});
    return input;
}

std::string kinds(const std::vector<Finding>& found) {
    QStringList out;
    for (const Finding& one : found) out += one.code() + (one.language.isEmpty() ? QString() : u'/' + one.language);
    out.sort();
    return out.join(u' ').toStdString();
}

TEST(PanelCheck, EachRuleHasAProjectThatBreaksIt) {
    const std::string header = "key,comment,en,de\n";
    const struct {
        const char* name;
        std::string elements, rows, expected;
    } rows[] = {
        {"good", R"({"id":"a","kind":"text","rect":[0,0,200,40],"text":"@k"})", "k,,Hello,Hallo\n", ""},
        {"missing key", R"({"id":"a","kind":"text","rect":[0,0,200,40],"text":"@gone"})", "", "H1001"},
        {"missing translation", R"({"id":"a","kind":"text","rect":[0,0,200,40],"text":"@k"})", "k,,Hello,\n",
         "H1002/de"},
        {"orphan key", "", "k,,Hello,Hallo\n", "H1003"},
        {"placeholders differ", R"({"id":"a","kind":"text","rect":[0,0,300,40],"text":"@k","values":{"t":"x"}})",
         "k,,T {t},T\n", "H1004/de"},
        {"value missing", R"({"id":"a","kind":"text","rect":[0,0,300,40],"text":"@k"})", "k,,T {t},T {t}\n",
         "H1005/de H1005/en"},
        {"open brace", R"({"id":"a","kind":"text","rect":[0,0,300,40],"text":"@k"})", "k,,T {t,T\n", "H1006/en"},
        {"too long", R"({"id":"a","kind":"button","rect":[0,0,100,50],"text":"@k"})",
         "k,,Stop,Notausschalterverriegelung\n", "H1007/de"},
        {"hard-coded", R"({"id":"a","kind":"text","rect":[0,0,300,40],"text":"Hello"})", "", "H1008"},
        {"a sign is no text", R"({"id":"a","kind":"text","rect":[0,0,300,40],"text":"-> 5"})", "", ""},
        {"unknown kind", R"({"id":"a","kind":"hologram","rect":[0,0,300,40]})", "", "H1011"},
        {"unknown panel",
         R"({"id":"a","kind":"button","rect":[0,0,100,50],"text":"","icon":"home","action":"panel","panel":"other"})",
         "", "H1013"},
        {"language button",
         R"({"id":"a","kind":"button","rect":[0,0,100,50],"text":"","icon":"home","action":"language","tag":"fr"})", "",
         "H1016"},
        {"outside", R"({"id":"a","kind":"lamp","rect":[5000,0,100,50]})", "", "H1017"},
        {"bad format", R"({"id":"a","kind":"number","rect":[0,0,100,50],"format":"%q"})", "", "H1018"},
        {"empty list", R"({"id":"a","kind":"combo","rect":[0,0,100,50],"list":"State"})", "", "H1001"},
        {"list", R"({"id":"a","kind":"combo","rect":[0,0,200,50],"list":"State"})",
         "State.0,,Off,Aus\nState.1,,On,Ein\n", ""},
        {"list too long", R"({"id":"a","kind":"combo","rect":[0,0,100,50],"list":"State"})",
         "State.0,,Off,Ausgeschaltet und verriegelt\n", "H1007/de"},
        {"the head of a table is cut",
         R"({"id":"t","kind":"table","rect":[0,0,300,200],"columns":[{"title":"@k","width":1},{"title":"","width":5}]})",
         "k,,n,Betriebsstunden\n", "H1007/de"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(kinds(checkPanels(project(row.elements, header + row.rows))), row.expected) << row.name;
}

TEST(PanelCheck, AsksTheFrontEndForEveryBindingWithTheTypeItNeeds) {
    CheckInput input = project(
        R"({"id":"a","kind":"lamp","rect":[0,0,50,50],"value":"Mian.on","visible":"Main.s = Step#Fill","when":[{"if":"Main.fault"}]},
                                  {"id":"t","kind":"table","rect":[0,0,300,200],"columns":[{"value":"Main.r[#].v"},{"value":"Main.times[#] + T#10s"}]})",
        "key,comment,en,de\n");
    QStringList asked;
    input.checkBinding = [&](const QString& expression, std::string_view wanted, bool isTarget) -> Message {
        asked += expression + u':' + QString::fromStdString(std::string(wanted)) +
                 (isTarget ? QStringLiteral("!") : QString());
        return expression.startsWith(QStringLiteral("Mian"))
                   ? errors::NoVariableSuggest(Verbatim("Mian"), Verbatim("Main"))
                   : Message();
    };
    const std::vector<Finding> found = checkPanels(input);
    EXPECT_EQ(kinds(found), "H1012");
    EXPECT_EQ(found[0].property.toStdString(), "value");
    EXPECT_EQ(found[0].text().toStdString(),
              "hmi/main.panel.json: a.value: error H1012: there is no variable 'Mian'; did you mean 'Main'?");
    Finding ofFile = found[0];
    ofFile.element.clear();
    ofFile.property.clear();
    ofFile.line = 3;
    EXPECT_EQ(ofFile.text().toStdString(),
              "hmi/main.panel.json:3: error H1012: there is no variable 'Mian'; did you mean 'Main'?");
    EXPECT_EQ(asked.join(u' ').toStdString(),
              "Main.s = Step#Fill:bool Main.fault:bool Mian.on:bool Main.r[1].v:any! Main.times[1] + T#10s:any!");
}

TEST(PanelCheck, MeasuresThePseudoLanguageToo) {
    CheckInput input =
        project(R"({"id":"a","kind":"button","rect":[0,0,70,44],"text":"@k"})", "key,comment,en,de\nk,,Start,Start\n");
    EXPECT_EQ(kinds(checkPanels(input)), "");
    input.languages = QStringList{kPseudoTag};
    EXPECT_EQ(kinds(checkPanels(input)), "H1007/qps-ploc");
}

TEST(PanelCheck, AMissingFontIsAnError) {
    CheckInput input = project("", "key,comment,en,de\n");
    LanguageSettings settings = input.texts.settings();
    settings.font = QStringLiteral("No Such Font At All");
    input.texts.setSettings(settings);
    EXPECT_EQ(kinds(checkPanels(input)), "H1010");
}

TEST(PanelCheck, ChecksAlarmsAndTheListsThatShowThem) {
    CheckInput input =
        project(R"({"id":"l","kind":"alarmList","rect":[0,0,300,200]})",
                "key,comment,en,de\nload,,Overload,Der Motor wurde wegen Überlast abgeschaltet und bleibt aus\n");
    input.hasAlarms = true;
    input.alarms = *AlarmFile::parse(
        R"({"classes":[{"name":"fault"}],"alarms":[{"id":"a","condition":"x","class":"hint","text":"@load"},{"id":"b","text":"@gone"}]})",
        QString());
    // Of the list's own words "Alarm" is cut in both languages, "Acknowledge all" in English.
    EXPECT_EQ(kinds(checkPanels(input)), "H1001 H1007/de H1007/de H1007/en H1007/en H1012 H1015");
}

} // namespace
} // namespace plc::hmi
