// Every body that ships, and every one of a corpus named by STEPWISE_CORPUS, opens in both views: nothing is refused,
// every statement has its place, the picture can be laid out and drawn, and most of it needs no box with text.
#include "opened.h"
#include "runtime/compiler/ladder/picture.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace plc::ladder {
namespace {

namespace fs = std::filesystem;

struct Source {
    std::string path, text;
    std::unique_ptr<syntax::SyntaxFile> file;
};

std::vector<Source> sourcesBelow(const fs::path& folder) {
    std::vector<Source> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".st") continue;
        std::ifstream stream(entry.path(), std::ios::binary);
        std::ostringstream text;
        text << stream.rdbuf();
        out.push_back({entry.path().string(), text.str(), nullptr});
    }
    std::sort(out.begin(), out.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
    for (size_t i = 0; i < out.size(); ++i) {
        diagnostics::Sink sink;
        out[i].file = parse::parseFile(FileId(i), out[i].text, sink);
    }
    return out;
}

size_t count(const syntax::Block& block) {
    size_t all = 0;
    for (const syntax::Stmt* stmt : block) {
        if (stmt->kind == syntax::StmtKind::Empty) continue;
        all += 1 + count(stmt->body) + count(stmt->elseBody);
        for (const syntax::IfBranch& branch : stmt->branches) all += count(branch.body);
        for (const syntax::CaseArm& arm : stmt->arms) all += count(arm.body);
    }
    return all;
}

/// Of a body's own statements, each belongs to a rung, and to one only (a frame to its head and its tail).
void expectEveryStatementOnce(const Diagram& diagram, const Unit& unit, const std::string& where) {
    std::map<const syntax::Stmt*, int> seen;
    for (const Rung& rung : diagram.rungs)
        for (const syntax::Stmt* stmt : rung.statements) {
            const bool isFrame = rung.kind == RungKind::Head || rung.kind == RungKind::Tail;
            EXPECT_TRUE(isFrame || ++seen[stmt] == 1) << where;
        }
    for (const Rung& rung : diagram.rungs)
        if (rung.kind == RungKind::Head) seen[rung.statements.front()] = 1;
    for (const syntax::Stmt* stmt : unit.body->statements)
        EXPECT_TRUE(stmt->kind == syntax::StmtKind::Empty || seen.count(stmt) == 1u) << where;
}

Share openAll(const std::vector<Source>& sources, const DeclaredTypes& types) {
    Share all;
    for (const Source& source : sources) {
        for (const Unit& unit : unitsOf(*source.file)) {
            const std::string where = source.path + " " + unit.name;
            for (const Form form : {Form::Ladder, Form::Blocks}) {
                const Diagram diagram = project(source.text, *source.file, unit, types, form);
                const Layout layout = computeLayout(diagram);
                EXPECT_EQ(layout.rungs.size(), diagram.rungs.size()) << where;
                EXPECT_FALSE(asSvg(layout, unit.name).empty());
                EXPECT_EQ(asText(layout).find('\t'), std::string::npos) << where;
                if (unit.body->language != syntax::BodyLanguage::St) continue;
                expectEveryStatementOnce(diagram, unit, where);
                // what a syntax error left is counted as text, too
                EXPECT_GE(diagram.share.total(), count(unit.body->statements)) << where;
                if (form == Form::Ladder) all += diagram.share;
            }
        }
    }
    return all;
}

std::vector<fs::path> folders() {
    const fs::path root(sourceDir());
    std::vector<fs::path> out{root / "runtime/library/st", root / "projects/examples", root / "tests/golden"};
    if (const char* corpus = std::getenv("STEPWISE_CORPUS")) out.emplace_back(corpus);
    return out;
}

TEST(EveryUnit, OpensInBothViewsAndIsMostlyDrawn) {
    const std::vector<Source> library = sourcesBelow(folders()[0]);
    for (const fs::path& folder : folders()) {
        const std::vector<Source> sources = sourcesBelow(folder);
        ASSERT_FALSE(sources.empty()) << folder;
        std::vector<const syntax::SyntaxFile*> files;
        for (const Source& source : sources) files.push_back(source.file.get());
        for (const Source& source : library) files.push_back(source.file.get());
        const Share share = openAll(sources, DeclaredTypes(files));
        const auto percent = [&](size_t part) {
            return 100.0 * static_cast<double>(part) / static_cast<double>(share.total());
        };
        std::printf("%s: %zu statements, %.1f %% drawn, %.1f %% frames, %.1f %% text\n", folder.filename().c_str(),
                    share.total(), percent(share.drawn), percent(share.framed), percent(share.text));
        EXPECT_GT(percent(share.drawn), 75.0) << folder;
    }
}

TEST(EveryUnit, OpensHoweverItIsCutOff) {
    const std::string whole =
        program("// c\nIF a AND (b OR NOT c) THEN x := i + 1 > j; ELSIF d THEN T1(IN := a); y := T1.Q; END_IF\n"
                "CASE i OF 1: x := y := a; 2..3: RETURN; ELSE next: JMP next; END_CASE\n"
                "FOR i := 1 TO 3 DO up(CLK := a); y := up.Q; END_FOR\n");
    for (size_t length = 0; length <= whole.size(); ++length)
        for (const Form form : {Form::Ladder, Form::Blocks}) {
            const Opened opened(whole.substr(0, length), form);
            EXPECT_GE(computeLayout(opened.diagram).height, 0);
        }
}

} // namespace
} // namespace plc::ladder
