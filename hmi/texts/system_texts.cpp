#include "hmi/texts/system_texts.h"

#include "runtime/base/assert.h"

#include <QFile>

#include <array>

/// The resource is in this library.
static void registerTexts() { Q_INIT_RESOURCE(system_texts); }

namespace plc::hmi {

namespace {

/// The rows of system_texts.csv, in the order of SystemText.
constexpr std::array kKeys{
    "ok",
    "cancel",
    "yes",
    "no",
    "clear",
    "close",
    "log_in",
    "log_out",
    "access_code",
    "wrong_access_code",
    "log_in_first",
    "connection_lost",
    "time",
    "alarm",
    "no_alarms",
    "acknowledge_all",
    "all",
    "unacknowledged",
    "acknowledged",
    "returned",
    "gone",
    "until_restart",
    "stopped",
    "paused",
    "fault",
    "past",
    "no_controller",
    "between",
    "at_least",
    "at_most",
    "too_long",
    "bad_character",
    "not_a_number",
    "outside_limits",
    "is_forced",
    "not_running",
    "in_the_past",
    "not_writable",
    "password",
    "wrong_password",
    "too_many_tries",
    "only_for",
    "confirm_write",
    "acknowledge",
    "show_me",
    "shelve_for",
    "shelved_until",
    "out_of_service",
    "put_back",
    "alarms_per_hour",
    "alarm_floods",
    "standing_alarms",
    "chattering_alarms",
    "user_name",
    "confirm_remove",
    "confirm_read",
};

static_assert(kKeys.size() == static_cast<size_t>(SystemText::ConfirmRead) + 1);

/// system_texts.csv, which is a table like that of a project.
const TextTable& ownTable() {
    static const TextTable table = [] {
        registerTexts();
        QFile file(QStringLiteral(":/hmi/system_texts.csv"));
        PLC_ASSERT(file.open(QIODevice::ReadOnly), return TextTable());
        auto read = TextTable::parse(file.readAll().toStdString(), file.fileName());
        PLC_ASSERT(read, return TextTable());
        return *std::move(read);
    }();
    return table;
}

} // namespace

QString systemKey(SystemText text) {
    return QStringLiteral("hmi.") + QLatin1String(kKeys.at(static_cast<size_t>(text)));
}

QString systemText(const TextCatalog& texts, SystemText text, const QString& tag) {
    const QString key = systemKey(text);
    if (texts.table().contains(key)) return texts.text(u'@' + key, tag);
    const QString english = ownTable().text(key, QStringLiteral("en"));
    if (tag.compare(kPseudoTag, Qt::CaseInsensitive) == 0) return pseudoText(english);
    for (const QString& one : texts.settings().chain(tag))
        if (const QString own = ownTable().text(key, one.section(u'-', 0, 0)); !own.isEmpty()) return own;
    return english;
}

} // namespace plc::hmi
