// kill -9 in the middle of a save: every file the studio writes is the whole old or the whole new one. A second process
// saves without end (saveWithoutEnd) and is killed at moments from a seed; the files are compared with the two texts it
// writes in turn. And a disk without room: the old file stays, and it is said which one was not written and why.
#include "tests/app/killed_save.h"
#include "tests/support/paths.h"
#include "tests/support/patience.h"

#include "editor/trace/setup/trace_setup.h"
#include "editor/workspace/workspace.h"
#include "hmi/station/panel_project.h"
#include "projects/session/session.h"
#include "projects/storage/project_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <random>
#include <sys/resource.h>

namespace plc::app {
namespace {

/// Everything the studio writes into a project, in two forms.
class Writers {
public:
    explicit Writers(const QString& folder) : m_folder(folder) {
        QDir().mkpath(folder + "/src");
        for (const char* part : {"hmi", "traces", "expected"}) QDir().mkpath(folder + "/" + part);
        QFile main(folder + "/src/main.st");
        if (!main.exists() && main.open(QIODevice::WriteOnly))
            main.write("PROGRAM Main\nVAR RETAIN n : DINT; END_VAR\nn := n + 1;\nEND_PROGRAM\n");
        QFile project(folder + "/project.json");
        if (!project.exists() && project.open(QIODevice::WriteOnly)) project.write("{\n  \"name\": \"A\"\n}\n");
        main.close();
        project.close();
        EXPECT_TRUE(m_workspace.open(folder));
        for (const char* example : {"gravel", "agv"}) {
            const auto opened = projects::openProject({plc::sourceDir() + "/projects/examples/" + example});
            m_panels.push_back(hmi::loadPanelProject(*opened));
            m_panels.back().folder = folder;
            m_panels.back().disk.reset(); // two forms take turns, each over the other
        }
        for (int scans : {200, 300}) {
            session::Settings settings;
            settings.retainFile = (folder + "/retain.json").toStdString();
            QFile::remove(folder + "/retain.json");
            driver::BuildInput input;
            input.files.push_back(
                {"src/main.st", "PROGRAM Main\nVAR RETAIN n : DINT; END_VAR\nn := n + 1;\nEND_PROGRAM\n"});
            m_sessions.push_back(std::make_unique<session::Session>(driver::build(input), settings));
            m_sessions.back()->runHere(
                [&](const controller::Controller& c) { return c.nextScan() >= static_cast<uint64_t>(scans); });
        }
    }

    static QStringList files() {
        return {"src/main.st",   "project.json",    "hmi/overview.panel.json",
                "hmi/texts.csv", "hmi/alarms.json", "traces/one.trace.json",
                "run.rec",       "retain.json"};
    }

