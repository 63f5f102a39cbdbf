// The state of a controller as JSON, to send it to an attached studio, and back. What comes back was sent by somebody:
// whatever is missing or of another type is left out. Functions, any thread.
#pragma once
#include "projects/session/mirror.h"

#include <nlohmann/json.hpp>

namespace plc::remote {

using Json = nlohmann::ordered_json;

[[nodiscard]] const char* nameOf(controller::State state);
[[nodiscard]] Json stateJson(const session::Session& session);
/// `program`: of the mirror; places are looked up there.
[[nodiscard]] session::Mirror::Figures readState(const Json& json, const driver::Built& built);
[[nodiscard]] Json eventJson(const controller::Event& event);
[[nodiscard]] controller::Event readEvent(const Json& json);
/// What a program is built from, as recordings keep it (D19).
[[nodiscard]] Json sourcesJson(const driver::BuildInput& input);
[[nodiscard]] driver::BuildInput readSources(const Json& json);
/// What images and frames of a program depend on: equal on both sides, an image from there can be read here.
[[nodiscard]] uint64_t layoutSum(const image::CompiledProgram& program);
/// Of a member, or nothing that was said.
[[nodiscard]] std::string textAt(const Json& json, const char* key);
[[nodiscard]] uint64_t numberAt(const Json& json, const char* key);

} // namespace plc::remote
