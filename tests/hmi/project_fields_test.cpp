// What project.json says of panels and is not so: a language that nobody speaks, a list that is none, a panel that is
// not there. Each is one finding, and the rest of the project is as it was.
#include "hmi/check/panel_check.h"
#include "hmi/station/panel_project.h"
#include "hmi/texts/language_tags.h"
#include "projects/storage/project_file.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

class ProjectFields : public ::testing::Test {
protected:
    /// Of a project with a panel "main" and this project.json.
    Result<projects::Project> opened(const std::string& json) {
        const std::string folder = m_folder.path().toStdString();
        (void)QDir(m_folder.path()).mkpath(QStringLiteral("hmi"));
        (void)QDir(m_folder.path()).mkpath(QStringLiteral("src"));
        EXPECT_TRUE(projects::writeFileAtomically(folder + "/project.json", json));
        EXPECT_TRUE(projects::writeFileAtomically(folder + "/hmi/main.panel.json", "{\"elements\": []}"));
        return projects::openProject({folder});
    }
    /// Problems of the files and findings of the check about project.json, one a line.
    std::string findings(const std::string& json) {
        const auto project = opened(json);
        EXPECT_TRUE(project) << project.error().english();
        if (!project) return {};
        const PanelProject panels = loadPanelProject(*project);
        EXPECT_EQ(panels.panels.size(), 1u);
        std::string out;
        for (const Error& each : panels.problems) out += each.english() + "\n";
        for (const Finding& each : checkPanels(panels.checkInput()))
            if (each.file == QStringLiteral("project.json")) out += each.text().toStdString() + "\n";
        return out;
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(ProjectFields, ALanguageThatNobodySpeaksIsAFinding) {
    EXPECT_EQ(findings(R"({"hmi": {"languages": ["en", "de-AT", "sr-Latn", "ar-u-nu-latn"], "fallback": ["de"]}})"),
              "");
    EXPECT_EQ(findings(R"({"hmi": {"languages": ["en", "xx,yy"], "fallback": ["german"]}})"),
              "project.json: languages: error H1016: xx,yy is not the code of a language; use codes such as de or "
              "pt-BR\n"
              "project.json: fallback: error H1016: german is not the code of a language; use codes such as de or "
              "pt-BR\n");
}

TEST_F(ProjectFields, AListThatIsNoneIsAProblem) {
    EXPECT_EQ(findings(R"({"hmi": {"languages": "en,de"}})"),
              "project.json: \"languages\" must be a list; put it in square brackets\n");
    for (const char* wrong : {R"({"libraries": "util"})", R"({"defines": ["A", 5]})"}) {
        const auto project = opened(wrong);
        ASSERT_FALSE(project) << wrong;
        EXPECT_NE(project.error().english().find("must be a list of names"), std::string::npos)
            << project.error().english();
    }
}

TEST_F(ProjectFields, AStartPanelThatIsNotThereIsAProblem) {
    EXPECT_EQ(findings(R"({"hmi": {"startPanel": "main"}})"), "");
    EXPECT_EQ(findings(R"({"hmi": {"startPanel": "mian"}})"),
              "project.json: There is no panel mian; create it or choose another one\n");
}

TEST(LanguageTags, TheReadersIsChosenAmongThose) {
    const QStringList tags{"en", "de-AT", "zh", "zh-TW", "de"};
    EXPECT_EQ(closestTag(tags, QLocale("de_DE")).toStdString(), "de-AT");
    EXPECT_EQ(closestTag(tags, QLocale("zh_TW")).toStdString(), "zh-TW");
    EXPECT_EQ(closestTag(tags, QLocale("zh_CN")).toStdString(), "zh");
    EXPECT_EQ(closestTag(tags, QLocale("fr_FR")).toStdString(), "en");
    EXPECT_EQ(closestTag({}, QLocale("fr_FR")).toStdString(), "");
}

} // namespace
} // namespace plc::hmi
