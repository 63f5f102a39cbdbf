#include "app/cli/program/commands.h"

#include "app/cli/kit/errors.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"
#include "runtime/compiler/format/format.h"
#include "runtime/platform/streams.h"

#include <filesystem>
#include <iostream>
#include <sstream>

namespace plc::cli {

namespace {

namespace fs = std::filesystem;

/// ST files named, and those of project folders named.
Result<std::vector<std::string>> filesOf(const std::vector<std::string>& paths) {
    std::vector<std::string> out;
    for (const std::string& path : paths) {
        std::error_code problem;
        if (fs::is_directory(path, problem)) {
            const auto project = projects::openProject({path});
            if (!project) return project.error();
            for (const auto* list : {&project->sources, &project->tests})
                for (const driver::SourceFile& file : *list)
                    out.push_back(path + (path.ends_with('/') ? "" : "/") + file.path);
        } else if (fs::exists(path, problem)) {
            out.push_back(path);
        } else {
            return Error{errors::NoSuchFileOrFolder(), path};
        }
    }
    return out;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> out;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) out.push_back(line);
    if (!text.empty() && text.back() != '\n') out.back() += " (no line end)";
    return out;
}

/// Changed stretches, old lines with -, new ones with +; lines between the common begin and end are aligned greedily.
std::string difference(const std::string& path, const std::string& before, const std::string& after, bool colours) {
    const std::vector<std::string> a = linesOf(before), b = linesOf(after);
    const std::string red = colours ? "\033[31m" : "", green = colours ? "\033[32m" : "",
                      plain = colours ? "\033[0m" : "";
    std::string out = "--- " + path + "\n+++ " + path + " (formatted)\n";
    for (size_t i = 0, k = 0; i < a.size() || k < b.size();) {
        if (i < a.size() && k < b.size() && a[i] == b[k]) {
            ++i, ++k;
            continue;
        }
        size_t skipA = 0, skipB = 0; // the nearest pair of equal lines ahead
        bool found = false;
        for (size_t distance = 1; distance < 60 && !found; ++distance)
            for (size_t left = 0; left <= distance && !found; ++left)
                if (i + left < a.size() && k + distance - left < b.size() && a[i + left] == b[k + distance - left])
                    skipA = left, skipB = distance - left, found = true;
        if (!found) skipA = a.size() - i, skipB = b.size() - k;
        out += "@@ line " + std::to_string(i + 1) + " @@\n";
        for (size_t n = 0; n < skipA; ++n) out += red + "-" + a[i + n] + plain + "\n";
        for (size_t n = 0; n < skipB; ++n) out += green + "+" + b[k + n] + plain + "\n";
        i += skipA, k += skipB;
    }
    return out;
}

int formatFiles(const Arguments& arguments) {
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("fmt")), ""});
    const auto files = filesOf(arguments.paths());
    if (!files) return wrongUse(files.error());
    format::FormatOptions options;
    if (const auto text = arguments.value("--indent")) {
        const auto indent = parseCount(*text);
        if (!indent || *indent < 1 || *indent > 16) return wrongUse({errors::IndentRange(), *text});
        options.indentWidth = static_cast<int>(*indent);
    }
    options.alignDeclarations = arguments.has("--align");
    std::optional<projects::Encoding> encoding;
    if (arguments.has("--utf8")) encoding = projects::Encoding::Utf8;
    const bool onlyCheck = arguments.has("--check"), json = arguments.wantsJson();
    size_t changed = 0;
    std::string list;
    for (const std::string& path : *files) {
        const auto before = projects::readSourceText(path);
        if (!before) return wrongUse(before.error());
        const std::string after = format::format(before->text, options);
        const bool recodes = encoding && before->encoding != *encoding;
        if (after == before->text && !recodes) continue;
        ++changed;
        list += (list.empty() ? "" : ",") + jsonString(path);
        if (!onlyCheck) {
            if (auto written = projects::writeSourceText(path, after, encoding); !written)
                return wrongUse(written.error());
            if (!json) std::cout << "formatted " << path << "\n";
        } else if (!json) {
            std::cout << difference(path, before->text, after, wantsColours(platform::kStandardOutput));
        }
    }
    if (json)
        std::cout << "{\"changed\":[" << list << "],\"files\":" << files->size() << "}\n";
    else
        std::cout << changed << " of " << files->size() << (onlyCheck ? " files would change\n" : " files changed\n");
    return onlyCheck && changed ? kProgramWrong : kGood;
}

} // namespace

Command formatCommand() {
    return {
        {"fmt",
         "PATH… [OPTIONS]",
         "Formats ST files in place.",
         {{"--check", "", "change nothing; show the difference and exit 1 when there is one"},
          {"--indent", "4", "blanks per level"},
          {"--align", "", "also the colons of neighbouring declarations"},
          {"--utf8", "", "also convert files in UTF-16 or Windows-1252 to UTF-8; otherwise they keep their encoding"},
          {"--format", "text|json", "text (default), or an object with the changed files"}},
         "stepwise fmt --check projects/examples/motor"},
        formatFiles};
}

} // namespace plc::cli
