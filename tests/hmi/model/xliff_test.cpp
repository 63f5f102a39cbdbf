// XLIFF out and in: what a translator's tool changes comes back, what does not fit is said and not taken.
#include "hmi/texts/xliff.h"

#include <QXmlStreamReader>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

TextTable tableOf(const std::string& csv) {
    Result<TextTable> table = TextTable::parse(csv, QStringLiteral("hmi/texts.csv"));
    EXPECT_TRUE(table);
    return table ? *table : TextTable();
}

const char* const kTexts = "key,comment,en,de\n"
                           "main.start,on a button,Start,Starten\n"
                           "main.level,,\"Level {level:%.1f} of {max:%d} < \"\"full\"\" & more\",\n"
                           "main.space,,\"  two  blanks \",\n"
                           "main.arabic,,بدء {n:%d},\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from << "\n" << text;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Xliff, BothVersionsAreWellFormedAndComeBackAsTheyWere) {
    for (const XliffVersion version : {XliffVersion::V12, XliffVersion::V20}) {
        const TextTable table = tableOf(kTexts);
        XliffOptions options{version, QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("hmi/texts.csv")};
        options.places[QStringLiteral("main.start")] = QStringList{QStringLiteral("main: button1.text")};
        const std::string bytes = writeXliff(table, options);
        QXmlStreamReader xml(QByteArray::fromStdString(bytes));
        while (!xml.atEnd()) xml.readNext();
        EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
        EXPECT_NE(bytes.find("main: button1.text"), std::string::npos);
        EXPECT_NE(bytes.find("on a button"), std::string::npos);
        const Result<XliffFile> file = readXliff(bytes, QStringLiteral("f.xlf"));
        ASSERT_TRUE(file) << file.error().english();
        EXPECT_EQ(file->version, version);
        EXPECT_EQ(file->source.toStdString(), "en");
        EXPECT_EQ(file->target.toStdString(), "de");
        ASSERT_EQ(file->units.size(), 4u);
        for (size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(file->units[i].key, table.rows()[i].key);
            EXPECT_EQ(file->units[i].source, table.rows()[i].texts[0]);
            EXPECT_EQ(file->units[i].target, table.rows()[i].texts[1]);
        }
        TextTable back = table;
        const XliffReport report = takeXliff(back, *file, QStringLiteral("f.xlf"));
        EXPECT_EQ(report.taken, 0);
        EXPECT_EQ(report.same, 1);
        EXPECT_EQ(report.empty, 3);
        EXPECT_TRUE(report.remarks.empty());
        EXPECT_EQ(back.write(), table.write());
    }
}

TEST(Xliff, TakesTranslationsAndAddsTheLanguage) {
    for (const XliffVersion version : {XliffVersion::V12, XliffVersion::V20}) {
        TextTable table = tableOf("key,comment,en\nk,,Level {n:%d}\n");
        std::string bytes =
            writeXliff(table, {version, QStringLiteral("en"), QStringLiteral("da"), QStringLiteral("t")});
        if (version == XliffVersion::V20) {
            bytes = replaced(bytes, "</source>",
                             "</source><target><ph id=\"1\" equiv=\"{n:%d}\"/> i <pc id=\"2\">niveau</pc></target>");
            bytes = replaced(bytes, "\"initial\"", "\"reviewed\"");
        } else {
            bytes = replaced(bytes, "state=\"needs-translation\"></target>",
                             "state=\"final\"><ph id=\"1\">{n:%d}</ph> i <g id=\"2\">niveau</g></target>");
        }
        const Result<XliffFile> file = readXliff(bytes, QStringLiteral("f.xlf"));
        ASSERT_TRUE(file) << file.error().english();
        const XliffReport report = takeXliff(table, *file, QStringLiteral("f.xlf"));
        EXPECT_EQ(report.taken, 1);
        EXPECT_EQ(table.text(QStringLiteral("k"), QStringLiteral("da")).toStdString(), "{n:%d} i niveau");
    }
}

