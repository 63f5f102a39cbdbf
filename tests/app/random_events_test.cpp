// A careless user: random keys and mouse on the real window, from a seed. Nothing may crash, hang or lose a text.
//   STEPWISE_RANDOM_EVENTS=10000   how many (300 when not given)
//   STEPWISE_RANDOM_SEED=7         the same seed gives the same events (the seed is printed)
//   STEPWISE_RANDOM_TRACE=1        prints each event before it happens
#include "tests/app/studio_fixture.h"
#include "tests/support/paths.h"
#include "tests/support/repeats.h"

#include "app/documents/design_pages.h"
#include "app/panels/live_views.h"
#include "app/settings/settings_dialog.h"
#include "editor/kit/theme.h"
#include "editor/tuning/tuning_view.h"
#include "hmi/designer/panel_designer.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QDialog>
#include <QDockWidget>
#include <QDrag>
#include <QFileDialog>
#include <QInputDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <QWheelEvent>
#include <QWindow>

#include <array>
#include <cstdio>
#include <random>

namespace plc::app {
namespace {

void copyFolder(const QString& from, const QString& to) {
    QDir().mkpath(to);
    for (const QFileInfo& entry : QDir(from).entryInfoList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot)) {
        if (entry.isDir())
            copyFolder(entry.filePath(), to + "/" + entry.fileName());
        else
            QFile::copy(entry.filePath(), to + "/" + entry.fileName());
    }
}

int numberOf(const char* variable, int fallback) {
    bool ok = false;
    const int n = qEnvironmentVariableIntValue(variable, &ok);
    return ok ? n : fallback;
}

/// Closes what would wait for an answer: menus, dialogs, drags. Which answer it gives comes from the seed and from how
/// many it gave.
class Answers : public QObject {
public:
    explicit Answers(uint32_t seed) : m_random(seed ^ 0x9e3779b9U) {
        m_timer.setInterval(10);
        connect(&m_timer, &QTimer::timeout, this, &Answers::look);
        m_timer.start();
    }

private:
    void look() {
        if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) return answerMenu(menu);
        if (QWidget* popup = QApplication::activePopupWidget()) {
            if (++m_popupAge < 3) return;
            m_popupAge = 0;
            popup->close();
            return;
        }
        m_popupAge = 0;
        if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) answer(dialog);
        QDrag::cancel();
    }
    void answerMenu(QMenu* menu) {
        if (++m_popupAge < 2) return;
        m_popupAge = 0;
        const uint32_t choice = m_random();
        const QList<QAction*> actions = menu->actions();
        QAction* chosen = actions.isEmpty() ? nullptr : actions[static_cast<int>(choice >> 8) % actions.size()];
        if (choice % 3 != 0 || !chosen || chosen->menu() || chosen->objectName() == "file.quit")
            return void(menu->close());
        menu->setActiveAction(chosen);
        later(menu, [menu] { QTest::keyPress(menu, Qt::Key_Return); });
    }
    void answer(QDialog* dialog) {
        if (m_dialog != dialog) {
            m_dialog = dialog;
            m_dialogAge = 0;
        }
        if (++m_dialogAge < 2) return;
        m_dialog = nullptr;
        const uint32_t choice = m_random();
        // Files of this machine and limits of memory are not the test's to play with.
        auto* input = qobject_cast<QInputDialog*>(dialog);
        if (qobject_cast<QFileDialog*>(dialog) || qobject_cast<SettingsDialog*>(dialog) ||
            (input && input->inputMode() == QInputDialog::IntInput))
            return dialog->reject();
        if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
            const QList<QAbstractButton*> buttons = box->buttons();
            if (buttons.isEmpty()) return box->reject();
            return later(box, [button = buttons[static_cast<int>(choice >> 8) % buttons.size()]] { button->click(); });
        }
        if (choice & 1) {
            const QPointer<QWidget> field(dialog->focusWidget() ? dialog->focusWidget() : dialog);
            for (const QChar c : QString("x%1").arg(choice >> 20))
                if (field) QTest::keyPress(field, c.toLatin1());
            if (choice & 2) return later(dialog, [dialog] { dialog->accept(); });
        }
        dialog->reject();
    }

    /// An answer may open the next dialog, which needs this timer again: not from within its own call.
    template <class F> static void later(QObject* context, F&& f) {
        QTimer::singleShot(0, context, std::forward<F>(f));
    }

    QTimer m_timer;
    std::mt19937 m_random;
    QDialog* m_dialog = nullptr;
    int m_popupAge = 0, m_dialogAge = 0;
};

