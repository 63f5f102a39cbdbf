// stepwise alarms: the journal that the panels have kept, filtered, as a table or as statistics.
#include "app/cli/panels/commands.h"

#include "app/cli/kit/errors.h"
#include "hmi/alarms/statistics.h"
#include "hmi/station/panel_project.h"
#include "hmi/texts/csv.h"
#include "projects/storage/project_file.h"

#include <QDateTime>
#include <QFileInfo>

#include <iomanip>
#include <iostream>

namespace plc::cli {

namespace {

using hmi::AlarmEventKind;

const char* wordOf(AlarmEventKind kind) {
    switch (kind) {
    case AlarmEventKind::Raised:
        return "raised";
    case AlarmEventKind::Returned:
        return "returned";
    case AlarmEventKind::Acknowledged:
        return "acknowledged";
    }
    return "";
}

double secondsOf(hmi::Nanoseconds time) { return std::chrono::duration<double>(time).count(); }

std::string table(const std::vector<hmi::AlarmRecord>& records) {
    std::string out = "time,scan,alarm,event,user,recorded,values\r\n";
    for (const hmi::AlarmRecord& one : records) {
        QStringList values;
        for (const auto& [name, value] : one.values) values += name + u'=' + value.toLiteral();
        const QString wall =
            one.wallTime ? QDateTime::fromMSecsSinceEpoch(one.wallTime, Qt::UTC).toString(Qt::ISODate) : QString();
        out += hmi::writeCsvRow({QString::number(secondsOf(one.at.time), 'f', 3), QString::number(one.at.scan),
                                 one.alarm, QString::fromLatin1(wordOf(one.kind)), one.user, wall,
                                 values.join(QStringLiteral("; "))});
    }
    return out;
}

void printCounts(const char* title, const std::vector<hmi::AlarmCount>& counts) {
    for (const hmi::AlarmCount& one : counts) std::cout << title << one.alarm.toStdString() << " " << one.count << "\n";
}

int statistics(const Arguments& arguments, std::vector<hmi::AlarmRecord> records) {
    hmi::Nanoseconds last{};
    for (const hmi::AlarmRecord& one : records) last = std::max(last, one.at.time);
    const int hours = std::max(1, std::atoi(arguments.value("--hours").value_or("24").c_str()));
    const hmi::AlarmStatistics found =
        hmi::statisticsOf(std::move(records), std::max(hmi::Nanoseconds{}, last - std::chrono::hours(hours)), last);
    std::cout << std::fixed << std::setprecision(1) << "raised " << found.raised << "\nper hour " << found.perHour
              << "\nseconds to acknowledge " << found.secondsToAcknowledge << "\nfloods " << found.floods.size() << " ("
              << 100 * found.shareInFlood << " % of the time)\n";
    for (const QString& alarm : found.standing) std::cout << "standing " << alarm.toStdString() << "\n";
    printCounts("chattering ", found.chattering);
    printCounts("frequent ", found.mostFrequent);
    return kGood;
}

int runAlarms(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::AlarmsNeedProject(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const QString path = QString::fromStdString(project->folder) + "/.stepwise/alarms.sqlite";
    if (!QFileInfo::exists(path)) return wrongUse({errors::NoAlarmJournal(), path.toStdString()});
    needApplication(); // the database's driver is a plugin
    hmi::AlarmStore store;
    if (auto opened = store.open(path); !opened) return wrongUse(opened.error());
    hmi::AlarmQuery query;
    for (const std::string& alarm : arguments.values("--alarm")) query.alarms += QString::fromStdString(alarm);
    if (const auto kind = arguments.value("--event")) {
        for (const AlarmEventKind one :
             {AlarmEventKind::Raised, AlarmEventKind::Returned, AlarmEventKind::Acknowledged})
            if (*kind == wordOf(one)) query.kind = one;
        if (!query.kind) return wrongUse({errors::AlarmEventIs(), *kind});
    }
    query.limit = std::max(1, std::atoi(arguments.value("--limit").value_or("100000").c_str()));
    std::vector<hmi::AlarmRecord> records = store.query(query);
    if (arguments.has("--statistics")) return statistics(arguments, std::move(records));
    const std::string text = table(records);
    if (const auto file = arguments.value("--csv")) {
        const auto written = projects::writeFileAtomically(*file, text);
        return written ? kGood : wrongUse(written.error());
    }
    std::cout << text;
    return kGood;
}

} // namespace

Command alarmsCommand() {
    return {{"alarms",
             "PROJECT [OPTIONS]",
             "Prints the alarm journal of the panels, newest first, or its statistics.",
             {{"--alarm", "ID", "only this alarm (repeatable)"},
              {"--event", "raised|returned|acknowledged", "only this"},
              {"--limit", "N", "at most so many entries"},
              {"--csv", "FILE", "into a file"},
              {"--statistics", "", "alarms per hour, floods, standing, chattering and the ten most frequent ones"},
              {"--hours", "24", "with --statistics: how far back, from the newest entry"}},
             "stepwise alarms projects/examples/alarm_texts --statistics"},
            runAlarms};
}

} // namespace plc::cli
