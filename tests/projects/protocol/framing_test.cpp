// Messages come out as they went in, whatever the pieces; what is no message is reported, and a long one costs nothing.
#include "projects/protocol/framing.h"
#include "projects/protocol/json_rpc.h"

#include <gtest/gtest.h>

namespace plc::protocol {
namespace {

/// What comes out of the bytes, given in pieces of that size; a problem as "!".
std::vector<std::string> read(Framing framing, std::string_view bytes, size_t piece, FramingLimits limits = {}) {
    MessageReader reader(framing, limits);
    std::vector<std::string> out;
    for (size_t at = 0; at < bytes.size(); at += piece) {
        reader.feed(bytes.substr(at, piece));
        while (auto message = reader.next()) out.push_back(*message ? **message : "!");
    }
    if (reader.isBroken()) out.emplace_back("broken");
    return out;
}

using Texts = std::vector<std::string>;

TEST(Heads, GiveTheMessagesInPiecesOfAnySize) {
    const std::string bytes = framed(Framing::Heads, "{\"a\":1}") + framed(Framing::Heads, "") +
                              "content-type: x\r\nCONTENT-LENGTH:  3 \r\n\r\nabc";
    for (size_t piece = 1; piece <= bytes.size(); ++piece)
        EXPECT_EQ(read(Framing::Heads, bytes, piece), (Texts{"{\"a\":1}", "", "abc"})) << piece;
}

TEST(Heads, ThatCannotBeReadEndTheConnection) {
    for (const char* head : {"Content-Length: x\r\n\r\n", "Content-Length: -1\r\n\r\n", "\r\n\r\n",
                             "Length: 3\r\n\r\nabc", "Content-Length: 3\r\nContent-Length: 3\r\n\r\nabc",
                             "GET / HTTP/1.1\r\n\r\n", "Content-Length: 99999999999999999999999\r\n\r\n"})
        EXPECT_EQ(read(Framing::Heads, head, 1), (Texts{"!", "broken"})) << head;
    EXPECT_EQ(read(Framing::Heads, std::string(100'000, 'x'), 1000), (Texts{"!", "broken"}));
}

TEST(Heads, SkipAMessageThatIsTooLong) {
    const std::string bytes = framed(Framing::Heads, std::string(5000, 'x')) + framed(Framing::Heads, "good");
    for (const size_t piece : {1, 7, 1000, 100'000})
        EXPECT_EQ(read(Framing::Heads, bytes, piece, {4096, 4999}), (Texts{"!", "good"})) << piece;
}

TEST(Lines, GiveAMessageEach) {
    const std::string bytes = "{\"a\":1}\r\n\n  \n{}\n" + std::string(50, 'x') + "\n[]\n";
    for (size_t piece = 1; piece <= bytes.size(); ++piece)
        EXPECT_EQ(read(Framing::Lines, bytes, piece, {4096, 20}), (Texts{"{\"a\":1}", "{}", "!", "[]"})) << piece;
}

TEST(Messages, AreReadStrictly) {
    const std::pair<const char*, int> table[] = {
        {"", -32700},
        {"{", -32700},
        {"\xff", -32700},
        {"{\"jsonrpc\":\"2.0\",\"method\":\"x\",\"params\":{\"n\":1e999}}", -32700},
        {"[]", -32600},
        {"1", -32600},
        {"{}", -32600},
        {"{\"jsonrpc\":\"1.0\",\"method\":\"x\"}", -32600},
        {"{\"jsonrpc\":\"2.0\",\"method\":1}", -32600},
        {"{\"jsonrpc\":\"2.0\",\"id\":1}", -32600},
        {"{\"jsonrpc\":\"2.0\",\"id\":{},\"method\":\"x\"}", -32600},
        {"{\"jsonrpc\":\"2.0\",\"id\":1.5,\"method\":\"x\"}", -32600},
        {"{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"x\",\"params\":5}", -32600},
        {"{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"x\"}", 0},
        {"{\"jsonrpc\":\"2.0\",\"method\":\"x\",\"params\":[]}", 0},
        {"{\"jsonrpc\":\"2.0\",\"id\":\"r\",\"result\":null}", 0},
    };
    for (const auto& [text, code] : table) {
        const auto message = readIncoming(text);
        const Failure* failure = std::get_if<Failure>(&message);
        EXPECT_EQ(failure ? static_cast<int>(failure->code) : 0, code) << text;
    }
    EXPECT_TRUE(std::holds_alternative<Failure>(parseJson(std::string(100'000, '[')))) << "deeper than anybody writes";
}

TEST(Parameters, OfTheWrongTypeAreNotThere) {
    const Json json = Json::parse(R"({"a":{"b":1,"c":"x","d":[1,"y"],"e":18446744073709551615,"f":1.5}})");
    EXPECT_EQ(integerAt(json, "a.b"), 1);
    EXPECT_EQ(textAt(json, "a.c"), "x");
    EXPECT_EQ(textAt(json, "a.b"), std::nullopt);
    EXPECT_EQ(integerAt(json, "a.e"), std::nullopt);
    EXPECT_EQ(integerAt(json, "a.f"), std::nullopt);
    EXPECT_EQ(find(json, "a.b.c"), nullptr);
    EXPECT_EQ(textsAt(json, "a.d"), (std::vector<std::string>{"y"}));
}

} // namespace
} // namespace plc::protocol
