// The bytes of a STRING in every encoding that a project may name, and values as text in them.
#include "runtime/types/string_code.h"
#include "runtime/types/value.h"

#include <gtest/gtest.h>

using namespace plc::types;

namespace {

StringCode codeOf(const char* name) { return stringCodeNamed(name).value(); }

} // namespace

TEST(StringCode, EveryNameIsReadBackAndNoOtherIs) {
    for (const std::string& name : stringCodeNames()) {
        const auto code = stringCodeNamed(name);
        ASSERT_TRUE(code) << name;
        EXPECT_EQ(nameOf(*code), name);
    }
    EXPECT_EQ(stringCodeNamed("cp1251"), StringCode::Windows1251);
    EXPECT_EQ(stringCodeNamed("latin1"), StringCode::Latin1);
    for (const char* name : {"", " ", "Shift-JIS", "cp1251 1251"}) EXPECT_FALSE(stringCodeNamed(name)) << name;
}

TEST(StringCode, EveryByteOfEveryEncodingComesBack) {
    for (const std::string& name : stringCodeNames()) {
        const StringCode code = codeOf(name.c_str());
        for (int byte = 1; byte <= 0xFF; ++byte) {
            const std::string bytes(1, static_cast<char>(byte));
            std::string back;
            for (const char32_t c : charactersOf(code, bytes)) EXPECT_TRUE(appendCharacter(code, back, c));
            EXPECT_EQ(back, bytes) << name << " " << byte;
            if (code == StringCode::Utf8 && byte >= 0x80) continue; // half of a character
            EXPECT_EQ(stringOfUtf8(code, utf8OfString(code, bytes)), bytes) << name << " " << byte;
            bool isWhole = true;
            EXPECT_EQ(stringOfWide(code, wideOfString(code, bytes), isWhole), bytes) << name << " " << byte;
            EXPECT_TRUE(isWhole);
            EXPECT_EQ(characterOfWide(code, wideOfCharacter(code, static_cast<unsigned char>(byte))), byte)
                << name << " " << byte;
        }
    }
}

TEST(StringCode, CodePagesHaveTheirLetters) {
    const struct {
        const char *code, *bytes, *utf8;
    } rows[] = {{"Latin-1", "\xE4\xDF", "\u00E4\u00DF"},
                {"Windows-1252", "\x80\x9F", "\u20AC\u0178"},
                {"Windows-1251", "\xC6\xB8", "\u0416\u0451"},
                {"Windows-1250", "\xBF\xB3", "\u017C\u0142"},
                {"Windows-1253", "\xD9", "\u03A9"},
                {"Windows-1254", "\xF0\xFE", "\u011F\u015F"},
                {"Windows-1257", "\xE0", "\u0105"},
                {"ISO-8859-2", "\xB1", "\u0105"},
                {"ISO-8859-5", "\xB6", "\u0416"},
                {"ISO-8859-15", "\xA4", "\u20AC"},
                {"KOI8-R", "\xF6", "\u0416"},
                {"IBM850", "\x84", "\u00E4"},
                {"IBM866", "\x86", "\u0416"},
                {"UTF-8", "\xD0\x96", "\u0416"}};
    for (const auto& [code, bytes, utf8] : rows) {
        EXPECT_EQ(utf8OfString(codeOf(code), bytes), utf8) << code;
        EXPECT_EQ(stringOfUtf8(codeOf(code), utf8), bytes) << code;
    }
    size_t bad = 0;
    EXPECT_FALSE(stringOfUtf8(StringCode::Windows1251, "\u0416 \u03A9", &bad));
    EXPECT_EQ(bad, 3u);
    EXPECT_FALSE(characterOfWide(StringCode::Windows1251, u'\u03A9'));
    EXPECT_FALSE(characterOfWide(StringCode::Utf8, u'\u0416')); // two bytes
}

TEST(StringCode, CasesAreThoseOfTheEncoding) {
    EXPECT_EQ(upperLetter(StringCode::Windows1251, '\xE6'), '\xC6');
    EXPECT_EQ(lowerLetter(StringCode::Windows1251, '\xA8'), '\xB8'); // Yo
    EXPECT_EQ(upperLetter(StringCode::Ibm866, '\xA6'), '\x86');
    EXPECT_EQ(upperLetter(StringCode::Windows1252, '\xFF'), '\x9F'); // y with two dots
    EXPECT_EQ(upperLetter(StringCode::Utf8, 'a'), 'A');
    EXPECT_EQ(upperLetter(StringCode::Utf8, '\xB6'), '\xB6');
}

