// Panels in a real Chromium: the canvas shows what Qt paints, and what is pressed there moves the plant.
#include "chromium.h"
#include "served.h"
#include "service.h"
#include "thousand_elements.h"

#include "tests/hmi/running.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QTemporaryDir>

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
        return page.waitFor(QStringLiteral("stepwise.shown > 0 && stepwise.display.isWhole"));
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
                    if (!page->waitFor(QStringLiteral("stepwise.shown > 0 && stepwise.display.isWhole"))) return true;
                    theirs = page->canvas();
                    worst = difference(mine, theirs);
                    return worst <= 0.01;
                },
                kPatience);
            EXPECT_TRUE(isSame && worst <= 0.01) << name.toStdString() << ": " << worst * 100 << " %";
            std::printf("%-40s %.3f %%\n", name.toUtf8().constData(), worst * 100);
            if (worst > 0.01) keepPictures(name, mine, theirs);
        }
}

TEST_F(Browser, ShowsWhatQtPaints) {
    const QDir folder(QString::fromStdString(sourceDir() + "/projects/examples"));
    QStringList names{"alarm_texts", "depalletiser", "gravel", "motor"};
    if (qEnvironmentVariableIsSet("STEPWISE_LONG")) {
        names.clear();
        for (const QString& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
            if (!QDir(folder.filePath(name + "/hmi")).entryList({"*.panel.json"}).isEmpty()) names += name;
    }
    // One at a time: STEPWISE_EXAMPLES=car_wash,motor
    if (qEnvironmentVariableIsSet("STEPWISE_EXAMPLES")) names = qEnvironmentVariable("STEPWISE_EXAMPLES").split(u',');
    for (const QString& name : names) expectSamePictures(*s_chromium, name.toStdString());
}

/// The client keeps pictures of what stays the same and repaints only what changed; nobody may see that.
TEST_F(Browser, WhatIsRepaintedInPartsIsThePictureOfTheWhole) {
    const auto image = [](const QString& url) {
        return QImage::fromData(QByteArray::fromBase64(url.section(u',', 1).toLatin1()), "PNG");
    };
    for (const char* example : {"pwm", "six_pumps", "traffic_light"}) {
        Served served;
        served.open(exampleFolder(example));
        ASSERT_FALSE(HasFatalFailure());
        served.machine->startThread({session::Pace::Real});
        const auto page = s_chromium->open(served.url("panel/" + served.panels.startPanel + "?bare&scale=1"),
                                           served.panels.find(served.panels.startPanel)->panel.size());
        ASSERT_TRUE(page->waitFor(QStringLiteral("stepwise.display.painted > 40"))) << example;
        const QJsonArray urls = page->evaluate(QStringLiteral("stepwise.display.pictures('both')")).toArray();
        ASSERT_EQ(urls.size(), 2);
        EXPECT_LT(difference(image(urls[0].toString()), image(urls[1].toString())), 0.0005) << example;
    }
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

/// Prints what a design asks for: frames a second of `count` browsers, and what a frame costs. How many there are
/// depends on what else the machine does; that all browsers go on is certain anywhere.
void measureBrowsers(Chromium& chromium, size_t count, double scale) {
    QTemporaryDir folder;
    ASSERT_TRUE(writeThousandElements(folder.path()));
    Service service({folder.path()});
    if (testing::Test::HasFailure()) return;
    std::vector<std::unique_ptr<Page>> pages;
    for (size_t i = 0; i < count; ++i)
        pages.push_back(chromium.open(service.url + "panel/main?bare&scale=" + QString::number(scale),
                                      (QSizeF(1920, 1080) * scale).toSize()));
    for (const auto& page : pages) ASSERT_TRUE(page->waitFor(QStringLiteral("stepwise.shown > 30"), 2 * kPatience));
    const auto frames = [&] {
        std::vector<double> out;
        for (const auto& page : pages) out.push_back(page->evaluate(QStringLiteral("stepwise.shown")).toDouble());
        return out;
    };
    const std::vector<double> before = frames();
    const QHash<QString, double> cpuBefore = chromium.processorSeconds();
    const double serverBefore = service.processorSeconds();
    QElapsedTimer clock;
    clock.start();
    std::vector<double> after;
    const auto allGoOn = [&] {
        after = frames();
        return std::equal(after.begin(), after.end(), before.begin(), std::greater<>());
    };
    // a duration: over which frames are counted, and until everybody has one
    EXPECT_TRUE(waitUntil([&] { return clock.elapsed() > 4000 && allGoOn(); }, kPatience)) << "one stands still";
    const double seconds = static_cast<double>(clock.elapsed()) / 1000;
    const double server = service.processorSeconds() - serverBefore;
    const QHash<QString, double> cpu = chromium.processorSeconds();
    double sum = 0, least = 1e9;
    for (size_t i = 0; i < count; ++i) {
        EXPECT_GT(after[i], before[i]) << "browser " << i << " stands still";
        sum += after[i] - before[i];
        least = std::min(least, (after[i] - before[i]) / seconds);
    }
    const auto perFrame = [&](const char* kind) {
        return 1000 * (cpu[QLatin1String(kind)] - cpuBefore[QLatin1String(kind)]) / sum;
    };
    std::printf("%zu browsers at scale %.1f, 1,000 changing elements: %.1f frames a second each, at least %.1f; "
                "processor time of a frame: page %.1f ms, its compositor %.1f ms, browser %.1f ms, server %.1f ms\n",
                count, scale, sum / seconds / static_cast<double>(count), least, perFrame("renderer"), perFrame("GPU"),
                perFrame("browser"), 1000 * server / sum);
    service.process.terminate();
    EXPECT_TRUE(service.process.waitForFinished(kPatience));
}

TEST_F(Browser, AThousandChangingElementsInOneBrowser) { measureBrowsers(*s_chromium, 1, 1); }
TEST_F(Browser, AThousandChangingElementsInSeveralBrowsers) { // ten when there is time: each paints in software
    measureBrowsers(*s_chromium, qEnvironmentVariableIsSet("STEPWISE_LONG") ? 10 : 2, 0.5);
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
        QStringLiteral("await stepwise.display.ask('elements').then(shown => shown.length == 3 && shown[2])");
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
    EXPECT_TRUE(danish->waitFor("document.getElementById('state').className == ''"));
    EXPECT_EQ(danish->evaluate("stepwise.panel.language").toString(), "da");
}

} // namespace
} // namespace plc::serve
