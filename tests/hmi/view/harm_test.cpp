// What a panel file from anywhere can do to the studio: numbers beyond every bound, pictures that unpack or draw
// without end, and pictures that are not the project's.
#include "hmi/check/panel_check.h"

#include "hmi/view/element_factory.h"
#include <QElapsedTimer>
#include <QImage>
#include <QTemporaryDir>
#include <gtest/gtest.h>
#include <zlib.h>

#include <ctime>
#include <sys/stat.h>

namespace plc::hmi {
namespace {

Panel panelOf(const std::string& elements) {
    Result<Panel> panel = Panel::parse("{\"elements\": [" + elements + "]}", QStringLiteral("main"));
    EXPECT_TRUE(panel) << panel.error().english();
    return panel ? *panel : Panel();
}

CheckInput inputOf(const std::string& elements, const PictureFolder& pictures = {}) {
    CheckInput input;
    input.panels.push_back({QStringLiteral("main"), panelOf(elements)});
    input.folder = pictures.path;
    input.picturesOutside = pictures.mayLeave;
    return input;
}

std::string findings(const CheckInput& input) {
    QStringList out;
    for (const Finding& one : checkPanels(input)) out += one.element + u'.' + one.property + u' ' + one.code();
    return out.join(QStringLiteral("; ")).toStdString();
}

TEST(HarmfulPanel, NumbersBeyondTheirRangeAreReportedAndDrawnWithTheNearestThatIsAllowed) {
    const struct {
        std::string element, finding;
    } rows[] = {
        {R"("kind":"cellGrid","rows":2000,"columns":2000)", "a.rows H1032; a.columns H1032"},
        {R"("kind":"gauge","ticks":100000000)", "a.ticks H1032"},
        {R"("kind":"sevenSegment","digits":100000000)", "a.digits H1032"},
        {R"("kind":"table","count":100000000,"columns":[{"title":"","value":"","width":1e300}])",
         "a.columns[0].width H1032; a.count H1032"},
        {R"("kind":"text","text":"","fontSize":1e9)", "a.fontSize H1032"},
        {R"("kind":"radio","columns":-5)", "a.columns H1032"},
        {R"("kind":"gauge","min":1e16,"max":1.0000000000000002e16)", "a.format H1007"},
        {R"("kind":"bar","min":-1e308,"max":1e308)", "a.format H1007"},
        {R"("kind":"cellGrid","first":1e300)", ""},
        {R"("kind":"rounded","radius":1e300)", "a.radius H1032"},
        {R"("kind":"symbol","rect":[0,0,1e300,1e300])", ""},
    };
    for (const auto& row : rows) {
        const std::string rect = row.element.find("rect") == std::string::npos ? R"("rect":[0,0,200,200],)" : "";
        const CheckInput input = inputOf("{\"id\":\"a\"," + rect + row.element + "}");
        const std::clock_t begin = std::clock();
        EXPECT_EQ(findings(input), row.finding) << row.element;
        PanelScene scene{makeElementView};
        scene.setDesigning(true);
        scene.setPanel(input.panels[0].panel);
        EXPECT_FALSE(scene.picture().isNull());
        EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC) << row.element;
    }
}

/// A project folder with a picture of some name and content, and a secret beside the folder.
struct PictureProject {
    QTemporaryDir parent;
    QString folder = parent.filePath(QStringLiteral("project"));
    PictureProject() { QDir().mkpath(folder); }
    QString write(const QString& name, const QByteArray& bytes) const {
        QFile file(folder + u'/' + name);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return name;
    }
    std::string complaint(const QString& name, bool mayLeave = false) const {
        const std::clock_t begin = std::clock(); // what the program needs; how long that takes, other programs decide
        const Result<QPixmap> picture = loadPicture({folder, mayLeave}, name, {100, 100});
        EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
        return picture ? std::string() : picture.error().message.english();
    }
};

/// As gzip packs it, `times` one after the other. (The program itself had 30 s for the bomb, which a busy machine
/// took.)
QByteArray packed(const QByteArray& bytes, int times = 1) {
    z_stream stream{};
    EXPECT_EQ(deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
    QByteArray out;
    QByteArray in = bytes;
    for (int i = 0; i < times; ++i) {
        stream.next_in = reinterpret_cast<Bytef*>(in.data());
        stream.avail_in = static_cast<uInt>(in.size());
        do {
            const qsizetype before = out.size(), piece = 64 * 1024;
            out.resize(before + piece);
            stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);
            stream.avail_out = static_cast<uInt>(piece);
            EXPECT_NE(deflate(&stream, i + 1 == times ? Z_FINISH : Z_NO_FLUSH), Z_STREAM_ERROR);
            out.resize(before + piece - static_cast<qsizetype>(stream.avail_out));
        } while (stream.avail_out == 0);
    }
    deflateEnd(&stream);
    return out;
}

const QByteArray kSvg = R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink")";

TEST(HarmfulPicture, APackedPictureIsShownAndABombIsRefused) {
    const PictureProject project;
    const QByteArray good = kSvg + R"( width="20" height="10"><rect width="20" height="10" fill="red"/></svg>)";
    EXPECT_EQ(project.complaint(project.write("good.svgz", packed(good))), "");
    const QByteArray bomb = packed(kSvg + ">" + QByteArray(1 << 20, ' '), 300);
    EXPECT_LT(bomb.size(), 4 << 20);
    EXPECT_EQ(project.complaint(project.write("bomb.svgz", bomb)),
              "The picture bomb.svgz unpacks to more than 16 MB; use a smaller one");
    EXPECT_EQ(project.complaint(project.write("cut.svgz", packed(good).left(30))),
              "cut.svgz is not a picture in a known format such as PNG, JPEG or SVG; save it as one of them");
}

TEST(HarmfulPicture, ShapesThatMultiplyOrContainThemselvesAreRefused) {
    const PictureProject project;
    QByteArray doubling = kSvg + "><g id=\"g0\"><rect width=\"1\" height=\"1\"/></g>";
    for (int i = 1; i < 40; ++i)
        doubling += QStringLiteral("<g id=\"g%1\"><use xlink:href=\"#g%2\"/><use xlink:href=\"#g%2\"/></g>")
                        .arg(i)
                        .arg(i - 1)
                        .toLatin1();
    EXPECT_EQ(project.complaint(project.write("doubling.svg", doubling + "</svg>")),
              "The picture doubling.svg draws more than 100000 shapes; simplify it or save it as PNG");
    EXPECT_NE(project.complaint(project.write("self.svg", kSvg + "><g id=\"a\"><use xlink:href=\"#a\"/></g></svg>")),
              "");
    QByteArray deep = kSvg + ">";
    for (int i = 0; i < 100000; ++i) deep += "<g>";
    EXPECT_EQ(project.complaint(project.write("deep.svg", deep)),
              "The shapes of the picture deep.svg are nested more than 64 deep or contain themselves; simplify it or "
              "save it as PNG");
    EXPECT_EQ(
        project.complaint(project.write(
            "dashes.svg", kSvg + "><line x2=\"1000000\" stroke=\"red\" stroke-dasharray=\"0.00001\"/></svg>")),
        "The picture dashes.svg has dashed lines of more than 100000 dashes; make the dashes longer or save it as PNG");
}

TEST(HarmfulPicture, OtherFilesAreNotReadThroughAPicture) {
    const PictureProject project;
    QImage secret(4, 4, QImage::Format_RGB32);
    secret.fill(Qt::red);
    ASSERT_TRUE(secret.save(project.parent.filePath("secret.png")));
    EXPECT_EQ(project.complaint(project.write("spy.svg", kSvg + "><image xlink:href=\"../secret.png\"/></svg>")),
              "The picture spy.svg loads ../secret.png; embed it in the picture as PNG or JPEG");
    const std::string outside = "The picture ../secret.png is outside the project; copy it into the project, or set "
                                "picturesOutside to true under hmi in project.json";
    EXPECT_EQ(project.complaint("../secret.png"), outside);
    EXPECT_EQ(project.complaint("../secret.png", true), "") << "the project says so";
    ASSERT_TRUE(QFile::link(project.parent.filePath("secret.png"), project.folder + "/link.png"));
    EXPECT_NE(project.complaint("link.png"), "") << "a link leads outside";
}

TEST(HarmfulPicture, ThePixelsOfAPictureAreCountedBeforeItIsRead) {
    const PictureProject project;
    QImage large(9000, 9000, QImage::Format_Mono);
    large.fill(0);
    ASSERT_TRUE(large.save(project.folder + "/large.png"));
    EXPECT_EQ(project.complaint("large.png"),
              "The picture large.png is 9000 x 9000 pixels; more than 32 million are not drawn; use a smaller one");
    ASSERT_EQ(::mkfifo((project.folder + "/pipe.png").toLocal8Bit().constData(), 0600), 0);
    EXPECT_NE(project.complaint("pipe.png"), "") << "opening a pipe would wait for ever";
    EXPECT_EQ(project.complaint(project.write("words.png", "no picture")),
              "words.png is not a picture in a known format such as PNG, JPEG or SVG; save it as one of them");
}

TEST(HarmfulPicture, ThePanelCheckSaysWhatIsWrongAndThePanelShowsThePlaceOfThePicture) {
    const PictureProject project;
    project.write("words.png", "no picture");
    const CheckInput input = inputOf(R"({"id":"a","kind":"image","rect":[0,0,200,200],"file":"words.png"},
                                        {"id":"b","kind":"image","rect":[0,0,200,200],"file":"gone.png"})",
                                     {project.folder});
    EXPECT_EQ(findings(input), "a.file H1031; b.file H1014");
}

} // namespace
} // namespace plc::hmi
