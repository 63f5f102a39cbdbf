#include "app/cli/manual.h"

#include <algorithm>
#include <cctype>

namespace plc::cli {

namespace {

/// Text as troff reads it: no line begins with a control character, a hyphen is a hyphen.
std::string troff(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
            out += std::string("\\&") + c;
        else
            out += c;
    }
    return out;
}

std::string bold(std::string_view text) { return "\\fB" + troff(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + troff(text) + "\\fR"; }

std::string titleLine(std::string name, const std::string& version) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    return ".TH " + troff(name) + " 1 \"\" \"Stepwise " + version + "\" \"User Commands\"\n";
}

std::string nameSection(const std::string& name, std::string_view summary) {
    if (summary.ends_with('.')) summary.remove_suffix(1);
    return ".SH NAME\n" + troff(name) + " \\- " + troff(summary) + "\n";
}

/// What may follow an option, from the example that the help shows.
enum class ValueKind { None, File, Folder, Choice, Other };
ValueKind kindOf(const OptionSpec& option) {
    if (option.value.empty()) return ValueKind::None;
    if (option.value == "FILE") return ValueKind::File;
    if (option.value == "FOLDER" || option.value == "DIR") return ValueKind::Folder;
    const bool isChoice = option.value.find('|') != std::string_view::npos &&
                          std::all_of(option.value.begin(), option.value.end(), [](char c) {
                              return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '|' || c == '_';
                          });
    return isChoice ? ValueKind::Choice : ValueKind::Other;
}

std::string words(std::string_view choice) {
    std::string out(choice);
    std::replace(out.begin(), out.end(), '|', ' ');
    return out;
}

std::string shellQuoted(std::string_view text, std::string_view alsoEscaped = {}) { // 'text' of a shell
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'')
            out += "'\\''";
        else if (alsoEscaped.find(c) != std::string_view::npos)
            out += std::string("\\") + c;
        else
            out += c;
    }
    return out + "'";
}

/// "--csv|--record) COMPREPLY=(…) ;;": one arm for all options of a kind.
std::string bashArm(const CommandSpec& command, ValueKind kind, std::string_view action) {
    std::string names;
    for (const OptionSpec& option : command.options)
        if (kindOf(option) == kind) names += (names.empty() ? "" : "|") + std::string(option.name);
    if (names.empty()) return {};
    return "            " + names + ") " + std::string(action) + "; return ;;\n";
}

std::string bashCommand(const CommandSpec& command) {
    std::string options = "--help";
    for (const OptionSpec& option : command.options) options += " " + std::string(option.name);
    std::string out = "    " + std::string(command.name) + ")\n        case $previous in\n";
    out += bashArm(command, ValueKind::File, "COMPREPLY=($(compgen -f -- \"$current\"))");
    out += bashArm(command, ValueKind::Folder, "COMPREPLY=($(compgen -d -- \"$current\"))");
    out += bashArm(command, ValueKind::Other, "COMPREPLY=()");
    for (const OptionSpec& option : command.options)
        if (kindOf(option) == ValueKind::Choice)
            out += "            " + std::string(option.name) + ") COMPREPLY=($(compgen -W " +
                   shellQuoted(words(option.value)) + " -- \"$current\")); return ;;\n";
    return out + "        esac\n        options=" + shellQuoted(options) + " ;;\n";
}

std::string zshOption(const OptionSpec& option) {
    const std::string help = "[" + std::string(option.help) + "]";
    std::string spec = "*" + std::string(option.name);
    const std::string shown(option.value);
    switch (kindOf(option)) {
    case ValueKind::None:
        return shellQuoted(spec + help, ":");
    case ValueKind::File:
        return shellQuoted(spec + "=" + help, ":") + "':file:_files'";
    case ValueKind::Folder:
        return shellQuoted(spec + "=" + help, ":") + "':folder:_files -/'";
    case ValueKind::Choice:
        return shellQuoted(spec + "=" + help, ":") + "':choice:(" + words(shown) + ")'";
    case ValueKind::Other:
        return shellQuoted(spec + "=" + help, ":") + "':" + "value" + ": '";
    }
    return {};
}

} // namespace

