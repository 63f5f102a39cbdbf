// Many browsers at one controller: each gets its frames, and what it keeps of them is the panel. The clients here read
// every frame as the page does and acknowledge it, but paint nothing: a page needs a machine of its own.
#include "drawn_panel.h"
#include "service.h"
#include "tests/support/patience.h"
#include "thousand_elements.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QWebSocket>

namespace plc::serve {
namespace {

struct Watcher {
    QWebSocket socket;
    DrawnPanel panel;
    int frames = 0;
    qint64 bytes = 0;
    explicit Watcher(const QString& url) {
        QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket, [this](const QByteArray& frame) {
            bytes += frame.size();
            ++frames;
            EXPECT_TRUE(panel.take(frame)) << panel.problem().toStdString();
            socket.sendTextMessage(QStringLiteral(R"({"t":"drawn","n":%1})").arg(panel.number()));
        });
        QObject::connect(&socket, &QWebSocket::connected, &socket,
                         [this] { socket.sendTextMessage(QStringLiteral(R"({"t":"hello","n":1})")); });
        const QUrl place(url);
        socket.open(QUrl(QStringLiteral("ws://%1:%2/panel-stream").arg(place.host()).arg(place.port())));
    }
};

/// Prints how many frames a second each of ten gets, the server in a process of its own. How many that are depends on
/// what else the machine does; that everybody goes on and has the whole panel is certain anywhere.
TEST(ManyBrowsers, TenGetAThousandChangingElements) {
    constexpr size_t kCount = 10, kElements = 1000;
    QTemporaryDir folder;
    ASSERT_TRUE(writeThousandElements(folder.path()));
    Service service({folder.path()});
    if (HasFailure()) return;
    std::vector<std::unique_ptr<Watcher>> watchers;
    for (size_t i = 0; i < kCount; ++i) watchers.push_back(std::make_unique<Watcher>(service.url));
    const auto haveAll = [&](int frames) {
        return std::all_of(watchers.begin(), watchers.end(), [&](const auto& one) { return one->frames >= frames; });
    };
    ASSERT_TRUE(waitUntil([&] { return haveAll(10); }, 2 * kPatience));
    std::vector<int> before;
    for (const auto& one : watchers) before.push_back(one->frames);
    const auto allGoOn = [&] {
        for (size_t i = 0; i < kCount; ++i)
            if (watchers[i]->frames == before[i]) return false;
        return true;
    };
    const double cpu = service.processorSeconds(), own = static_cast<double>(std::clock());
    QElapsedTimer clock;
    clock.start();
    // a duration: over which frames are counted, and until everybody has one
    EXPECT_TRUE(waitUntil([&] { return clock.elapsed() > 3000 && allGoOn(); }, kPatience)) << "one stands still";
    const double seconds = static_cast<double>(clock.elapsed()) / 1000;
    double least = 1e9, sum = 0, bytes = 0;
    for (size_t i = 0; i < kCount; ++i) {
        const int frames = watchers[i]->frames - before[i];
        EXPECT_GT(frames, 0) << "browser " << i << " stands still; " << watchers[i]->socket.closeReason().toStdString();
        least = std::min(least, frames / seconds);
        sum += frames;
        bytes += static_cast<double>(watchers[i]->bytes) / watchers[i]->frames / kCount;
        EXPECT_GE(watchers[i]->panel.elements().size(), kElements);
        for (const auto& [index, element] : watchers[i]->panel.elements()) {
            if (index >= kElements) continue; // what lies over the panel
            EXPECT_TRUE(element.isShown && !element.commands.isEmpty()) << index;
        }
    }
    std::printf("10 browsers, 1,000 changing elements: %.1f frames a second each, at least %.1f; %.0f kB a frame; the "
                "server takes %.0f %% of a core, %.2f ms a frame of a browser, reading them %.0f %%\n",
                sum / seconds / kCount, least, bytes / 1000, 100 * (service.processorSeconds() - cpu) / seconds,
                1000 * (service.processorSeconds() - cpu) / sum,
                100 * (static_cast<double>(std::clock()) - own) / CLOCKS_PER_SEC / seconds);
    service.process.terminate();
    EXPECT_TRUE(service.process.waitForFinished(kPatience));
}

} // namespace
} // namespace plc::serve
