// Damaged files of every kind in the real window: a project with one or two of them is opened, looked at, run and
// closed. Whatever is wrong with a file is said, the others are there, and nothing crashes or hangs.
//   STEPWISE_DAMAGED=200      how many projects (12 when not given)
//   STEPWISE_RANDOM_SEED=7    the first seed; it is printed
#include "tests/app/studio_fixture.h"
#include "tests/support/damage.h"
#include "tests/support/paths.h"
#include "tests/support/settle.h"

#include "app/documents/design_pages.h"
#include "app/panels/live_views.h"
#include "projects/storage/project_file.h"

#include <QAbstractButton>
#include <QAction>
#include <QDialog>
#include <QDirIterator>
#include <QMessageBox>
#include <QTimer>

namespace plc::app {
namespace {

int numberOf(const char* variable, int otherwise) {
    bool isNumber = false;
    const int value = qEnvironmentVariableIntValue(variable, &isNumber);
    return isNumber ? value : otherwise;
}

class DamagedProjectTest : public StudioTest {
protected:
    void SetUp() override {
        QSettings("Stepwise", "Stepwise").clear();
        Settings().setSawTour();
        window = std::make_unique<MainWindow>();
        window->show();
        // Whatever asks is answered: nothing is kept, the rest is closed as by the Escape key.
        QObject::connect(&m_answers, &QTimer::timeout, [this] {
            QWidget* asks = QApplication::activeModalWidget();
            if (!asks) return;
            ++m_said;
            auto* box = qobject_cast<QMessageBox*>(asks);
            if (QAbstractButton* discard = box ? box->button(QMessageBox::Discard) : nullptr) return discard->click();
            if (auto* dialog = qobject_cast<QDialog*>(asks)) dialog->reject();
        });
        m_answers.start(10);
    }
    /// A copy of an example that has files of most kinds, and those that it has not.
    QStringList copyTo(const QString& folder) {
        const QString from = QString::fromStdString(plc::sourceDir()) + "/projects/examples/bottling";
        QStringList files;
        for (QDirIterator all(from, QDir::Files, QDirIterator::Subdirectories); all.hasNext();) {
            const QString path = all.next(), name = path.mid(from.size() + 1);
            QDir().mkpath(QFileInfo(folder + "/" + name).path());
            QFile::copy(path, folder + "/" + name);
            QFile::setPermissions(folder + "/" + name, QFile::ReadOwner | QFile::WriteOwner);
            if (!name.endsWith(".png") && !name.endsWith(".md")) files << name;
        }
        QFile::copy(QString::fromStdString(plc::sourceDir()) + "/projects/examples/modbus_tank/devices.json",
                    folder + "/devices.json");
        files << "devices.json";
        files.sort();
        return files;
    }
    void lookAtEverything() {
        window->designs().openTexts();
        window->designs().openAlarms();
        window->designs().openRecipes();
        window->designs().openPeople();
        for (const QString& file : QDir(window->workspace().folder() + "/hmi").entryList({"*.panel.json"}))
            window->designs().openPanel(file.section('.', 0, 0));
        for (const char* dock : {"devices", "trace", "panel", "problems"}) window->showDock(dock);
        settle();
        window->action("run.start")->trigger();
        settle();
        window->grab();
    }
    QTimer m_answers;
    int m_said = 0;
};

TEST_F(DamagedProjectTest, IsOpenedLookedAtAndClosedWhateverItsFilesHold) {
    const int first = numberOf("STEPWISE_RANDOM_SEED", 1), count = numberOf("STEPWISE_DAMAGED", 12);
    for (int seed = first; seed < first + count; ++seed) {
        QTemporaryDir project;
        const QStringList files = copyTo(project.path());
        plc::testing::Damage damage(static_cast<unsigned>(seed));
        // each kind in turn, and a second one by chance
        QStringList damaged{
            files[static_cast<int>(static_cast<unsigned>(seed * 7) % static_cast<unsigned>(files.size()))]};
        if (damage.pick(2)) damaged << files[static_cast<qsizetype>(damage.pick(static_cast<size_t>(files.size())))];
        for (const QString& file : damaged) {
            const std::string path = (project.path() + "/" + file).toStdString();
            const auto text = projects::readFile(path);
            ASSERT_TRUE(text) << path;
            ASSERT_TRUE(projects::writeFileAtomically(path, damage.text(*text)));
        }
        SCOPED_TRACE("seed " + std::to_string(seed) + ": " + damaged.join(", ").toStdString());
        const int before = m_said;
        if (!window->openProject(project.path())) {
            EXPECT_GT(m_said, before) << "it is refused without a word";
            continue;
        }
        ASSERT_TRUE(waitFor([&] { return window->workspace().model() != nullptr; }));
        lookAtEverything();
        window->control().disconnectSession();
        window->closeProject();
        settle();
        EXPECT_FALSE(window->workspace().isOpen());
    }
}

} // namespace
} // namespace plc::app
