// Reading, writing and forcing variables, and what moves values from one program to the next. Scan thread.
#include "runtime/base/messages.h"
#include "runtime/controller/controller_state.h"
#include "runtime/controller/fitting.h"
#include "runtime/controller/online_change.h"
#include "runtime/controller/retained_places.h"

namespace plc::controller {

namespace {

Message shownWrite(const image::Layout& layout, std::string_view path, const types::Value& value) {
    return errors::Assigned(path, types::toText(*layout.types, value));
}

/// A constant, or a part of one.
bool isConstant(const image::Layout& layout, const image::Place& place) {
    for (const image::Root& root : layout.roots)
        if (root.constant && root.bit < 0 && place.offset >= root.offset &&
            place.offset < root.offset + (*layout.types)[root.type].size)
            return true;
    return false;
}

} // namespace

Result<types::Value> Controller::read(std::string_view path) const {
    const Result<image::Place> place = m->layout().find(path);
    if (!place) return place.error();
    return types::readValue(*m->layout().types, place->type, image().subspan(place->offset), place->bit);
}

Result<void> Controller::write(std::string_view path, const types::Value& value) {
    const Result<image::Place> place = m->layout().find(path);
    if (!place) return place.error();
    return write(path, *place, value);
}

Result<void> Controller::write(std::string_view path, image::Place place, const types::Value& value) {
    const Result<types::Value> written = m->write(place, value);
    if (!written) return Error{written.error().message, std::string(path)};
    m->report(EventKind::Write, shownWrite(m->layout(), path, *written));
    return {};
}

Result<void> Controller::write(image::Place place, const types::Value& value) {
    const Result<types::Value> written = m->write(place, value);
    if (!written) return written.error();
    return {};
}

Result<types::Value> Controller::State_::write(image::Place place, const types::Value& value) {
    const types::TypeTable& types = *layout().types;
    if (const Forced* forced = forces.overlapping(types, place)) return Error{errors::IsForced(forced->path), {}};
    if (isConstant(layout(), place)) return Error{errors::ConstantNotWritten(), {}};
    Result<types::Value> fit = fitted(types, value, place.type);
    if (!fit) return fit;
    types::writeValue(types, place.type, *fit, image.span().subspan(place.offset), place.bit);
    markWritten(dirtyPages, place.offset, place.bit >= 0 ? 1 : types[place.type].size);
    touch(image::OutsideKind::Write, place);
    return fit;
}

Result<void> Controller::force(std::string_view path, const types::Value& value) {
    const types::TypeTable& types = *m->layout().types;
    const Result<image::Place> place = m->layout().find(path);
    if (!place) return place.error();
    if (isConstant(m->layout(), *place)) return Error{errors::ConstantNotForced(), std::string(path)};
    Result<types::Value> fit = fitted(types, value, place->type);
    if (!fit) return Error{fit.error().message, std::string(path)};
    Message text = shownWrite(m->layout(), path, *fit);
    m->forces.set(types, Forced{std::string(path), *place, std::move(*fit)});
    m->applyForces();
    m->touch(image::OutsideKind::Force, *place);
    m->report(EventKind::Force, std::move(text));
    return {};
}

Result<void> Controller::release(std::string_view path) {
    const Result<image::Place> place = m->layout().find(path);
    if (!place) return place.error();
    if (!m->forces.remove(*place)) return Error{errors::NotForced(), std::string(path)};
    m->touch(image::OutsideKind::Release, *place);
    m->report(EventKind::Release, errors::Plainly(path));
    return {};
}

void Controller::releaseAll() {
    if (m->forces.isEmpty()) return;
    m->forces.clear();
    m->touch(image::OutsideKind::ReleaseAll);
    m->report(EventKind::Release, {});
}

const std::vector<Forced>& Controller::forces() const { return m->forces.list(); }

// ---------------------------------------------------------------- another program, another time

OnlineChangeReport Controller::changeProgram(std::shared_ptr<const image::CompiledProgram> program) {
    m->isAllDirty = true;
    const std::shared_ptr<const image::CompiledProgram> oldProgram = m->program;
    ImageBuffer old = std::move(m->image);
    m->image = ImageBuffer();
    const image::ImageHeader header = *reinterpret_cast<const image::ImageHeader*>(old.get());
    std::vector<std::string> pending; // event tasks that have seen their edge
    for (const TaskRun& run : m->schedule.runs())
        if (run.isPending) pending.push_back(run.task->name);

    OnlineChangeReport result;
    m->setProgram(program);
    if (!m->initialise(m->image.span())) {
        const Fault why = m->describeFault(false);
        result.refusal = errors::InitialValuesFault(why.message);
        m->setProgram(oldProgram);
        m->image = std::move(old);
        m->prepareContext(m->image.get(), m->settings.loopBudgetPerScan);
        m->schedule.restoreTriggers(m->image.get());
        return result;
    }
    m->keepSafeOutputs();
    result = carryOver(oldProgram->layout, old.span(), program->layout, m->image.span());
    m->header() = header;
    for (std::string& path : m->forces.rebind(program->layout)) result.lostForces.push_back(std::move(path));
    m->applyForces();
    m->schedule.restoreTriggers(m->image.get());
    for (TaskRun& run : m->schedule.runs())
        run.isPending = std::find(pending.begin(), pending.end(), run.task->name) != pending.end();
    m->simulationFault.reset(); // the plant may be what was fixed
    m->touch(image::OutsideKind::OnlineChange);
    for (ScanObserver* observer : m->observers) observer->programChanged(m->program);
    m->report(EventKind::OnlineChange, {});
    return result;
}

void Controller::resumeFrom(std::shared_ptr<const image::CompiledProgram> program, std::span<const std::byte> image,
                            uint64_t scan, Nanoseconds time) {
    m->isAllDirty = true;
    const bool isOther = program != m->program;
    m->time = time.count();
    m->scan = scan + 1;
    if (isOther) {
        m->setProgram(std::move(program));
        (void)m->initialise(m->image.span()); // for the safe outputs; everything else is overwritten
        m->keepSafeOutputs();
    }
    const size_t size = std::min<size_t>(image.size(), m->layout().dataEnd);
    std::memcpy(m->image.get(), image.data(), size);
    std::memset(m->image.get() + size, 0, m->image.span().size() - size);
    m->prepareContext(m->image.get(), m->settings.loopBudgetPerScan);
    m->firstPending = (m->header().reserved[2] & kFirstScanPending) != 0;
    m->simulationFirstPending = (m->header().reserved[2] & kSimulationFirstPending) != 0;
    m->fault.reset();
    m->simulationFault.reset();
    m->isHalted = false;
    m->state = State::Paused;
    if (isOther) {
        (void)m->forces.rebind(m->layout());
        for (ScanObserver* observer : m->observers) observer->programChanged(m->program);
    }
    m->applyForces();
    m->schedule.rebase(m->time);
    m->schedule.restoreTriggers(m->image.get());
    m->touch(image::OutsideKind::Resumed);
    m->report(EventKind::WentBack, {});
}

// ---------------------------------------------------------------- retain

std::vector<std::pair<std::string, types::Value>> Controller::retained(bool persistentOnly) const {
    std::vector<std::pair<std::string, types::Value>> values;
    const image::Layout& layout = m->layout();
    forEachRetained(layout, persistentOnly, [&](const std::string& path, const image::Place& place) {
        layout.forEachLeaf(path, place, [&](const std::string& leaf, const image::Place& at) {
            const types::TypeKind kind = layout.types->kind(at.type);
            const bool isReference = kind == types::TypeKind::Pointer || kind == types::TypeKind::Reference ||
                                     kind == types::TypeKind::Interface;
            if (!isReference)
                values.emplace_back(leaf, types::readValue(*layout.types, at.type, image().subspan(at.offset), at.bit));
            return true;
        });
    });
    return values;
}

size_t Controller::restoreRetained(std::span<const std::pair<std::string, types::Value>> values) {
    const types::TypeTable& types = *m->layout().types;
    size_t restored = 0;
    m->isAllDirty = true;
    for (const auto& [path, value] : values) {
        const Result<image::Place> place = m->layout().find(path);
        if (!place) continue;
        const bool isSameKind = !types::isElementary(types.kind(value.type)) ||
                                value.type.index() > static_cast<size_t>(types::TypeKind::Wchar) ||
                                types.storage(place->type) == value.type;
        const Result<types::Value> fit = fitted(types, value, place->type);
        if (!isSameKind || !fit) continue;
        types::writeValue(types, place->type, *fit, m->image.span().subspan(place->offset), place->bit);
        ++restored;
    }
    m->applyForces();
    m->schedule.restoreTriggers(m->image.get());
    if (restored > 0) m->touch(image::OutsideKind::Retain);
    return restored;
}

} // namespace plc::controller