TEST(Xliff, PiecesOfASegmentedUnitAreOneText) {
    TextTable table = tableOf("key,comment,en\nk,,One. Two.\n");
    const Result<XliffFile> file = readXliff(
        R"(<xliff xmlns="urn:oasis:names:tc:xliff:document:2.0" version="2.0" srcLang="en" trgLang="de"><file id="f"><group id="g">
           <unit id="1" name="k"><originalData><data id="d">{n}</data></originalData>
             <segment state="final"><source>One.</source><target>Eins.</target></segment><ignorable><source> </source></ignorable>
             <segment state="final"><source>Two.</source><target>Zwei.</target></segment></unit></group></file></xliff>)",
        QStringLiteral("f.xlf"));
    ASSERT_TRUE(file) << file.error().english();
    EXPECT_EQ(file->units.front().source.toStdString(), "One. Two.");
    EXPECT_EQ(takeXliff(table, *file, QStringLiteral("f.xlf")).taken, 1);
    EXPECT_EQ(table.text(QStringLiteral("k"), QStringLiteral("de")).toStdString(), "Eins. Zwei.");
}

TEST(Xliff, SaysWhatDoesNotFitAndTakesNoneOfIt) {
    const auto unit = [](const std::string& key, const std::string& source, const std::string& target) {
        return "<trans-unit id=\"" + key + "\"><source>" + source + "</source><target>" + target +
               "</target></trans-unit>\n";
    };
    TextTable table = tableOf("key,comment,en\na,,Level {n:%d}\nb,,New text\n");
    const std::string bytes = "<xliff version=\"1.2\"><file source-language=\"en\" target-language=\"de\"><body>\n" +
                              unit("gone", "x", "y") + unit("a", "Level {n:%d}", "Pegel") +
                              unit("b", "Old text", "Alter Text") + "</body></file></xliff>";
    const Result<XliffFile> file = readXliff(bytes, QStringLiteral("f.xlf"));
    ASSERT_TRUE(file) << file.error().english();
    const XliffReport report = takeXliff(table, *file, QStringLiteral("f.xlf"));
    ASSERT_EQ(report.remarks.size(), 3u);
    EXPECT_EQ(report.remarks[0].english(), "f.xlf:2: The key gone is not in the text table; add it there");
    EXPECT_EQ(report.remarks[1].place, "f.xlf:3");
    EXPECT_EQ(report.remarks[2].place, "f.xlf:4");
    EXPECT_TRUE(table.text(QStringLiteral("a"), QStringLiteral("de")).isEmpty());
    EXPECT_EQ(table.text(QStringLiteral("b"), QStringLiteral("de")).toStdString(), "Alter Text");
}

TEST(Xliff, APlaceholderThatAToolLostInBothLanguagesIsNotLostHere) {
    TextTable table = tableOf("key,comment,en,de\na,,Load {load:%.0f} %,Last {load:%.0f} %\n");
    const std::string bytes = "<xliff version=\"1.2\"><file source-language=\"en\" target-language=\"de\"><body>\n"
                              "<trans-unit id=\"a\"><source>Load  %</source><target>Last  %</target></trans-unit>\n"
                              "</body></file></xliff>";
    const Result<XliffFile> file = readXliff(bytes, QStringLiteral("f.xlf"));
    ASSERT_TRUE(file) << file.error().english();
    const XliffReport report = takeXliff(table, *file, QStringLiteral("f.xlf"));
    EXPECT_EQ(report.taken, 0);
    EXPECT_EQ(report.remarks.size(), 2u) << "another source, other placeholders";
    EXPECT_EQ(table.text(QStringLiteral("a"), QStringLiteral("de")).toStdString(), "Last {load:%.0f} %");
}

TEST(Xliff, AFileThatIsNoneIsRefusedWithItsPlace) {
    const char* const rows[] = {"",
                                "nothing",
                                "<html/>",
                                "<xliff version=\"3\"/>",
                                "<xliff version=\"2.0\" trgLang=\"de\"><file>",
                                "<xliff version=\"1.2\"><file source-language=\"en\"><body/></file></xliff>"};
    for (const char* bytes : rows) {
        const Result<XliffFile> file = readXliff(bytes, QStringLiteral("f.xlf"));
        ASSERT_FALSE(file) << bytes;
        EXPECT_EQ(file.error().place.rfind("f.xlf:", 0), 0u) << file.error().place;
    }
    std::string deep = "<xliff version=\"2.0\" srcLang=\"en\" trgLang=\"de\">";
    for (int i = 0; i < 5000; ++i) deep += "<group>";
    EXPECT_FALSE(readXliff(deep, QStringLiteral("f.xlf")));
    std::string inlined = "<xliff version=\"1.2\"><file target-language=\"de\"><body><trans-unit id=\"k\"><source>";
    for (int i = 0; i < 200000; ++i) inlined += "<g>";
    EXPECT_FALSE(readXliff(inlined, QStringLiteral("f.xlf")));
}

} // namespace
} // namespace plc::hmi
