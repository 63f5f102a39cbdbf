// stepwise people: who may operate the panels, and the trail of what they did.
#include "app/cli/panels/commands.h"

#include "app/cli/kit/errors.h"
#include "hmi/model/errors.h"
#include "hmi/people/audit_trail.h"
#include "hmi/people/password.h"
#include "hmi/station/panel_project.h"
#include "projects/storage/project_file.h"

#include <iostream>

namespace plc::cli {

namespace {

int list(const hmi::PeopleFile& people) {
    for (const hmi::Role& role : people.roles()) std::cout << "role " << role.name.toStdString() << "\n";
    for (const hmi::User& user : people.users())
        std::cout << "user " << user.name.toStdString() << ": " << user.roles.join(", ").toStdString()
                  << (user.password.isEmpty() ? " (no password)" : "") << "\n";
    return kGood;
}

int audit(const Arguments& arguments, const hmi::PanelProject& panels) {
    const QString path = panels.folder + "/.stepwise/audit.csv";
    const auto read = hmi::readAudit(path);
    if (!read) return wrongUse(read.error());
    const std::string table = hmi::auditToCsv(read->entries);
    if (const auto file = arguments.value("--csv")) {
        if (auto written = projects::writeFileAtomically(*file, table); !written) return wrongUse(written.error());
    } else {
        std::cout << table;
    }
    if (read->firstBroken == 0) return kGood;
    std::cerr << errors::AuditChanged(read->firstBroken).english() << "\n";
    return kProgramWrong;
}

/// One line of standard input, so that no password is seen in a list of commands.
Result<QString> passwordFor(const QString& user) {
    std::string line;
    if (!std::getline(std::cin, line)) return Error{errors::PasswordFromInput(), ""};
    const QString password = QString::fromStdString(line);
    if (Message weak = hmi::weaknessOf(password, user); !weak.isEmpty()) return Error{weak, user.toStdString()};
    return hmi::hashOf(password);
}

int set(const Arguments& arguments, hmi::PanelProject& panels, const std::string& name) {
    const hmi::User* known = panels.people.find(QString::fromStdString(name));
    hmi::User user = known ? *known : hmi::User{QString::fromStdString(name)};
    if (const auto roles = arguments.values("--role"); !roles.empty()) {
        user.roles.clear();
        for (const std::string& role : roles) {
            user.roles += QString::fromStdString(role);
            if (!panels.people.role(user.roles.back())) panels.people.setRole({user.roles.back(), {}, {}});
        }
    }
    if (const auto language = arguments.value("--language")) user.language = QString::fromStdString(*language);
    if (const auto panel = arguments.value("--start-panel")) user.startPanel = QString::fromStdString(*panel);
    if (arguments.has("--password")) {
        auto hash = passwordFor(user.name);
        if (!hash) return wrongUse(hash.error());
        user.password = *hash;
    }
    panels.people.setUser(user);
    const auto saved = hmi::savePeople(panels);
    return saved ? kGood : wrongUse(saved.error());
}

int runPeople(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::PeopleNeedsProject(), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    hmi::PanelProject panels = hmi::loadPanelProject(*project);
    if (arguments.has("--audit")) return audit(arguments, panels);
    for (const Error& problem : panels.problems)
        if (problem.place.starts_with("hmi/people.json")) return wrongUse(problem);
    if (const auto name = arguments.value("--user")) return set(arguments, panels, *name);
    if (const auto name = arguments.value("--remove")) {
        if (!panels.people.removeUser(QString::fromStdString(*name)))
            return wrongUse({errors::NoSuchUser(*name), project->name});
        const auto saved = hmi::savePeople(panels);
        return saved ? kGood : wrongUse(saved.error());
    }
    if (const auto seconds = arguments.value("--timeout")) {
        panels.people.setTimeout(std::max(0, std::atoi(seconds->c_str())));
        const auto saved = hmi::savePeople(panels);
        return saved ? kGood : wrongUse(saved.error());
    }
    return list(panels.people);
}

} // namespace

Command peopleCommand() {
    return {{"people",
             "PROJECT [OPTIONS]",
             "Lists and changes who may operate the panels of a project, and prints the audit trail.",
             {{"--user", "NAME", "adds the user or changes the one of that name"},
              {"--role", "ROLE", "with --user: a role of the user (repeatable); a new role is added"},
              {"--password", "", "with --user: reads the password from standard input"},
              {"--language", "TAG", "with --user: the language after logging in"},
              {"--start-panel", "NAME", "with --user: the panel after logging in"},
              {"--remove", "NAME", "removes the user"},
              {"--timeout", "SECONDS", "logs out after this time without a touch; 0 never"},
              {"--audit", "",
               "the audit trail: who changed what, when, from which value to which; and whether it is complete"},
              {"--csv", "FILE", "with --audit: into a file"}},
             "stepwise people projects/examples/motor --user anna --role operator --password"},
            runPeople};
}

} // namespace plc::cli
