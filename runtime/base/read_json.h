// Reads JSON that came from outside (a project, panel, set-up or alarm file): nothing it may hold makes an exception,
// and lists nested deeper than any of our files are refused, because what walks a value does so by recursion. Function,
// any thread.
#pragma once
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

namespace plc {

constexpr int kDeepestJson = 100;

template <class Json> struct JsonText {
    Json value;   // discarded when the text is not good
    int line = 0; // where it is not
    [[nodiscard]] bool isGood() const { return !value.is_discarded(); }
};

template <class Json> [[nodiscard]] JsonText<Json> readJson(std::string_view text) {
    struct TooDeep {};
    const auto lineAt = [&](size_t byte) {
        return static_cast<int>(1 + std::count(text.begin(),
                                               text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size())),
                                               '\n'));
    };
    const auto watchDepth = [](int depth, typename Json::parse_event_t, Json&) {
        if (depth > kDeepestJson) throw TooDeep();
        return true;
    };
    try {
        return {Json::parse(text, watchDepth), 0};
    } catch (const typename Json::parse_error& problem) {
        return {Json(Json::value_t::discarded), lineAt(problem.byte)};
    } catch (const typename Json::exception&) { // a number that no double holds
        return {Json(Json::value_t::discarded), lineAt(0)};
    } catch (const TooDeep&) {
        return {Json(Json::value_t::discarded), lineAt(0)};
    }
}

} // namespace plc
