// What the command line says to a first word that is no command: it may be one that is mistyped, a path, or a file that
// the studio does not open.
#include "command_fixture.h"

namespace plc {
namespace {

struct FirstWord : CommandTest {
    /// What it says, on one line.
    std::string said(const std::string& word) {
        EXPECT_EQ(command({word}), 2) << word;
        EXPECT_EQ(out, "") << word;
        return err;
    }
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(FirstWord, AMistypedCommandIsCorrected) {
    EXPECT_TRUE(has(said("chekc"), "There is no command chekc; did you mean check?")) << err;
}

TEST_F(FirstWord, AnUnknownNameIsNeitherACommandNorAFolder) {
    EXPECT_TRUE(has(said("p"), "There is no command p, and no folder of this name")) << err;
    EXPECT_TRUE(has(err, "stepwise --help")) << err;
}

TEST_F(FirstWord, APathThatIsMissingIsCalledAPath) {
    for (const char* word : {"./x", "proj/", "x.st", "../gravel", "C:\\plant", "project.json"}) {
        EXPECT_TRUE(has(said(word), std::string("There is no file or folder ") + word)) << err;
        EXPECT_FALSE(has(err, "no command")) << err;
    }
}

TEST_F(FirstWord, AFileThatTheStudioDoesNotOpenGetsTheCommandsForIt) {
    write("pump.st", "PROGRAM Main END_PROGRAM\n");
    EXPECT_TRUE(has(said(path("pump.st")), "stepwise check " + path("pump.st"))) << err;
    EXPECT_FALSE(has(err, "no command")) << err;
    write("notes.txt", "x");
    EXPECT_TRUE(has(said(path("notes.txt")), "open the folder of its project")) << err;
    EXPECT_FALSE(has(err, "stepwise check")) << err;
}

TEST_F(FirstWord, AnOptionNeedsACommand) {
    EXPECT_TRUE(has(said("--watch"), "no option --watch without a command")) << err;
}

} // namespace
} // namespace plc
