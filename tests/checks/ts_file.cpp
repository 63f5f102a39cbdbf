#include "tests/checks/ts_file.h"

#include "tests/support/paths.h"

#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

namespace plc::checks {
namespace {

std::string replaced(std::string text, std::string_view what, std::string_view by) {
    for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

std::string fromXml(std::string text) {
    constexpr std::array<std::array<const char*, 2>, 5> entities{
        {{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}};
    constexpr std::array<std::array<const char*, 2>, 2> blanks{{{"&#xa0;", "\u00A0"}, {"&#x202f;", "\u202F"}}};
    for (const auto& [entity, character] : blanks) text = replaced(std::move(text), entity, character);
    for (const auto& [entity, character] : entities) text = replaced(std::move(text), entity, character);
    return text;
}

/// What stands between the first <name …> and its end in `text`, without the tags.
std::optional<std::string> element(std::string_view text, const std::string& name) {
    const size_t open = text.find("<" + name);
    if (open == std::string_view::npos) return std::nullopt;
    const size_t begin = text.find('>', open) + 1;
    const size_t end = text.find("</" + name + ">", begin);
    if (end == std::string_view::npos) return std::nullopt;
    return std::string(text.substr(begin, end - begin));
}

Message parseMessage(const std::string& context, std::string_view text) {
    Message message{context, fromXml(element(text, "source").value_or("")), {}};
    message.isPlural = text.substr(0, text.find('>')).find("numerus=\"yes\"") != std::string_view::npos;
    message.isUnfinished = text.find("type=\"unfinished\"") != std::string_view::npos;
    message.isVanished = text.find("type=\"vanished\"") != std::string_view::npos ||
                         text.find("type=\"obsolete\"") != std::string_view::npos;
    const std::string translation = element(text, "translation").value_or("");
    if (!message.isPlural) return message.translations = {fromXml(translation)}, message;
    constexpr std::string_view end = "</numerusform>";
    for (size_t at = 0; (at = translation.find("<numerusform>", at)) != std::string::npos;
         at = translation.find(end, at) + end.size())
        message.translations.push_back(
            fromXml(element(std::string_view(translation).substr(at), "numerusform").value_or("")));
    return message;
}

} // namespace

std::string contentOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<Message> messagesOf(const std::string& language) {
    const std::string text = contentOf(sourceDir() + "/translations/stepwise_" + language + ".ts");
    std::vector<Message> out;
    std::string context;
    for (size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at) {
        if (text.compare(at, 6, "<name>") == 0) context = *element(std::string_view(text).substr(at), "name");
        if (text.compare(at, 8, "<message") != 0) continue;
        const size_t end = text.find("</message>", at);
        out.push_back(parseMessage(context, std::string_view(text).substr(at, end - at)));
        at = end;
    }
    return out;
}

} // namespace plc::checks
