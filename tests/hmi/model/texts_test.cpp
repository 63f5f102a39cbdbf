// Operator texts: the table on disk, formats, placeholders, the fallback chain.
#include "hmi/texts/catalog.h"
#include "hmi/texts/system_texts.h"

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

TextTable table(const std::string& bytes) {
    Result<TextTable> parsed = TextTable::parse(bytes, QStringLiteral("texts.csv"));
    EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().english());
    return parsed ? *parsed : TextTable();
}

const std::string kCsv = "\xEF\xBB\xBFkey,comment,en,da,ar,zh-CN\r\n"
                         "start,,Start,Start,\xD8\xA8\xD8\xAF\xD8\xA1,\xE5\x90\xAF\xE5\x8A\xA8\r\n"
                         "temp,\"live, value\",\"{temp:%.1f} \xC2\xB0"
                         "C \"\"hot\"\"\",{temp:%.1f} grader,,\r\n"
                         "State.0,,Idle,Klar,,\r\n"
                         "State.1,,\"Two\nlines\",,,\r\n";

TEST(TextCsv, LoadingAndSavingChangesNoByte) { EXPECT_EQ(table(kCsv).write(), kCsv); }

TEST(TextCsv, ReadsSemicolonsAndTabsWithOrWithoutBom) {
    for (const char* text :
         {"key;comment;en\na;;x, y\n", "key\tcomment\ten\r\na\t\tx, y", "\xEF\xBB\xBFkey,comment,en\ra,,\"x, y\""})
        EXPECT_EQ(table(text).text(QStringLiteral("a"), QStringLiteral("en")).toStdString(), "x, y") << text;
}

TEST(TextCsv, RefusesWithTheLine) {
    for (const auto& [text, place] :
         {std::pair{"key,comment,en\na,,b\nc,,\xFFz\n", "texts.csv:3"},
          std::pair{"key,comment,en\na,,\"b\nc,,d\n", "texts.csv:2"},
          std::pair{"key,comment,en\na,,\"b\"c\n", "texts.csv:2"},
          std::pair{"key,comment,en\na,,b\na,,c\n", "texts.csv:3"}, std::pair{"name,text\na,b\n", "texts.csv:1"},
          std::pair{"key,comment,en\na,,b,c\n", "texts.csv:2"},
          std::pair{"key,comment,en\n\"a\n\nb\",,1\n,,c\n", "texts.csv:5"}}) {
        const Result<TextTable> parsed = TextTable::parse(text, QStringLiteral("texts.csv"));
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.error().place, place);
    }
}

TEST(TextCatalog, AsksTheLanguageItsParentAndTheFallbackChain) {
    LanguageSettings settings;
    settings.languages = QStringList{"en", "da", "zh-CN", "de-AT"};
    settings.fallback = QStringList{"da"};
    const TextCatalog catalog(table("key,comment,en,da,de\na,,A,B,C\nb,,A,B,\nc,,A,,\nd,,,,\n"), settings);
    const auto text = [&](const char* key, const char* tag) {
        return catalog.text(QLatin1String(key), QLatin1String(tag)).toStdString();
    };
    EXPECT_EQ(text("@a", "de-AT"), "C");
    EXPECT_EQ(text("@b", "de-AT"), "B");
    EXPECT_EQ(text("@c", "de-AT"), "A");
    EXPECT_EQ(text("@d", "en"), "‹d›");
    EXPECT_EQ(text("@gone", "en"), "‹gone›");
    EXPECT_EQ(text("plain", "en"), "plain");
    EXPECT_EQ(text("@@home", "en"), "@home");
}

TEST(TextCatalog, FillsPlaceholdersAsTheLanguageWritesNumbers) {
    LanguageSettings settings;
    settings.languages = QStringList{"en", "da"};
    const TextCatalog catalog(table(kCsv), settings);
    const auto value = [](const QString& name) {
        return name == QStringLiteral("temp") ? Value::ofReal(21.26) : Value();
    };
    EXPECT_EQ(catalog.fill(QStringLiteral("@temp"), QStringLiteral("en"), value).toStdString(), "21.3 °C \"hot\"");
    EXPECT_EQ(catalog.fill(QStringLiteral("@temp"), QStringLiteral("da"), value).toStdString(), "21,3 grader");
    EXPECT_EQ(catalog.fill(QStringLiteral("{{x}} {temp}"), QStringLiteral("en"), value).toStdString(), "{x} 21.26");
    EXPECT_EQ(catalog.listText(QStringLiteral("State"), 1, QStringLiteral("da")).toStdString(), "Two\nlines");
    EXPECT_TRUE(catalog.listText(QStringLiteral("State"), 2, QStringLiteral("da")).isEmpty());
}

