#include "runtime/base/xml_text.h"

#include <gtest/gtest.h>

namespace plc {
namespace {

TEST(XmlText, EscapesWhatMarkupWouldTakeForItsOwn) {
    EXPECT_EQ(xmlText("IF a < b & c > 'd' THEN \"e\""), "IF a &lt; b &amp; c &gt; 'd' THEN &quot;e&quot;");
    EXPECT_EQ(xmlText("&lt;"), "&amp;lt;");
}

TEST(XmlText, LeavesOutWhatXmlCannotWrite) {
    EXPECT_EQ(xmlText(std::string_view("a\0b\x1b[0mc\td\r\n", 12)), "ab[0mc\td\r\n");
}

TEST(XmlText, KeepsLettersOfEveryScript) { EXPECT_EQ(xmlText("Füllstand × 水"), "Füllstand × 水"); }

} // namespace
} // namespace plc
