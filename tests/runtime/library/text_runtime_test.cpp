#include "runtime/library/text_runtime.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace {

/// A STRING(capacity) with a guard byte behind it.
struct Text {
    explicit Text(uint32_t capacity, const char* text = "") : capacity(capacity), bytes(capacity + 2, '#') {
        std::strcpy(bytes.data(), text);
    }
    [[nodiscard]] std::string text() const { return {bytes.data(), strnlen(bytes.data(), capacity + 1)}; }
    [[nodiscard]] bool isIntact() const {
        return bytes[capacity + 1] == '#' && std::memchr(bytes.data(), 0, capacity + 1) != nullptr;
    }
    char* data() { return bytes.data(); }
    uint32_t capacity;
    std::vector<char> bytes;
};

} // namespace

TEST(TextRuntime, NeverWritesBehindItsCapacity) {
    for (uint32_t capacity = 0; capacity < 8; ++capacity) {
        Text to(capacity), a(20, "ABCDEFGH"), b(20, "xyz");
        const auto check = [&](const std::string& whole, const char* what) {
            EXPECT_EQ(to.text(), whole.substr(0, capacity)) << what;
            EXPECT_TRUE(to.isIntact()) << what;
        };
        plc_text_assign(to.data(), capacity, a.data(), 20);
        check("ABCDEFGH", "assign");
        plc_text_append(to.data(), capacity, b.data(), 20);
        check("ABCDEFGH", "append");
        plc_text_left(to.data(), capacity, a.data(), 20, 6);
        check("ABCDEF", "left");
        plc_text_right(to.data(), capacity, a.data(), 20, 6);
        check("CDEFGH", "right");
        plc_text_mid(to.data(), capacity, a.data(), 20, 6, 2);
        check("BCDEFG", "mid");
        plc_text_insert(to.data(), capacity, a.data(), 20, b.data(), 20, 1);
        check("AxyzBCDEFGH", "insert");
        plc_text_delete(to.data(), capacity, a.data(), 20, 2, 2);
        check("ADEFGH", "delete");
        plc_text_replace(to.data(), capacity, a.data(), 20, b.data(), 20, 2, 2);
        check("AxyzDEFGH", "replace");
        plc_text_upper(to.data(), capacity, b.data(), 20);
        check("XYZ", "upper");
        plc_text_from_integer(to.data(), capacity, static_cast<uint32_t>(plc::types::TypeKind::Dint), -123456);
        check("-123456", "from integer");
        plc_text_from_real(to.data(), capacity, static_cast<uint32_t>(plc::types::TypeKind::Lreal), 1.5);
        check("1.5", "from real");
        plc_text_from_character(to.data(), capacity, 'A');
        check("A", "from character");
    }
}

TEST(TextRuntime, AResultMayOverwriteItsOperands) {
    Text s(20, "ABCDEF"), t(20, "xy");
    plc_text_right(s.data(), 20, s.data(), 20, 4);
    EXPECT_EQ(s.text(), "CDEF");
    plc_text_insert(s.data(), 20, s.data(), 20, t.data(), 20, 2);
    EXPECT_EQ(s.text(), "CDxyEF");
    plc_text_insert(s.data(), 20, t.data(), 20, s.data(), 20, 1);
    EXPECT_EQ(s.text(), "xCDxyEFy");
    plc_text_delete(s.data(), 20, s.data(), 20, 3, 2);
    EXPECT_EQ(s.text(), "xyEFy");
    plc_text_append(s.data(), 20, s.data(), 20);
    EXPECT_EQ(s.text(), "xyEFyxyEFy");
    plc_text_replace(s.data(), 20, s.data(), 20, s.data(), 20, 8, 2);
    EXPECT_EQ(s.text(), "xxyEFyxyEFyy");
    plc_text_assign(s.data(), 20, s.data() + 1, 19);
    EXPECT_EQ(s.text(), "xyEFyxyEFyy");
}

TEST(TextRuntime, LongTextsThatOverlapWorkToo) {
    constexpr uint32_t capacity = 3'000;
    Text s(capacity, std::string(2'000, 'a').c_str()), t(5, "b");
    plc_text_insert(s.data(), capacity, s.data(), capacity, t.data(), 5, 1'000);
    EXPECT_EQ(s.text(), std::string(1'000, 'a') + "b" + std::string(1'000, 'a'));
}

TEST(TextRuntime, ATextWithoutEndIsReadToItsCapacity) {
    const char raw[] = {'A', 'B', 'C', 'D'};
    EXPECT_EQ(plc_text_length(raw, 3), 3u);
    Text to(10);
    plc_text_assign(to.data(), 10, raw, 3);
    EXPECT_EQ(to.text(), "ABC");
}

TEST(TextRuntime, ComparesByCharacterAsUnsigned) {
    const auto compare = [](const char* a, const char* b) { return plc_text_compare(a, 80, b, 80); };
    EXPECT_EQ(compare("AB", "ABC"), -1);
    EXPECT_EQ(compare("ABC", "AB"), 1);
    EXPECT_EQ(compare("", ""), 0);
    EXPECT_EQ(compare("\xE4", "z"), 1);
}

TEST(TextRuntime, WideAndNarrow) {
    char16_t wide[11];
    plc_text_to_wide(wide, 10, "a\xE4", 80);
    EXPECT_EQ(std::u16string(wide), u"a\u00E4");
    char narrow[11];
    EXPECT_EQ(plc_wtext_to_narrow(narrow, 10, u"a\u00E4\u20AC", 80), 0);
    EXPECT_STREQ(narrow, "a\xE4?");
    EXPECT_EQ(plc_wtext_to_narrow(narrow, 10, u"abc", 80), 1);
    uint8_t ok = 0;
    EXPECT_EQ(plc_wtext_to_integer(u"42\u20AC", 80, static_cast<uint32_t>(plc::types::TypeKind::Int), &ok), 42);
    EXPECT_EQ(ok, 1);
}

TEST(TextRuntime, EverySymbolHasOneNameAndAnAddress) {
    std::set<std::string_view> names;
    for (const auto& symbol : plc::library::runtimeSymbols()) {
        EXPECT_TRUE(names.insert(symbol.name).second) << symbol.name;
        EXPECT_NE(symbol.address, nullptr);
    }
    EXPECT_TRUE(names.contains("plc_wtext_replace"));
}
