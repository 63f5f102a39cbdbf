// Numbers on the wire: every type in every byte order, JSON; what does not fit.
#include "projects/devices/configuration/wire.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace plc::devices;

namespace {

constexpr Order kOrders[] = {Order::Abcd, Order::Cdab, Order::Badc, Order::Dcba};

Channel holding(WireType type, Order order = Order::Abcd) {
    Channel channel;
    channel.type = type;
    channel.order = order;
    return channel;
}

} // namespace

TEST(Wire, WordsAndBytesChangePlacesAsNamed) {
    const Sample number = Sample::ofUnsigned(0x0A0B0C0D);
    const struct {
        Order order;
        uint16_t first, second;
    } rows[] = {{Order::Abcd, 0x0A0B, 0x0C0D},
                {Order::Cdab, 0x0C0D, 0x0A0B},
                {Order::Badc, 0x0B0A, 0x0D0C},
                {Order::Dcba, 0x0D0C, 0x0B0A}};
    for (const auto& row : rows) {
        uint16_t registers[2] = {};
        ASSERT_TRUE(toRegisters(holding(WireType::Udint, row.order), number, registers));
        EXPECT_EQ(registers[0], row.first) << spelling(row.order);
        EXPECT_EQ(registers[1], row.second) << spelling(row.order);
    }
}

TEST(Wire, WhatIsWrittenIsReadBackInEveryTypeAndOrder) {
    std::mt19937_64 dice(19);
    constexpr WireType kTypes[] = {WireType::Int,  WireType::Uint,  WireType::Dint, WireType::Udint,
                                   WireType::Lint, WireType::Ulint, WireType::Real, WireType::Lreal};
    for (const WireType type : kTypes)
        for (const Order order : kOrders)
            for (int i = 0; i < 200; ++i) {
                const Channel channel = holding(type, order);
                uint16_t raw[4] = {}, again[4] = {};
                for (unsigned r = 0; r < channel.registers(); ++r) raw[r] = static_cast<uint16_t>(dice());
                const Sample sample = fromRegisters(channel, raw);
                if (std::isnan(sample.real)) continue; // many patterns, one meaning
                ASSERT_TRUE(toRegisters(channel, sample, again)) << spelling(type) << " " << sample.shown();
                EXPECT_TRUE(std::equal(raw, raw + 4, again)) << spelling(type) << " " << spelling(order);
            }
}

TEST(Wire, ANumberThatDoesNotFitIsNotSent) {
    const struct {
        WireType type;
        double number;
        bool fits;
    } rows[] = {
        {WireType::Int, 32767, true},          {WireType::Int, 32768, false},         {WireType::Int, -32769, false},
        {WireType::Uint, 65535, true},         {WireType::Uint, -1, false},           {WireType::Uint, 65535.6, false},
        {WireType::Ulint, 1e19, true},         {WireType::Ulint, 2e19, false},        {WireType::Lint, 1e19, false},
        {WireType::Real, 1e39, false},         {WireType::Real, INFINITY, true},      {WireType::Dint, NAN, false},
        {WireType::Udint, 4294967295.0, true}, {WireType::Udint, 4294967296.0, false}};
    for (const auto& row : rows) {
        uint16_t registers[4] = {};
        EXPECT_EQ(toRegisters(holding(row.type), Sample::of(row.number), registers), row.fits)
            << spelling(row.type) << " " << row.number;
    }
}

TEST(Wire, ScaleAndOffsetWorkBothWays) {
    Channel channel = holding(WireType::Int);
    channel.scale = 0.1;
    channel.offset = -40;
    const uint16_t raw[] = {653};
    EXPECT_NEAR(fromRegisters(channel, raw).real, 25.3, 1e-9);
    uint16_t sent[1] = {};
    ASSERT_TRUE(toRegisters(channel, Sample::of(25.3), sent));
    EXPECT_EQ(sent[0], 653);
}

