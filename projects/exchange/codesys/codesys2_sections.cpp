#include "projects/exchange/codesys/codesys2_sections.h"

#include "projects/exchange/base/libraries.h"
#include "projects/exchange/base/xml.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <functional>

namespace plc::exchange {
namespace {

void forEachLine(std::string_view text, const std::function<void(const std::string&)>& use) {
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find('\n', at), text.size());
        if (const std::string line = trimmed(text.substr(at, end - at)); !line.empty()) use(line);
        at = end + 1;
    }
}

/// STANDARD.LIB 4.10.05 11:14:46: the first line; what follows lists the units of the library.
void readLibrary(const std::string& section, const std::string& place, Imported& imported) {
    const std::string first = trimmed(section.substr(0, section.find('\n')));
    const std::string folded = foldCase(first);
    const size_t end = folded.find(".lib");
    if (end != std::string::npos) useLibrary(imported, first.substr(0, end), false, place);
}

/// The value of `KEY := value` in the parameters of a task; empty without it.
std::string parameterOf(std::string_view parameters, std::string_view key) {
    for (size_t at = 0; at < parameters.size();) {
        const size_t end = std::min(parameters.find(',', at), parameters.size());
        const std::string_view each = parameters.substr(at, end - at);
        const size_t assign = each.find(":=");
        if (assign != std::string_view::npos && equalsIgnoringCase(trimmed(each.substr(0, assign)), key))
            return trimmed(each.substr(assign + 2));
        at = end + 1;
    }
    return {};
}

/// TASK main (PRIORITY := 1, INTERVAL := T#3ms); PLC_PRG(); END_TASK
void readTasks(const std::string& section, const std::string& place, Imported& imported, ForeignTasks& tasks) {
    bool isInside = false;
    forEachLine(section, [&](const std::string& line) {
        const size_t open = line.find('('), close = line.rfind(')');
        const bool hasParameters = open != std::string::npos && close != std::string::npos && open < close;
        if (foldCase(line).starts_with("end_task")) {
            isInside = false;
        } else if (foldCase(line).starts_with("task ") && hasParameters) {
            const std::string_view parameters = std::string_view(line).substr(open + 1, close - open - 1);
            ForeignTask task;
            task.name = trimmed(std::string_view(line).substr(5, open - 5));
            task.interval = parameterOf(parameters, "INTERVAL");
            task.priority = parameterOf(parameters, "PRIORITY");
            for (const char* key : {"EVENT", "SINGLE"})
                if (const std::string event = parameterOf(parameters, key); !event.empty())
                    imported.report.add(place, remarks::TaskEventNotRead(task.name, event));
            tasks.push_back(std::move(task));
            isInside = true;
        } else if (isInside && hasParameters && line.front() != '{') {
            tasks.back().programs.push_back(trimmed(line.substr(0, open)));
        }
    });
}

std::string typeOfAddress(const std::string& address) {
    switch (address.size() > 2 ? std::toupper(static_cast<unsigned char>(address[2])) : 0) {
    case 'B':
        return "BYTE";
    case 'W':
        return "WORD";
    case 'D':
        return "DWORD";
    case 'L':
        return "LWORD";
    case 'R':
        return "REAL";
    default:
        return "BOOL";
    }
}

/// Gathers what the configuration of the devices declares: names of channels and of their bits.
class ChannelReader {
public:
    void read(const std::string& section) {
        forEachLine(section, [this](const std::string& line) { readLine(line); });
    }
    std::string declarations;
    std::string first;
    int count = 0;

private:
    static std::string unquoted(std::string text) {
        text = trimmed(text);
        return text.size() >= 2 && text.front() == '\'' && text.back() == '\'' ? text.substr(1, text.size() - 2) : text;
    }
    static bool isName(const std::string& text) {
        return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
               std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    }

    void readLine(const std::string& line) {
        if (line.starts_with("_SYMBOLIC_NAME:"))
            m_name = unquoted(line.substr(15));
        else if (line.starts_with("_COMMENT:"))
            m_comment = unquoted(line.substr(9));
        else if (line.starts_with("_IECADR:"))
            declare(m_name, trimmed(std::string_view(line).substr(8)), m_comment);
        else if (line.starts_with("_BIT "))
            readBit(line);
        else if (line == "_END_CHANNEL" || line == "_CHANNEL")
            m_name.clear();
    }
    /// _BIT 0: %IX1.0.0 'name' 'comment'
    void readBit(const std::string& line) {
        const size_t percent = line.find('%'), quote = line.find('\'');
        if (percent == std::string::npos || quote == std::string::npos || quote < percent) return;
        const size_t end = line.find('\'', quote + 1);
        if (end == std::string::npos) return;
        declare(line.substr(quote + 1, end - quote - 1),
                trimmed(std::string_view(line).substr(percent, quote - percent)), unquoted(line.substr(end + 1)));
    }
    void declare(const std::string& name, std::string address, const std::string& comment) {
        if (!isName(name) || address.size() < 3 || address[0] != '%') return;
        const std::string type = typeOfAddress(address);
        if (type == "REAL") address[2] = 'D'; // an address has a size, not a type
        declarations +=
            "    " + name + " AT " + address + " : " + type + ";" + (comment.empty() ? "" : " // " + comment) + "\n";
        if (count++ == 0) first = name;
    }

    std::string m_name, m_comment;
};

void readDevices(const std::string& section, const std::string& place, Imported& imported) {
    imported.report.add(place, remarks::DevicesNotRead());
    ChannelReader channels;
    channels.read(section);
    if (channels.count == 0) return;
    imported.report.add(place, remarks::ChannelNames(channels.first));
    ++imported.report.units["VAR_GLOBAL"];
    addFile(imported, "", "PLC_Configuration",
            "{gvl PLC_Configuration}\nVAR_GLOBAL\n" + channels.declarations + "END_VAR\n");
}

} // namespace

std::string endOfSection(std::string_view word) {
    if (word == "PLC_CONFIGURATION") return "PLC_END";
    for (const std::string_view each : {"VISUALISATION", "LIBRARY", "TASK_CONFIGURATION", "RESOURCE",
                                        "ALARM_CONFIGURATION", "WORKSPACE", "_WORKSPACE", "_ALARMCONFIG"})
        if (word == each) return each.front() == '_' ? "_END" + std::string(each) : "END_" + std::string(each);
    return {};
}

void readCodesys2Section(std::string_view word, const std::string& section, const std::string& place,
                         Imported& imported, ForeignTasks& tasks) {
    if (word == "LIBRARY") return readLibrary(section, place, imported);
    if (word == "RESOURCE") return readTasks(section, place, imported, tasks);
    if (word == "PLC_CONFIGURATION") return readDevices(section, place, imported);
    if (word == "_WORKSPACE" || word == "WORKSPACE") return; // the windows of the tool
    imported.report.add(place, remarks::ElementNotRead(std::string(word)));
}

} // namespace plc::exchange
