// Who else might have written a place: statements that a condition kept from it, found also where they name it by an
// IN_OUT or a reference.
#include "runtime/inside/slice.h"

#include <algorithm>
#include <cstring>

namespace plc::inside {

using image::WatchKind;
using tree::PlaceKind;
using tree::Stmt;
using tree::StmtKind;

namespace {

bool overlap(const types::TypeTable& types, const image::Place& a, const image::Place& b) {
    if (a.offset >= b.offset + sizeOf(types, b) || b.offset >= a.offset + sizeOf(types, a)) return false;
    return a.bit < 0 || b.bit < 0 || a.bit == b.bit;
}

} // namespace

bool Slicer::reaches(const Reach& reach, const image::Place& place) const {
    const types::TypeTable& types = *m_look.tree().types;
    if (reach.isKnown() || reach.stride == 0) return overlap(types, reach.place, place);
    image::Place element = reach.place;
    for (uint32_t passed = 0; passed < reach.span; passed += reach.stride, element.offset += reach.stride)
        if (overlap(types, element, place)) return true;
    return false;
}

// ---------------------------------------------------------------- what a place may reach

/// The offset that an IN_OUT or a reference at this place of the image held in the scan.
std::optional<uint32_t> Slicer::referredBy(uint32_t offset) const {
    uint64_t target = 0;
    const auto events = m_look.events();
    if (const EventIndex last = m_look.lastWriteBefore(static_cast<EventIndex>(events.size()), offset, sizeof target);
        last != kNone && events[last].offset == offset && events[last].size == sizeof target) {
        target = events[last].bits;
    } else {
        if (m_look.image().size() < offset + sizeof target) return std::nullopt;
        std::memcpy(&target, m_look.image().data() + offset, sizeof target);
    }
    if (target < sizeof(image::ImageHeader) || target >= m_look.program().layout.dataEnd) return std::nullopt;
    return static_cast<uint32_t>(target);
}

/// What the caller gave for an IN_OUT of a function or method.
std::optional<Slicer::Reach> Slicer::argumentOf(const Activation& run, uint32_t local) const {
    if (run.call == kNone || run.parent == kNone) return std::nullopt;
    for (const tree::CallArgument& argument : m_look.events()[run.call].call()->arguments)
        if (argument.mode == tree::ArgumentMode::InOut && argument.local == local && argument.place)
            return reachOf(*argument.place, m_look.activations()[run.parent]);
    return std::nullopt;
}

std::optional<Slicer::Reach> Slicer::reachOf(const tree::Place& place, const Activation& run) const {
    const auto at = [&](uint32_t offset) { return Reach{{place.type, offset, place.bit}}; };
    std::optional<Reach> base;
    if (place.base) {
        base = reachOf(*place.base, run);
        if (!base) return base;
    }
    switch (place.kind) {
    case PlaceKind::Absolute:
        return at(place.offset);
    case PlaceKind::Instance:
        return at(run.instance + place.offset);
    case PlaceKind::Local:
        return argumentOf(run, place.local);
    case PlaceKind::Field:
        if (!base->isWhole) { // of an element that is not known: this member of each
            base->place = {place.type, base->place.offset + place.offset, place.bit};
        }
        return base;
    case PlaceKind::InOutSlot: {
        if (base && !base->isKnown()) return std::nullopt;
        const auto target = referredBy((base ? base->place.offset : run.instance) + place.offset);
        return target ? std::optional(at(*target)) : std::nullopt;
    }
    case PlaceKind::Deref: {
        if (place.pointer->kind != tree::ExprKind::Load) return std::nullopt;
        const auto pointer = reachOf(*place.pointer->place, run);
        if (!pointer || !pointer->isKnown()) return std::nullopt;
        const auto target = referredBy(pointer->place.offset);
        return target ? std::optional(at(*target)) : std::nullopt;
    }
    case PlaceKind::Index: // which element is not known before the statement has run
        if (base->isKnown()) {
            const types::TypeTable& types = *m_look.tree().types;
            base->stride = std::max(1u, types[place.type].size);
            base->span = sizeOf(types, base->place);
            base->place.type = place.type;
        } else {
            base->isWhole = true;
        }
        return base;
    case PlaceKind::Bit:
    case PlaceKind::TextIndex:
        base->isWhole = true;
        return base;
    case PlaceKind::Temporary:
        break;
    }
    return std::nullopt;
}

// ---------------------------------------------------------------- who might have written

/// Statements behind the last write (or all, where there is none) that would have written it had their condition come
/// out otherwise.
void Slicer::otherWriters(const image::Place& place, EventIndex after, Steps& out, bool followsCalls) {
    const auto events = m_look.events();
    std::set<std::pair<const Stmt*, uint32_t>> seen;
    if (after == kNone && followsCalls) blockedCalls(out);
    for (uint32_t a = 0; a < m_look.activations().size(); ++a) {
        const Activation& activation = m_look.activations()[a];
        if (libraryActivation(a) != kNone) continue;
        for (const Stmt* stmt : m_map.assignments(activation.function)) {
            const std::optional<Reach> target = reachOf(*stmt->place, activation);
            if (!target || !reaches(*target, place)) continue;
            for (const Stmt* inner = stmt; inner;) {
                const StatementMap::Around* around = m_map.around(*inner);
                if (!around || !around->parent) break;
                const Stmt* parent = around->parent;
                inner = parent;
                if ((parent->kind != StmtKind::If && parent->kind != StmtKind::Case) || !parent->a) continue;
                const EventIndex until =
                    activation.end == kNone ? static_cast<EventIndex>(events.size()) : activation.end;
                const EventIndex at = valueEvent(*parent->a, until, a);
                if (at == kNone || (after != kNone && at < after)) continue;
                const bool wasTaken = parent->kind == StmtKind::If && (boolAt(at) ? 1 : 0) == around->arm;
                if (wasTaken || !seen.insert({parent, a}).second) break;
                guard(after == kNone ? Reason::Kind::Blocked : Reason::Kind::NotReset, *parent, at + 1, a, out);
                break;
            }
        }
    }
}

/// Conditions that kept a call from being made: what is called might have written it.
void Slicer::blockedCalls(Steps& out) {
    for (uint32_t a = 0; a < m_look.activations().size(); ++a) {
        const Activation& activation = m_look.activations()[a];
        if (libraryActivation(a) != kNone) continue;
        const auto until = activation.end == kNone ? static_cast<EventIndex>(m_look.events().size()) : activation.end;
        for (const Stmt* stmt : m_map.branches(activation.function)) {
            const EventIndex at = stmt->a ? valueEvent(*stmt->a, until, a) : kNone;
            if (at == kNone) continue;
            bool calls = stmt->kind == StmtKind::If && m_map.calls(boolAt(at) ? stmt->elseBody : stmt->body);
            for (const tree::CaseArm& arm : stmt->arms) calls = calls || m_map.calls(arm.body);
            if (calls) guard(Reason::Kind::Blocked, *stmt, at + 1, a, out);
        }
    }
}

} // namespace plc::inside
