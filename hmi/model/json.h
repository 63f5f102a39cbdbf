// JSON that keeps the order of its fields, and the canonical way in which panels and alarms are written:
// one field per line, shortest numbers, so that a file diffs by what the engineer changed. Any thread.
#pragma once
#include <QString>
#include <nlohmann/json.hpp>
#include <string>

namespace plc::hmi {

using Json = nlohmann::ordered_json;

QString toQString(const Json& text);
std::string toUtf8(const QString& text);
/// Whole numbers without fraction, at every depth.
Json canonicalNumbers(const Json& value);
/// On one line, with a blank after ':' and ','.
std::string writeCompact(const Json& value);
/// `{` one field per line at `indent + 2` `}`; fields are written compact, but for those that `nested` returns text
/// for.
std::string writeObject(const Json& object, int indent);
std::string writeList(const std::vector<Json>& objects, int indent);

} // namespace plc::hmi