TEST(TextFormat, KnowsPrintfAndTheFormOfTheBook) {
    const struct {
        Value value;
        const char *format, *tag, *shown;
    } rows[] = {
        {Value::ofReal(3.14159), "%.2f", "en", "3.14"},
        {Value::ofReal(3.14159), "%f5.2", "en", "\u20073.14"},
        {Value::ofReal(3.14159), "%.2f", "de", "3,14"},
        {Value::ofReal(-0.04), "%.1f", "en", "0.0"},
        {Value::ofReal(12345.6), "%'.0f", "en", "12,346"},
        {Value::ofInteger(7), "%05d", "en", "00007"},
        {Value::ofInteger(-7), "%05d", "en", "-0007"},
        {Value::ofInteger(7), "%+d", "en", "+7"},
        {Value::ofInteger(255), "16#%X", "en", "16#FF"},
        {Value::ofInteger(5), "%b", "en", "101"},
        {Value::ofInteger(42), "%.1f kg", "en", "42.0 kg"},
        {Value::ofReal(99.5), "%.0f%%", "en", "100%"},
        {Value::ofText(QStringLiteral("ab")), "<%s>", "en", "<ab>"},
        {Value::ofInstant(ValueKind::Time, 3723000000000), "", "en", "1 h 02 min 03 s"},
        {Value::ofInstant(ValueKind::Time, 1500000000), "%.1f s", "da", "1,5 s"},
        {Value::ofInstant(ValueKind::Time, 250000000), "", "en", "250 ms"},
        {Value::none({}), "%d", "en", "– –"},
    };
    for (const auto& row : rows)
        EXPECT_EQ(formatValue(row.value, QString::fromUtf8(row.format), localeOf(QLatin1String(row.tag))).toStdString(),
                  row.shown)
            << row.format;
}

TEST(TextFormat, DatesFollowTheLanguage) {
    const qint64 noon = 1704111845000000000; // 2024-01-01 12:24:05
    EXPECT_EQ(formatDate(noon, localeOf(QStringLiteral("de"))).toStdString(), "01.01.2024");
    EXPECT_EQ(formatDate(noon, localeOf(QStringLiteral("en-US"))).toStdString(), "1/1/2024");
    EXPECT_EQ(formatTime(noon, localeOf(QStringLiteral("de")), true).toStdString(), "12:24:05");
    EXPECT_EQ(formatTime(noon, localeOf(QStringLiteral("da")), true).toStdString(), "12.24.05");
    EXPECT_EQ(formatWeek(1735603200000000000, localeOf(QStringLiteral("da"))).toStdString(), "1"); // 31 December 2024
}

TEST(Language, UnitsFollowTheLanguageAndBack) {
    const LanguageSettings settings =
        LanguageSettings::fromJson(Json::parse(R"({"languages":["en-US","da"],"units":{"en-US":{"°C":"°F"}}})"));
    const UnitView view = settings.unitFor(QStringLiteral("en-US"), QStringLiteral("°C"));
    EXPECT_EQ(view.unit.toStdString(), "°F");
    EXPECT_DOUBLE_EQ(view.shown(100), 212);
    EXPECT_DOUBLE_EQ(view.raw(212), 100);
    EXPECT_EQ(settings.unitFor(QStringLiteral("da"), QStringLiteral("°C")).unit.toStdString(), "°C");
}

