// Damages texts and JSON values at random, from a seed: what a file may hold after a crash, a merge or a slip of the
// hand.
#pragma once
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace plc::testing {

class Damage {
public:
    using Json = nlohmann::ordered_json;
    explicit Damage(unsigned seed) : m_dice(seed) {}

    size_t pick(size_t count) { return count == 0 ? 0 : m_dice() % count; }

    std::string bytes(size_t longest) {
        std::string out(pick(longest), '\0');
        for (char& c : out) c = static_cast<char>(m_dice());
        return out;
    }

    /// One to four changes of bytes.
    std::string text(std::string text) {
        static const char* const words[] = {
            "null", "-1",  "1e999", "-1e308", "0.1",  "18446744073709551616", "[",       "]",       "{",   "}", "\"",
            ",",    ":",   "\n",    "\r\n",   "\xff", "\xEF\xBB\xBF",         "\\u0000", "\\ud800", "NaN", "=", ";",
            "%",    "{n}", "''",    "T#1s"};
        for (size_t i = 1 + pick(4); i > 0; --i) {
            const size_t at = pick(text.size() + 1), length = std::min(text.size() - at, pick(40));
            switch (pick(7)) {
            case 0:
                text.resize(at);
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(pick(text.size() + 1), pick(200)));
                break;
            case 3:
                text.insert(at, words[pick(std::size(words))]);
                break;
            case 4:
                text.insert(at, bytes(16));
                break;
            case 5:
                text.replace(at, length, words[pick(std::size(words))]);
                break;
            default:
                if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << pick(8)));
            }
        }
        return text;
    }

    /// Another value somewhere in it, a field gone or twice: the text stays JSON.
    Json json(Json root) {
        for (size_t i = 1 + pick(3); i > 0; --i) {
            Json* at = &root;
            while (at->is_structured() && !at->empty() && pick(6) != 0) {
                auto next = at->begin();
                std::advance(next, static_cast<std::ptrdiff_t>(pick(at->size())));
                at = &*next;
            }
            if (at->is_array() && pick(2) == 0 && !at->empty())
                at->push_back((*at)[pick(at->size())]);
            else if (at->is_structured() && !at->empty() && pick(2) == 0)
                at->erase(std::next(at->begin(), static_cast<std::ptrdiff_t>(pick(at->size()))));
            else
                *at = odd(root);
        }
        return root;
    }

private:
    Json odd(const Json& root) {
        switch (pick(16)) {
        case 0:
            return nullptr;
        case 1:
            return true;
        case 2:
            return -1;
        case 3:
            return 0;
        case 4:
            return 1e300;
        case 5:
            return -1e300;
        case 6:
            return INT64_MAX;
        case 7:
            return UINT64_MAX;
        case 8:
            return 0.5;
        case 9:
            return "";
        case 10:
            return std::string(pick(300), 'x');
        case 11:
            return "@nobody {a:%d} {b:%s}";
        case 12:
            return Json::array();
        case 13:
            return Json::object();
        case 14:
            return Json::array({1, "two", nullptr, Json::array({-3, 1e9})});
        default:
            return root;
        }
    }
    std::mt19937 m_dice;
};

} // namespace plc::testing
