// Every code that the check of panels can give, with a project that breaks the rule and the nearest one that keeps it.
// A rule without a row fails here.
#include "hmi/check/standard_check.h"
#include "hmi/model/errors.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include <set>

namespace plc::hmi {
namespace {

/// Of a project with one panel, a table of texts in English and German, and a picture that is none.
struct Tried {
    CheckInput input;
    QTemporaryDir folder;
    Tried() {
        QFile file(folder.filePath(QStringLiteral("words.png")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("no picture");
        texts("");
        input.folder = folder.path();
    }
    Tried& panel(const std::string& elements, const std::string& name = "main", const std::string& more = "") {
        Result<Panel> read = Panel::parse("{" + more + "\"elements\": [" + elements + "]}", toQString(Json(name)));
        EXPECT_TRUE(read) << read.error().english();
        input.panels.push_back({QString::fromStdString(name), *read});
        return *this;
    }
    Tried& texts(const std::string& rows, const std::string& header = "key,comment,en,de\n", const QString& font = {}) {
        LanguageSettings settings;
        settings.languages = QStringList{"en", "de"};
        if (!font.isEmpty()) settings.font = font;
        Result<TextTable> table = TextTable::parse(header + rows, QStringLiteral("hmi/texts.csv"));
        EXPECT_TRUE(table);
        input.texts = TextCatalog(*table, settings);
        return *this;
    }
    Tried& alarms(const std::string& list) {
        input.alarms = *AlarmFile::parse("{\"alarms\":[" + list + "]}", QString());
        input.hasAlarms = true;
        return *this;
    }
    Tried& standard(const std::string& settings = "{}") {
        input.standard = StandardSettings::fromJson(Json::parse(settings));
        input.startPanel = input.panels.front().name;
        return *this;
    }
    std::set<std::string> codes() const {
        std::set<std::string> out;
        for (const Finding& one : checkPanels(input)) out.insert(one.code().toStdString());
        return out;
    }
};

using Make = std::function<void(Tried&)>;
struct Row {
    int code;
    Make good, bad;
};

/// One element on the only panel.
Make element(const std::string& fields, const std::string& more = "") {
    return [=](Tried& t) {
        t.panel(R"({"id":"a","rect":[0,0,200,60],)" + fields + "}" + (more.empty() ? "" : "," + more));
    };
}
/// The same under the check against the standards, where the panel is not the first one.
Make held(const std::string& fields, const std::string& more = "", const std::string& settings = "{}") {
    return [=](Tried& t) {
        element(fields, more)(t);
        t.standard(settings).input.startPanel.clear();
    };
}
Make texts(const std::string& fields, const std::string& rows) {
    return [=](Tried& t) {
        element(fields)(t);
        t.texts(rows);
    };
}

std::string buttons(const char* text) {
    std::string out = R"({"id":"t","kind":"text","rect":[0,0,400,40],"text":")" + std::string(text) + "\"}";
    for (const char* name : {"1", "2", "3"})
        out += std::string(R"(,{"id":"b)") + name + R"(","kind":"button","rect":[0,)" + name +
               R"(00,120,48],"text":"S)" + name + R"(","target":"M.s)" + name + "\"}";
    return out;
}

std::string numbers(int count) {
    std::string out;
    for (int i = 0; i < count; ++i)
        out += std::string(i ? "," : "") + R"({"id":"n)" + std::to_string(i) + R"(","kind":"number","rect":[)" +
               std::to_string(i % 20 * 50) + "," + std::to_string(i / 20 * 30) + R"(,48,28],"value":"M.x"})";
    return out;
}

Make linked(const std::string& second) {
    return [=](Tried& t) {
        t.panel(R"({"id":"g","kind":"button","rect":[0,0,120,48],"action":"panel","panel":"two"},
                   {"id":"h","kind":"button","rect":[200,0,120,48],"action":"home"})")
            .panel(second, "two")
            .standard();
    };
}

Make urgent(int count, const std::string& help, const std::string& list) {
    return [=](Tried& t) {
        std::string out;
        for (int i = 0; i < 12; ++i)
            out += std::string(i ? "," : "") + R"({"id":"a)" + std::to_string(i) +
                   R"(","condition":"M.f","priority":)" + (i < count ? "1" : "3") + help + "}";
        t.panel(list).alarms(out).standard().input.standard.level = CheckLevel::Strict;
    };
}

