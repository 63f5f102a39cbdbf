// The check against ISA-101 and ISA-18.2: each rule with a panel that keeps it and one that breaks it, the project's
// settings, and the edits that correct what was found.
#include "hmi/check/standard_check.h"
#include "hmi/view/paint/colour_sight.h"

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

NamedPanel panelOf(const QString& name, const std::string& elements, const std::string& more = "") {
    Result<Panel> panel = Panel::parse("{" + more + "\"elements\": [" + elements + "]}", name);
    EXPECT_TRUE(panel) << panel.error().english();
    return {name, *panel};
}

CheckInput project(std::vector<NamedPanel> panels, const std::string& settings = "{}") {
    CheckInput input;
    input.panels = std::move(panels);
    input.startPanel = input.panels.front().name;
    input.standard = StandardSettings::fromJson(Json::parse(settings));
    return input;
}

std::string codes(const std::vector<Finding>& found) {
    QStringList out;
    for (const Finding& one : found) out += one.code() + u' ' + one.element + u'.' + one.property;
    return out.join(QStringLiteral(", ")).toStdString();
}

std::string findings(const CheckInput& input) {
    std::vector<Finding> all;
    for (const NamedPanel& panel : input.panels)
        for (Finding& one : checkStandard(input, panel)) all.push_back(std::move(one));
    for (Finding& one : checkStandardOfAll(input)) all.push_back(std::move(one));
    return codes(all);
}

/// Not the start panel of its project, which has a rule of its own.
std::string onOnePanel(const std::string& elements, const std::string& settings = "{}") {
    CheckInput input = project({panelOf(QStringLiteral("main"), elements)}, settings);
    input.startPanel.clear();
    return findings(input);
}

