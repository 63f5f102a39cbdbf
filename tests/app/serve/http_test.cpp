// What anybody may send: heads of requests, messages of browsers, guesses at the code. Fuzzed in the process.
#include "app/serve/gate.h"
#include "app/serve/http.h"
#include "hmi/web/client_message.h"

#include <gtest/gtest.h>
#include <random>

namespace plc::serve {
namespace {

using hmi::web::ClientWord;
using hmi::web::parseClientMessage;

TEST(Http, HeadsAreCompleteIncompleteOrBad) {
    const struct {
        const char* text;
        HeadState state;
    } rows[] = {{"GET / HTTP/1.1\r\nHost: a\r\n\r\n", HeadState::Complete},
                {"GET / HTTP/1.1\r\nHost", HeadState::Incomplete},
                {"", HeadState::Incomplete},
                {"\r\n\r\n", HeadState::Bad},
                {"GET  HTTP/1.1\r\n\r\n", HeadState::Bad},
                {"GET x HTTP/1.1\r\n\r\n", HeadState::Bad},
                {"GET / HTTP/2.0\r\n\r\n", HeadState::Bad},
                {"GET / HTTP/1.1\r\nno colon\r\n\r\n", HeadState::Bad},
                {"GET /%00 HTTP/1.1\r\n\r\n", HeadState::Bad},
                {"G\x01T / HTTP/1.1\r\n\r\n", HeadState::Bad}};
    for (const auto& [text, state] : rows) EXPECT_EQ(parseHead(QByteArray(text)).state, state) << text;
    EXPECT_EQ(parseHead(QByteArray(kLargestHead, 'a')).state, HeadState::Bad);
    const HttpHead head = parseHead("GET /panel/a%20b?language=de HTTP/1.1\r\nHOST: x:1\r\n\r\n");
    EXPECT_EQ(head.request.path, "/panel/a b");
    EXPECT_EQ(head.request.query, "language=de");
    EXPECT_EQ(head.request.field("host"), "x:1");
}

TEST(Http, OnlyPagesOfThisServerMayOpenItsPanels) {
    const auto isSame = [](const char* host, const char* origin) {
        HttpRequest request;
        request.fields = {{"host", host}, {"origin", origin}};
        return request.isSameOrigin();
    };
    EXPECT_TRUE(isSame("plant:8080", "http://plant:8080"));
    EXPECT_TRUE(isSame("plant", "http://plant"));
    EXPECT_TRUE(isSame("[::1]:80", "http://[::1]"));
    EXPECT_FALSE(isSame("plant:8080", "http://elsewhere:8080"));
    EXPECT_FALSE(isSame("plant:8080", "http://plant:81"));
    EXPECT_FALSE(isSame("plant:8080", "null"));
    EXPECT_FALSE(isSame("", "http://"));
}

TEST(ClientMessages, SoundOnesAreReadAndOthersAreNot) {
    const auto down = parseClientMessage(R"({"t":"down","x":12.5,"y":3})");
    ASSERT_TRUE(down);
    EXPECT_EQ(down->word, ClientWord::Down);
    EXPECT_EQ(down->at, QPointF(12.5, 3));
    EXPECT_TRUE(parseClientMessage(R"({"t":"cancel"})"));
    for (const char* bad :
         {"", "{}", "[]", "null", "7", R"({"t":7})", R"({"t":"down"})", R"({"t":"down","x":"1","y":2})",
          R"({"t":"down","x":1e99,"y":2})", R"({"t":"login"})", R"({"t":"launch"})", R"({"t":"drawn"})"})
        EXPECT_FALSE(parseClientMessage(bad)) << bad;
    EXPECT_FALSE(parseClientMessage(QByteArray(5000, ' ') + R"({"t":"cancel"})"));
    EXPECT_FALSE(parseClientMessage(R"({"t":"login","text":")" + QByteArray(300, 'x') + "\"}"));
    QByteArray deep(4000, '[');
    EXPECT_FALSE(parseClientMessage(deep));
}

TEST(ClientMessages, NoBytesBreakTheReaders) {
    std::mt19937 random(18); // the same every time
    const std::vector<QByteArray> seeds = {R"({"t":"hello","text":"main","more":"de","n":1})",
                                           R"({"t":"wheel","x":1,"y":2,"n":-3})", R"({"t":"key","text":"Enter"})",
                                           "GET /panel/x?y HTTP/1.1\r\nHost: a\r\nOrigin: http://a\r\n\r\n"};
    const int rounds = qEnvironmentVariableIsSet("STEPWISE_LONG") ? 10'000'000 : 200'000;
    size_t understood = 0;
    for (int i = 0; i < rounds; ++i) {
        QByteArray bytes = seeds[random() % seeds.size()];
        for (unsigned edits = random() % 4; edits > 0 && !bytes.isEmpty(); --edits) {
            const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()));
            switch (random() % 4) {
            case 0:
                bytes[at] = static_cast<char>(random());
                break;
            case 1:
                bytes.remove(at, 1 + static_cast<qsizetype>(random() % 8));
                break;
            case 2:
                bytes.insert(at, static_cast<char>(random()));
                break;
            default:
                bytes.insert(at, bytes.mid(static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size())), 9));
            }
        }
        understood += parseClientMessage(bytes) ? 1 : 0;
        const HttpHead head = parseHead(bytes);
        if (head.state == HeadState::Complete) understood += head.request.isSameOrigin() ? 1 : 0;
    }
    EXPECT_GT(understood, size_t(0));
}

TEST(Gate, GuessesAreSlowedDownForTheirAddressAlone) {
    Gate gate(byAccessCode("correct horse"));
    EXPECT_EQ(gate.ask("a", {}, "correct horse", 0).answer, Gate::Answer::Open);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(gate.ask("a", {}, "guess", i).answer, Gate::Answer::Wrong);
    EXPECT_EQ(gate.ask("a", {}, "correct horse", 20).answer, Gate::Answer::TooOften);
    EXPECT_EQ(gate.ask("b", {}, "correct horse", 20).answer, Gate::Answer::Open);
    EXPECT_EQ(gate.ask("a", {}, "correct horse", 61'000).answer, Gate::Answer::Open);
    EXPECT_EQ(gate.refusals(), 11u);
}

} // namespace
} // namespace plc::serve