std::vector<Row> findingRows() {
    const std::string label = R"("kind":"text","text":"@k")", say = R"("kind":"text","values":{"t":"x"},"text":"@k")";
    const Make noBinding = [](Tried& t) {
        element(R"("kind":"lamp","value":"Mian.on")")(t);
        t.input.checkBinding = [](const QString& expression, std::string_view, bool) -> Message {
            return expression.startsWith(QLatin1String("Mian")) ? errors::NoSuchRole(std::string("Mian")) : Message();
        };
    };
    const Make binding = [=](Tried& t) {
        noBinding(t);
        t.input.checkBinding = [](const QString&, std::string_view, bool) { return Message(); };
    };
    const auto placed = [](const std::string& arguments, const std::string& inner) {
        return [=](Tried& t) {
            t.panel(R"({"id":"v","kind":"faceplate","panel":"valve","rect":[0,0,99,99],"arguments":{)" + arguments +
                    "}}")
                .panel(inner, "valve", R"("parameters":[{"name":"title","type":"text"}],)");
        };
    };
    const auto framed = [](const std::string& frame) {
        return [=](Tried& t) { t.panel("").panel(frame, "around").input.frame = QStringLiteral("around"); };
    };
    const auto forRole = [](const char* role) {
        return [=](Tried& t) {
            element(std::string(R"("kind":"button","target":"b","text":"1","access":")") + role + '"')(t);
            t.input.hasPeople = true;
            t.input.roles = QStringList{"service"};
        };
    };
    const auto classed = [](const char* name) {
        return [=](Tried& t) {
            t.panel("").input.alarms = *AlarmFile::parse(
                std::string(R"({"classes":[{"name":"fault"}],"alarms":[{"id":"a","condition":"x","class":")") + name +
                    "\"}]}",
                QString());
            t.input.hasAlarms = true;
        };
    };
    const auto speaking = [](const char* tag) {
        return [=](Tried& t) {
            LanguageSettings settings;
            settings.languages = QStringList{QStringLiteral("en"), QString::fromLatin1(tag)};
            t.panel("").input.texts = TextCatalog(TextTable(), settings);
        };
    };
    return {
        {16, speaking("sr-Latn"), speaking("xx,yy")},
        {16, speaking("ar-u-nu-latn"), speaking("german")},
        {16, speaking("qps-ploc"), speaking("xx")},
        {1, texts(label, "k,,Hello,Hallo\n"), texts(label, "")},
        {2, texts(label, "k,,Hello,Hallo\n"), texts(label, "k,,Hello,\n")},
        {3, texts(label, "k,,Hello,Hallo\n"), texts(R"("kind":"lamp")", "k,,Hello,Hallo\n")},
        {4, texts(say, "k,,T {t},T {t}\n"), texts(say, "k,,T {t},T\n")},
        {5, texts(say, "k,,T {t},T {t}\n"), texts(label, "k,,T {t},T {t}\n")},
        {6, texts(say, "k,,T {t},T {t}\n"), texts(say, "k,,T {t,T {t\n")},
        {7, texts(R"("kind":"button","text":"@k")", "k,,Stop,Halt\n"),
         texts(R"("kind":"button","text":"@k")", "k,,Stop,Notausschalterverriegelungsanzeige\n")},
        {8, element(R"("kind":"text","text":"-> 5")"), element(R"("kind":"text","text":"Hello")")},
        {9, texts(label, "k,,Hello,Hallo\n"), texts(label, "k,,Hello,\xF4\x8F\xBF\xBD\n")},
        {10, [](Tried& t) { t.panel(""); },
         [](Tried& t) { t.panel("").texts("", "key,comment,en,de\n", "No Such Font"); }},
        {11, element(R"("kind":"lamp")"), element(R"("kind":"hologram")")},
        {12, binding, noBinding},
        {13, element(R"("kind":"button","icon":"home","action":"panel","panel":"main")"),
         element(R"("kind":"button","icon":"home","action":"panel","panel":"other")")},
        {14, element(R"("kind":"image")"), element(R"("kind":"image","file":"gone.png")")},
        {15, classed("fault"), classed("hint")},
        {16, element(R"("kind":"button","icon":"home","action":"language","tag":"de")"),
         element(R"("kind":"button","icon":"home","action":"language","tag":"fr")")},
        {17, element(R"("kind":"lamp")"),
         [](Tried& t) { t.panel(R"({"id":"a","kind":"lamp","rect":[5000,0,100,50]})"); }},
        {18, element(R"("kind":"number","format":"%d")"), element(R"("kind":"number","format":"%q")")},
        {19, placed(R"("title":"V1")", ""), placed(R"("title":"V1","colour":"red")", "")},
        {20, placed(R"("title":"V1")", ""),
         placed(R"("title":"V1")", R"({"id":"i","kind":"faceplate","panel":"valve","rect":[0,0,20,20]})")},
        {21, forRole("service"), forRole("captain")},
        {22, framed(R"({"id":"r","kind":"panelArea","rect":[0,60,900,500]})"), framed("")},
        {31, element(R"("kind":"image")"), element(R"("kind":"image","file":"words.png")")},
        {32, element(R"("kind":"gauge","ticks":10)"), element(R"("kind":"gauge","ticks":100000000)")},
        {33, element(R"("kind":"lamp","value":"b")"), element(R"("kind":"lamp","vlaue":"b")")},
        {34, element(R"("kind":"lamp","blink":true)"), element(R"("kind":"lamp","blink":"yes")")},
        {35, element(R"("kind":"lamp","onColor":"green")"), element(R"("kind":"lamp","onColor":"gren")")},
        {36, element(R"("kind":"bar","min":0,"max":100)"), element(R"("kind":"bar","min":100,"max":0)")},
        {37, element(R"("kind":"lamp")"), element(R"("kind":"lamp","parent":"g")")},
        {38, texts(label, "k,,Hello,Hallo\n"),
         [=](Tried& t) {
             element(label)(t);
             t.texts("k,,Hello,Hallo,Bonjour\n", "key,comment,en,de,fr\n");
         }},
        {39,
         element(R"("kind":"switch","target":"b","onText":"1")",
                 R"({"id":"t","kind":"text","rect":[0,64,200,40],"text":"Pump"})"),
         element(R"("kind":"slider","target":"b")")},
        {100, held(R"("kind":"rectangle")", "", R"({"checks":{"level":"basic"}})"),
         held(R"("kind":"rectangle")", "", R"({"checks":{"level":"hard"}})")},
    };
}

std::vector<Row> standardRows() {
    const std::string key = R"("kind":"button","text":"1","target":"M.b")",
                      list = R"({"id":"l","kind":"alarmBanner","rect":[0,0,560,48]})",
                      home = R"({"id":"h","kind":"button","rect":[200,0,120,48],"action":"home"})",
                      moved = R"({"id":"h","kind":"button","rect":[500,300,120,48],"action":"home"})";
    const std::string help = R"(,"help":"Call service")";
    const Make crowd = [](Tried& t) { t.panel(numbers(260)).standard(); };
    const Make few = [](Tried& t) { t.panel(numbers(150)).standard(); };
    const Make hint = [](Tried& t) { t.panel(buttons("Press S1 and watch the belt.")).standard(); };
    const Make noHint = [](Tried& t) { t.panel(buttons("Belt")).standard(); };
    const Make small = [](Tried& t) {
        t.panel(R"({"id":"a","kind":"button","rect":[0,0,40,16],"text":"1","target":"M.b"},
                   {"id":"b","kind":"button","rect":[0,18,40,16],"text":"2","target":"M.c"})")
            .standard();
    };
    return {
        {101, held(R"("kind":"rectangle","fill":"off")"), held(R"("kind":"rectangle","fill":"green")")},
        {102, held(R"("kind":"rectangle","fill":"alarm","visible":"M.fault")"),
         held(R"("kind":"rectangle","fill":"alarm")")},
        {103, held(R"("kind":"lamp","value":"M.on","label":"On")"), held(R"("kind":"lamp","value":"M.on")")},
        {104, held(R"("kind":"text","text":"L","textColor":"muted")"),
         held(R"("kind":"text","text":"L","textColor":"faint")")},
        {105, held(R"("kind":"text","text":"L","fontSize":12)"), held(R"("kind":"text","text":"L","fontSize":9)")},
        {106, few, crowd},
        {107, linked(home), linked("")},
        {108, linked(home), linked(moved)},
        {109, held(key), small},
        {110, held(key, R"({"id":"b","kind":"button","rect":[200,0,80,48],"text":"2","target":"M.c"})"),
         held(key, R"({"id":"b","kind":"button","rect":[160,0,80,48],"text":"2","target":"M.c"})")},
        {111, held(R"("kind":"number","value":"M.x")"), held(R"("kind":"number")")},
        {112, held(R"("kind":"numberEntry","target":"M.x","minimum":"0","maximum":"9")"),
         held(R"("kind":"numberEntry","target":"M.x","minimum":"0")")},
        {113, held(key + R"(,"access":"service","critical":true)"), held(key + R"(,"access":"service")")},
        {114, urgent(1, help, list), urgent(1, help, "")},
        {115, urgent(1, help, list), urgent(1, "", list)},
        {116, urgent(1, help, list), urgent(12, help, list)},
        {117, hint, noHint},
    };
}

TEST(EveryRule, HasAPanelThatBreaksItAndOneThatKeepsIt) {
    std::vector<Row> rows = findingRows();
    for (Row& row : standardRows()) rows.push_back(std::move(row));
    std::set<int> known;
    for (const Row& row : rows) {
        const std::string code = "H" + std::to_string(1000 + row.code);
        known.insert(row.code);
        for (const bool isGood : {true, false}) {
            Tried tried;
            (isGood ? row.good : row.bad)(tried);
            const std::set<std::string> found = tried.codes();
            std::string all;
            for (const std::string& one : found) all += one + " ";
            EXPECT_EQ(found.count(code) != 0, !isGood) << code << (isGood ? ", good: " : ", bad: ") << all;
        }
    }
    for (size_t i = 0; i < standardRules().size(); ++i)
        EXPECT_TRUE(known.count(101 + static_cast<int>(i))) << "no panels for " << standardRules()[i].name;
    // H1000 is a file that cannot be read, H1023 a recipe and H1040 a recorded value: test_hmi has them.
    constexpr int kRecipe = 23, kRange = 40;
    for (int code = 1; code < kRange; ++code) {
        if (code >= kRecipe && code <= static_cast<int>(FindingKind::BadPicture)) continue;
        EXPECT_TRUE(known.count(code)) << "no panels for H" << 1000 + code;
    }
}

} // namespace
} // namespace plc::hmi