TEST(StandardCheck, EachRuleHasAGoodAndABadPanel) {
    const struct {
        const char* name;
        std::string elements, expected;
    } rows[] = {
        {"a grey drawing", R"({"id":"a","kind":"rectangle","rect":[0,0,80,80],"fill":"off"})", ""},
        {"a loud drawing", R"({"id":"a","kind":"rectangle","rect":[0,0,80,80],"fill":"green"})", "H1101 a.fill"},
        {"loud by its value", R"({"id":"a","kind":"ellipse","rect":[0,0,80,80],"fill":"#00ff40"})", "H1101 a.fill"},
        {"earth is quiet", R"({"id":"a","kind":"ellipse","rect":[0,0,80,80],"fill":"#b98a4e"})", ""},
        {"red all the time", R"({"id":"a","kind":"button","rect":[0,0,80,50],"color":"red","target":"M.stop"})",
         "H1102 a.color"},
        {"red when something is wrong",
         R"({"id":"a","kind":"rectangle","rect":[0,0,80,80],"fill":"alarm","visible":"M.fault"})", ""},
        {"an edge that is not drawn",
         R"({"id":"a","kind":"rectangle","rect":[0,0,80,80],"line":"red","lineStyle":"none"})", ""},
        {"lamps told apart by brightness", R"({"id":"a","kind":"lamp","rect":[0,0,40,40],"value":"M.on","label":"On"})",
         ""},
        {"red or blue, as bright as each other",
         R"({"id":"a","kind":"lamp","rect":[0,0,40,40],"value":"M.on","label":"On","onColor":"red","offColor":"blue"})",
         "H1101 a.offColor, H1103 a.onColor"},
        {"a lamp without words", R"({"id":"a","kind":"lamp","rect":[0,0,40,40],"value":"M.on"})", "H1103 a.label"},
        {"a lamp with words beside it",
         R"({"id":"a","kind":"lamp","rect":[0,0,40,40],"value":"M.on"},
            {"id":"t","kind":"text","rect":[48,0,90,40],"text":"Pump"})",
         ""},
        {"states with words",
         R"({"id":"a","kind":"multiState","rect":[0,0,160,44],"value":"M.s",
             "states":[{"value":"0","text":"Off","color":"off"},{"value":"1","text":"On","color":"grey"}]})",
         ""},
        {"states with the same words",
         R"({"id":"a","kind":"multiState","rect":[0,0,160,44],"value":"M.s",
             "states":[{"value":"0","text":"Pump","color":"off"},{"value":"1","text":"Pump","color":"grey"}]})",
         "H1103 a.states[1].color"},
        {"faint on grey", R"({"id":"a","kind":"text","rect":[0,0,160,40],"text":"Level","textColor":"faint"})",
         "H1104 a.textColor"},
        {"muted on the background", R"({"id":"a","kind":"text","rect":[0,0,160,40],"text":"L","textColor":"muted"})",
         ""},
        {"white on what lies below it",
         R"({"id":"b","kind":"rectangle","rect":[0,0,200,80],"fill":"#222222"},
            {"id":"a","kind":"text","rect":[0,0,160,40],"text":"Level","textColor":"text"})",
         "H1104 a.textColor"},
        {"letters that can be read", R"({"id":"a","kind":"text","rect":[0,0,160,40],"text":"L","fontSize":12})", ""},
        {"small letters", R"({"id":"a","kind":"text","rect":[0,0,160,40],"text":"L","fontSize":9})",
         "H1105 a.fontSize"},
        {"a key for a finger", R"({"id":"a","kind":"button","rect":[0,0,40,40],"text":"1","target":"M.b"})", ""},
        {"a small key with room around it",
         R"({"id":"a","kind":"button","rect":[0,20,40,20],"text":"1","target":"M.b"})", ""},
        {"keys for a needle",
         R"({"id":"a","kind":"button","rect":[0,0,40,16],"text":"1","target":"M.b"},
            {"id":"b","kind":"button","rect":[0,18,40,16],"text":"2","target":"M.c"})",
         "H1109 a.rect, H1109 b.rect"},
        {"keys beside each other",
         R"({"id":"a","kind":"button","rect":[0,0,80,40],"text":"1","target":"M.b"},
            {"id":"b","kind":"button","rect":[80,0,80,40],"text":"2","target":"M.c"})",
         ""},
        {"a key over another",
         R"({"id":"a","kind":"button","rect":[0,0,80,40],"text":"1","target":"M.b"},
            {"id":"b","kind":"button","rect":[60,10,80,40],"text":"2","target":"M.c"})",
         "H1110 a.rect"},
        {"one of two is seen at a time",
         R"({"id":"a","kind":"button","rect":[0,0,80,40],"text":"1","target":"M.b","visible":"M.x"},
            {"id":"b","kind":"button","rect":[0,0,80,40],"text":"2","target":"M.c","visible":"NOT M.x"})",
         ""},
        {"nothing to show", R"({"id":"a","kind":"number","rect":[0,0,140,40]})", "H1111 a.value"},
        {"nothing to write", R"({"id":"a","kind":"switch","rect":[0,0,96,48],"onText":"On"})", "H1111 a.target"},
        {"a way without a goal", R"({"id":"a","kind":"button","rect":[0,0,96,48],"action":"popup"})", "H1111 a.panel"},
        {"acknowledging needs nothing", R"({"id":"a","kind":"button","rect":[0,0,96,48],"action":"acknowledge"})", ""},
        {"an entry with limits",
         R"({"id":"a","kind":"numberEntry","rect":[0,0,140,44],"target":"M.x","minimum":"0","maximum":"M.most"})", ""},
        {"an entry without an upper limit",
         R"({"id":"a","kind":"numberEntry","rect":[0,0,140,44],"target":"M.x","minimum":"0"})", "H1112 a.maximum"},
        {"for some only, and confirmed",
         R"({"id":"a","kind":"button","rect":[0,0,96,48],"target":"M.x","access":"service","critical":true})", ""},
        {"for some only, by one press",
         R"({"id":"a","kind":"button","rect":[0,0,96,48],"target":"M.x","access":"service"})", "H1113 a.critical"},
        {"a question is a confirmation",
         R"({"id":"a","kind":"button","rect":[0,0,96,48],"target":"M.x","access":"service","confirm":"Sure?"})", ""},
    };
    for (const auto& row : rows) EXPECT_EQ(onOnePanel(row.elements), row.expected) << row.name;
}

TEST(StandardCheck, AFaceplateIsMeasuredAsLargeAsItIsPlaced) {
    const NamedPanel valve =
        panelOf(QStringLiteral("valve"),
                R"({"id":"t","kind":"text","rect":[0,0,100,20],"text":"$title","fontSize":14},
                                        {"id":"b","kind":"button","rect":[0,40,60,48],"target":"$open"})",
                R"("size":[100,100],"parameters":[{"name":"title","type":"text"},{"name":"open"}],)");
    const auto placed = [&](const char* rect) {
        return findings(project(
            {panelOf(QStringLiteral("main"), std::string(R"({"id":"v","kind":"faceplate","panel":"valve","rect":)") +
                                                 rect + R"(,"arguments":{"title":"V1","open":"M.v1"}})"),
             valve}));
    };
    EXPECT_EQ(placed("[0,0,100,100]"), "");
    EXPECT_EQ(placed("[0,0,50,50]"), "H1105 v.rect, H1109 v.rect");
}

