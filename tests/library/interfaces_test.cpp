// Holds interfaces.json (what the guide of the Toolbox declares) against the library as it is parsed: no exception
// list.
#include "tests/library/library_texts.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

namespace plc::test {
namespace {

using nlohmann::json;

json readJson(const std::string& name) {
    std::ifstream file(plc::sourceDir() + "/tests/library/" + name);
    return json::parse(file);
}

std::string withoutBlanks(std::string_view text) {
    std::string out;
    for (const char c : text)
        if (c != ' ' && c != '\n' && c != '\t') out += c;
    return foldCase(out);
}

std::set<std::string> aliasesOf(const syntax::VarDecl& declaration) {
    std::set<std::string> names;
    for (const syntax::Pragma& pragma : declaration.pragmas) {
        if (!pragma.isAttribute || !equalsIgnoringCase(pragma.key, "alias")) continue;
        std::string name;
        for (const char c : std::string(pragma.value) + ",") {
            if (c == ',') {
                names.insert(foldCase(name));
                name.clear();
            } else if (c != ' ') {
                name += c;
            }
        }
    }
    return names;
}

void comparePins(const std::string& place, const json& expected, const std::vector<const syntax::VarDecl*>& actual,
                 std::string_view text) {
    ASSERT_EQ(actual.size(), expected.size()) << place;
    for (size_t i = 0; i < actual.size(); ++i) {
        const json& pin = expected[i];
        const syntax::VarDecl& declaration = *actual[i];
        const std::string name = pin["name"];
        ASSERT_EQ(declaration.names.size(), 1u) << place;
        EXPECT_EQ(declaration.names[0].text, name) << place << ": names and order";
        const auto& range = declaration.type->range;
        EXPECT_EQ(withoutBlanks(text.substr(range.begin, range.length())),
                  withoutBlanks(pin["type"].get<std::string>()))
            << place << '.' << name;
        std::set<std::string> wanted;
        if (pin.contains("aliases"))
            for (const json& alias : pin["aliases"])
                if (!equalsIgnoringCase(alias.get<std::string>(), name))
                    wanted.insert(foldCase(alias.get<std::string>()));
        EXPECT_EQ(aliasesOf(declaration), wanted) << place << '.' << name;
        EXPECT_FALSE(declaration.comment.empty()) << place << '.' << name << " has no comment";
    }
}

std::vector<const syntax::VarDecl*> pinsOf(const syntax::Pou& pou, syntax::SectionKind kind) {
    std::vector<const syntax::VarDecl*> pins;
    for (const syntax::VarSection* section : pou.sections)
        if (section->kind == kind) pins.insert(pins.end(), section->declarations.begin(), section->declarations.end());
    return pins;
}

TEST(ToolboxInterfaces, DeclareWhatTheGuideDeclares) {
    const ParsedLibrary toolbox = parseLibrary("toolbox");
    const json interfaces = readJson("interfaces.json");
    int pous = 0, structures = 0;
    for (const json& object : interfaces) {
        const std::string name = object["name"];
        const std::string kind = object["kind"];
        if (kind == "STRUCT") {
            ++structures;
            const auto found = toolbox.types.find(foldCase(name));
            ASSERT_NE(found, toolbox.types.end()) << name;
            const auto& [type, file] = found->second;
            EXPECT_EQ(type->name.text, name);
            ASSERT_EQ(type->spec->kind, syntax::TypeSpecKind::Struct) << name;
            comparePins(name, object["members"], {type->spec->fields.begin(), type->spec->fields.end()},
                        file->source.text);
            for (const json& alias : object.value("aliases", json::array())) {
                const auto other = toolbox.types.find(foldCase(alias.get<std::string>()));
                ASSERT_NE(other, toolbox.types.end()) << alias;
                ASSERT_FALSE(other->second.first->spec->path.empty()) << alias;
                EXPECT_TRUE(equalsIgnoringCase(other->second.first->spec->path.back().text, name)) << alias;
            }
            continue;
        }
        ++pous;
        const auto found = toolbox.pous.find(foldCase(name));
        ASSERT_NE(found, toolbox.pous.end()) << name;
        const auto& [pou, file] = found->second;
        EXPECT_EQ(pou->name.text, name);
        EXPECT_FALSE(pou->comment.empty()) << name;
        EXPECT_EQ(pou->kind, kind == "FUNCTION" ? syntax::PouKind::Function : syntax::PouKind::FunctionBlock) << name;
        comparePins(name, object["inputs"], pinsOf(*pou, syntax::SectionKind::Input), file->source.text);
        comparePins(name, object["inouts"], pinsOf(*pou, syntax::SectionKind::InOut), file->source.text);
        json outputs = json::array();
        for (const json& output : object["outputs"])
            if (kind != "FUNCTION" || output["name"] != name) outputs.push_back(output);
        comparePins(name, outputs, pinsOf(*pou, syntax::SectionKind::Output), file->source.text);
        if (kind == "FUNCTION") {
            ASSERT_NE(pou->result, nullptr) << name;
            const auto& range = pou->result->range;
            EXPECT_EQ(withoutBlanks(file->source.text.substr(range.begin, range.length())),
                      withoutBlanks(object["returns"]["type"].get<std::string>()))
                << name;
        } else {
            EXPECT_EQ(pou->result, nullptr) << name;
        }
    }
    EXPECT_EQ(pous, 50);
    EXPECT_EQ(structures, 14);
}

TEST(LibraryTexts, ParseWithoutAMessage) {
    for (const std::string_view name : library::libraries()) {
        const ParsedLibrary parsed = parseLibrary(name);
        for (const auto& diagnostic : parsed.diagnostics)
            ADD_FAILURE() << name << " at " << diagnostic.range.begin << ": " << diagnostic.message.english();
        EXPECT_FALSE(parsed.pous.empty()) << name;
        for (const auto& [folded, entry] : parsed.pous) {
            const syntax::Pou& pou = *entry.first;
            EXPECT_FALSE(pou.comment.empty()) << name << '.' << folded << " has no comment";
            for (const auto kind :
                 {syntax::SectionKind::Input, syntax::SectionKind::Output, syntax::SectionKind::InOut})
                for (const syntax::VarDecl* pin : pinsOf(pou, kind))
                    EXPECT_FALSE(pin->comment.empty()) << name << '.' << folded << '.' << pin->names[0].text;
        }
    }
}

} // namespace
} // namespace plc::test
