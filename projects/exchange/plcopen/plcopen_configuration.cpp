#include "projects/exchange/plcopen/plcopen_configuration.h"

#include "projects/exchange/base/durations.h"
#include "projects/exchange/plcopen/plcopen_interface.h"
#include "projects/exchange/plcopen/plcopen_types.h"

namespace plc::exchange {

namespace {

class Writer {
public:
    Writer(const XmlFile& file, Report& report) : m_file(file), m_report(report) {}

    ConfigurationText write(pugi::xml_node configuration) {
        std::string name = attribute(configuration, "name");
        m_out.text = commentLines(textOf(childOf(configuration, "documentation")), "") + "CONFIGURATION " +
                     identifier(name, "Plc") + "\n";
        writeSections(configuration, "    ");
        for (const pugi::xml_node resource : configuration.children())
            if (is(resource, "resource")) writeResource(resource);
        m_out.text += "END_CONFIGURATION\n";
        return std::move(m_out);
    }

private:
    static std::string identifier(const std::string& name, const char* otherwise) {
        std::string out;
        for (const char c : name)
            out += std::isalnum(static_cast<unsigned char>(c)) || c == '_' || static_cast<unsigned char>(c) >= 0x80
                       ? c
                       : '_';
        if (out.empty()) return otherwise;
        return std::isdigit(static_cast<unsigned char>(out[0])) ? "_" + out : out;
    }

    void writeSections(pugi::xml_node owner, const std::string& indent) {
        for (const pugi::xml_node child : owner.children()) {
            if (is(child, "globalVars") && !attribute(child, "name").empty()) {
                m_out.lists.push_back(child);
            } else if (is(child, "globalVars") || is(child, "accessVars") || is(child, "configVars")) {
                const std::string text =
                    is(child, "globalVars") ? globalsText(child, indent) : sectionText(child, indent);
                m_out.isEmpty &= text.empty();
                m_out.text += text;
            }
        }
    }

    void writeResource(pugi::xml_node resource) {
        m_out.text += commentLines(textOf(childOf(resource, "documentation")), "    ") + "    RESOURCE " +
                      identifier(attribute(resource, "name"), "Resource1") + " ON PLC\n";
        writeSections(resource, "        ");
        std::string instances;
        for (const pugi::xml_node child : resource.children()) {
            if (is(child, "task")) writeTask(child, instances);
            if (is(child, "pouInstance")) writeInstance(child, "", instances);
        }
        m_out.text += instances + "    END_RESOURCE\n";
    }

    std::string place(pugi::xml_node node) const { return m_file.place() + ":" + std::to_string(m_file.lineOf(node)); }

    void writeTask(pugi::xml_node task, std::string& instances) {
        const std::string name = identifier(attribute(task, "name"), "Task");
        const pugi::xml_node settings = childOf(dataOf(task, "/tasksettings"), "TaskSettings");
        std::string interval = durationText(attribute(task, "interval"));
        const std::string kind = attribute(settings, "KindOfTask");
        if (interval.empty())
            interval = durationText(attribute(settings, "Interval"), attribute(settings, "IntervalUnit"));
        if (kind == "Freewheeling") interval.clear();
        std::string single = attribute(task, "single");
        if (single.empty()) single = attribute(settings, "Event");
        if (const std::string event = attribute(settings, "ExternalEvent"); !event.empty() && interval.empty())
            m_report.add(place(task), remarks::TaskEventNotRead(name, event));
        std::string parts;
        const auto part = [&](const char* word, const std::string& value) {
            if (!value.empty()) parts += (parts.empty() ? "" : ", ") + std::string(word) + " := " + value;
        };
        part("INTERVAL", interval);
        part("SINGLE", single);
        part("PRIORITY", attribute(task, "priority"));
        const pugi::xml_node watchdog = childOf(settings, "Watchdog");
        if (isTrue(watchdog, "Enabled"))
            part("WATCHDOG", durationText(attribute(watchdog, "Time"), attribute(watchdog, "TimeUnit")));
        m_out.text += commentLines(textOf(childOf(task, "documentation")), "        ") + "        TASK " + name + "(" +
                      parts + ");\n";
        m_out.isEmpty = false;
        for (const pugi::xml_node child : task.children())
            if (is(child, "pouInstance")) writeInstance(child, name, instances);
    }

    void writeInstance(pugi::xml_node instance, const std::string& task, std::string& out) {
        const std::string name = attribute(instance, "name");
        std::string type = attribute(instance, "typeName");
        if (type.empty()) type = attribute(instance, "type"); // of versions before 0200
        if (type.empty()) type = name;                        // CODESYS calls the program itself
        if (name.find('.') != std::string::npos)              // VisuElems.Visu_Prg
            return m_report.add(place(instance), remarks::TaskProgramLeftOut(task, type));
        const std::string connections = attribute(instance, "connections");
        out += "        PROGRAM " + name + (task.empty() ? "" : " WITH " + task) + " : " + type +
               (connections.empty() ? "" : "(" + connections + ")") + ";\n";
        m_out.isEmpty = false;
    }

    const XmlFile& m_file;
    Report& m_report;
    ConfigurationText m_out;
};

} // namespace

ConfigurationText configurationText(pugi::xml_node configuration, const XmlFile& file, Report& report) {
    return Writer(file, report).write(configuration);
}

} // namespace plc::exchange