TEST(StandardCheck, APanelOfTooManyThingsIsCrowded) {
    const auto numbers = [](int count) {
        std::string out;
        for (int i = 0; i < count; ++i)
            out += std::string(i ? "," : "") + R"({"id":"n)" + std::to_string(i) + R"(","kind":"number","rect":[)" +
                   std::to_string(i % 20 * 50) + "," + std::to_string(i / 20 * 30) + R"(,48,28],"value":"M.x"})";
        return out;
    };
    EXPECT_EQ(onOnePanel(numbers(150)), "");
    EXPECT_EQ(onOnePanel(numbers(260)), "H1106 .");
}

TEST(StandardCheck, AStartPanelSaysWhatToPress) {
    const std::string buttons = R"({"id":"a","kind":"button","rect":[0,0,120,48],"text":"S1 Start","target":"M.s1"},
                                   {"id":"b","kind":"button","rect":[0,60,120,48],"text":"S2 Stop","target":"M.s2"},
                                   {"id":"c","kind":"button","rect":[0,440,120,48],"text":"S3 Reset","target":"M.s3"})";
    const auto withText = [&](const char* text) {
        return findings(
            project({panelOf(QStringLiteral("main"),
                             buttons + R"(,{"id":"t","kind":"text","rect":[0,200,400,40],"text":")" + text + "\"}")}));
    };
    const auto withState = [&](const char* text) {
        return findings(project({panelOf(
            QStringLiteral("main"), buttons + R"(,{"id":"s","kind":"multiState","rect":[0,120,160,44],"value":"M.s",
                "states":[{"value":"0","text":")" +
                                        text + R"("},{"value":"1","text":"Runs"}]})")}));
    };
    EXPECT_EQ(findings(project({panelOf(QStringLiteral("main"), buttons)})), "H1117 .");
    EXPECT_EQ(withText("Press S1 and watch the belt."), "");
    EXPECT_EQ(withText("按下按钮，观察皮带。"), "") << "written without spaces";
    EXPECT_EQ(withText("Conveyor with a rest"), "H1117 .") << "a title";
    EXPECT_EQ(withText("Wire of S1"), "H1117 .") << "a caption that names a control all the time";
    EXPECT_EQ(withText("Ready."), "H1117 .");
    EXPECT_EQ(withState("Ready: press S1"), "");
    EXPECT_EQ(withState("Stopped"), "H1117 .");
    EXPECT_EQ(withState("S1"), "H1117 .") << "the name of a state";
    EXPECT_EQ(findings(project({panelOf(QStringLiteral("main"), buttons.substr(0, buttons.rfind("},") + 1))})), "")
        << "start and stop speak for themselves";
}

TEST(StandardCheck, TheHintIsLookedForInTheFirstLanguage) {
    CheckInput input = project({panelOf(
        QStringLiteral("main"), R"({"id":"a","kind":"button","rect":[0,0,120,48],"text":"@start","target":"M.s1"},
            {"id":"b","kind":"button","rect":[0,60,120,48],"text":"@stop","target":"M.s2"},
            {"id":"c","kind":"button","rect":[0,440,120,48],"text":"@stop","target":"M.s3"},
            {"id":"s","kind":"multiState","rect":[0,120,160,44],"value":"M.s",
             "states":[{"value":"0","text":"@rest"},{"value":"1","text":"@runs"}]})")});
    TextTable table;
    for (const char* tag : {"en", "fr"}) table.addLanguage(QString::fromLatin1(tag));
    const auto say = [&](const char* key, const char* english, const char* french) {
        table.setText(QString::fromLatin1(key), QStringLiteral("en"), QString::fromUtf8(english));
        table.setText(QString::fromLatin1(key), QStringLiteral("fr"), QString::fromUtf8(french));
    };
    say("start", "Start", "Marche");
    say("stop", "Stop", "Arrêt");
    say("rest", "At rest", "À l’arrêt");
    say("runs", "Running", "En marche");
    LanguageSettings settings;
    settings.languages = {QStringLiteral("en"), QStringLiteral("fr")};
    input.texts = TextCatalog(table, settings);
    EXPECT_EQ(findings(input), "H1117 .") << "“En marche” is the name of a state";
    table.setText(QStringLiteral("rest"), QStringLiteral("en"), QStringLiteral("Press Start"));
    input.texts.setTable(table);
    EXPECT_EQ(findings(input), "");
}

TEST(StandardCheck, TheHintMayBeOnTheFrameOrInAFaceplate) {
    const std::string buttons = R"({"id":"a","kind":"button","rect":[0,0,120,48],"text":"Open","target":"M.s1"},
                                   {"id":"b","kind":"button","rect":[0,60,120,48],"text":"Close","target":"M.s2"},
                                   {"id":"c","kind":"button","rect":[0,440,120,40],"text":"Reset","target":"M.s3"})",
                      hint =
                          R"({"id":"t","kind":"text","rect":[0,0,400,40],"text":"Press Open and wait for the lamp."})",
                      back = R"(,{"id":"k","kind":"button","rect":[0,500,120,48],"action":"back"})",
                      area = R"(,{"id":"r","kind":"panelArea","rect":[0,60,900,500]})",
                      way = R"(,{"id":"g","kind":"button","rect":[300,0,120,48],"action":"panel","panel":"two"})";
    const NamedPanel start = panelOf(QStringLiteral("main"), buttons + way);
    EXPECT_EQ(findings(project({start, panelOf(QStringLiteral("two"), hint + back)})), "H1117 .")
        << "another panel is not seen yet";
    CheckInput framed = project(
        {start, panelOf(QStringLiteral("two"), buttons + back), panelOf(QStringLiteral("around"), hint + area)});
    framed.frame = QStringLiteral("around");
    EXPECT_EQ(findings(framed), "") << "panels behind the start panel need none";
    const std::string valve =
        R"({"id":"v","kind":"faceplate","panel":"valve","rect":[400,0,400,100],"arguments":{"way":"M.open"}})";
    EXPECT_EQ(findings(project(
                  {panelOf(QStringLiteral("main"), buttons + "," + valve),
                   panelOf(QStringLiteral("valve"), hint, R"("size":[400,100],"parameters":[{"name":"way"}],)")})),
              "");
}

TEST(StandardCheck, EveryPanelIsReachedAndLeftAgain) {
    const std::string back = R"({"id":"b","kind":"button","rect":[0,500,120,48],"action":"back"})";
    const auto to = [](const char* panel) {
        return std::string(R"({"id":"g","kind":"button","rect":[0,0,120,48],"action":"panel","panel":")") + panel +
               "\"}";
    };
    EXPECT_EQ(findings(project({panelOf(QStringLiteral("main"), to("pumps")), panelOf(QStringLiteral("pumps"), back)})),
              "");
    EXPECT_EQ(findings(project({panelOf(QStringLiteral("main"), to("pumps")), panelOf(QStringLiteral("pumps"), back),
                                panelOf(QStringLiteral("lost"), back)})),
              "H1107 .");
    EXPECT_EQ(findings(project({panelOf(QStringLiteral("main"), ""), panelOf(QStringLiteral("new"), "")})),
              "H1107 ."); // once: a way back from where nobody gets is not missed yet
    EXPECT_EQ(findings(project({panelOf(QStringLiteral("main"), to("trap")), panelOf(QStringLiteral("trap"), "")})),
              "H1107 .");
    EXPECT_EQ(findings(project({panelOf(QStringLiteral("a"), to("b")), panelOf(QStringLiteral("b"), to("c")),
                                panelOf(QStringLiteral("c"), to("d")), panelOf(QStringLiteral("d"), to("e")),
                                panelOf(QStringLiteral("e"), to("a"))})),
              "H1107 .");
}

TEST(StandardCheck, TheSameKeyHasTheSamePlaceOnEveryPanel) {
    const auto home = [](int x) {
        return R"({"id":"h","kind":"button","rect":[)" + std::to_string(x) +
               R"(,500,120,48],"action":"home"},{"id":"g","kind":"button","rect":[0,0,120,48],"action":"panel","panel":"two"})";
    };
    EXPECT_EQ(findings(project({panelOf(QStringLiteral("one"), home(8)), panelOf(QStringLiteral("two"), home(8))})),
              "");
    const CheckInput moved =
        project({panelOf(QStringLiteral("one"), home(8)), panelOf(QStringLiteral("two"), home(400))});
    EXPECT_EQ(findings(moved), "H1108 h.rect");
    Panel fixed = moved.panels[1].panel;
    applyTo(fixed, fixesOf(checkStandardOfAll(moved), QStringLiteral("hmi/two.panel.json"), fixed));
    EXPECT_EQ(fixed.find(QStringLiteral("h"))->rect(), QRectF(8, 500, 120, 48));
}

TEST(StandardCheck, AlarmsAreShownAndNotAllUrgent) {
    const auto alarms = [](int urgent, const char* help) {
        std::string out = R"({"alarms":[)";
        for (int i = 0; i < 12; ++i)
            out += std::string(i ? "," : "") + R"({"id":"a)" + std::to_string(i) +
                   R"(","condition":"M.f","priority":)" + (i < urgent ? "1" : "3") + help + "}";
        return *AlarmFile::parse(out + "]}", QStringLiteral("hmi/alarms.json"));
    };
    const std::string list = R"({"id":"l","kind":"alarmBanner","rect":[0,0,560,48]})";
    CheckInput input = project({panelOf(QStringLiteral("main"), list)});
    input.hasAlarms = true;
    input.alarms = alarms(12, "");
    EXPECT_EQ(findings(input), "") << "help and shares belong to the strict level";
    input.standard.level = CheckLevel::Strict;
    input.alarms = alarms(12, R"(,"help":"Call service")");
    EXPECT_EQ(findings(input), "H1116 .");
    input.alarms = alarms(1, R"(,"help":"Call service")");
    EXPECT_EQ(findings(input), "");
    input.alarms = alarms(1, "");
    EXPECT_NE(findings(input).find("H1115 a0.help"), std::string::npos);
    input = project({panelOf(QStringLiteral("main"), "")});
    input.hasAlarms = true;
    input.alarms = alarms(1, "");
    EXPECT_EQ(findings(input), "H1114 .");
}

