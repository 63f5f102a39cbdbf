#include "app/cli/remote/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/remote/attached.h"
#include "projects/remote/scan_stream.h"

#include <QEventLoop>
#include <QSaveFile>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace plc::cli {

namespace {

using remote::Json;
using Words = std::vector<std::string>;

void printState(const Json& state) {
    std::cout << remote::textAt(state, "state") << ", " << remote::numberAt(state, "scans") << " scans, "
              << remote::numberAt(state, "skipped") << " skipped\n";
    if (const auto fault = state.find("fault"); fault != state.end() && fault->is_object())
        std::cout << "fault: " << remote::textAt(*fault, "text") << " (task " << remote::textAt(*fault, "task")
                  << ")\n";
    for (const Json& forced : state.value("forces", Json::array()))
        std::cout << "forced: " << forced[0].get<std::string>() << " := " << forced[1].get<std::string>() << "\n";
    for (const Json& task : state.value("tasks", Json::array()))
        std::cout << "task " << remote::textAt(task, "name") << ": " << remote::numberAt(task, "count") << " runs, "
                  << remote::numberAt(task, "overruns") << " overruns, at most "
                  << remote::numberAt(task, "max_ns") / 1000 << " us\n";
}

int finish(const Result<Json>& answer) { return answer ? kGood : wrongUse(answer.error()); }

int state(Attached& there, const Words&, bool asJson) {
    const auto answer = there.ask({{"do", "state"}});
    if (!answer) return wrongUse(answer.error());
    if (asJson)
        std::cout << (*answer)["state"].dump(1) << "\n";
    else
        printState((*answer)["state"]);
    return kGood;
}

int list(Attached& there, const Words& words, bool asJson) {
    const auto answer = there.ask({{"do", "list"}, {"filter", words.empty() ? std::string() : words[0]}});
    if (!answer) return wrongUse(answer.error());
    const Json all = answer->value("variables", Json::array());
    if (asJson) std::cout << all.dump() << "\n";
    for (const Json& each : asJson ? Json::array() : all)
        std::cout << each[0].get<std::string>() << " : " << each[1].get<std::string>() << "\n";
    return kGood;
}

/// One line with the values, or each on a line of its own.
Result<bool> printValues(Attached& there, const Words& words, bool isTable) {
    const auto answer = there.ask({{"do", "read"}, {"watch", words}});
    if (!answer) return answer.error();
    const Json values = answer->value("values", Json::array());
    bool isGood = values.size() == words.size();
    if (isTable) std::cout << remote::numberAt(*answer, "scan");
    for (size_t i = 0; i < values.size(); ++i) {
        const bool hasValue = values[i].contains("value");
        const std::string shown = hasValue ? remote::textAt(values[i], "value") : "-";
        if (isTable)
            std::cout << "\t" << shown;
        else if (hasValue)
            std::cout << words[i] << " = " << shown << "\n";
        else
            std::cerr << words[i] << ": " << remote::textAt(values[i], "reason") << "\n";
        isGood = isGood && hasValue;
    }
    if (isTable) std::cout << std::endl;
    return isGood;
}

int read(Attached& there, const Words& words, bool) {
    const auto good = printValues(there, words, false);
    return !good ? wrongUse(good.error()) : *good ? kGood : kProgramWrong;
}

int watch(Attached& there, const Arguments& arguments, const Words& words) {
    std::chrono::nanoseconds every = std::chrono::milliseconds(500), length = std::chrono::hours(24 * 365);
    for (auto [option, into] : {std::pair("--every", &every), std::pair("--for", &length)})
        if (const auto text = arguments.value(option)) {
            const auto duration = parseDuration(*text);
            if (!duration) return wrongUse(duration.error());
            *into = *duration;
        }
    std::cout << "scan";
    for (const std::string& word : words) std::cout << "\t" << word;
    std::cout << "\n";
    for (const auto end = std::chrono::steady_clock::now() + length;
         std::chrono::steady_clock::now() < end && !isInterrupted();) {
        if (const auto good = printValues(there, words, true); !good) return wrongUse(good.error());
        there.wait(every);
    }
    return kGood;
}

/// A list of one pair; of braces alone nlohmann::json would make an object.
Json oneValue(const Words& words) { return Json::array({Json::array({words[0], words[1]})}); }

int write(Attached& there, const Words& words, bool) {
    return finish(there.ask({{"do", "write"}, {"values", oneValue(words)}}));
}
int force(Attached& there, const Words& words, bool) {
    return finish(there.ask({{"do", "force"}, {"values", oneValue(words)}}));
}
int release(Attached& there, const Words& words, bool) {
    return finish(words.empty() ? there.ask({{"do", "unforce_all"}})
                                : there.ask({{"do", "unforce"}, {"path", words[0]}}));
}
int order(Attached& there, const char* what) { return finish(there.ask({{"do", what}})); }

int reset(Attached& there, const Words& words, bool) {
    return finish(there.ask({{"do", "reset"}, {"kind", words.empty() ? std::string("warm") : words[0]}}));
}

int recording(Attached& there, const Words& words, bool) {
    const auto bytes = there.fetchRecording();
    if (!bytes) return wrongUse(bytes.error());
    QSaveFile file(QString::fromStdString(words[0]));
    if (!file.open(QIODevice::WriteOnly) || file.write(*bytes) != bytes->size() || !file.commit())
        return wrongUse({errors::FileNotWritten(errors::ofSystem(errno)), words[0]});
    std::cout << words[0] << ": " << bytes->size() << " bytes\n";
    return kGood;
}

/// Only below the folder, whatever the controller says its files are called.
bool isInside(const std::filesystem::path& path) {
    if (path.empty() || path.is_absolute()) return false;
    return std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

int sources(Attached& there, const Words& words, bool) {
    const auto answer = there.ask({{"do", "program"}});
    if (!answer) return wrongUse(answer.error());
    const driver::BuildInput input = remote::readSources(answer->value("sources", Json::object()));
    for (const driver::SourceFile& file : input.files) {
        const std::filesystem::path path(file.path);
        const std::filesystem::path place = std::filesystem::path(words[0]) / (isInside(path) ? path : path.filename());
        std::error_code problem;
        std::filesystem::create_directories(place.parent_path(), problem);
        if (!(std::ofstream(place, std::ios::binary) << file.text))
            return wrongUse({errors::FileNotWritten(errors::ofSystem(errno)), place.string()});
        std::cout << place.string() << "\n";
    }
    return kGood;
}

int change(Attached& there, const Arguments& arguments, const Words& words) {
    const auto project = openNamedProject(arguments, {words[0]});
    if (!project) return wrongUse(project.error());
    const driver::BuildInput input = project->buildInput();
    if (printDiagnostics(driver::check(input), false, false)) return kProgramWrong;
    const auto answer = there.ask({{"do", "change"}, {"sources", remote::sourcesJson(input)}});
    if (!answer) return wrongUse(answer.error());
    std::cout << "changed: " << remote::numberAt(*answer, "kept") << " variables kept, "
              << remote::numberAt(*answer, "new") << " new, " << remote::numberAt(*answer, "lost") << " lost\n";
    return kGood;
}

struct Verb {
    std::string_view name;
    size_t least, most; // words behind it
    int (*run)(Attached& there, const Words& words, bool asJson);
};

constexpr size_t kAny = 1000;
const Verb kVerbs[] = {{"state", 0, 0, state},
                       {"list", 0, 1, list},
                       {"read", 1, kAny, read},
                       {"watch", 1, kAny, nullptr},
                       {"write", 2, 2, write},
                       {"force", 2, 2, force},
                       {"release", 0, 1, release},
                       {"start", 0, 0, [](Attached& there, const Words&, bool) { return order(there, "start"); }},
                       {"pause", 0, 0, [](Attached& there, const Words&, bool) { return order(there, "pause"); }},
                       {"scan", 0, 0, [](Attached& there, const Words&, bool) { return order(there, "scan"); }},
                       {"stop", 0, 0, [](Attached& there, const Words&, bool) { return order(there, "stop"); }},
                       {"reset", 0, 1, reset},
                       {"recording", 1, 1, recording},
                       {"sources", 1, 1, sources},
                       {"change", 1, 1, nullptr}};

int runAttach(const Arguments& arguments) {
    const Words& paths = arguments.paths();
    if (paths.empty()) return wrongUse({errors::AttachNeedsAddress(), ""});
    const std::string name = paths.size() > 1 ? paths[1] : "state";
    const auto verb =
        std::find_if(std::begin(kVerbs), std::end(kVerbs), [&](const Verb& each) { return each.name == name; });
    if (verb == std::end(kVerbs)) return wrongUse({errors::NoSuchVerb(name), ""});
    const Words words(paths.begin() + std::min<std::ptrdiff_t>(2, std::ssize(paths)), paths.end());
    if (words.size() < verb->least || words.size() > verb->most) return wrongUse({errors::VerbWords(name), ""});
    const auto file = arguments.value("--code");
    if (!file) return wrongUse({errors::AttachNeedsCode(), {}});
    const auto code = Attached::readCode(*file);
    if (!code) return wrongUse(code.error());
    needApplication();
    catchInterrupt();
    Attached there;
    const auto attached =
        there.attach({.url = QUrl(QString::fromStdString(paths[0])),
                      .code = *code,
                      .trustFile = QString::fromStdString(arguments.value("--certificate").value_or("")),
                      .name = QStringLiteral("command line")});
    if (!attached) return wrongUse(attached.error());
    if (verb->name == "watch") return watch(there, arguments, words);
    if (verb->name == "change") return change(there, arguments, words);
    return verb->run(there, words, arguments.wantsJson());
}

} // namespace

Command attachCommand() {
    return {{"attach",
             "URL [VERB …]",
             "Attaches to a running `stepwise serve`: state, list [TEXT], read EXPR…, watch EXPR…, write PATH VALUE, "
             "force PATH VALUE, release [PATH], start, pause, scan, stop, reset [warm|cold|origin], recording FILE, "
             "sources DIR, change PROJECT.",
             {{"--code", "FILE", "the attach code, the file attach-code in the controller's state folder"},
              {"--certificate", "FILE", "a certificate (PEM) that is trusted in addition to those of the system"},
              {"--every", "500ms", "of watch: how often a line is printed"},
              {"--for", "10s", "of watch: how long"},
              {"--format", "text|json", "of state and list"},
              {"--library", "NAME", "of change: a library the files use (repeatable)"}},
             "stepwise attach http://127.0.0.1:8080/ read Main.speed --code .stepwise/serve/attach-code"},
            runAttach};
}

} // namespace plc::cli
