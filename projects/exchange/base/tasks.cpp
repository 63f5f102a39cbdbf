#include "projects/exchange/base/tasks.h"

#include "runtime/base/text.h"

namespace plc::exchange {

void addConfiguration(const ForeignTasks& all, Imported& imported) {
    if (all.empty()) return;
    std::string tasks, instances;
    std::set<std::string> names; // a program may run in one task only
    for (const ForeignTask& task : all) {
        if (!names.insert("task " + foldCase(task.name)).second) continue;
        tasks += "        TASK " + task.name + "(";
        if (!task.interval.empty()) tasks += "INTERVAL := " + task.interval + ", ";
        tasks += "PRIORITY := " + (task.priority.empty() ? "0" : task.priority) + ");\n";
        for (const std::string& program : task.programs)
            if (program.find('.') != std::string::npos)
                imported.report.add(task.name, remarks::TaskProgramLeftOut(task.name, program));
            else if (names.insert(foldCase(program)).second)
                instances += "        PROGRAM " + program + " WITH " + task.name + " : " + program + ";\n";
    }
    ++imported.report.units["CONFIGURATION"];
    addFile(imported, "", "configuration",
            "CONFIGURATION Plc\n    RESOURCE Resource1 ON PLC\n" + tasks + instances +
                "    END_RESOURCE\nEND_CONFIGURATION\n");
}

} // namespace plc::exchange