TEST(StandardCheck, TheProjectChoosesLevelDistanceAndWhatIsOffWithAReason) {
    const std::string loud = R"({"id":"a","kind":"rectangle","rect":[0,0,80,80],"fill":"green"})",
                      small = R"({"id":"s","kind":"text","rect":[200,0,80,40],"text":"L","fontSize":12})";
    EXPECT_EQ(onOnePanel(loud, R"({"checks":{"level":"basic"}})"), "");
    EXPECT_EQ(onOnePanel(loud, R"({"checks":{"level":"off"}})"), "");
    EXPECT_EQ(onOnePanel(loud, R"({"checks":{"off":{"normal-grey":"the goods are green"}}})"), "");
    EXPECT_EQ(onOnePanel(loud, R"({"checks":{"off":{"normal-grey@main/a":"the goods are green"}}})"), "");
    EXPECT_EQ(onOnePanel(loud, R"({"checks":{"off":{"normal-grey@main/b":"the goods are green"}}})"), "H1101 a.fill");
    EXPECT_EQ(onOnePanel(loud, R"({"checks":{"off":{"normal-grey":" "}}})"),
              "H1101 a.fill, H1100 .checks.off.normal-grey");
    EXPECT_EQ(onOnePanel(small), "");
    EXPECT_EQ(onOnePanel(small, R"({"checks":{"viewingDistance":2000}})"), "H1105 s.fontSize");
    const CheckInput strict =
        project({panelOf(QStringLiteral("main"), loud)}, R"({"checks":{"errors":["normal-grey"]}})");
    ASSERT_EQ(checkStandard(strict, strict.panels[0]).size(), 1u);
    EXPECT_TRUE(checkStandard(strict, strict.panels[0])[0].isError);
    const std::string press = R"({"id":"b","kind":"button","rect":[0,0,80,48],"target":"Plant.DoseNow"})";
    EXPECT_EQ(onOnePanel(press), "");
    EXPECT_EQ(onOnePanel(press, R"({"checks":{"critical":["plant.dose*"]}})"), "H1113 b.critical");
}

