#include "app/cli/program/commands.h"

#include "app/cli/devices/device_output.h"
#include "app/cli/kit/errors.h"
#include "app/cli/panels/panel_findings.h"
#include "editor/trace/setup/trace_setup.h"
#include "projects/testing/test_run.h"
#include "runtime/platform/streams.h"

#include <iostream>

namespace plc::cli {

namespace {
int check(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("check")), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    for (const auto& [path, encoding] : project->encodings)
        std::cerr << path << ": note: the file is written in " << encoding << " and stays so\n";
    const driver::Checked checked = [&] {
        const Busy busy("checking " + project->name);
        return driver::check(project->buildInput());
    }();
    // Panels, texts, alarms and traces belong to the project (D9).
    std::vector<hmi::Finding> findings;
    if (hasPanels(*project)) {
        needApplication();
        const hmi::PanelProject panels = hmi::loadPanelProject(*project);
        findings = hmi::checkPanels(panels, hmi::checkedForPanels(project->buildInput(), checked, panels.panels));
    }
    for (const std::string& name : project->traces)
        if (const auto setup = trace::loadSetup(project->folder + "/traces/" + name); !setup)
            findings.push_back({hmi::FindingKind::UnknownKind,
                                true,
                                QString::fromStdString("traces/" + name),
                                0,
                                {},
                                {},
                                {},
                                setup.error().message});
    const bool hasLayout = !checked.analysis->hasErrors && checked.analysis->program;
    const auto deviceFindings = findDeviceProblems(*project, hasLayout ? &checked.analysis->program->layout : nullptr);
    if (!deviceFindings) return wrongUse(deviceFindings.error());
    std::vector<std::string> objects, tests;
    if (arguments.wantsJson())
        for (const hmi::Finding& finding : findings) objects.push_back(renderJson(finding));
    if (arguments.wantsJson())
        for (const devices::Finding& finding : *deviceFindings) objects.push_back(renderJson(finding));
    if (!checked.analysis->hasErrors)
        tests = testing::checkTests(*project, arguments.wantsJson(), wantsColours(platform::kStandardError));
    if (arguments.wantsJson()) objects.insert(objects.end(), tests.begin(), tests.end());
    bool wrong = printDiagnostics(checked, arguments.wantsJson(), arguments.has("--infos") || arguments.wantsJson(),
                                  objects, Entry::Optional);
    if (!arguments.wantsJson()) {
        for (const std::string& problem : tests) std::cerr << problem;
        printFindings(findings, std::cerr);
        printFindings(*deviceFindings, std::cerr);
    }
    wrong |= devices::hasErrors(*deviceFindings);
    wrong |= !tests.empty();
    for (const hmi::Finding& finding : findings) wrong |= finding.isError;
    if (!arguments.wantsJson() && !wrong) std::cout << project->name << ": no errors\n";
    return wrong ? kProgramWrong : kGood;
}
} // namespace

Command checkCommand() {
    return {{"check",
             "PATH… [OPTIONS]",
             "Checks a project, or ST files, and lists what is wrong.",
             {{"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"},
              {"--infos", "", "also informational messages"},
              {"--format", "text|json",
               "text (default), or a list of objects with file, range, code, severity, message, fixes"}},
             "stepwise check projects/examples/motor"},
            check};
}

} // namespace plc::cli
