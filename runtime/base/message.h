// A message is a value: which sentence it is (a row of a .def list) and its arguments, typed. The text is made where it
// is shown, in the language of who reads it: english() here, kit::messageText() in the studio. A row names the types of
// its parameters; a call with others, or a sentence whose {0} {1}… do not match, does not compile.
// "{1:element|elements}" in a sentence is the one or the other as argument 1 is 1 or not. Values, any thread.
#pragma once
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace plc {

class Message;

namespace messages {

/// What a parameter of a sentence may be.
enum class ParameterKind : uint8_t { Name, Names, Integer, Real, Path, Phrase, Thing, Nested };

struct Form;

using Argument = std::variant<int64_t, uint64_t, double, std::string, std::vector<std::string>, const Form*,
                              std::shared_ptr<const Message>>;

/// How the language itself or a format writes it (":=", "T#10ms"), the same for every reader.
struct Verbatim {
    explicit Verbatim(std::string_view written) : text(written) {}
    std::string text;
};

/// What the user wrote, or a name from his program; never translated. A literal of ours is no name: see Phrase,
/// Verbatim.
struct Name {
    static constexpr ParameterKind kKind = ParameterKind::Name;
    Name(std::string written) : text(std::move(written)) {}
    Name(std::string_view written) : text(written) {}
    Name(Verbatim written) : text(std::move(written.text)) {}
    Name(const char*) = delete;
    operator Argument() && { return std::move(text); }
    std::string text;
};
/// Several names, shown with commas between them.
struct Names {
    static constexpr ParameterKind kKind = ParameterKind::Names;
    Names(std::vector<std::string> written) : all(std::move(written)) {}
    operator Argument() && { return std::move(all); }
    std::vector<std::string> all;
};
struct Integer {
    static constexpr ParameterKind kKind = ParameterKind::Integer;
    template <class T, class = std::enable_if_t<std::is_integral_v<T>>> Integer(T number) {
        if constexpr (std::is_signed_v<T>)
            value = static_cast<int64_t>(number);
        else
            value = static_cast<uint64_t>(number);
    }
    Integer(bool) = delete;
    Integer(char) = delete;
    operator Argument() && {
        return std::visit([](auto number) { return Argument(number); }, value);
    }
    std::variant<int64_t, uint64_t> value;
};
struct Real {
    static constexpr ParameterKind kKind = ParameterKind::Real;
    Real(double number) : value(number) {}
    operator Argument() && { return value; }
    double value;
};
/// A file or folder.
struct Path {
    static constexpr ParameterKind kKind = ParameterKind::Path;
    Path(std::string path) : text(std::move(path)) {}
    Path(const char*) = delete;
    operator Argument() && { return std::move(text); }
    std::string text;
};

} // namespace messages

class Message {
public:
    Message() = default; // says nothing
    Message(const messages::Form& form, std::vector<messages::Argument> arguments)
        : m_form(&form), m_arguments(std::move(arguments)) {}
    [[nodiscard]] bool isEmpty() const { return !m_form; }
    [[nodiscard]] const messages::Form* form() const { return m_form; }
    [[nodiscard]] const std::vector<messages::Argument>& arguments() const { return m_arguments; }
    /// Argument `index` where it is a name or path; empty otherwise.
    [[nodiscard]] std::string_view name(size_t index) const;
    [[nodiscard]] std::string english() const;
    friend bool operator==(const Message& a, const Message& b);
    friend std::ostream& operator<<(std::ostream& out, const Message& message); // English

private:
    const messages::Form* m_form = nullptr;
    std::vector<messages::Argument> m_arguments;
};

namespace messages {

/// A message as an argument of another.
struct Nested {
    static constexpr ParameterKind kKind = ParameterKind::Nested;
    Nested(Message inner) : message(std::move(inner)) {}
    operator Argument() && { return std::make_shared<const Message>(std::move(message)); }
    Message message;
};
/// Words of ours inside a sentence ("an index"), from phrases.def, translated like the sentence.
struct Phrase {
    static constexpr ParameterKind kKind = ParameterKind::Phrase;
    explicit Phrase(const Form& words) : value(&words) {}
    explicit Phrase(Message inner) : value(std::make_shared<const Message>(std::move(inner))) {}
    operator Argument() && { return std::move(value); }
    Argument value;
};
/// A name or words of ours.
struct Thing {
    static constexpr ParameterKind kKind = ParameterKind::Thing;
    Thing(Name name) : value(std::move(name.text)) {}
    Thing(std::string name) : value(std::move(name)) {}
    Thing(std::string_view name) : value(std::string(name)) {}
    Thing(Verbatim name) : value(std::move(name.text)) {}
    Thing(Phrase phrase) : value(std::move(phrase.value)) {}
    Thing(const char*) = delete;
    operator Argument() && { return std::move(value); }
    Argument value;
};

/// A row of a list.
struct Form {
    const char* context; // of its translation
    const char* name;    // "IndexOutOfRange"
    const char* text;    // English
    const ParameterKind* parameters;
    uint8_t count;
};

namespace detail {
/// Where a placeholder begins at `text`: its number, else -1.
constexpr int placeholder(const char* text) {
    return text[0] == '{' && text[1] >= '0' && text[1] <= '9' && (text[2] == '}' || text[2] == ':') ? text[1] - '0'
                                                                                                    : -1;
}
/// Each parameter is used, and nothing else; {n:…} chooses by a whole number.
constexpr bool isSound(const char* text, const ParameterKind* kinds, size_t count) {
    unsigned used = 0;
    if (!*text) return false;
    for (const char* at = text; *at; ++at) {
        const int index = placeholder(at);
        if (index < 0) continue;
        if (static_cast<size_t>(index) >= count) return false;
        if (at[2] == ':' && kinds[index] != ParameterKind::Integer) return false;
        used |= 1u << index;
    }
    return used == (1u << count) - 1;
}
template <class... Parameters> struct Kinds {
    static constexpr ParameterKind all[] = {Parameters::kKind..., ParameterKind::Name}; // one more: never empty
};
} // namespace detail

/// A row with the types of its parameters: makes its messages.
template <class... Parameters> struct TypedForm : Form {
    constexpr TypedForm(const char* ofContext, const char* ofName, const char* english)
        : Form{ofContext, ofName, english, detail::Kinds<Parameters...>::all, sizeof...(Parameters)} {
        if (!detail::isSound(english, detail::Kinds<Parameters...>::all, sizeof...(Parameters)))
            throw "the placeholders of the sentence are not its parameters";
    }
    [[nodiscard]] Message operator()(Parameters... arguments) const {
        std::vector<Argument> all;
        all.reserve(sizeof...(Parameters));
        (all.push_back(std::move(arguments)), ...);
        return Message(*this, std::move(all));
    }
};
/// A row of phrases.def.
template <class... Parameters> struct PhraseForm : TypedForm<Parameters...> {
    using TypedForm<Parameters...>::TypedForm;
    [[nodiscard]] Phrase operator()(Parameters... arguments) const {
        if constexpr (sizeof...(Parameters) == 0)
            return Phrase(*this);
        else
            return Phrase(TypedForm<Parameters...>::operator()(std::move(arguments)...));
    }
};

/// The sentence of a form in some language.
using Translator = std::function<std::string(const Form&)>;
/// The message's text with the sentences that `translator` gives, its own and those of its arguments.
[[nodiscard]] std::string render(const Message& message, const Translator& translator);

} // namespace messages

using messages::Verbatim;

} // namespace plc
