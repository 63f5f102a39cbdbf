// What acts from outside, told to the observers when the next scan begins, and a recorded scan made again from what
// they kept (D13). Scan thread.
#include "runtime/base/assert.h"
#include "runtime/controller/controller_state.h"

namespace plc::controller {

using image::OutsideKind;
using image::OutsideNote;

void Controller::actFor(std::string origin) { m->origin = std::move(origin); }

void Controller::State_::touch(OutsideKind kind, std::string text) {
    isTouched = true;
    OutsideNote note;
    note.kind = kind;
    note.text = std::move(text);
    note.origin = origin;
    notes.push_back(std::move(note));
}

void Controller::State_::touch(OutsideKind kind, const image::Place& place, std::string text) {
    isTouched = true;
    OutsideNote note;
    note.kind = kind;
    note.offset = place.offset;
    note.size = place.bit >= 0 ? 1 : (*layout().types)[place.type].size;
    note.bit = place.bit;
    note.text = std::move(text);
    note.origin = origin;
    if (!isScanning) {
        notes.push_back(std::move(note));
        return;
    }
    note.site = siteNow;
    note.instance = instanceNow;
    const std::byte* first = image.get() + place.offset;
    note.bytes.assign(first, first + note.size);
    notesWhileHalted.push_back(std::move(note));
}

image::ScanStart Controller::State_::scanStart() const {
    const Schedule::Triggers triggers = schedule.triggers();
    image::ScanStart start;
    start.plcRuns = plcRuns();
    start.isFirst = firstPending;
    start.isSimulationFirst = simulationFirstPending;
    start.hasSimulationFault = simulationFault.has_value();
    start.timeBefore = time;
    start.pendingEvents = triggers.pending;
    start.triggersBefore = triggers.before;
    start.forces = forces.bytes();
    return start;
}

void Controller::State_::tellOutside() {
    const image::ScanStart start = scanStart();
    const image::Outside outside{image.span(), isAllDirty ? std::span<const uint8_t>() : dirtyPages, start, notes};
    for (ScanObserver* observer : observers) observer->outsideActed(outside);
    notes.clear();
    isTouched = false;
}

/// Puts what acted at a breakpoint into a scan that is made again.
void Controller::State_::actAtSites(const Rerun& wanted) {
    std::fill(siteFlags.begin(), siteFlags.end(), uint8_t(0));
    hook = nullptr;
    std::vector<uint32_t> sites;
    for (const OutsideNote& note : wanted.notes)
        if (note.site != 0 && note.site < siteFlags.size()) siteFlags[note.site] = 1;
    if (std::none_of(siteFlags.begin(), siteFlags.end(), [](uint8_t flag) { return flag != 0; })) return;
    hook = [this, notes = wanted.notes, left = wanted.occurrence, done = size_t(0)](uint32_t site, uint32_t instance,
                                                                                    uint32_t) mutable {
        const auto isHere = [&](const OutsideNote& note) { return note.site == site && note.instance == instance; };
        while (done < notes.size() && notes[done].site == 0) ++done;
        if (done == notes.size() || !isHere(notes[done])) return;
        if (left > 0) {
            --left;
            return;
        }
        for (; done < notes.size() && isHere(notes[done]); ++done) act(notes[done]);
    };
}

void Controller::State_::act(const OutsideNote& note) {
    Forces once;
    const image::ForcedBytes bytes{note.offset, note.size, note.bit, {}, note.bytes};
    once.setBytes({bytes});
    once.apply(image.get(), dirtyPages);
    if (note.kind == OutsideKind::Write) return;
    std::vector<image::ForcedBytes> held = forces.patches();
    std::erase_if(held, [&](const image::ForcedBytes& each) {
        return note.kind == OutsideKind::ReleaseAll || (each.offset == note.offset && each.bit == note.bit);
    });
    if (note.kind == OutsideKind::Force) held.push_back(bytes);
    forces.setBytes(held);
}

bool Controller::rerun(const Rerun& wanted) {
    State_& s = *m;
    const std::span<std::byte> bytes = s.image.span();
    const size_t known = std::min(wanted.image.size(), bytes.size());
    std::memcpy(bytes.data(), wanted.image.data(), known);
    std::memset(bytes.data() + known, 0, bytes.size() - known);
    s.rerunCode = wanted.code;
    s.clockBack = wanted.clockBack.count();
    s.isAllDirty = true;
    s.isRealTime = false;
    s.isHalted = false;
    s.scan = wanted.scan;
    s.time = wanted.start->timeBefore;
    s.settings.calendarStartNs = wanted.calendarStartNs;
    s.fault.reset();
    s.simulationFault.reset();
    if (wanted.start->hasSimulationFault) s.simulationFault.emplace();
    s.state = wanted.start->plcRuns ? State::Running : State::Stopped;
    s.firstPending = wanted.start->isFirst;
    s.simulationFirstPending = wanted.start->isSimulationFirst;
    s.forces.setBytes(wanted.start->forces);
    s.prepareContext(bytes.data(), s.settings.loopBudgetPerScan);
    s.schedule.rebase(s.time);
    if (wanted.startIsPartial) {
        s.firstPending = (s.header().reserved[2] & kFirstScanPending) != 0;
        s.simulationFirstPending = (s.header().reserved[2] & kSimulationFirstPending) != 0;
        s.schedule.restoreTriggers(bytes.data());
    } else {
        s.schedule.setTriggers({wanted.start->pendingEvents, wanted.start->triggersBefore});
    }
    s.actAtSites(wanted);
    s.isTouched = false;
    return s.scanAt(wanted.instant.count(), wanted.instant.count());
}

} // namespace plc::controller
