// Files that mean harm or are broken: each kind ends with an error or a line of the report, in bounded time.
#include "fixture.h"

#include "projects/exchange/base/xml.h"

namespace plc::exchange {
namespace {

std::string number(const std::string& name, int n) { return "<v n=\"" + name + "\">" + std::to_string(n) + "L</v>"; }
std::string drawn(const std::string& language, const std::string& type, const std::string& content) {
    return "<TcPlcObject><POU Name=\"A\"><Declaration><![CDATA[PROGRAM A\nVAR y : INT; END_VAR]]></Declaration>"
           "<Implementation><" +
           language + "><XmlArchive><Data><o t=\"" + type + "\">" + content + "</o></Data></XmlArchive></" + language +
           "></Implementation></POU></TcPlcObject>";
}
/// ADD with the input pins 3n and 3n+1 and the output pin 3n+2.
std::string adder(int n) {
    const auto pin = [](int id) { return "<o>" + number("Id", id) + "</o>"; };
    return "<o t=\"CFCBoxElement\"><o n=\"Inputs\"><l2 n=\"InnerList\">" + pin(3 * n) + pin(3 * n + 1) +
           "</l2></o><o n=\"Outputs\"><l2 n=\"InnerList\">" + pin(3 * n + 2) +
           "</l2></o><o n=\"Texts\"><l2 n=\"InnerList\"><o><v n=\"Text\">\"ADD\"</v></o></l2></o>"
           "<v n=\"KindOfCall\">Operator</v>" +
           number("Id", n) + "</o>";
}
std::string line(int from, int to) {
    return "<o t=\"CFCConnection\">" + number("SourcePinId", from) + number("DestPinId", to) + "</o>";
}
std::string target(int pin) {
    return "<o t=\"CFCOutputElement\"><o n=\"Input\">" + number("Id", pin) +
           "</o><o n=\"Text\"><v n=\"Text\">\"y\"</v>"
           "</o>" +
           number("Id", 100000) + "</o>";
}
std::string functionChart(const std::string& elements) {
    return drawn("CFC", "CFCImplementationObject", "<o n=\"Items\"><l2 n=\"InnerList\">" + elements + "</l2></o>");
}

class Hostile : public ExchangeTest {
protected:
    /// What the import of a file with these bytes says: its error, or its report.
    std::string said(const std::string& name, const std::string& bytes) {
        const auto imported = importFrom(write(name, bytes));
        return imported ? imported->report.toText() : imported.error().english();
    }
};

TEST_F(Hostile, EntitiesAreRefusedInEveryKindOfFile) {
    std::string bomb = "<!DOCTYPE l [<!ENTITY a \"ha\">";
    for (char c = 'b'; c <= 'z'; ++c) {
        bomb += std::string("<!ENTITY ") + c + " \"";
        for (int i = 0; i < 10; ++i) bomb += std::string("&") + static_cast<char>(c - 1) + ";";
        bomb += "\">";
    }
    for (const char* name : {"bomb.xml", "bomb.TcPOU", "bomb.export", "bomb.plcproj"}) {
        const std::string text = said(name, "<?xml version=\"1.0\"?>" + bomb + "]><project>&z;</project>");
        EXPECT_NE(text.find("document type"), std::string::npos) << name << ": " << text;
    }
    const std::string outside = "<!DOCTYPE l SYSTEM \"file:///etc/passwd\"><TcPlcObject/>";
    EXPECT_NE(said("outside.TcPOU", outside).find("document type"), std::string::npos);
}

TEST_F(Hostile, DepthIsRefusedWithItsLine) {
    std::string open, close;
    for (int i = 0; i < 100000; ++i) open += "<a>", close += "</a>";
    const std::string text = said("deep.TcPOU", "<TcPlcObject>\n" + open + close + "</TcPlcObject>");
    EXPECT_NE(text.find("deep.TcPOU:2"), std::string::npos) << text;
    EXPECT_NE(text.find("nested too deeply"), std::string::npos) << text;
}

TEST_F(Hostile, SizeIsRefusedBeforeItIsRead) {
    XmlLimits small;
    small.bytes = 1000;
    const auto file = XmlFile::parse("<project>" + std::string(2000, ' ') + "</project>", "big.xml", {}, small);
    ASSERT_FALSE(file);
    EXPECT_NE(file.error().english().find("big.xml"), std::string::npos) << file.error().english();
    EXPECT_TRUE(XmlFile::parse("<project/>", "small.xml", {}, small));
}

TEST_F(Hostile, EncodingsThatAreNotWhatTheySayAreErrorsOrNotes) {
    EXPECT_NE(said("e.TcPOU", "<?xml version=\"1.0\" encoding=\"ebcdic\"?><TcPlcObject/>").find("ebcdic"),
              std::string::npos);
    EXPECT_NE(said("half.TcPOU", std::string("\xFF\xFE<\0T\0c", 7)).find("not well-formed"), std::string::npos);
    EXPECT_NE(said("nul.TcPOU", std::string("<TcPlcObject a=\"\0\"/>", 20)).find("not well-formed"), std::string::npos);
    const std::string latin = "<?xml version=\"1.0\" encoding=\"utf-8\"?><TcPlcObject><POU Name=\"A\"><Declaration>"
                              "<![CDATA[PROGRAM A // \xE9\nVAR END_VAR]]></Declaration></POU></TcPlcObject>";
    EXPECT_NE(said("latin.TcPOU", latin).find("Windows-1252"), std::string::npos);
}

TEST_F(Hostile, NamesDoNotLeaveTheProject) {
    const auto imported = importFrom(write("n.TcPOU", "<TcPlcObject><POU Name=\"../../../x\"><Declaration>"
                                                      "<![CDATA[PROGRAM x\nVAR END_VAR]]></Declaration></POU>"
                                                      "</TcPlcObject>"));
    ASSERT_TRUE(imported);
    for (const ImportedFile& file : imported->files) {
        EXPECT_EQ(file.path.find(".."), file.path.find(".._")) << file.path;
        EXPECT_TRUE(file.path.starts_with("src/")) << file.path;
    }
    ASSERT_TRUE(writeImported(*imported, path("out")));
    EXPECT_FALSE(std::filesystem::exists(path("x.st")));
}

TEST_F(Hostile, DiagramsThatDoubleAtEachBoxEnd) {
    std::string chain;
    constexpr int kBoxes = 60;
    for (int n = 1; n <= kBoxes; ++n) chain += adder(n);
    for (int n = 1; n < kBoxes; ++n) chain += line(3 * n + 2, 3 * n + 3) + line(3 * n + 2, 3 * n + 4);
    const std::string text = said("double.TcPOU", functionChart(chain + target(9999) + line(3 * kBoxes + 2, 9999)));
    EXPECT_NE(text.find("(A)"), std::string::npos) << text;
}

TEST_F(Hostile, DiagramsThatBiteTheirTailHaveALine) {
    const std::string text =
        said("ring.TcPOU", functionChart(adder(1) + adder(2) + line(5, 6) + line(8, 3) + target(9999) + line(8, 9999)));
    EXPECT_NE(text.find("loop"), std::string::npos) << text;
    EXPECT_NE(said("self.TcPOU", functionChart(adder(1) + line(5, 3) + target(9999) + line(5, 9999))).find("loop"),
              std::string::npos);
}

TEST_F(Hostile, ChartsOfBranchesInBranchesEnd) {
    const std::string open = "<o t=\"SFCBranch\"><o n=\"ElementList\"><l2 n=\"InnerList\"><o><o n=\"ElementList\">"
                             "<l2 n=\"InnerList\">",
                      close = "</l2></o></o></l2></o></o>";
    std::string chart = "<o n=\"Root\"><o n=\"ElementList\"><l2 n=\"InnerList\">";
    for (int i = 0; i < 25; ++i) chart += open;
    for (int i = 0; i < 25; ++i) chart += close;
    const std::string text = said("branches.TcPOU", drawn("SFC", "SFCImplementationObject", chart + "</l2></o></o>"));
    EXPECT_NE(text.find("bodies: SFC 1"), std::string::npos) << text;
}

TEST_F(Hostile, ExportsWithEndlessBoxesAndCountsAreKeptWithALine) {
    const std::string head = "(* @NESTEDCOMMENTS := 'Yes' *)\nPROGRAM A\nVAR\nEND_VAR\n"
                             "(* @END_DECLARATION := '0' *)\n_FBD_BODY\n_NETWORKS : ";
    std::string deep = head + "1\n_NETWORK\n_ASSIGN\n";
    for (int i = 0; i < 20000; ++i) deep += "_OPERATOR\n_BOX_EXPR : 1\n";
    for (const std::string& text :
         {deep, head + "2147483647\n_NETWORK\n", head + "1\n_NETWORK\n_ASSIGN\n_OPERATOR\n_BOX_EXPR : 99999999999\n"}) {
        const auto imported = importFrom(write("a.EXP", text + "END_PROGRAM\n"));
        ASSERT_TRUE(imported);
        EXPECT_EQ(imported->report.losses(), 1u) << imported->report.toText();
    }
}

} // namespace
} // namespace plc::exchange
