// `stepwise import` and `stepwise export`: a project out of a file and back, previews, reports as text and JSON, wrong
// use; `stepwise check` of a file of TwinCAT reads the program in it.
#include "tests/app/cli/command_fixture.h"

#include "projects/storage/project_file.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace plc {
namespace {

const char* const kUnit =
    "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<TcPlcObject Version=\"1.1.0.1\">\n<POU Name=\"MAIN\" "
    "Id=\"{1}\"><Declaration><![CDATA[PROGRAM MAIN\nVAR\n    n : INT;\nEND_VAR\n]]></Declaration>"
    "<Implementation><ST><![CDATA[n := n + 1;]]></ST></Implementation></POU></TcPlcObject>\n";

class ExchangeCommands : public CommandTest {};

TEST_F(ExchangeCommands, AFileBecomesAProjectThatRunsAndGoesOutAgain) {
    write("MAIN.TcPOU", kUnit);
    EXPECT_EQ(command({"import", path("MAIN.TcPOU"), "--to", path("machine")}), cli::kGood) << err;
    EXPECT_NE(out.find("units: PROGRAM 1; bodies: ST 1; not kept: 0"), std::string::npos) << out;
    EXPECT_EQ(read("machine/src/MAIN.st"), "PROGRAM MAIN\nVAR\n    n : INT;\nEND_VAR\nn := n + 1;\nEND_PROGRAM\n");
    EXPECT_EQ(command({"run", path("machine"), "--for", "5ms"}), cli::kGood) << err;
    EXPECT_EQ(command({"export", path("machine"), "--to", path("machine.xml")}), cli::kGood) << err;
    EXPECT_NE(read("machine.xml").find("tc6_0200"), std::string::npos);
    EXPECT_EQ(command({"export", path("machine"), "--to", path("plain.xml"), "--version", "0201"}), cli::kGood) << err;
    EXPECT_NE(read("plain.xml").find("tc6_0201"), std::string::npos);
    EXPECT_NE(out.find("units: pou 1; bodies: ST 1"), std::string::npos) << out;
    EXPECT_EQ(command({"import", path("plain.xml"), "--to", path("again")}), cli::kGood) << err;
    EXPECT_EQ(read("again/src/MAIN.st"), read("machine/src/MAIN.st"));
}

TEST_F(ExchangeCommands, APreviewWritesNothingAndJsonCanBeRead) {
    write("MAIN.TcPOU", kUnit);
    EXPECT_EQ(command({"import", path("MAIN.TcPOU"), "--preview", "--format", "json"}), cli::kGood) << err;
    const auto json = nlohmann::json::parse(out);
    EXPECT_EQ(json["notKept"], 0);
    EXPECT_EQ(json["units"]["PROGRAM"], 1);
    EXPECT_FALSE(std::filesystem::exists(path("machine")));
}

TEST_F(ExchangeCommands, CheckReadsTheProgramInAFileOfTwinCat) {
    write("MAIN.TcPOU", kUnit);
    EXPECT_EQ(command({"check", path("MAIN.TcPOU")}), cli::kGood) << err;
    std::string wrong = kUnit;
    wrong.replace(wrong.find("n := n + 1"), 10, "m := n + 1");
    write("MAIN.TcPOU", wrong);
    EXPECT_EQ(command({"check", path("MAIN.TcPOU")}), cli::kProgramWrong);
    EXPECT_NE(err.find("P2001"), std::string::npos) << err;
    write("x.st", kUnit);
    EXPECT_EQ(command({"check", path("x.st")}), cli::kWrongUse);
    EXPECT_NE(err.find("This is XML"), std::string::npos) << err;
}

TEST_F(ExchangeCommands, WrongUseIsNamed) {
    EXPECT_EQ(command({"import"}), cli::kWrongUse);
    write("MAIN.TcPOU", kUnit);
    EXPECT_EQ(command({"import", path("MAIN.TcPOU")}), cli::kWrongUse);
    EXPECT_NE(err.find("--to"), std::string::npos);
    EXPECT_EQ(command({"import", path("gone.xml"), "--to", path("p")}), cli::kWrongUse);
    std::filesystem::create_directories(path("taken"));
    write("taken/file", "x");
    EXPECT_EQ(command({"import", path("MAIN.TcPOU"), "--to", path("taken")}), cli::kWrongUse);
    EXPECT_NE(err.find("not empty"), std::string::npos);
    write("p.st", "PROGRAM P\nEND_PROGRAM\n");
    EXPECT_EQ(command({"export", path("p.st")}), cli::kWrongUse);
    EXPECT_EQ(command({"export", path("p.st"), "--to", path("o.xml"), "--version", "0300"}), cli::kWrongUse);
    EXPECT_FALSE(std::filesystem::exists(path("o.xml")));
}

TEST_F(ExchangeCommands, TheEncodingOfAnImportIsChosenByName) {
    write("p.st", "PROGRAM P // \xB3\nEND_PROGRAM\n");
    EXPECT_EQ(command({"import", path("p.st"), "--encoding", "Martian", "--to", path("out")}), cli::kWrongUse);
    EXPECT_NE(err.find("The encoding Martian is not known; choose one of Windows-1252"), std::string::npos) << err;
    EXPECT_FALSE(std::filesystem::exists(path("out")));
    EXPECT_EQ(command({"import", path("p.st"), "--encoding", "cp1250", "--to", path("out")}), cli::kGood) << err;
    EXPECT_NE(read("out/src/p.st").find("// \xC5\x82"), std::string::npos);
}

TEST_F(ExchangeCommands, TheEncodingOfASourceIsKeptUnlessUtf8IsAsked) {
    write("p.st", "PROGRAM P // \xE9\nVAR\nn:INT;\nEND_VAR\nn:=1;\nEND_PROGRAM\n");
    EXPECT_EQ(command({"check", path("p.st")}), cli::kGood) << err;
    EXPECT_NE(err.find("Windows-1252"), std::string::npos) << err;
    EXPECT_EQ(command({"fmt", path("p.st")}), cli::kGood) << err;
    EXPECT_NE(read("p.st").find("// \xE9\n"), std::string::npos);
    EXPECT_NE(read("p.st").find("n : INT;"), std::string::npos);
    EXPECT_EQ(command({"fmt", path("p.st"), "--utf8"}), cli::kGood) << err;
    EXPECT_NE(read("p.st").find("// \xC3\xA9\n"), std::string::npos);
}

/// A program whose comment has every letter of a code page; a formatter has work with it.
std::string programWithLettersOf(const std::string& page, std::string& utf8) {
    const auto encoding = projects::encodingNamed(page);
    EXPECT_TRUE(encoding) << page;
    std::string bytes = "PROGRAM P // ";
    for (int byte = 0xA1; byte <= 0xFF; ++byte) bytes += static_cast<char>(byte);
    bytes += "\nVAR\nn:INT;\nEND_VAR\nn:=1;\nEND_PROGRAM\n";
    utf8 = projects::decodeText(bytes, encoding).text;
    return bytes;
}

TEST_F(ExchangeCommands, EveryCodePageIsImportedKeptAndConvertedWhenAsked) {
    ASSERT_EQ(projects::codePageNames().size(), 12u);
    for (const std::string& page : projects::codePageNames()) {
        std::string utf8;
        const std::string bytes = programWithLettersOf(page, utf8);
        const std::string letters = bytes.substr(0, bytes.find('\n') + 1);
        write(page + ".st", bytes);
        EXPECT_EQ(command({"import", path(page + ".st"), "--encoding", page, "--to", path("in" + page)}), cli::kGood)
            << page << err;
        EXPECT_EQ(read("in" + page + "/src/" + page + ".st"), utf8) << page;

        std::filesystem::create_directories(path(page + "/src"));
        write(page + "/project.json", "{\"name\": \"p\", \"encoding\": \"" + page + "\"}");
        write(page + "/src/p.st", bytes);
        EXPECT_EQ(command({"check", path(page)}), cli::kGood) << page << err;
        EXPECT_EQ(command({"fmt", path(page + "/src/p.st")}), cli::kGood) << page << err;
        EXPECT_EQ(read(page + "/src/p.st").substr(0, letters.size()), letters) << page << ": as found";
        EXPECT_NE(read(page + "/src/p.st").find("n : INT;"), std::string::npos) << page;
        EXPECT_EQ(command({"fmt", path(page + "/src/p.st"), "--utf8"}), cli::kGood) << page << err;
        EXPECT_EQ(read(page + "/src/p.st").substr(0, utf8.find('\n')), utf8.substr(0, utf8.find('\n'))) << page;
        EXPECT_EQ(command({"check", path(page)}), cli::kGood) << page << err;
    }
}

} // namespace
} // namespace plc
