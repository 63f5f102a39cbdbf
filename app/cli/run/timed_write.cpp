#include "app/cli/run/timed_write.h"

#include "app/cli/kit/command.h"
#include "app/cli/kit/errors.h"
#include "projects/session/value_text.h"
#include "runtime/base/text.h"
#include "runtime/controller/leave_hook.h"

#include <algorithm>

namespace plc::cli {

Result<TimedWrite> parseWrite(const std::string& word, bool isForce) {
    const size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0) return Error{errors::NotAWrite(word), ""};
    TimedWrite write;
    write.isForce = isForce;
    write.path = word.substr(0, equals);
    write.text = word.substr(equals + 1);
    // The last @ is the time, unless it stands inside a text literal.
    const size_t at = write.text.rfind('@');
    if (at != std::string::npos &&
        std::count(write.text.begin() + static_cast<std::ptrdiff_t>(at), write.text.end(), '\'') % 2 == 0) {
        const auto time = parseDuration(write.text.substr(at + 1));
        if (!time) return time.error();
        write.at = *time;
        write.text.erase(at);
    }
    if (write.text.empty()) return Error{errors::WriteWithoutValue(word), ""};
    write.isRelease = isForce && equalsIgnoringCase(write.text, "release");
    return write;
}

Result<types::Value> valueFor(const driver::Checked& checked, const controller::Controller& controller,
                              const TimedWrite& write) {
    const auto place = controller.program().layout.find(write.path);
    if (!place) return place.error();
    return session::parseValue(checked, place->type, write.text, write.path);
}

Result<std::vector<TimedWrite>> readWrites(const Arguments& arguments, const driver::Checked& checked,
                                           const controller::Controller& controller) {
    std::vector<TimedWrite> writes;
    for (const bool isForce : {true, false})
        for (const std::string& word : arguments.values(isForce ? "--force" : "--set")) {
            const auto write = parseWrite(word, isForce);
            if (!write) return write.error();
            if (!write->isRelease)
                if (const auto value = valueFor(checked, controller, *write); !value) return value.error();
            writes.push_back(*write);
        }
    std::stable_sort(writes.begin(), writes.end(),
                     [](const TimedWrite& a, const TimedWrite& b) { return a.at < b.at; });
    return writes;
}

Result<void> apply(const driver::Checked& checked, controller::Controller& controller, const TimedWrite& write) {
    if (write.isRelease) return controller.release(write.path);
    const auto value = valueFor(checked, controller, write);
    if (!value) return value.error();
    return write.isForce ? controller.force(write.path, *value) : controller.write(write.path, *value);
}

Result<void> runProject(const Arguments& arguments, const driver::Built& built, session::Session& session,
                        std::chrono::nanoseconds length, std::string_view lengthOption) {
    controller::Controller& controller = session.controller();
    if (const auto text = arguments.value(lengthOption)) {
        const auto time = parseDuration(*text);
        if (!time) return time.error();
        length = *time;
    }
    const auto writes = readWrites(arguments, built.checked, controller);
    if (!writes) return writes.error();
    controller::setLeaveHook(controller, isInterrupted); // a scan may take longer than anybody waits
    controller.start();
    ProgressLine progress;
    size_t next = 0;
    for (uint64_t done = 0;
         !isInterrupted() && controller.state() == controller::State::Running && controller.nextDue() < length;
         ++done) {
        for (; next < writes->size() && (*writes)[next].at <= controller.nextDue(); ++next)
            if (auto written = apply(built.checked, controller, (*writes)[next]); !written) return written;
        controller.scan();
        if ((done & 0xfff) == 0)
            progress.show("scan " + std::to_string(done) + ", " + types::durationText(controller.lastTime().count()));
    }
    return {};
}

} // namespace plc::cli