    Result<void> save(const QString& file, int form) {
        const hmi::PanelProject& panels = m_panels[static_cast<size_t>(form)];
        if (file.endsWith(".st")) {
            std::string text = "PROGRAM Main\nVAR RETAIN n : DINT; END_VAR\n";
            for (int i = 0; i < 2000; ++i)
                text += form ? "n := n + 2; // the second form\n" : "n := n + 1; // the first\n";
            m_workspace.setText(file, text + "END_PROGRAM\n");
            return m_workspace.save(file);
        }
        if (file == "project.json") {
            projects::Project project = m_workspace.project();
            project.json["name"] = std::string(form ? 4000 : 3000, form ? 'b' : 'a');
            return projects::saveProjectFile(project);
        }
        if (file.endsWith(".panel.json")) return hmi::savePanel(panels, {"overview", panels.panels.front().panel});
        if (file.endsWith(".csv")) return hmi::saveTexts(panels);
        if (file == "hmi/alarms.json") return hmi::saveAlarms(panels);
        if (file.endsWith(".trace.json"))
            return trace::saveSetup(trace::setupOf(form ? std::vector<std::string>{"Main.n", "Main.n * 2"}
                                                        : std::vector<std::string>{"Main.n"}),
                                    (m_folder + "/" + file).toStdString());
        if (file.endsWith(".rec"))
            return m_sessions[static_cast<size_t>(form)]->history().save((m_folder + "/" + file).toStdString());
        return m_sessions[static_cast<size_t>(form)]->saveRetained();
    }

private:
    QString m_folder;
    editor::Workspace m_workspace;
    std::vector<hmi::PanelProject> m_panels;
    std::vector<std::unique_ptr<session::Session>> m_sessions;
};

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}
QString expected(const QString& folder, const QString& file, int form) {
    return folder + "/expected/" + QString(file).replace('/', '_') + (form ? ".b" : ".a");
}

TEST(KilledSave, LeavesTheWholeOldOrTheWholeNewFile) {
    QTemporaryDir folder;
    std::mt19937 random(20261121);
    QMap<QString, QSet<int>> seen;
    for (int round = 0; round < 12; ++round) {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("STEPWISE_SAVE_FOLDER", folder.path());
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationFilePath(), QStringList());
        ASSERT_TRUE(process.waitForStarted(kPatience));
        QByteArray output;
        while (!output.contains("ready\n") && process.waitForReadyRead(kPatience)) output += process.readAll();
        ASSERT_TRUE(output.contains("ready\n")) << output.toStdString();
        QTest::qSleep(static_cast<int>(random() % 40)); // a duration: any moment of saving may be the last
        ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
        process.waitForFinished(kPatience);
        for (const QString& file : Writers::files()) {
            const QByteArray now = contentOf(folder.path() + "/" + file);
            const QByteArray forms[2] = {contentOf(expected(folder.path(), file, 0)),
                                         contentOf(expected(folder.path(), file, 1))};
            ASSERT_FALSE(forms[0].isEmpty()) << file.toStdString();
            ASSERT_NE(forms[0], forms[1]) << file.toStdString() << ": the test needs two forms";
            EXPECT_TRUE(now == forms[0] || now == forms[1])
                << file.toStdString() << " is neither, with " << now.size() << " bytes; " << forms[0].size() << " or "
                << forms[1].size() << " were written";
            seen[file].insert(now == forms[1]);
        }
    }
    int both = 0;
    for (const QSet<int>& forms : seen) both += forms.size() == 2;
    EXPECT_GT(both, 0) << "no kill hit another moment than the others";
}

/// No file may become larger than this while it lives: what a full disk is to those who write.
class NoRoom {
public:
    explicit NoRoom(rlim_t bytes) {
        EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &m_before), 0);
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit tight{bytes, m_before.rlim_max};
        EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    }
    ~NoRoom() {
        ::setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }
    NoRoom(const NoRoom&) = delete;
    NoRoom& operator=(const NoRoom&) = delete;

private:
    rlimit m_before{};
    void (*m_handler)(int) = nullptr;
};

QStringList allFiles(const QString& folder) {
    QStringList out;
    for (QDirIterator each(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories); each.hasNext();)
        out << each.next();
    out.sort();
    return out;
}

TEST(FullDisk, LeavesEachOldFileAndSaysWhichItIsAndWhatToDo) {
    QTemporaryDir folder;
    Writers writers(folder.path());
    for (const QString& file : Writers::files()) {
        SCOPED_TRACE(file.toStdString());
        ASSERT_TRUE(writers.save(file, 0));
        const QByteArray before = contentOf(folder.path() + "/" + file);
        const QStringList files = allFiles(folder.path());
        Result<void> refused;
        {
            const NoRoom full(16);
            refused = writers.save(file, 1);
        }
        ASSERT_FALSE(refused) << "saved, it is said";
        EXPECT_EQ(contentOf(folder.path() + "/" + file), before);
        EXPECT_EQ(allFiles(folder.path()), files) << "something half is left";
        const std::string said = refused.error().english();
        EXPECT_NE(said.find(file.section('/', -1).toStdString()), std::string::npos) << said;
        EXPECT_NE(said.find("; "), std::string::npos) << "no remedy: " << said;
        EXPECT_TRUE(writers.save(file, 1)) << "once there is room";
        EXPECT_NE(contentOf(folder.path() + "/" + file), before);
    }
}

} // namespace

int saveWithoutEnd(const QString& folder) {
    Writers writers(folder);
    for (const QString& file : Writers::files())
        for (int form : {0, 1}) {
            if (!writers.save(file, form)) return 1;
            QFile::remove(expected(folder, file, form));
            QFile::copy(folder + "/" + file, expected(folder, file, form));
        }
    std::printf("ready\n");
    std::fflush(stdout);
    for (int turn = 0;; ++turn)
        for (const QString& file : Writers::files()) (void)writers.save(file, turn % 2);
}

} // namespace plc::app