std::string manualPage(const CommandSpec& command, const std::string& version) {
    const std::string name = "stepwise-" + std::string(command.name);
    std::string out = titleLine(name, version) + nameSection(name, command.summary);
    out += ".SH SYNOPSIS\n" + bold("stepwise " + std::string(command.name)) + " " + troff(command.usage) + "\n";
    out += ".SH DESCRIPTION\n" + troff(command.summary) + "\n";
    if (!command.options.empty()) out += ".SH OPTIONS\n";
    for (const OptionSpec& option : command.options) {
        out += ".TP\n" + bold(option.name) + (option.value.empty() ? "" : " " + italic(option.value)) + "\n";
        out += troff(option.help) + "\n";
    }
    out += ".SH EXIT STATUS\n0 where all is good, 1 where the program has errors or faulted, 2 for wrong use.\n";
    return out + ".SH EXAMPLE\n.EX\n" + troff(command.example) + "\n.EE\n.SH SEE ALSO\n" + bold("stepwise") + "(1)\n";
}

std::string overviewPage(const std::vector<CommandSpec>& commands, const std::string& version) {
    std::string out = titleLine("stepwise", version) +
                      nameSection("stepwise", "write, run and watch IEC 61131-3 programs") + ".SH SYNOPSIS\n" +
                      bold("stepwise") + " [" + italic("PROJECT") + "]\n.br\n" + bold("stepwise") + " " +
                      italic("COMMAND") + " [" + italic("OPTIONS") + "]\n";
    out += ".SH DESCRIPTION\nWithout a command it opens the studio. The commands work without a display.\n"
           ".SH COMMANDS\n";
    for (const CommandSpec& command : commands)
        out += ".TP\n" + bold("stepwise-" + std::string(command.name)) + "(1)\n" + troff(command.summary) + "\n";
    return out + ".SH OPTIONS\n.TP\n" + bold("--help") + "\nthe commands\n.TP\n" + bold("--version") +
           "\nthe version\n.SH FILES\n.TP\n" + italic("/usr/share/stepwise/examples") +
           "\nprojects to begin with; the studio opens a copy\n.TP\n" + italic("/var/lib/stepwise") +
           "\nprojects that run as a service, as stepwise@.service says\n";
}

std::string bashCompletion(const std::vector<CommandSpec>& commands) {
    std::string names;
    for (const CommandSpec& command : commands) names += (names.empty() ? "" : " ") + std::string(command.name);
    std::string out = "# bash completion of stepwise, made by `stepwise doc completion`\n"
                      "_stepwise() {\n"
                      "    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options=\n"
                      "    COMPREPLY=()\n"
                      "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
                      "        COMPREPLY=($(compgen -W " +
                      shellQuoted(names + " --help --version") +
                      " -- \"$current\") $(compgen -d -- \"$current\"))\n"
                      "        return\n"
                      "    fi\n"
                      "    case ${COMP_WORDS[1]} in\n";
    for (const CommandSpec& command : commands) out += bashCommand(command);
    return out + "    esac\n"
                 "    case $current in\n"
                 "        -*) COMPREPLY=($(compgen -W \"$options\" -- \"$current\")) ;;\n"
                 "        *) COMPREPLY=($(compgen -f -- \"$current\")) ;;\n"
                 "    esac\n"
                 "}\n"
                 "complete -o filenames -F _stepwise stepwise\n";
}

std::string zshCompletion(const std::vector<CommandSpec>& commands) {
    std::string out = "#compdef stepwise\n# zsh completion of stepwise, made by `stepwise doc completion`\n"
                      "_stepwise() {\n    local -a commands=(\n";
    for (const CommandSpec& command : commands)
        out += "        " + shellQuoted(std::string(command.name) + ":" + std::string(command.summary)) + "\n";
    out += "    )\n"
           "    if (( CURRENT == 2 )); then\n"
           "        _describe -t commands command commands\n"
           "        _files -/\n"
           "        return\n"
           "    fi\n"
           "    local name=$words[2]\n"
           "    shift words\n"
           "    (( CURRENT-- ))\n"
           "    case $name in\n";
    for (const CommandSpec& command : commands) {
        out += "    " + std::string(command.name) + ")\n        _arguments \\\n";
        for (const OptionSpec& option : command.options) out += "            " + zshOption(option) + " \\\n";
        out += "            '--help[shows the options and an example]' '*:path:_files' ;;\n";
    }
    return out + "    esac\n}\n_stepwise \"$@\"\n";
}

} // namespace plc::cli