TEST(StringCode, NoCharacterIsCutInHalf) {
    bool isWhole = true;
    EXPECT_EQ(stringOfWide(StringCode::Utf8, u"a\u0416", isWhole, 2), "a");
    EXPECT_EQ(stringOfWide(StringCode::Utf8, u"\U0001F600", isWhole, 4), "\xF0\x9F\x98\x80");
    EXPECT_TRUE(isWhole);
    EXPECT_EQ(wideOfString(StringCode::Utf8, "\xF0\x9F\x98\x80"), u"\U0001F600");
    EXPECT_EQ(utf8OfString(StringCode::Utf8, "\xD0"), "\u00D0"); // half of one is shown as its number
}

TEST(StringCode, HalfAPairIsNoCharacter) {
    bool isWhole = true;
    const std::u16string cut{u'a', char16_t(0xD83D)};
    EXPECT_EQ(stringOfWide(StringCode::Utf8, cut, isWhole), "a?");
    EXPECT_FALSE(isWhole);
    EXPECT_EQ(bytesOfCharacter(StringCode::Utf8, 0xDE00).size, 0);
    EXPECT_EQ(bytesOfCharacter(StringCode::Utf8, 0xE000).size, 3);
}

TEST(StringCode, AWstringCutWithinACharacterIsShownByItsUnitAndReadBack) {
    TypeTable types;
    const TypeId type = types.wstring(5), wchar = TypeTable::of(TypeKind::Wchar);
    const std::u16string pair = u"\U0001F600";
    const struct {
        std::u16string units;
        const char *text, *json;
    } rows[] = {
        {std::u16string(u"a") + pair[0], R"("a$D83D")", "\"a\uFFFD\""},
        {pair[1] + std::u16string(u"b"), R"("$DE00b")", "\"\uFFFDb\""},
        {std::u16string() + pair[1] + pair[0], R"("$DE00$D83D")", "\"\uFFFD\uFFFD\""},
        {pair + u"b", "\"\U0001F600b\"", "\"\U0001F600b\""},
    };
    for (const auto& row : rows) {
        const Value value{type, row.units};
        EXPECT_EQ(toText(types, value), row.text);
        EXPECT_EQ(toJson(types, value), row.json) << row.text;
        const auto back = parseValue(types, type, row.text);
        ASSERT_TRUE(back) << row.text;
        EXPECT_EQ(std::get<std::u16string>(back->data), row.units) << row.text;
    }
    const auto joined = parseValue(types, type, R"("$D83D$DE00")");
    ASSERT_TRUE(joined);
    EXPECT_EQ(toText(types, *joined), "\"\U0001F600\"");
    EXPECT_EQ(toText(types, {wchar, int64_t{0xD83D}}), R"("$D83D")");
    EXPECT_EQ(toJson(types, {wchar, int64_t{0xD83D}}), "\"\uFFFD\"");
    EXPECT_EQ(parseValue(types, wchar, R"("$D83D")")->integer(), 0xD83D);
}

TEST(StringCode, ValuesAreShownAndReadInTheEncodingOfTheTable) {
    for (const char* name : {"Windows-1251", "UTF-8"}) {
        TypeTable types;
        types.strings = codeOf(name);
        const TypeId type = types.string(20);
        for (const char* text : {"'\u041D\u0430\u0441\u043E\u0441'", "'a$98b'", "'$$ $N'"}) {
            const auto value = parseValue(types, type, text);
            ASSERT_TRUE(value) << name << " " << text;
            EXPECT_EQ(toText(types, *value), text) << name;
        }
        EXPECT_EQ(toJson(types, *parseValue(types, type, "'\u0416'")), "\"\u0416\"") << name;
    }
    TypeTable types;
    types.strings = StringCode::Windows1251;
    EXPECT_FALSE(parseValue(types, types.string(20), "'\u03A9'"));
    EXPECT_FALSE(parseValue(types, types.string(2), "'\u0416\u0416\u0416'"));
    types.strings = StringCode::Utf8;
    EXPECT_FALSE(parseValue(types, types.string(3), "'\u0416\u0416'")); // four bytes
}
