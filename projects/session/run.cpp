#include "projects/session/run.h"

#include "projects/session/versions.h"
#include "runtime/base/assert.h"
#include "runtime/base/messages.h"

namespace plc::session {

Run::Run() : m_versions(std::make_shared<Versions>()) {}
Run::~Run() = default;

std::vector<std::byte> Run::snapshot(uint64_t* scan) const {
    Snapshot newest;
    latest(newest);
    if (scan) *scan = newest.scan;
    return std::move(newest.image);
}

Result<expression::Expression> Run::expression(const std::string& text, const std::string& scope) const {
    const auto newest = program();
    if (!newest) return Error{errors::RecordingHasNoProgram(), ""};
    return expression(text, scope, *newest);
}

Result<expression::Expression> Run::expression(const std::string& text, const std::string& scope,
                                               const image::CompiledProgram& version) const {
    const std::shared_ptr<const driver::Built> built = m_versions->of(&version);
    if (!built) return Error{errors::RecordingHasNoProgram(), ""};
    return m_versions->expression(*built, text, scope);
}

history::Recompile Run::recompile(const std::string& text, const std::string& scope) const {
    return [versions = m_versions, text, scope](const image::CompiledProgram& program) {
        const std::shared_ptr<const driver::Built> built = versions->of(&program);
        if (!built) return expression::Expression();
        Result<expression::Expression> compiled = versions->expression(*built, text, scope);
        return compiled ? std::move(*compiled) : expression::Expression();
    };
}

Result<Target> Run::target(const std::string& path) const {
    auto newest = program();
    if (!newest) return Error{errors::RecordingHasNoProgram(), path};
    const Result<image::Place> place = newest->layout.find(path);
    if (!place) return place.error();
    return Target(path, *place, std::move(newest));
}

// Who writes asks isLive() first and tells the user why not; a run that is live has its own of all of these.
void Run::write(Target, types::Value, std::string) { PLC_ASSERT(isLive(), return ); }
void Run::writeTogether(std::vector<Assignment>, std::string) { PLC_ASSERT(isLive(), return ); }
void Run::press(Target, types::Value, types::Value, std::string) { PLC_ASSERT(isLive(), return ); }
void Run::release(Target) { PLC_ASSERT(isLive(), return ); }
void Run::force(std::string, types::Value, std::string) { PLC_ASSERT(isLive(), return ); }
void Run::unforce(std::string) { PLC_ASSERT(isLive(), return ); }
void Run::unforceAll() { PLC_ASSERT(isLive(), return ); }
std::vector<controller::Forced> Run::forces() const { return {}; }
std::vector<Error> Run::takeRefusals() { return {}; }

} // namespace plc::session