TEST(StandardCheck, WrongSettingsAreReportedAndChangeNothing) {
    for (const auto& [settings, place] :
         {std::pair{R"({"checks":7})", ".checks"}, std::pair{R"({"checks":{"level":"hard"}})", ".checks.level"},
          std::pair{R"({"checks":{"lvel":"basic"}})", ".checks.lvel"},
          std::pair{R"({"checks":{"off":{"contrst":"why not"}}})", ".checks.off.contrst"},
          std::pair{R"({"checks":{"errors":"contrast"}})", ".checks.errors"},
          std::pair{R"({"checks":{"viewingDistance":-5}})", ".checks.viewingDistance"},
          std::pair{R"({"checks":{"pixelPitch":"small"}})", ".checks.pixelPitch"}}) {
        EXPECT_EQ(onOnePanel("", settings), std::string("H1100 ") + place) << settings;
        EXPECT_EQ(StandardSettings::fromJson(Json::parse(settings)).level, CheckLevel::Standard) << settings;
    }
}

TEST(StandardCheck, FixesCorrectWhatTheyAreGivenWith) {
    CheckInput input = project({panelOf(QStringLiteral("main"),
                                        R"({"id":"a","kind":"rectangle","rect":[0,0,80,80],"fill":"green"},
                                           {"id":"b","kind":"button","rect":[200,0,60,40],"color":"red","target":"M.x","access":"service"},
                                           {"id":"t","kind":"text","rect":[0,200,160,40],"text":"L","textColor":"faint","fontSize":9})")});
    const std::vector<Finding> found = checkStandard(input, input.panels[0]);
    EXPECT_EQ(codes(found), "H1101 a.fill, H1102 b.color, H1104 t.textColor, H1105 t.fontSize, H1113 b.critical");
    for (const Finding& one : found) {
        EXPECT_FALSE(one.fix.isEmpty()) << one.text().toStdString();
        EXPECT_FALSE(one.why.isEmpty()) << one.text().toStdString();
    }
    const std::string before = input.panels[0].panel.write();
    const Edit back =
        applyTo(input.panels[0].panel, fixesOf(found, QStringLiteral("hmi/main.panel.json"), input.panels[0].panel));
    EXPECT_EQ(findings(input), "");
    applyTo(input.panels[0].panel, back);
    EXPECT_EQ(input.panels[0].panel.write(), before) << "undo of the fixes changes no byte";
}

TEST(StandardCheck, ColoursThatOnlyDifferInHueBecomeThoseOfTheKind) {
    CheckInput input = project(
        {panelOf(QStringLiteral("main"),
                 R"({"id":"a","kind":"lamp","label":"Pump","value":"M.x","onColor":"#00A000","offColor":"#FF0000"})")});
    const std::vector<Finding> found = checkStandard(input, input.panels[0]);
    ASSERT_NE(codes(found).find("H1103 a.onColor"), std::string::npos) << codes(found);
    applyTo(input.panels[0].panel, fixesOf(found, QStringLiteral("hmi/main.panel.json"), input.panels[0].panel));
    EXPECT_EQ(findings(input), "");
}

TEST(StandardCheck, TenThousandElementsInOnePlaceAreCheckedInReasonableTime) {
    std::string elements;
    for (int i = 0; i < 10'000; ++i)
        elements += std::string(i ? "," : "") + R"({"id":"b)" + std::to_string(i) +
                    R"(","kind":"button","rect":[0,0,80,40],"target":"M.x"})";
    const CheckInput input = project({panelOf(QStringLiteral("main"), elements)});
    const size_t count = checkStandard(input, input.panels[0]).size();
    EXPECT_GE(count, 9'999u);
    EXPECT_LE(count, 20'000u) << "one finding each, not one for each pair";
}

TEST(ColourSight, FollowsTheFormulasOfWcag) {
    EXPECT_NEAR(contrast(Qt::black, Qt::white), 21, 1e-6);
    EXPECT_NEAR(contrast(QColor(0x77, 0x77, 0x77), Qt::white), 4.48, 0.01);
    EXPECT_NEAR(luminance(QColor(255, 0, 0)), 0.2126, 1e-4);
    EXPECT_TRUE(isAlarmColour(QStringLiteral("#ff2000")));
    EXPECT_FALSE(isAlarmColour(QStringLiteral("#7a5c34")));
    EXPECT_FALSE(isLoud(QStringLiteral("accent")));
}

} // namespace
} // namespace plc::hmi
