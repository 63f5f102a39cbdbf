// Messages are values: typed arguments in, a sentence in the reader's language out.
#include "runtime/base/message.h"
#include "runtime/base/phrases.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace plc {
namespace {

using messages::Form;
using messages::Integer;
using messages::Name;
using messages::Names;
using messages::Nested;
using messages::Real;
using messages::Thing;
using messages::TypedForm;

constexpr TypedForm<Name, Integer> kBits{"Test", "Bits", "{0} has {1} {1:bit|bits}"};
constexpr TypedForm<Thing> kUnexpected{"Test", "Unexpected", "{0} is not expected"};
constexpr TypedForm<Nested> kReason{"Test", "Reason", "not saved: {0}"};
constexpr TypedForm<Names, Real> kAll{"Test", "All", "{1} of {0}"};

TEST(Message, ASentenceTakesItsArguments) {
    EXPECT_EQ(kBits(std::string("speed"), 16).english(), "speed has 16 bits");
    EXPECT_EQ(kBits(std::string("lamp"), 1u).english(), "lamp has 1 bit");
    EXPECT_EQ(kBits(std::string("wide"), UINT64_MAX).english(), "wide has 18446744073709551615 bits");
    EXPECT_EQ(kBits(std::string("low"), INT64_MIN).english(), "low has -9223372036854775808 bits");
    EXPECT_EQ(kAll(std::vector<std::string>{"a", "b"}, 0.5).english(), "0.5 of a, b");
    EXPECT_EQ(Message().english(), "");
}

TEST(Message, AnArgumentIsNeverReadAsASentence) {
    EXPECT_EQ(kBits(std::string("{1}{0}"), 2).english(), "{1}{0} has 2 bits");
    EXPECT_EQ(kUnexpected(std::string("{0:a|b}")).english(), "{0:a|b} is not expected");
}

TEST(Message, AMessageInAMessageIsTranslatedWithIt) {
    const Message message = kReason(kUnexpected(phrases::AnIndex()));
    EXPECT_EQ(message.english(), "not saved: An index is not expected");
    const auto german = [](const Form& form) -> std::string {
        const std::string_view name = form.name;
        return name == "Reason" ? "nicht gespeichert: {0}" : name == "Unexpected" ? "unerwartet: {0}" : "ein Index";
    };
    EXPECT_EQ(messages::render(message, german), "nicht gespeichert: unerwartet: ein Index");
}

TEST(Message, WordsOfOursBeginASentenceWithACapitalNamesKeepTheirs) {
    EXPECT_EQ(kUnexpected(phrases::AnIndex()).english(), "An index is not expected");
    EXPECT_EQ(kUnexpected(std::string("index")).english(), "index is not expected");
    EXPECT_EQ(kUnexpected(phrases::ConstantVariable(std::string("limit"))).english(),
              "limit (a constant) is not expected");
}

TEST(Message, EqualMessagesHaveEqualFormsAndArguments) {
    EXPECT_EQ(kBits(std::string("a"), 1), kBits(std::string("a"), 1));
    EXPECT_NE(kBits(std::string("a"), 1), kBits(std::string("a"), 2));
    EXPECT_EQ(kReason(kUnexpected(std::string("a"))), kReason(kUnexpected(std::string("a"))));
    EXPECT_NE(kReason(kUnexpected(std::string("a"))), kReason(kUnexpected(std::string("b"))));
    EXPECT_NE(Message(), kUnexpected(std::string("a")));
}

TEST(Message, ATranslationWithTooFewOrBrokenPlacesShowsWhatItHas) {
    const Message message = kBits(std::string("x"), 8);
    EXPECT_EQ(messages::render(message, [](const Form&) { return std::string("nur {0}"); }), "nur x");
    EXPECT_EQ(messages::render(message, [](const Form&) { return std::string("{7} {0"); }), "{7} {0");
    EXPECT_EQ(messages::render(message, [](const Form&) { return std::string("{1:Bit"); }), "{1:Bit");
}

// What must not compile: an English word where a name belongs, a wrong type, a missing argument.
using Bits = TypedForm<Name, Integer>;
static_assert(std::is_invocable_v<Bits, std::string, int>);
static_assert(!std::is_invocable_v<Bits, const char*, int>);
static_assert(!std::is_invocable_v<Bits, std::string, std::string>);
static_assert(!std::is_invocable_v<Bits, std::string, bool>);
static_assert(!std::is_invocable_v<Bits, std::string>);
static_assert(!std::is_invocable_v<TypedForm<messages::Phrase>, std::string>);
static_assert(!std::is_constructible_v<Thing, const char*>);
constexpr messages::ParameterKind kTwo[] = {messages::ParameterKind::Name, messages::ParameterKind::Integer};
static_assert(messages::detail::isSound("{0} and {1}", kTwo, 2));
static_assert(messages::detail::isSound("{0} {1:bit|bits}", kTwo, 2));
static_assert(!messages::detail::isSound("{0}", kTwo, 2));
static_assert(!messages::detail::isSound("{0} {1} {2}", kTwo, 2));
static_assert(!messages::detail::isSound("{0:a|b} {1}", kTwo, 2));
static_assert(!messages::detail::isSound("", kTwo, 0));

} // namespace
} // namespace plc
