// Libraries in the studio: their sources open read-only and can be halted in; what they hide is not offered.
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QRegularExpression>

namespace plc::app {
namespace {

TEST_F(StudioTest, ABreakpointInALibraryBlockHaltsThere) {
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("TON")));
    window->action("edit.definition")->trigger();
    editor::StEditor* library = window->tabs().currentEditor();
    ASSERT_NE(library, nullptr);
    ASSERT_TRUE(library->file().startsWith("library/")) << library->file().toStdString();
    EXPECT_TRUE(library->isReadOnly());
    // The first assignment of the block's body.
    const std::string text = library->utf8();
    const size_t at = text.find(":=", text.find("END_VAR", text.rfind("END_VAR", text.find("END_FUNCTION_BLOCK"))));
    ASSERT_NE(at, std::string::npos);
    library->goTo(static_cast<uint32_t>(at));
    const QString file = library->file();
    window->action("run.breakpoint")->trigger();
    ASSERT_EQ(window->control().breakpoints().size(), 1u);
    EXPECT_EQ(window->control().breakpoints().front().file, file);
    window->tabs().setCurrentIndex(0);
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Halted; }));
    EXPECT_TRUE(waitFor([&] {
        return window->tabs().currentEditor() && window->tabs().currentEditor()->file() == file;
    })) << "the halted line is in front";
}

TEST_F(StudioTest, CompletionDoesNotOfferWhatALibraryHides) {
    write("project.json", "{\n  \"name\": \"Test\",\n  \"libraries\": [\"toolbox\", \"analog\", \"plant\"]\n}\n");
    window->openProject(folder.path());
    ASSERT_TRUE(waitFor([&] { return window->workspace().model() != nullptr; }));
    const auto model = window->workspace().model();
    QStringList hidden;
    for (const auto& file : model->sources().files) {
        const QString text = QString::fromStdString(std::string(file.text()));
        static const QRegularExpression unit(
            "\\{attribute "
            "'hide'\\}\\s*(?:FUNCTION_BLOCK|FUNCTION)\\s+(?:(?:PUBLIC|INTERNAL|FINAL|ABSTRACT)\\s+)*(\\w+)");
        for (auto it = unit.globalMatch(text); it.hasNext();) hidden << it.next().captured(1);
    }
    ASSERT_FALSE(hidden.isEmpty()) << "the libraries hide something";
    const std::string text = window->workspace().text("src/main.st");
    for (const QString& name : hidden) {
        const std::string typed = text.substr(0, text.find("END_PROGRAM")) + name.left(3).toStdString();
        const auto offered = model->complete(*model->fileOf("src/main.st"), typed + "\nEND_PROGRAM\n",
                                             static_cast<uint32_t>(typed.size()));
        for (const auto& item : offered.items) EXPECT_NE(QString::fromStdString(item.text), name);
    }
}

} // namespace
} // namespace plc::app