TEST(Wire, ABitOfARegisterLeavesTheOthersAlone) {
    Channel channel = holding(WireType::Bool);
    channel.bit = 3;
    uint16_t word[] = {0xF0F0};
    ASSERT_TRUE(toRegisters(channel, Sample::of(int64_t(1)), word));
    EXPECT_EQ(word[0], 0xF0F8);
    EXPECT_EQ(fromRegisters(channel, word).integer, 1);
    ASSERT_TRUE(toRegisters(channel, Sample::of(int64_t(0)), word));
    EXPECT_EQ(word[0], 0xF0F0);
}

TEST(Wire, MessagesAreReadPlainAndInJson) {
    const struct {
        std::string path, payload, shown;
        WireType type = WireType::Lreal;
    } rows[] = {{"", " 21.5\n", "21.5"},
                {"", "+7", "7"},
                {"", "ON", "1"},
                {"", "false", "0"},
                {"", "18446744073709551615", "18446744073709551615"},
                {"", "warm", ""},
                {"", "", ""},
                {"", "nan", ""},
                {"", "caf\xC3\xA9", "caf\xC3\xA9", WireType::Text},
                {"", "\xE4\xB8\xAD", "\xE4\xB8\xAD", WireType::Text}, // the STRING decides, see below
                {"", "\xE4", "", WireType::Text},                     // no UTF-8
                {"/a/b", R"({"a": {"b": 3}})", "3"},
                {"/a/1", R"({"a": [5, 6.5]})", "6.5"},
                {"/a/2", R"({"a": [5, 6]})", ""},
                {"/a~1b/~0", R"({"a/b": {"~": true}})", "1"},
                {"/a", R"({"a": "12"})", "12"},
                {"/a", R"({"a": null})", ""},
                {"/a", "{", ""},
                {"/a", "", ""},
                {"/a", R"({"a": [1]})", "[1]", WireType::Text},
                {"/a", R"({"a": 1e999})", ""}};
    for (const auto& row : rows) {
        Channel channel = holding(row.type);
        channel.jsonPath = row.path;
        EXPECT_EQ(fromMessage(channel, row.payload).shown(), row.shown) << row.path << " in " << row.payload;
    }
}

TEST(Wire, ChannelsOfOneTopicGoIntoOneMessage) {
    Channel a = holding(WireType::Lreal), b = holding(WireType::Bool);
    a.jsonPath = "/pump/speed";
    b.jsonPath = "/pump/on";
    const Sample speed = Sample::of(1.5), on = Sample::of(int64_t(1));
    const Channel* channels[] = {&a, &b};
    const Sample* samples[] = {&speed, &on};
    EXPECT_EQ(toMessage(channels, samples), R"({"pump":{"speed":1.5,"on":true}})");
    a.jsonPath.clear();
    EXPECT_EQ(toMessage(std::span(channels).first(1), std::span(samples).first(1)), "1.5");
}

TEST(Wire, TextsBecomeTheBytesOfTheProjectsStrings) {
    const struct {
        plc::types::StringCode code;
        std::string text, bytes; // "": refused
    } rows[] = {{plc::types::StringCode::Latin1, "caf\xC3\xA9", "caf\xE9"},
                {plc::types::StringCode::Latin1, "\u0416", ""},
                {plc::types::StringCode::Windows1251, "\u0416\u0451", "\xC6\xB8"},
                {plc::types::StringCode::Windows1251, "\u03A9", ""},
                {plc::types::StringCode::Utf8, "\u0416\u0416", "\xD0\x96\xD0\x96"},
                {plc::types::StringCode::Utf8, "\u0416\u0416\u0416", ""}}; // six bytes
    for (const auto& [code, text, bytes] : rows) {
        Target target;
        target.kind = plc::types::TypeKind::String;
        target.capacity = 5;
        target.size = 6;
        target.strings = code;
        std::vector<std::byte> image(target.size);
        EXPECT_EQ(encode(Sample::ofText(text), target, image), !bytes.empty()) << text;
        if (bytes.empty()) continue;
        EXPECT_EQ(std::string(reinterpret_cast<const char*>(image.data())), bytes);
        EXPECT_EQ(decode(target, image).shown(), text);
    }
}
