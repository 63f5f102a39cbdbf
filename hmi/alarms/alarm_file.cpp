#include "hmi/alarms/alarm_file.h"

#include "hmi/model/errors.h"
#include "runtime/base/read_json.h"

#include <QSet>

namespace plc::hmi {

namespace {
/// An id that no row has yet.
std::string freeId(const QString& wanted, const QSet<QString>& ids) {
    const QString stem = wanted.isEmpty() ? QStringLiteral("alarm") : wanted;
    for (int number = 2;; ++number)
        if (const QString id = stem + QString::number(number); !ids.contains(id)) return toUtf8(id);
}
} // namespace

Result<AlarmFile> AlarmFile::parse(const std::string& utf8, const QString& place, std::vector<Error>* problems) {
    const auto fail = [&](Message message) { return Error{std::move(message), place.toStdString()}; };
    const Json root = readJson<Json>(utf8).value;
    if (!root.is_object()) return fail(errors::AlarmsNotJson());
    AlarmFile file;
    file.m_fields = root;
    for (const char* key : {"classes", "alarms"}) {
        if (!root.contains(key))
            file.m_fields[key] = nullptr;
        else if (!root[key].is_array())
            return fail(errors::MustBeList(Verbatim(key)));
    }
    std::vector<Error> found;
    const auto read = [&](const char* key, const ElementDescriptor& descriptor, std::vector<Properties>& out,
                          std::vector<Json>& unread) {
        if (!root.contains(key)) return;
        for (const Json& row : root[key]) {
            if (row.is_object()) {
                out.emplace_back(descriptor, inCanonicalOrder(row, descriptor));
                continue;
            }
            unread.push_back(row);
            found.push_back(fail(errors::AlarmNotObject()));
        }
        file.m_fields[key] = nullptr;
    };
    read("classes", alarmClassDescriptor(), file.m_classes, file.m_unreadClasses);
    read("alarms", alarmDescriptor(), file.m_alarms, file.m_unreadAlarms);
    QSet<QString> ids;
    for (Properties& row : file.m_alarms) {
        const QString id = row.text("id");
        if (id.isEmpty()) found.push_back(fail(errors::AlarmWithoutId()));
        if (ids.contains(id)) found.push_back(fail(errors::AlarmIdTwice(toUtf8(id))));
        if (id.isEmpty() || ids.contains(id)) row.set("id", freeId(id, ids));
        ids += row.text("id");
    }
    if (!found.empty() && !problems) return found.front();
    if (problems) problems->insert(problems->end(), found.begin(), found.end());
    return file;
}

std::string AlarmFile::write() const {
    std::string out = "{";
    for (const auto& [key, value] : m_fields.items()) {
        out += (out.size() > 1 ? ",\n  " : "\n  ") + Json(key).dump() + ": ";
        const std::vector<Properties>* rows = key == "classes" ? &m_classes : key == "alarms" ? &m_alarms : nullptr;
        if (!rows) {
            out += writeCompact(value);
            continue;
        }
        std::vector<Json> list;
        for (const Properties& row : *rows) list.push_back(row.fields());
        const std::vector<Json>& unread = key == "classes" ? m_unreadClasses : m_unreadAlarms;
        list.insert(list.end(), unread.begin(), unread.end());
        out += writeList(list, 2);
    }
    return out + "\n}\n";
}

std::vector<AlarmDefinition> AlarmFile::definitions() const {
    std::vector<AlarmDefinition> out;
    for (const Properties& row : m_alarms) {
        AlarmDefinition one;
        one.id = row.text("id");
        one.condition = row.text("condition");
        one.className = row.text("class");
        one.text = row.text("text");
        one.inhibit = row.text("inhibit");
        one.help = row.text("help");
        one.show = row.text("show");
        one.firstOut = row.text("firstOut");
        one.priority = std::clamp(row.integer("priority"), 1, 4);
        one.onDelay = std::max(0.0, row.number("onDelay"));
        one.offDelay = std::max(0.0, row.number("offDelay"));
        one.mustAcknowledge = row.isSet("acknowledge");
        const Json& values = row.at("values");
        if (values.is_object())
            for (const auto& [name, expression] : values.items())
                one.values.emplace_back(QString::fromStdString(name), toQString(expression));
        out.push_back(std::move(one));
    }
    return out;
}

std::vector<AlarmClass> AlarmFile::classes() const {
    std::vector<AlarmClass> out;
    for (const Properties& row : m_classes) out.push_back({row.text("name"), row.text("title"), row.text("color")});
    return out;
}

Properties AlarmFile::newRow() const {
    QSet<QString> ids;
    for (const Properties& row : m_alarms) ids += row.text("id");
    int number = 1;
    while (ids.contains(QStringLiteral("alarm%1").arg(number))) ++number;
    return Properties(alarmDescriptor(), Json{{"id", "alarm" + std::to_string(number)}});
}

} // namespace plc::hmi
