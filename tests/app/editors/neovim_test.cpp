// `stepwise lsp` with a real editor: Neovim, set up by the lines of docs/editors.md.
#include "tests/support/paths.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <filesystem>

#include <gtest/gtest.h>

namespace plc {
namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
}

/// The first block of that language behind a heading.
QByteArray blockOf(const QByteArray& page, const QByteArray& heading, const QByteArray& language) {
    const qsizetype at = page.indexOf("\n## " + heading + "\n");
    const qsizetype begin = page.indexOf("```" + language + "\n", at) + language.size() + 4;
    return at < 0 || begin < at ? QByteArray() : page.mid(begin, page.indexOf("```", begin) - begin);
}

TEST(Neovim, WorksWithTheSetUpOfTheDocumentation) {
    const QString source = QString::fromStdString(sourceDir());
    const QByteArray setUp = blockOf(contentOf(source + "/docs/editors.md"), "Neovim", "lua");
    ASSERT_TRUE(setUp.contains("stepwise"));
    QTemporaryDir folder;
    std::filesystem::copy(sourceDir() + "/tests/projects/language_server/plant", folder.filePath("plant").toStdString(),
                          std::filesystem::copy_options::recursive);
    QFile init(folder.filePath("init.lua"));
    ASSERT_TRUE(init.open(QIODevice::WriteOnly) && init.write(setUp) == setUp.size());
    init.close();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QString::fromStdString(binaryDir()) + "/bin:" + environment.value("PATH"));
    for (const char* place : {"HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
        environment.insert(place, folder.path());
    QProcess neovim;
    neovim.setProcessEnvironment(environment);
    neovim.setWorkingDirectory(folder.filePath("plant"));
    neovim.setProcessChannelMode(QProcess::MergedChannels);
    neovim.start("nvim", {"--headless", "-n", "-i", "NONE", "-u", init.fileName(), "-c",
                          "luafile " + source + "/tests/app/editors/neovim.lua"});
    ASSERT_TRUE(neovim.waitForStarted(kPatience)) << "neovim is missing: .ci/packages.txt names it";
    ASSERT_TRUE(neovim.waitForFinished(5 * kPatience));
    const QByteArray output = neovim.readAll();
    EXPECT_EQ(neovim.exitCode(), 0) << output.toStdString();
    EXPECT_TRUE(output.contains("all good")) << output.toStdString();
    EXPECT_TRUE(contentOf(folder.filePath("plant/src/pump.st")).contains("runs := start AND speed > 0;"));
}

} // namespace
} // namespace plc