/// One event; every field is drawn whatever the window looks like, so that the row of events depends on the seed alone.
struct Event {
    uint32_t kind, x, y, dx, dy, key, modifiers, which;
};

constexpr std::array kKeys{
    Qt::Key_Return, Qt::Key_Tab,   Qt::Key_Backspace, Qt::Key_Delete, Qt::Key_Escape, Qt::Key_Up,       Qt::Key_Down,
    Qt::Key_Left,   Qt::Key_Right, Qt::Key_Home,      Qt::Key_End,    Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_F2,
    Qt::Key_F3,     Qt::Key_F4,    Qt::Key_F5,        Qt::Key_F7,     Qt::Key_F8,     Qt::Key_F9,       Qt::Key_F10,
    Qt::Key_F11,    Qt::Key_F12,   Qt::Key_Space,     Qt::Key_Menu,   Qt::Key_A,      Qt::Key_C,        Qt::Key_V,
    Qt::Key_X,      Qt::Key_Z,     Qt::Key_Y,         Qt::Key_D,      Qt::Key_G,      Qt::Key_S,        Qt::Key_F,
    Qt::Key_Slash,  Qt::Key_Plus,  Qt::Key_Minus,     Qt::Key_I,      Qt::Key_O,      Qt::Key_P,        Qt::Key_T,
    Qt::Key_W,      Qt::Key_Insert};
constexpr std::array kWords{"IF a THEN\n", "END_IF;",      "x := 1;",
                            "pulse.",      "(* ",          "*)",
                            "'",           "VAR\n",        "FOR i := 0 TO 3 DO\n",
                            "MAIN(",       "{attribute '", "ü",
                            "//",          "16#FF",        "T#1s",
                            ":=",          "END_VAR",      "STEP S:",
                            "\"",          "[[",           "12345678901234567890"};

