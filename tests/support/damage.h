// Damages texts and JSON values at random, from a seed: what a file may hold after a crash, a merge or a slip of the
// hand.
#pragma once
#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace plc::testing {

class Damage {
public:
    using Json = nlohmann::ordered_json;
    explicit Damage(unsigned seed) : m_dice(seed) {}

    /// Nothing where it is no JSON, or nested deeper than a file or message ever is: what writes JSON calls itself for
    /// each level.
    static std::optional<Json> readable(std::string_view text) {
        constexpr int kDeepest = 100;
        bool tooDeep = false;
        const auto look = [&tooDeep](int depth, Json::parse_event_t, const Json&) {
            tooDeep = tooDeep || depth > kDeepest;
            return !tooDeep;
        };
        Json json = Json::parse(text, look, false);
        if (tooDeep || !json.is_structured()) return std::nullopt;
        return json;
    }

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

    /// One to four changes of what the JSON holds: another value, member, name or order somewhere. The text stays JSON.
    /// `donor`, a file of the same kind, lends members, elements and values, so that most of what comes out makes
    /// sense.
    Json json(Json root, const Json& donor) {
        std::vector<Loan> loans;
        lend(donor, "", loans);
        for (size_t i = 1 + pick(4); i > 0; --i) {
            std::vector<Spot> spots;
            collect(root, spots);
            if (spots.empty())
                root = odd(donor);
            else
                change(spots[pick(spots.size())], spots, loans, donor);
        }
        return root;
    }
    Json json(Json root) { return json(root, root); }

private:
    /// A member or an element: the `at`th of `parent`.
    struct Spot {
        Json* parent;
        size_t at;
        [[nodiscard]] Json::iterator place() const {
            return std::next(parent->begin(), static_cast<std::ptrdiff_t>(at));
        }
    };
    /// A value with its name; an element has that of its list.
    struct Loan {
        std::string name;
        const Json* value;
    };

    static void collect(Json& value, std::vector<Spot>& spots) {
        if (!value.is_structured()) return;
        size_t at = 0;
        for (Json& each : value) {
            spots.push_back({&value, at++});
            collect(each, spots);
        }
    }
    static void lend(const Json& value, const std::string& name, std::vector<Loan>& loans) {
        if (!name.empty()) loans.push_back({name, &value});
        if (value.is_array())
            for (const Json& each : value) lend(each, name, loans);
        if (value.is_object())
            for (const auto& [key, each] : value.items()) lend(each, key, loans);
    }
    /// What the donor has under the same name; anything where it has nothing.
    Json lent(const std::string& name, const std::vector<Loan>& loans, const Json& donor) {
        std::vector<const Json*> fit;
        for (const Loan& loan : loans)
            if (loan.name == name) fit.push_back(loan.value);
        if (!fit.empty()) return *fit[pick(fit.size())];
        return loans.empty() ? odd(donor) : *loans[pick(loans.size())].value;
    }

    void change(const Spot& spot, const std::vector<Spot>& all, const std::vector<Loan>& loans, const Json& donor) {
        Json& parent = *spot.parent;
        const auto place = spot.place();
        const std::string name = parent.is_object() ? place.key() : std::string();
        switch (pick(10)) {
        case 0: // gone
            parent.erase(place);
            break;
        case 1: // in another's place, which is in its own
            exchange(spot, all[pick(all.size())]);
            break;
        case 2: // one more beside it
            if (parent.is_array())
                parent.insert(place, pick(2) == 0 ? Json(*place) : lent(nameOfList(parent, all), loans, donor));
            else if (!loans.empty()) {
                const Loan& loan = loans[pick(loans.size())];
                parent[loan.name] = *loan.value;
            }
            break;
        case 3: // under another name
            if (parent.is_object()) rename(parent, spot.at, loans);
            break;
        case 4:
        case 5:
            *place = lent(parent.is_array() ? nameOfList(parent, all) : name, loans, donor);
            break;
        case 6:
            *place = odd(donor);
            break;
        default:
            nudge(*place);
        }
    }
    static std::string nameOfList(const Json& list, const std::vector<Spot>& all) {
        for (const Spot& spot : all)
            if (spot.parent->is_object() && &*spot.place() == &list) return spot.place().key();
        return {};
    }
    static bool holds(const Json& value, const Json* part) {
        if (&value == part) return true;
        return value.is_structured() &&
               std::any_of(value.begin(), value.end(), [&](const Json& each) { return holds(each, part); });
    }
    /// Not where one holds the other.
    static void exchange(const Spot& one, const Spot& other) {
        Json &first = *one.place(), &second = *other.place();
        if (!holds(first, other.parent) && !holds(second, one.parent)) std::swap(first, second);
    }
    void rename(Json& object, size_t at, const std::vector<Loan>& loans) {
        Json out = Json::object();
        size_t i = 0;
        for (const auto& [key, each] : object.items()) {
            std::string name = key;
            if (i++ == at) name = pick(2) == 0 && !loans.empty() ? loans[pick(loans.size())].name : spoilt(name);
            out[name] = each;
        }
        object = std::move(out);
    }
    /// A text with one of the characters that files, markup and format texts give a meaning.
    std::string spoilt(std::string text) {
        static const char* const pieces[] = {"\"",    "\\", "\n",           "\r\n",       "\t", "\x01", "'", "<b>",
                                             "&amp;", "%s", "{0}",          "}",          ",",  ".",    "/", " ",
                                             "#",     "::", "\u00e4\u4e16", "\U0001F600", "[0]"};
        // between characters of several bytes, not in them
        size_t at = pick(text.size() + 1);
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
        if (pick(4) == 0) return text.substr(0, at);
        return text.insert(at, pieces[pick(std::size(pieces))]);
    }
    /// Nearly what it was.
    void nudge(Json& value) {
        if (value.is_boolean())
            value = !value.get<bool>();
        else if (value.is_string())
            value = spoilt(value.get<std::string>());
        else if (value.is_number_integer() && pick(2) == 0)
            value = static_cast<int64_t>(value.get<uint64_t>() +
                                         (pick(2) == 0 ? pick(65) - 32 : (pick(2) == 0 ? 1 : ~uint64_t{0})));
        else if (value.is_number()) {
            static constexpr double factors[] = {-1, 0.5, 2, 10, 0.1, 1000};
            value = value.get<double>() * factors[pick(std::size(factors))];
        } else if (value.is_array() && value.size() > 1)
            std::swap(value[pick(value.size())], value[pick(value.size())]);
    }

    Json odd(const Json& root) {
        switch (pick(18)) {
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
        case 15: // a line, a count, an index
        case 16:
            return pick(64);
        default:
            return root;
        }
    }
    std::mt19937 m_dice;
};

} // namespace plc::testing