TEST(Language, TheVariableIsAPositionOrATag) {
    LanguageSettings settings;
    settings.languages = QStringList{"en-GB", "da", "de"};
    EXPECT_EQ(settings.tagOf(Value::ofInteger(1)).toStdString(), "da");
    EXPECT_EQ(settings.tagOf(Value::ofText(QStringLiteral("DE"))).toStdString(), "de");
    EXPECT_EQ(settings.tagOf(Value::ofText(QStringLiteral("en"))).toStdString(), "en-GB");
    EXPECT_TRUE(settings.tagOf(Value::ofInteger(9)).isEmpty());
    EXPECT_EQ(settings.valueOf(QStringLiteral("de"), ValueKind::Integer).toInteger(), 2);
}

TEST(Language, TheTextsOfThePanelItselfFollowTheLanguageAndTheTable) {
    const auto said = [](const TextCatalog& texts, const char* tag) {
        return systemText(texts, SystemText::Cancel, QLatin1String(tag)).toStdString();
    };
    LanguageSettings settings;
    settings.languages = QStringList{"de-AT", "da", "cs", "ar"};
    TextCatalog texts(TextTable(), settings);
    EXPECT_EQ(said(texts, "de-AT"), "Abbrechen");
    EXPECT_EQ(said(texts, "da"), "Annuller");
    EXPECT_EQ(said(texts, "ar"), "إلغاء");
    EXPECT_EQ(said(texts, "cs"), "Abbrechen"); // the first language of the project
    settings.fallback = QStringList{"fr"};
    texts.setSettings(settings);
    EXPECT_EQ(said(texts, "cs"), "Annuler");
    texts.setTable(*TextTable::parse("key,comment,da,cs\nhmi.cancel,,Fortryd,Storno\n", QString()));
    EXPECT_EQ(said(texts, "cs"), "Storno");
    EXPECT_EQ(said(texts, "da"), "Fortryd");
    EXPECT_EQ(systemText(TextCatalog(), SystemText::Cancel, QStringLiteral("xx")).toStdString(), "Cancel");
}

TEST(Language, ThePanelItselfSpeaksEveryLanguageOfTheExamples) {
    for (const char* tag : {"de", "da", "fr", "es", "nl", "it", "sv", "pl", "ar", "zh-CN"}) {
        LanguageSettings settings;
        settings.languages = QStringList{QLatin1String(tag)};
        const TextCatalog texts(TextTable(), settings);
        int same = 0;
        for (int i = 0; i <= static_cast<int>(SystemText::ConfirmRead); ++i) {
            const auto text = static_cast<SystemText>(i);
            const QString said = systemText(texts, text, QLatin1String(tag));
            const QString english = systemText(TextCatalog(), text, QStringLiteral("en"));
            same += said == english;
            EXPECT_FALSE(said.isEmpty()) << systemKey(text).toStdString() << ' ' << tag;
            EXPECT_EQ(said.count(QStringLiteral("%1")), english.count(QStringLiteral("%1"))) << said.toStdString();
        }
        EXPECT_LE(same, 4) << tag << ": words like OK, Alarm, No";
    }
}

TEST(Language, PseudoTextIsLongerAccentedAndKeepsPlaceholders) {
    const QString text = pseudoText(QStringLiteral("Motor {speed:%.1f} on"));
    EXPECT_TRUE(text.contains(QStringLiteral("{speed:%.1f}")));
    EXPECT_GT(text.size(), 22 + 2);
    EXPECT_FALSE(text.contains(QStringLiteral("Motor")));
}

TEST(TextTable, GivesATypedTextItsKey) {
    TextTable texts = table("key,comment,en\nmain.start_pump,,Start pump\n");
    EXPECT_EQ(texts.newKeyFor(QStringLiteral("main"), QStringLiteral("Start pump!")).toStdString(),
              "main.start_pump_2");
    EXPECT_EQ(texts.keyOfText(QStringLiteral("en"), QStringLiteral("Start pump")).toStdString(), "main.start_pump");
    EXPECT_EQ(texts.newKeyFor(QStringLiteral("main"), QStringLiteral("{t:%.1f} °C")).toStdString(), "main.c");
    EXPECT_TRUE(texts.renameKey(QStringLiteral("main.start_pump"), QStringLiteral("pump.start")));
    EXPECT_FALSE(texts.contains(QStringLiteral("main.start_pump")));
}

} // namespace
} // namespace plc::hmi
