#include "hmi/model/json.h"

#include <cmath>

namespace plc::hmi {

QString toQString(const Json& text) {
    if (!text.is_string()) return {};
    return QString::fromStdString(text.get_ref<const std::string&>());
}

std::string toUtf8(const QString& text) { return text.toStdString(); }

Json canonicalNumbers(const Json& value) {
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (std::isfinite(number) && std::abs(number) < 9e15 && std::floor(number) == number)
            return static_cast<int64_t>(number);
        return value;
    }
    if (!value.is_structured()) return value;
    Json out = value;
    for (Json& item : out) item = canonicalNumbers(item);
    return out;
}

std::string writeCompact(const Json& value) {
    if (value.is_array()) {
        std::string out = "[";
        for (const Json& item : value) out += (out.size() > 1 ? ", " : "") + writeCompact(item);
        return out + "]";
    }
    if (value.is_object()) {
        std::string out = "{";
        for (const auto& [key, item] : value.items())
            out += (out.size() > 1 ? ", " : "") + Json(key).dump() + ": " + writeCompact(item);
        return out + "}";
    }
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string writeObject(const Json& object, int indent) {
    std::string out = "{";
    const std::string margin(static_cast<size_t>(indent) + 2, ' ');
    bool first = true;
    for (const auto& [key, item] : object.items()) {
        out += (first ? "\n" : ",\n") + margin + Json(key).dump() + ": " + writeCompact(item);
        first = false;
    }
    if (first) return "{}";
    return out + "\n" + std::string(static_cast<size_t>(indent), ' ') + "}";
}

std::string writeList(const std::vector<Json>& objects, int indent) {
    if (objects.empty()) return "[]";
    std::string out = "[";
    const std::string margin(static_cast<size_t>(indent) + 2, ' ');
    bool first = true;
    for (const Json& object : objects) {
        out += (first ? "\n" : ",\n") + margin +
               (object.is_object() ? writeObject(object, indent + 2) : writeCompact(object));
        first = false;
    }
    return out + "\n" + std::string(static_cast<size_t>(indent), ' ') + "]";
}

} // namespace plc::hmi
