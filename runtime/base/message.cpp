#include "runtime/base/message.h"

#include <charconv>
#include <ostream>

namespace plc {

namespace messages {

namespace {

std::string joined(const std::vector<std::string>& names) {
    std::string out;
    for (const std::string& name : names) (out += out.empty() ? "" : ", ") += name;
    return out;
}

/// "." between the digits: whoever translates gives that of the language.
constexpr Form kDecimalSign{"", "DecimalSign", ".", nullptr, 0};

std::string shown(const Argument& argument, const Translator& translator) {
    struct Shower {
        const Translator& translator;
        std::string operator()(int64_t number) const { return std::to_string(number); }
        std::string operator()(uint64_t number) const { return std::to_string(number); }
        std::string operator()(double number) const {
            char digits[32];
            std::string text(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
            if (const size_t point = text.find('.'); point != std::string::npos)
                text.replace(point, 1, translator(kDecimalSign));
            return text;
        }
        std::string operator()(const std::string& text) const { return text; }
        std::string operator()(const std::vector<std::string>& names) const { return joined(names); }
        std::string operator()(const Form* words) const { return translator(*words); }
        std::string operator()(const std::shared_ptr<const Message>& inner) const { return render(*inner, translator); }
    };
    return std::visit(Shower{translator}, argument);
}

bool isOne(const Argument& argument) {
    if (const auto* number = std::get_if<int64_t>(&argument)) return *number == 1;
    if (const auto* number = std::get_if<uint64_t>(&argument)) return *number == 1;
    return false;
}

/// "one|other": which of the two.
std::string_view chosen(std::string_view forms, bool one) {
    const size_t bar = forms.find('|');
    if (bar == std::string_view::npos) return forms;
    return one ? forms.substr(0, bar) : forms.substr(bar + 1);
}

/// Words of ours, not a name that they explain: they begin a sentence with a capital.
bool beginsWithOurs(const Argument& argument) {
    const auto* words = std::get_if<const Form*>(&argument);
    return words && (*words)->text[0] != '{';
}

std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

} // namespace

std::string render(const Message& message, const Translator& translator) {
    if (message.isEmpty()) return {};
    const std::string text = translator(*message.form());
    std::string out;
    out.reserve(text.size() + 32);
    // In one go: an argument may hold braces itself.
    for (size_t at = 0; at < text.size();) {
        const int index = text.size() - at > 2 ? detail::placeholder(text.c_str() + at) : -1;
        const size_t end = index < 0 ? std::string::npos : text.find('}', at);
        if (end == std::string::npos || static_cast<size_t>(index) >= message.arguments().size()) {
            out += text[at++];
            continue;
        }
        const Argument& argument = message.arguments()[static_cast<size_t>(index)];
        if (text[at + 2] == ':')
            out += chosen(std::string_view(text).substr(at + 3, end - at - 3), isOne(argument));
        else
            out += at == 0 && beginsWithOurs(argument) ? capitalised(shown(argument, translator))
                                                       : shown(argument, translator);
        at = end + 1;
    }
    return out;
}

} // namespace messages

std::string_view Message::name(size_t index) const {
    if (index >= m_arguments.size()) return {};
    const auto* text = std::get_if<std::string>(&m_arguments[index]);
    return text ? std::string_view(*text) : std::string_view();
}

std::string Message::english() const {
    return messages::render(*this, [](const messages::Form& form) { return std::string(form.text); });
}

std::ostream& operator<<(std::ostream& out, const Message& message) { return out << message.english(); }

bool operator==(const Message& a, const Message& b) {
    if (a.m_form != b.m_form || a.m_arguments.size() != b.m_arguments.size()) return false;
    using Inner = std::shared_ptr<const Message>;
    for (size_t i = 0; i < a.m_arguments.size(); ++i) {
        const messages::Argument &x = a.m_arguments[i], &y = b.m_arguments[i];
        const Inner *left = std::get_if<Inner>(&x), *right = std::get_if<Inner>(&y);
        if (left && right ? !(**left == **right) : x != y) return false;
    }
    return true;
}

} // namespace plc
