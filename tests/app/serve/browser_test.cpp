// Panels in a real Chromium: the canvas shows what Qt paints, and what is pressed there moves the plant.
#include "chromium.h"
#include "served.h"

#include "tests/hmi/running.h"

#include <QDir>

namespace plc::serve {
namespace {

/// Share of the pixels that a person would call different.
double difference(const QImage& a, const QImage& b) {
    constexpr int kVisible = 40; // of 255, in any colour
    if (a.size() != b.size() || a.isNull()) return 1;
    const QImage left = a.convertToFormat(QImage::Format_RGB32), right = b.convertToFormat(QImage::Format_RGB32);
    qint64 count = 0;
    for (int y = 0; y < left.height(); ++y) {
        const auto* p = reinterpret_cast<const QRgb*>(left.constScanLine(y));
        const auto* q = reinterpret_cast<const QRgb*>(right.constScanLine(y));
        for (int x = 0; x < left.width(); ++x) {
            const int most = std::max({std::abs(qRed(p[x]) - qRed(q[x])), std::abs(qGreen(p[x]) - qGreen(q[x])),
                                       std::abs(qBlue(p[x]) - qBlue(q[x]))});
            count += most > kVisible ? 1 : 0;
        }
    }
    return static_cast<double>(count) / (static_cast<double>(left.width()) * left.height());
}

void keepPictures(const QString& name, const QImage& mine, const QImage& theirs) {
    const QDir folder(QString::fromStdString(binaryDir()));
    (void)folder.mkpath(QStringLiteral("browser"));
    mine.save(folder.filePath("browser/" + name + ".qt.png"));
    theirs.save(folder.filePath("browser/" + name + ".browser.png"));
}

class Browser : public testing::Test {
protected:
    static void SetUpTestSuite() {
        if (!s_chromium) s_chromium = new Chromium;
    }
    static void TearDownTestSuite() {
        delete s_chromium;
        s_chromium = nullptr;
    }
    void SetUp() override { ASSERT_TRUE(s_chromium->isRunning()) << s_chromium->problem().toStdString(); }
    static bool isDrawn(Page& page) {
        return page.waitFor(QStringLiteral("stepwise.shown > 0 && stepwise.painter.pictures.every(p => p.complete)"));
    }
    static void logIn(Page& page) {
        page.evaluate(QStringLiteral("stepwise.send({t: 'login', text: '%1'})").arg(QLatin1String(kCode)));
        EXPECT_TRUE(page.waitFor(QStringLiteral("stepwise.panel.operator == 'operator'")));
    }
    static Chromium* s_chromium;
};
Chromium* Browser::s_chromium = nullptr;

/// Every panel in every language, a quarter of a minute into the run.
void expectSamePictures(Chromium& chromium, const std::string& example) {
    ServerSettings settings;
    settings.clock = [] { return qint64(0); }; // the same phase of blinking on both sides
    Served served;
    served.open(exampleFolder(example), settings);
    if (testing::Test::HasFatalFailure()) return;
    served.machine->runHere([](const controller::Controller& c) { return c.lastTime() >= std::chrono::seconds(15); });
    for (const hmi::NamedPanel& panel : served.panels.panels)
        for (const QString& language : served.panels.texts.settings().languages) {
            const QString name = QString::fromStdString(example) + '.' + panel.name + '.' + language;
            const QImage mine = hmi::renderPanel(served.panels, served.machine.get(), panel.name, language);
            const auto page = chromium.open(served.url("panel/" + panel.name + "?bare&scale=1&language=" + language),
                                            panel.panel.size());
            QImage theirs;
            double worst = 1;
            const bool isSame = waitUntil(
                [&] {
                    if (!page->waitFor(
                            QStringLiteral("stepwise.shown > 0 && stepwise.painter.pictures.every(p => p.complete)")))
                        return true;
                    theirs = page->canvas();
                    worst = difference(mine, theirs);
                    return worst <= 0.01;
                },
                5000);
            EXPECT_TRUE(isSame && worst <= 0.01) << name.toStdString() << ": " << worst * 100 << " %";
            std::printf("%-40s %.3f %%\n", name.toUtf8().constData(), worst * 100);
            if (worst > 0.01) keepPictures(name, mine, theirs);
        }
}

TEST_F(Browser, ShowsWhatQtPaints) {
    const QDir folder(QString::fromStdString(sourceDir() + "/projects/examples"));
    QStringList names{"alarm_texts", "gravel", "motor"};
    if (qEnvironmentVariableIsSet("STEPWISE_LONG")) {
        names.clear();
        for (const QString& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
            if (!QDir(folder.filePath(name + "/hmi")).entryList({"*.panel.json"}).isEmpty()) names += name;
    }
    for (const QString& name : names) expectSamePictures(*s_chromium, name.toStdString());
}

constexpr const char* kPanel = R"(
    {"id": "go", "kind": "button", "rect": [20, 20, 160, 60], "text": "Go", "target": "Main.start", "action": "momentary"},
    {"id": "level", "kind": "numberEntry", "rect": [20, 100, 160, 60], "target": "Main.level", "minimum": "0", "maximum": "50"})";

void openMachine(Served& served, const char* elements = kPanel) {
    served.panels = hmi::machineProject();
    served.panels.panels.push_back({QStringLiteral("main"), hmi::panelOf(elements)});
    served.panels.startPanel = QStringLiteral("main");
    driver::BuildInput input;
    input.files.push_back({"main.st", hmi::kMachine});
    served.build(input);
}

TEST_F(Browser, AButtonPressedThereMovesThePlantOnceSomebodyLoggedIn) {
    Served served;
    openMachine(served);
    ASSERT_FALSE(HasFatalFailure());
    served.machine->startThread({session::Pace::Real});
    const auto page = s_chromium->open(served.url("panel/main?bare&scale=1"), {640, 400});
    ASSERT_TRUE(isDrawn(*page));
    page->click({60, 50});
    EXPECT_TRUE(page->waitFor("document.getElementById('note').textContent.includes('log in')"));
    EXPECT_EQ(served.number("Main.presses"), 0);
    logIn(*page);
    page->click({60, 50});
    EXPECT_TRUE(waitUntil([&] { return served.number("Main.presses") == 1; }));
    EXPECT_TRUE(waitUntil([&] { return served.number("Main.start") == 0; })) << "the button came up again";
}

TEST_F(Browser, ANumberIsTypedOnTheKeypadAndItsLimitsHold) {
    Served served;
    openMachine(served);
    ASSERT_FALSE(HasFatalFailure());
    served.machine->startThread({session::Pace::Real});
    const auto page = s_chromium->open(served.url("panel/main?bare&scale=1"), {640, 400});
    ASSERT_TRUE(isDrawn(*page));
    logIn(*page);
    const QString isOpen =
        QStringLiteral("stepwise.painter.elements.length == 3 && stepwise.painter.elements[2].isShown");
    page->click({60, 130});
    ASSERT_TRUE(page->waitFor(isOpen));
    for (const char* key : {"9", "9", "Enter"}) page->key(QLatin1String(key));
    EXPECT_TRUE(page->waitFor(isOpen)) << "99 lies above the limit";
    for (const char* key : {"Backspace", "Backspace", "3", "7", "Enter"}) page->key(QLatin1String(key));
    EXPECT_TRUE(page->waitFor(QStringLiteral("!(%1)").arg(isOpen)));
    EXPECT_TRUE(waitUntil([&] { return served.number("Main.level") == 37; }));
}

TEST_F(Browser, EachPersonHasALanguageAndComesBackAfterACut) {
    Served served;
    openMachine(served, R"({"id": "t", "kind": "text", "rect": [20, 20, 300, 60], "text": "@start"})");
    ASSERT_FALSE(HasFatalFailure());
    served.machine->startThread({session::Pace::Real});
    const auto danish = s_chromium->open(served.url("panel/main?language=da")),
               arabic = s_chromium->open(served.url("panel/main?language=ar"));
    const QString words = QStringLiteral("document.querySelector('#elements > *').getAttribute('aria-label')");
    ASSERT_TRUE(danish->waitFor(words + " == 'Start'"));
    ASSERT_TRUE(arabic->waitFor(words + QStringLiteral(" == 'بدء'")));
    EXPECT_EQ(arabic->evaluate("document.body.dir").toString(), "rtl");
    // The server goes and comes back at the same port.
    ServerSettings settings;
    settings.port = served.server->port();
    served.server.reset();
    ASSERT_TRUE(danish->waitFor("document.getElementById('state').className == 'bad'"));
    served.server = std::make_unique<Server>(served.panels, *served.machine, byAccessCode(kCode), settings);
    ASSERT_TRUE(served.server->start());
    EXPECT_TRUE(danish->waitFor("document.getElementById('state').className == ''", 30'000));
    EXPECT_EQ(danish->evaluate("stepwise.panel.language").toString(), "da");
}

} // namespace
} // namespace plc::serve
