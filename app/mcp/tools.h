// What an assistant can ask for: a table of tools, each a command of the command line with the options that only read
// and simulate. Nothing here writes into a project. Values, any thread.
#pragma once
#include "projects/protocol/json_rpc.h"

#include <string_view>
#include <vector>

namespace plc::mcp {

using protocol::Json;

enum class FieldType : uint8_t { Text, Texts, Flag };
struct Field {
    std::string_view name;
    FieldType type = FieldType::Text;
    std::string_view option; // "--for"; empty: a word of its own, in this order
    std::string_view help;
    bool isNeeded = false;
};
/// What the tool makes besides text.
enum class Picture : uint8_t { None, File /* --picture */, Folder /* --pictures */ };
struct Tool {
    std::string_view name, description;
    std::vector<std::string_view> words; // "why", "--format", "json"
    Picture picture = Picture::None;
    std::vector<Field> fields;
};
[[nodiscard]] const std::vector<Tool>& tools();
/// The schema of a tool's arguments.
[[nodiscard]] Json inputSchema(const std::vector<Field>& fields);
/// The words of the command line; the error names what is missing, unknown or of another type.
[[nodiscard]] Result<std::vector<std::string>> wordsOf(const Tool& tool, const Json& arguments);
/// Whether the arguments fit the fields.
[[nodiscard]] Result<void> checkArguments(std::string_view tool, const std::vector<Field>& fields,
                                          const Json& arguments);

} // namespace plc::mcp
