#include "app/mcp/tools.h"

#include "projects/protocol/errors.h"

#include <algorithm>

namespace plc::mcp {

namespace errors = protocol::errors;

namespace {

const Field kProject{"project", FieldType::Text, "", "folder of the project, or an ST file", true};
const Field kSet{"set", FieldType::Texts, "--set",
                 "stimuli: PATH=VALUE or PATH=VALUE@TIME, written before the first scan at or after TIME, for example "
                 "Plant.StartButton=TRUE@1s"};
const Field kForce{"force", FieldType::Texts, "--force", "likewise, but forced; VALUE RELEASE ends it"};
const Field kFor{"for", FieldType::Text, "--for", "PLC time to run, for example 10s (default) or 2m"};
const Field kLibraries{"libraries", FieldType::Texts, "--library",
                       "libraries that an ST file uses, besides the standard"};

} // namespace

const std::vector<Tool>& tools() {
    static const std::vector<Tool> all = {
        {"check",
         "Checks a project or ST file, its panels, texts, alarms and tests included: a list of findings with file, "
         "range, code, severity, message and fixes.",
         {"check", "--format", "json"},
         Picture::None,
         {kProject, kLibraries}},
        {"run",
         "Runs a project in virtual time with stimuli and returns the values at the end. Nothing real is driven and "
         "nothing is kept.",
         {"run", "--format", "json"},
         Picture::None,
         {kProject,
          kFor,
          {"until", FieldType::Text, "--until", "ends as soon as this ST expression is true"},
          kSet,
          kForce,
          {"watch", FieldType::Texts, "--watch", "ST expressions to return (default: all variables)"},
          {"start", FieldType::Text, "--start", "calendar at the first scan: DT#2026-01-01-06:00:00"},
          kLibraries}},
        {"test",
         "Runs the TESTs of a project and says which failed, where and why.",
         {"test", "--format", "json"},
         Picture::None,
         {kProject,
          {"filter", FieldType::Text, "--filter", "only tests whose title holds this text (* and ? are wildcards)"},
          kLibraries}},
        {"why",
         "Explains the value of an ST expression at a moment of a run or recording: what changed it, what had to hold; "
         "or, with `not`, what would have changed the result of the condition. Each answer is verified.",
         {"why", "--format", "json"},
         Picture::None,
         {{"project", FieldType::Text, "", "folder of the project, an ST file, or a recording", true},
          {"expression", FieldType::Text, "", "what is asked about, for example IO.K1", true},
          {"at", FieldType::Text, "--at", "the moment: a PLC time such as 1.5s, or a scan number (default: the last)"},
          {"not", FieldType::Flag, "--not", "what would change the result of the condition"},
          kSet,
          kForce,
          kFor,
          kLibraries}},
        {"trace",
         "Runs a project and draws chosen values over time: a picture, and a table of their values, least, greatest, "
         "mean and step response.",
         {"trace", "--statistics"},
         Picture::File,
         {kProject,
          {"channels", FieldType::Texts, "--channels", "ST expressions to draw", true},
          kFor,
          kSet,
          kForce,
          {"cursors", FieldType::Text, "--cursors", "two times to measure between: 1s,2.5s"},
          {"from", FieldType::Text, "--from", "first time shown"},
          {"to", FieldType::Text, "--to", "last time shown"},
          kLibraries}},
        {"panel",
         "Pictures of the operator panels of a project, at a moment of a run with stimuli when asked.",
         {"panel"},
         Picture::Folder,
         {{"project", FieldType::Text, "", "folder of the project", true},
          {"panels", FieldType::Texts, "--panel", "only these panels"},
          {"language", FieldType::Text, "--language", "only this language, or all"},
          {"at", FieldType::Text, "--at", "moment of a run, for example 10s"},
          kSet,
          kForce}},
        {"panel_findings",
         "What is wrong with the operator panels of a project: texts that do not fit, unknown variables, low contrast.",
         {"panel", "--check", "--format", "json"},
         Picture::None,
         {{"project", FieldType::Text, "", "folder of the project", true},
          {"at", FieldType::Text, "--at", "compares bars and charts with a run up to this time"},
          kSet}},
    };
    return all;
}

Json inputSchema(const std::vector<Field>& fields) {
    Json properties = Json::object(), needed = Json::array();
    for (const Field& field : fields) {
        Json& property = properties[std::string(field.name)];
        switch (field.type) {
        case FieldType::Text:
            property["type"] = "string";
            break;
        case FieldType::Texts:
            property["type"] = "array";
            property["items"] = {{"type", "string"}};
            break;
        case FieldType::Flag:
            property["type"] = "boolean";
            break;
        }
        property["description"] = field.help;
        if (field.isNeeded) needed.push_back(field.name);
    }
    Json schema{{"type", "object"}, {"properties", std::move(properties)}};
    if (!needed.empty()) schema["required"] = std::move(needed);
    schema["additionalProperties"] = false;
    return schema;
}

namespace {

bool fits(const Field& field, const Json& value) {
    switch (field.type) {
    case FieldType::Text: // a word that looks like an option would be one
        return value.is_string() && (!field.option.empty() || !value.get<std::string>().starts_with("-"));
    case FieldType::Texts:
        return value.is_array() &&
               std::all_of(value.begin(), value.end(), [](const Json& each) { return each.is_string(); });
    case FieldType::Flag:
        return value.is_boolean();
    }
    return false;
}

Message noSuchArgument(std::string_view tool, const std::string& name, const std::vector<Field>& fields) {
    std::vector<std::string> known;
    for (const Field& field : fields) known.emplace_back(field.name);
    return known.empty() ? errors::NoSuchArgument(tool, name) : errors::NoSuchArgumentBut(tool, name, known);
}

} // namespace

Result<void> checkArguments(std::string_view tool, const std::vector<Field>& fields, const Json& arguments) {
    if (!arguments.is_object()) return Error{errors::WrongParameter(tool, Verbatim("arguments")), {}};
    for (const auto& [name, value] : arguments.items())
        if (std::none_of(fields.begin(), fields.end(), [&, &n = name](const Field& each) { return each.name == n; }))
            return Error{noSuchArgument(tool, name, fields), {}};
    for (const Field& field : fields) {
        const Json* value = protocol::find(arguments, field.name);
        if ((!value && field.isNeeded) || (value && !fits(field, *value)))
            return Error{errors::WrongParameter(tool, field.name), {}};
    }
    return {};
}

Result<std::vector<std::string>> wordsOf(const Tool& tool, const Json& arguments) {
    if (auto good = checkArguments(tool.name, tool.fields, arguments); !good) return good.error();
    std::vector<std::string> words(tool.words.begin(), tool.words.end());
    for (const Field& field : tool.fields) {
        const Json* value = protocol::find(arguments, field.name);
        if (!value) continue;
        const std::string option(field.option);
        if (field.type == FieldType::Flag) {
            if (value->get<bool>()) words.push_back(option);
        } else if (field.type == FieldType::Text) {
            words.push_back(option.empty() ? value->get<std::string>() : option + "=" + value->get<std::string>());
        } else {
            for (const Json& each : *value) words.push_back(option + "=" + each.get<std::string>());
        }
    }
    return words;
}

} // namespace plc::mcp
