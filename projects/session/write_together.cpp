#include "projects/session/write_together.h"

namespace plc::session {

namespace {

/// As it is now; an error where the program has no such variable.
Result<Assignment> presentOf(const controller::Controller& controller, const std::string& path) {
    const image::Layout& layout = controller.program().layout;
    const Result<image::Place> place = layout.find(path);
    if (!place) return Error{place.error().message, path};
    return Assignment{
        path, types::readValue(*layout.types, place->type, controller.image().subspan(place->offset), place->bit)};
}

} // namespace

Result<void> writeAllOrNone(controller::Controller& controller, const std::vector<Assignment>& values) {
    std::vector<Assignment> before;
    for (const Assignment& one : values) {
        auto present = presentOf(controller, one.path);
        if (!present) return present.error();
        before.push_back(std::move(*present));
    }
    for (size_t i = 0; i < values.size(); ++i) {
        const Result<void> done = controller.write(values[i].path, values[i].value);
        if (done) continue;
        while (i-- > 0) (void)controller.write(before[i].path, before[i].value);
        return done.error();
    }
    return {};
}

} // namespace plc::session
