#include "hmi/web/client_message.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace plc::hmi::web {

namespace {

using Json = nlohmann::json;
enum Wants : uint8_t { Nothing = 0, Text = 1, Place = 2, Number = 4, More = 8 };

struct Row {
    const char* name;
    ClientWord word;
    int wants; // besides `More`, which may be left out, all must be there
};
constexpr std::array kRows = {Row{"hello", ClientWord::Hello, Number},
                              Row{"drawn", ClientWord::Drawn, Number},
                              Row{"down", ClientWord::Down, Place},
                              Row{"move", ClientWord::Move, Place},
                              Row{"up", ClientWord::Up, Place},
                              Row{"cancel", ClientWord::Cancel, Nothing},
                              Row{"wheel", ClientWord::Wheel, Place | Number},
                              Row{"key", ClientWord::Key, Text},
                              Row{"activate", ClientWord::Activate, Number},
                              Row{"panel", ClientWord::Panel, Text},
                              Row{"language", ClientWord::Language, Text},
                              Row{"scale", ClientWord::Scale, Number},
                              Row{"login", ClientWord::LogIn, Text},
                              Row{"logout", ClientWord::LogOut, Nothing},
                              Row{"motion", ClientWord::Motion, Number}};

bool read(const Json& from, const char* key, QString& into) {
    constexpr size_t kLongest = 256;
    const auto found = from.find(key);
    if (found == from.end()) return false;
    const std::string* text = found->get_ptr<const std::string*>();
    if (!text || text->size() > kLongest) return false;
    into = QString::fromStdString(*text);
    return true;
}

bool read(const Json& from, const char* key, double& into) {
    constexpr double kFarthest = 1e9;
    const auto found = from.find(key);
    if (found == from.end() || !found->is_number()) return false;
    into = found->get<double>();
    return std::isfinite(into) && std::abs(into) <= kFarthest;
}

} // namespace

std::optional<ClientMessage> parseClientMessage(QByteArrayView text) {
    if (text.size() > kLargestClientMessage) return {};
    const Json json = Json::parse(text.begin(), text.end(), nullptr, false);
    if (!json.is_object()) return {};
    QString name;
    if (!read(json, "t", name)) return {};
    for (const Row& row : kRows) {
        if (name != QLatin1String(row.name)) continue;
        ClientMessage out;
        out.word = row.word;
        double x = 0, y = 0;
        if ((row.wants & Place) && (!read(json, "x", x) || !read(json, "y", y))) return {};
        if ((row.wants & Number) && !read(json, "n", out.number)) return {};
        const bool hasText = read(json, "text", out.text);
        if ((row.wants & Text) && !hasText) return {};
        (void)read(json, "more", out.more);
        out.at = {x, y};
        return out;
    }
    return {};
}

} // namespace plc::hmi::web