class RandomEvents : public ::testing::Test {
protected:
    void SetUp() override {
        m_home.emplace("HOME", m_folder.path() + "/home");
        m_examples.emplace("STEPWISE_EXAMPLES", m_folder.path() + "/examples");
        QDir().mkpath(m_folder.path() + "/home");
        for (const char* name : {"gravel", "pid_pt1"})
            copyFolder(QString::fromStdString(plc::sourceDir()) + "/projects/examples/" + name,
                       m_folder.path() + "/examples/" + name);
        copyFolder(QString::fromStdString(plc::sourceDir()) + "/projects/examples/" + example(), project());
        QSettings("Stepwise", "Stepwise").clear();
        Settings().setSawTour();
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(m_window.get()));
        openAgain();
    }
    void TearDown() override {
        if (m_window) m_window->control().disconnectSession();
        m_window.reset();
        kit::Theme::current().setChoice(kit::ThemeChoice::Light);
    }
    [[nodiscard]] QString project() const { return m_folder.path() + "/project"; }
    [[nodiscard]] virtual QString example() const { return "gravel"; }

    virtual void openAgain() {
        if (!m_window->isVisible()) m_window->show();
        if (m_window->workspace().isOpen()) return;
        m_window->openProject(project());
        (void)QTest::qWaitFor([&] { return m_window->workspace().model() != nullptr; }, 20'000);
    }

    /// The window that takes events now: a menu or dialog, else mostly the main window, sometimes another that is open.
    [[nodiscard]] QWidget* top(uint32_t which) const {
        if (QWidget* popup = QApplication::activePopupWidget()) return popup;
        if (QWidget* modal = QApplication::activeModalWidget()) return modal;
        QList<QWidget*> others;
        for (QWidget* each : QApplication::topLevelWidgets())
            if (each->isVisible() && each != m_window.get() && each->windowType() != Qt::ToolTip &&
                each->windowHandle())
                others << each;
        std::sort(others.begin(), others.end(), [](const QWidget* a, const QWidget* b) {
            return a->objectName() + a->windowTitle() < b->objectName() + b->windowTitle();
        });
        if (others.isEmpty() || which % 4) return m_window.get();
        return others[static_cast<int>(which / 4) % others.size()];
    }

    virtual void goSomewhere(uint32_t where) {
        MainWindow& w = *m_window;
        if (!w.workspace().isOpen()) return openAgain();
        switch (where % 9) {
        case 0:
            if (!w.live().panels().panels.empty()) w.designs().openPanel(w.live().panels().panels.front().name);
            return;
        case 1:
            return w.designs().openTexts();
        case 2:
            return w.designs().openAlarms();
        case 3:
            return w.tabs().showChart("src/main.st", "");
        case 4:
            return w.showDock("trace");
        case 5:
            return w.showDock("panel");
        case 6:
            return w.resetLayout();
        case 7: {
            const QStringList files = w.workspace().files();
            if (!files.isEmpty()) w.tabs().openFile(files[static_cast<int>(where / 9) % files.size()]);
            return;
        }
        default: {
            const auto docks = w.findChildren<QDockWidget*>();
            if (QDockWidget* dock = docks[static_cast<int>(where / 9) % docks.size()]; where & 0x10000)
                dock->setFloating(!dock->isFloating());
            else
                w.showDock(dock->objectName());
            return;
        }
        }
    }

    // A press may take its window away; what follows goes to the window only while it lives.
    // QTest::keyPress goes on with a window that the press of a modifier has taken away.
    static void key(QWindow* to, int key, Qt::KeyboardModifiers modifiers) {
        const QPointer<QWindow> window(to);
        const auto send = [&](bool isPress, int code, Qt::KeyboardModifiers held, const QString& text = {}) {
            if (window) QTest::simulateEvent(window, isPress, code, held, text, false);
        };
        static constexpr std::array<std::pair<Qt::KeyboardModifier, Qt::Key>, 3> kHeld{
            {{Qt::ShiftModifier, Qt::Key_Shift},
             {Qt::ControlModifier, Qt::Key_Control},
             {Qt::AltModifier, Qt::Key_Alt}}};
        Qt::KeyboardModifiers held;
        for (const auto& [modifier, own] : kHeld)
            if (modifiers & modifier) {
                send(true, own, held);
                held |= modifier;
            }
        const char ascii = QTest::keyToAscii(static_cast<Qt::Key>(key));
        const QString text = ascii ? QString(QChar::fromLatin1(ascii)) : QString();
        send(true, key, modifiers, text);
        send(false, key, modifiers, text);
        for (auto each = kHeld.rbegin(); each != kHeld.rend(); ++each)
            if (modifiers & each->first) {
                send(false, each->second, held);
                held &= ~each->first;
            }
    }
    static void click(QWindow* to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint at, int times = 1) {
        const QPointer<QWindow> window(to);
        for (int i = 0; i < times; ++i) {
            if (window) QTest::mousePress(window, button, modifiers, at);
            if (window) QTest::mouseRelease(window, button, modifiers, at);
        }
        if (times > 1 && window) QTest::mouseDClick(window, button, modifiers, at);
    }

    void apply(const Event& event) {
        QPointer<QWidget> target = top(event.which);
        if (!target || !target->windowHandle()) return;
        QWindow* window = target->windowHandle();
        const auto at = [&](uint32_t x, uint32_t y) {
            return QPoint(static_cast<int>(x % static_cast<uint32_t>(std::max(1, target->width()))),
                          static_cast<int>(y % static_cast<uint32_t>(std::max(1, target->height()))));
        };
        const QPoint from = at(event.x, event.y);
        static constexpr std::array<Qt::KeyboardModifier, 6> kModifiers{
            Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ControlModifier, Qt::ShiftModifier, Qt::AltModifier};
        const Qt::KeyboardModifiers modifiers = kModifiers[event.modifiers % kModifiers.size()];
        switch (event.kind % 20) {
        case 0:
        case 1:
        case 2:
        case 3:
        case 4:
            return click(window, Qt::LeftButton, modifiers, from);
        case 5:
            return click(window, Qt::LeftButton, modifiers, from, 2);
        case 6:
            return click(window, Qt::RightButton, Qt::NoModifier, from);
        case 7:
        case 8: { // a drag, also a short one
            const QPoint to = event.dx & 1 ? at(event.dx >> 1, event.dy)
                                           : from + QPoint(static_cast<int>(event.dx % 60) - 30,
                                                           static_cast<int>(event.dy % 60) - 30);
            QTest::mousePress(window, Qt::LeftButton, modifiers, from);
            QPointer<QWindow> alive(window);
            for (int step = 1; step <= 4 && alive; ++step) QTest::mouseMove(alive, from + (to - from) * step / 4);
            if (alive) QTest::mouseRelease(alive, Qt::LeftButton, modifiers, to);
            return;
        }
        case 9: { // the wheel
            QWidget* under = target->childAt(from);
            if (!under) return;
            QWheelEvent wheel(under->mapFrom(target, from), target->mapToGlobal(from), {},
                              QPoint(0, event.dy & 1 ? 120 : -120), Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
            QApplication::sendEvent(under, &wheel);
            return;
        }
        case 10:
        case 11:
        case 12:
        case 13:
            return key(window, kKeys[event.key % kKeys.size()],
                       modifiers | (event.modifiers & 0x100 ? Qt::ShiftModifier : Qt::NoModifier));
        case 14:
        case 15: {
            const QString word = QString::fromUtf8(kWords[event.key % kWords.size()]);
            for (const QChar c : word) {
                if (!target || !target->windowHandle()) return;
                window = target->windowHandle();
                if (c == '\n')
                    key(window, Qt::Key_Return, Qt::NoModifier);
                else
                    QTest::sendKeyEvent(QTest::Press, window, Qt::Key_unknown, c, Qt::NoModifier);
            }
            return;
        }
        case 16:
        case 17: { // any action, as from the palette
            const QList<QAction*> actions = m_window->allActions();
            QAction* action = actions[static_cast<int>(event.key >> 1) % actions.size()];
            if (action->objectName() == "file.quit" || QApplication::activeModalWidget()) return;
            return action->trigger();
        }
        default:
            return goSomewhere(event.key);
        }
    }

    void makeEvents(int fewer = 1) {
        const auto seed = static_cast<uint32_t>(numberOf("STEPWISE_RANDOM_SEED", 1));
        const int count = numberOf("STEPWISE_RANDOM_EVENTS", 300) / fewer;
        const bool traced = qEnvironmentVariableIsSet("STEPWISE_RANDOM_TRACE");
        std::printf("seed %u, %d events\n", seed, count);
        std::mt19937 random(seed);
        Answers answers(seed);
        for (int i = 0; i < count; ++i) {
            Event event{};
            for (uint32_t* field :
                 {&event.kind, &event.x, &event.y, &event.dx, &event.dy, &event.key, &event.modifiers, &event.which})
                *field = random();
            if (traced) {
                const QWidget* shown = m_window->tabs().currentWidget();
                std::fprintf(stderr, "%d: kind %u at %u,%u key %u modifiers %u which %u on %s\n", i, event.kind % 20,
                             event.x % 1440, event.y % 900, event.key, event.modifiers % 6, event.which % 4,
                             shown ? shown->metaObject()->className() : "-");
            }
            apply(event);
            QApplication::processEvents();
            if (i % 50 == 49) {
                openAgain();
                checkTexts();
                if (HasFatalFailure()) FAIL() << "after event " << i << " of seed " << seed;
            }
            if (qobject_cast<QWidget*>(QApplication::activeModalWidget()) || QApplication::activePopupWidget())
                QTest::qWait(15); // a duration: Answers looks for dialogs by a timer
        }
        (void)QTest::qWaitFor([] { return !QApplication::activeModalWidget() && !QApplication::activePopupWidget(); },
                              20'000);
        openAgain();
        checkTexts();
    }

    /// What an editor shows is what the project holds: nothing typed gets lost on the way.
    void checkTexts() {
        if (!m_window->workspace().isOpen()) return;
        for (const QString& file : m_window->tabs().openFiles())
            ASSERT_EQ(m_window->tabs().pageOf(file)->first().utf8(), m_window->workspace().text(file))
                << file.toStdString();
    }

    /// Sets a variable of the environment for the length of a test.
    struct Variable {
        Variable(const char* name, const QString& value) : m_name(name), m_before(qgetenv(name)) {
            qputenv(name, value.toUtf8());
        }
        ~Variable() { m_before.isNull() ? (void)qunsetenv(m_name) : (void)qputenv(m_name, m_before); }
        Variable(const Variable&) = delete;
        Variable& operator=(const Variable&) = delete;
        const char* m_name;
        QByteArray m_before;
    };
    QTemporaryDir m_folder;
    std::optional<Variable> m_home, m_examples;
    std::unique_ptr<MainWindow> m_window;
};

TEST_F(RandomEvents, NeitherCrashNorLoseAText) { makeEvents(); }

/// The controller runs as fast as it can and soon forgets what is looked at: the oldest scans go while a view, a search
/// or a second run of a scan reads them.
class ShortRecording : public RandomEvents {
protected:
    [[nodiscard]] QString example() const override { return "cascade"; }
    void openAgain() override {
        RandomEvents::openAgain();
        editor::RunControl& control = m_window->control();
        control.setHistoryBudget(size_t(2) << 20);
        control.setMode({session::Pace::Fastest, 1.0});
        if (control.isBuilding() || control.isEnding()) return;
        if (!control.isOnline()) repair();
        control.setBreakpoints({});
        control.start();
    }
    /// Takes the program as it was: what was typed into it has errors.
    void repair() {
        const QString folder = QString::fromStdString(plc::sourceDir()) + "/projects/examples/" + example() + "/src";
        QDir(project() + "/src").removeRecursively();
        copyFolder(folder, project() + "/src");
        for (const QString& file : m_window->workspace().files()) m_window->workspace().revert(file);
    }
    void goSomewhere(uint32_t where) override {
        const history::History* recorded = m_window->control().shownHistory();
        if (where % 2 || !recorded) return RandomEvents::goSomewhere(where / 2);
        lookBack(where / 2, *recorded);
    }
    void lookBack(uint32_t where, const history::History& recorded) {
        editor::RunControl& control = m_window->control();
        const history::Statistics there = recorded.statistics();
        if (there.first == there.end) return;
        static constexpr std::array kActions{"time.back",   "time.walk",  "time.backIn", "time.passBack",
                                             "time.why",    "time.who",   "time.whyNot", "time.coverage",
                                             "time.whatIf", "time.resume"};
        switch (where % 6) {
        case 0:
            return control.view(there.first);
        case 1:
            return control.view(there.first + (where / 6) % (there.end - there.first));
        case 2:
            return control.view(std::nullopt);
        case 3:
            m_window->showDock("tuning");
            if (auto* tuning = m_window->findChild<editor::TuningView*>()) tuning->findSteps();
            return;
        default:
            for (QAction* action : m_window->allActions())
                if (action->objectName() == kActions[(where / 6) % kActions.size()]) return action->trigger();
        }
    }
};

// At full speed a sanitizer leaves the window little time.
TEST_F(ShortRecording, IsLookedBackOnWhileItForgets) { makeEvents(kFewer); }

} // namespace
} // namespace plc::app
