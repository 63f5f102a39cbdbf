#include "runtime/inside/slice.h"

#include "runtime/inside/words.h"

#include <algorithm>

namespace plc::inside {

using image::WatchKind;
using library::BinaryOp;
using tree::Expr;
using tree::ExprKind;
using tree::Stmt;
using tree::StmtKind;
using types::TypeKind;

namespace {
// An explanation is read by a person; what is longer says "and more" and can be asked further from there.
constexpr size_t kMostSteps = 400;
constexpr uint32_t kDeepest = 60;

/// What lowering made of a chart: not what a person would change. A step's X is.
bool isMachinery(const std::string& path) {
    if (path.find("__") != std::string::npos) return true;
    return path.ends_with(".enter") || path.ends_with(".leave");
}
} // namespace

uint32_t sizeOf(const types::TypeTable& types, const image::Place& place) {
    return place.bit >= 0 ? 1 : std::max(1u, types[place.type].size);
}

std::string nameOf(const image::Layout& layout, const image::Place& place) {
    if (place.bit < 0) return layout.pathAt(place.offset, place.type);
    for (const image::Root& root : layout.roots)
        if (root.bit == place.bit && root.offset == place.offset) return image::Layout::pathOf(root);
    std::string found;
    // Roots are few and searched in whole; pathAt knows bytes and cannot tell the bits in one of them apart.
    for (const image::Root& root : layout.roots) { // BIT members, and bits of words
        const uint32_t size = (*layout.types)[root.type].size;
        if (root.bit >= 0 || place.offset < root.offset || place.offset >= root.offset + std::max(1u, size)) continue;
        layout.forEachLeaf(image::Layout::pathOf(root), {root.type, root.offset, root.bit},
                           [&](const std::string& path, const image::Place& at) {
                               if (at.offset == place.offset && at.bit == place.bit) found = path;
                               return found.empty();
                           });
        if (!found.empty()) return found;
    }
    const std::string whole = layout.pathAt(place.offset);
    return whole.empty() ? whole : whole + "." + std::to_string(place.bit);
}

Slicer::Slicer(const Look& look, const StatementMap& map) : m_look(look), m_map(map) {}

Slice Slicer::sliceOf(const image::Place& place) { return sliceOf(std::vector<image::Place>{place}); }

Slice Slicer::sliceOf(const std::vector<image::Place>& places) {
    m_slice = {};
    m_seen.clear();
    m_blocks.clear();
    m_count = 0;
    const auto end = static_cast<EventIndex>(m_look.events().size());
    for (const image::Place& place : places) {
        placeBefore(end, place, m_slice.steps, {});
        const EventIndex last =
            m_look.lastWriteBefore(end, place.offset, sizeOf(*m_look.tree().types, place), place.bit);
        if (last != kNone && m_slice.task == kNone)
            m_slice.task = m_look.activations()[m_look.events()[last].activation].task;
        otherWriters(place, last, m_slice.steps);
    }
    return std::move(m_slice);
}

bool Slicer::isFull() {
    if (++m_count <= kMostSteps && m_depth < kDeepest) return false;
    m_slice.isCut = true;
    return true;
}

// ---------------------------------------------------------------- places

void Slicer::read(EventIndex at, Steps& out) {
    const Event& event = m_look.events()[at];
    image::Place place{event.place()->type, event.offset, event.bit};
    if (event.bit >= 0) place.type = types::TypeTable::of(TypeKind::Bool);
    placeBefore(at, place, out, event.place()->range);
}

void Slicer::placeBefore(EventIndex before, const image::Place& place, Steps& out, SourceRange) {
    const EventIndex last =
        m_look.lastWriteBefore(before, place.offset, sizeOf(*m_look.tree().types, place), place.bit);
    if (last != kNone)
        write(last, place, out);
    else if (const uint32_t block = blockAround(before, place); block != kNone)
        library(before, block, out); // it ran and left this as it was
    else
        leaf(place, before, out);
}

/// The run of a library's block before `before` that the place belongs to; kNone: none.
uint32_t Slicer::blockAround(EventIndex before, const image::Place& place) const {
    const auto activations = m_look.activations();
    for (auto a = static_cast<uint32_t>(activations.size()); a-- > 0;) {
        const Activation& run = activations[a];
        const types::TypeId type = m_look.tree().functions[run.function].instanceType;
        if (run.begin >= before || run.end == kNone || run.end >= before || !type.isValid()) continue;
        if (place.offset < run.instance || place.offset >= run.instance + (*m_look.tree().types)[type].size) continue;
        if (libraryActivation(a) == a) return a;
    }
    return kNone;
}

void Slicer::leaf(const image::Place& place, EventIndex read, Steps& out, bool isInternal) {
    const image::Layout& layout = m_look.program().layout;
    // The header is the PLC clock: time is what timers wait for, so it is a reason of its own.
    if (place.offset < sizeof(image::ImageHeader)) return clock(out);
    if (place.offset >= layout.dataEnd) return; // a frame: a local without a writer
    for (const image::Root& root : layout.roots)
        if (root.constant && place.offset >= root.offset &&
            place.offset < root.offset + (*layout.types)[root.type].size)
            return;
    Leaf fresh;
    fresh.place = place;
    const auto known = std::find_if(m_slice.leaves.begin(), m_slice.leaves.end(),
                                    [&](const Leaf& l) { return !(l < fresh) && !(fresh < l); });
    auto index = static_cast<uint32_t>(known - m_slice.leaves.begin());
    if (known == m_slice.leaves.end()) {
        fresh.path = nameOf(layout, place);
        fresh.isInternal = isInternal || isMachinery(fresh.path);
        const std::span<const std::byte> image =
            // What a read in the scan found is the image before it; asked about the end, it is the image after it.
            read < m_look.events().size() ? std::span<const std::byte>(m_look.input().image) : m_look.image();
        if (!m_look.tree().types->isAggregate(place.type))
            fresh.value = types::readValue(*layout.types, place.type, image.subspan(place.offset), place.bit);
        fresh.condition = m_condition.range;
        fresh.conditionHeld = m_condition.held;
        m_slice.leaves.push_back(std::move(fresh));
    }
    for (const types::Value& other : m_condition.against) m_slice.leaves[index].others.push_back(other);
    Reason step;
    step.leaf = index;
    step.path = m_slice.leaves[index].path;
    step.value = m_slice.leaves[index].value;
    step.isInternal = m_slice.leaves[index].isInternal;
    step.event = read;
    out.push_back(std::move(step));
}

void Slicer::clock(Steps& out) {
    const auto known =
        std::find_if(m_slice.leaves.begin(), m_slice.leaves.end(), [](const Leaf& l) { return l.isClock; });
    const auto index = static_cast<uint32_t>(known - m_slice.leaves.begin());
    if (known == m_slice.leaves.end()) {
        Leaf time;
        time.isClock = true;
        m_slice.leaves.push_back(std::move(time));
    }
    Reason step;
    step.leaf = index;
    out.push_back(std::move(step));
}

// ---------------------------------------------------------------- writes

uint32_t Slicer::libraryActivation(uint32_t activation) const {
    uint32_t found = kNone;
    for (uint32_t a = activation; a != kNone; a = m_look.activations()[a].parent)
        if (!m_look.program().functions[m_look.activations()[a].function].library.empty()) found = a;
    return found;
}

void Slicer::write(EventIndex at, const image::Place& place, Steps& out) {
    const Event& event = m_look.events()[at];
    // One write may explain many reads. It is listed once, or a chain of sums doubles with every step.
    if (!m_seen.insert(at).second || isFull()) return;
    ++m_depth;
    const Activation& activation = m_look.activations()[event.activation];
    const tree::Function& function = m_look.tree().functions[activation.function];
    if (const uint32_t library = libraryActivation(event.activation); library != kNone && event.node) {
        this->library(at, library, out);
    } else if (!event.node) {
        parameter(at, out);
    } else if (event.stmt()->isHidden && event.stmt()->kind == StmtKind::Assign &&
               event.offset >= m_look.program().layout.dataEnd) {
        assigned(at, out); // a temporary of the compiler's
    } else {
        Reason step;
        step.kind = Reason::Kind::Statement;
        step.range = event.stmt()->range;
        step.function = function.name;
        step.instance = m_look.instanceOf(event.activation);
        step.path = nameOf(m_look.program().layout, place);
        if (event.offset >= m_look.program().layout.dataEnd) {
            for (const image::FunctionLocal& local : m_look.program().functions[activation.function].locals)
                if (activation.frame + local.frameOffset == event.offset) step.path = local.name;
        }
        step.event = at;
        step.value = m_look.valueOf(event);
        if (const tree::Expr* given = event.stmt()->a;
            !step.value.hasValue() && given) { // a text: too wide for one event
            const EventIndex made = valueEvent(*given, at, event.activation);
            if (made != kNone) step.value = m_look.valueOf(m_look.events()[made]);
        }
        assigned(at, step.steps);
        guards(*event.stmt(), at, event.activation, step.steps);
        out.push_back(std::move(step));
    }
    --m_depth;
}

void Slicer::assigned(EventIndex at, Steps& out) {
    const Event& event = m_look.events()[at];
    const Stmt& stmt = *event.stmt();
    // The condition that was being explained ends here: what the value was made of was not decided by it.
    const Condition around = std::exchange(m_condition, {});
    switch (stmt.kind) {
    case StmtKind::Assign:
        expression(*stmt.a, at, event.activation, out);
        break;
    case StmtKind::For:
        for (const Expr* each : {stmt.a, stmt.b, stmt.c})
            if (each) expression(*each, at, event.activation, out);
        break;
    default:
        output(at, out);
        break;
    }
    m_condition = around;
}

/// An input of a function: what the caller gave.
void Slicer::parameter(EventIndex at, Steps& out) {
    const Event& event = m_look.events()[at];
    const Activation& activation = m_look.activations()[event.activation];
    if (activation.call == kNone) return;
    const std::vector<image::FunctionLocal>& locals = m_look.program().functions[activation.function].locals;
    const tree::Call& call = *m_look.events()[activation.call].call();
    for (const tree::CallArgument& argument : call.arguments) {
        if (!argument.value || argument.local >= locals.size()) continue;
        if (activation.frame + locals[argument.local].frameOffset != event.offset) continue;
        expression(*argument.value, activation.call, activation.parent, out);
    }
}

/// Written by the call that the statement makes: an output of a function.
void Slicer::output(EventIndex at, Steps& out) {
    const Event& event = m_look.events()[at];
    const auto activations = m_look.activations();
    for (auto a = static_cast<uint32_t>(activations.size()); a-- > 0;) {
        const Activation& callee = activations[a];
        if (callee.parent != event.activation || callee.end == kNone || callee.end > at || callee.call == kNone)
            continue;
        const std::vector<image::FunctionLocal>& locals = m_look.program().functions[callee.function].locals;
        for (const tree::CallArgument& argument : m_look.events()[callee.call].call()->arguments) {
            if (argument.mode != tree::ArgumentMode::Output || !argument.place || argument.local >= locals.size())
                continue;
            const std::optional<image::Place> target = fixedPlace(*argument.place, activations[event.activation]);
            if (target && (target->offset != event.offset || target->bit != event.bit)) continue;
            const image::FunctionLocal& local = locals[argument.local];
            placeBefore(callee.end, {local.type, callee.frame + local.frameOffset, -1}, out, {});
        }
        return;
    }
}

/// What a library's block was given; where nothing gave it in this scan, what kept others from it.
void Slicer::input(const Activation& activation, const image::Place& place, Steps& out) {
    const EventIndex given =
        m_look.lastWriteBefore(activation.begin, place.offset, sizeOf(*m_look.tree().types, place), place.bit);
    if (given != kNone) return write(given, place, out);
    leaf(place, activation.begin, out, true);
    if (m_depth < kDeepest / 4) otherWriters(place, kNone, out, false);
}

/// A block or function of a library is explained by what it was given, not by its insides.
void Slicer::library(EventIndex at, uint32_t index, Steps& out) {
    const Activation& activation = m_look.activations()[index];
    if (!m_blocks.insert(index).second) return;
    const tree::Function& function = m_look.tree().functions[activation.function];
    const types::TypeTable& types = *m_look.tree().types;
    Reason step;
    step.kind = Reason::Kind::Block;
    step.event = at;
    step.function = function.name;
    if (activation.call != kNone) {
        const EventIndex around = statementAround(activation.call, activation.parent);
        if (around != kNone) step.range = m_look.events()[around].stmt()->range;
    }
    if (function.instanceType.isValid()) {
        const types::Type& block = types[function.instanceType];
        step.blockType = block.name;
        step.path = m_look.program().layout.pathAt(activation.instance, function.instanceType);
        step.instance = step.path;
        step.note = blockNote(m_look, activation.instance, block);
        for (const types::Field& field : block.fields) {
            if (field.section != types::FieldSection::Input || types.isAggregate(field.type)) continue;
            input(activation, {field.type, activation.instance + field.offset, field.bit}, step.steps);
        }
        // A timer's start or a flip-flop's state came from scans before; without them its output has no reason.
        for (const types::Field& field : block.fields) { // what it remembers
            const bool isOwn = field.section == types::FieldSection::Local ||
                               field.section == types::FieldSection::Static ||
                               field.section == types::FieldSection::Output;
            if (isOwn && !types.isAggregate(field.type) && !types.isText(field.type))
                leaf({field.type, activation.instance + field.offset, field.bit}, activation.begin, step.steps, true);
        }
        for (EventIndex i = activation.begin; i < std::min(at, activation.end); ++i) {
            const Event& event = m_look.events()[i];
            if (event.kind == WatchKind::Value && event.expr()->kind == ExprKind::Intrinsic &&
                (event.expr()->intrinsic == library::Intrinsic::Time ||
                 event.expr()->intrinsic == library::Intrinsic::Calendar)) {
                clock(step.steps);
                break;
            }
        }
    } else if (activation.call != kNone) {
        for (const tree::CallArgument& argument : m_look.events()[activation.call].call()->arguments)
            if (argument.value) expression(*argument.value, activation.call, activation.parent, step.steps);
    }
    if (const EventIndex around =
            activation.call == kNone ? kNone : statementAround(activation.call, activation.parent);
        around != kNone)
        guards(*m_look.events()[around].stmt(), activation.call, activation.parent, step.steps);
    out.push_back(std::move(step));
}

// ---------------------------------------------------------------- expressions

EventIndex Slicer::valueEvent(const Expr& expr, EventIndex before, uint32_t activation) const {
    const auto events = m_look.events();
    const EventIndex first = m_look.activations()[activation].begin;
    for (EventIndex i = std::min<EventIndex>(before, static_cast<EventIndex>(events.size())); i-- > first;)
        if (events[i].node == &expr && events[i].activation == activation &&
            (events[i].kind == WatchKind::Value || events[i].kind == WatchKind::Text ||
             events[i].kind == WatchKind::Bytes))
            return i;
    return kNone;
}

EventIndex Slicer::statementAround(EventIndex before, uint32_t activation) const {
    const auto events = m_look.events();
    for (EventIndex i = before; i-- > m_look.activations()[activation].begin;)
        if (events[i].kind == WatchKind::Statement && events[i].activation == activation &&
            events[i].stmt()->kind != StmtKind::Block)
            return i;
    return kNone;
}

void Slicer::expression(const Expr& expr, EventIndex before, uint32_t activation, Steps& out) {
    if (expr.kind == ExprKind::Constant || isFull()) return;
    const EventIndex at = valueEvent(expr, before, activation);
    if (at == kNone) return; // not evaluated
    const bool isCondition = m_look.tree().types->storageKind(expr.type) == TypeKind::Bool;
    const Condition around = m_condition;
    const bool isComparison = expr.kind == ExprKind::Binary && expr.binary >= BinaryOp::Equal;
    if (isCondition && (expr.kind == ExprKind::Load || isComparison)) m_condition = {expr.range, boolAt(at), {}};
    if (isCondition && isComparison)
        for (const Expr* side : {expr.a, expr.b}) {
            const EventIndex value = valueEvent(*side, at, activation);
            if (side->kind == ExprKind::Constant) m_condition.against.push_back(side->value);
            if (value != kNone) m_condition.against.push_back(m_look.valueOf(m_look.events()[value]));
        }
    ++m_depth;
    operands(expr, at, activation, out);
    --m_depth;
    m_condition = around;
}

void Slicer::operands(const Expr& expr, EventIndex at, uint32_t activation, Steps& out) {
    const auto all = [&](std::initializer_list<const Expr*> each) {
        for (const Expr* e : each)
            if (e) expression(*e, at, activation, out);
    };
    const bool isBool = m_look.tree().types->storageKind(expr.type) == TypeKind::Bool;
    const auto decisive = [&](bool isAnd) {
        const bool result = boolAt(at);
        for (const Expr* side : {expr.a, expr.b}) {
            if (!side) continue;
            const EventIndex value = valueEvent(*side, at, activation);
            if (side->kind == ExprKind::Constant || value == kNone) continue;
            if (result == isAnd || boolAt(value) == result) expression(*side, at, activation, out);
        }
    };
    switch (expr.kind) {
    case ExprKind::Load: {
        const auto events = m_look.events();
        for (EventIndex i = at; i-- > m_look.activations()[activation].begin;) {
            if (events[i].kind != WatchKind::Read || events[i].node != expr.place || events[i].activation != activation)
                continue;
            read(i, out);
            break;
        }
        for (const tree::Place* p = expr.place; p; p = p->base)
            for (const Expr* index : p->indices) expression(*index, at, activation, out);
        break;
    }
    case ExprKind::Binary:
        if (isBool && (expr.binary == BinaryOp::And || expr.binary == BinaryOp::Or))
            decisive(expr.binary == BinaryOp::And);
        else
            all({expr.a, expr.b});
        break;
    case ExprKind::AndThen:
    case ExprKind::OrElse:
        decisive(expr.kind == ExprKind::AndThen);
        break;
    case ExprKind::Intrinsic:
        if (expr.intrinsic == library::Intrinsic::Time || expr.intrinsic == library::Intrinsic::Calendar) clock(out);
        for (const Expr* operand : expr.operands) expression(*operand, at, activation, out);
        break;
    case ExprKind::Call:
        callResult(expr, at, activation, out);
        break;
    default:
        all({expr.a, expr.b, expr.c});
        break;
    }
}

void Slicer::callResult(const Expr& expr, EventIndex at, uint32_t activation, Steps& out) {
    const auto activations = m_look.activations();
    for (auto a = static_cast<uint32_t>(activations.size()); a-- > 0;) {
        const Activation& callee = activations[a];
        if (callee.parent != activation || callee.end == kNone || callee.end > at || callee.call == kNone) continue;
        if (m_look.events()[callee.call].node != expr.call) continue;
        const tree::Function& function = m_look.tree().functions[callee.function];
        if (function.resultLocal >= function.locals.size()) return;
        const image::FunctionLocal& local = m_look.program().functions[callee.function].locals[function.resultLocal];
        const EventIndex last = m_look.lastWriteBefore(callee.end, callee.frame + local.frameOffset,
                                                       std::max(1u, (*m_look.tree().types)[local.type].size));
        if (last != kNone) write(last, {local.type, callee.frame + local.frameOffset, -1}, out);
        return;
    }
}

// ---------------------------------------------------------------- conditions

void Slicer::guard(Reason::Kind kind, const Stmt& around, EventIndex before, uint32_t activation, Steps& out) {
    if (!around.a || isFull()) return;
    const EventIndex at = valueEvent(*around.a, before, activation);
    if (at == kNone) return;
    Reason step;
    step.kind = kind;
    step.range = around.a->range;
    step.function = m_look.tree().functions[m_look.activations()[activation].function].name;
    step.instance = m_look.instanceOf(activation);
    step.value = m_look.valueOf(m_look.events()[at]);
    step.event = at;
    const Condition outer = m_condition;
    m_condition = {around.a->range, false, {}};
    for (const tree::CaseArm& arm : around.arms)
        for (const tree::CaseRange& range : arm.ranges) {
            types::Value choice;
            choice.type = around.a->type;
            choice.data = range.low;
            m_condition.against.push_back(choice);
        }
    expression(*around.a, at + 1, activation, step.steps);
    m_condition = outer;
    out.push_back(std::move(step));
}

void Slicer::guards(const Stmt& stmt, EventIndex before, uint32_t activation, Steps& out) {
    for (const Stmt* inner = &stmt; inner;) {
        const StatementMap::Around* around = m_map.around(*inner);
        if (!around) break;
        for (const Stmt* sibling : *around->siblings) { // one before it that could have left
            if (sibling == inner) break;
            if (sibling && (sibling->kind == StmtKind::If || sibling->kind == StmtKind::Case) &&
                m_map.mayLeave(*sibling))
                guard(Reason::Kind::Guard, *sibling, before, activation, out);
        }
        const Stmt* parent = around->parent;
        if (parent &&
            (parent->kind == StmtKind::If || parent->kind == StmtKind::Case || parent->kind == StmtKind::While))
            guard(Reason::Kind::Guard, *parent, before, activation, out);
        inner = parent;
    }
    const Activation& run = m_look.activations()[activation];
    if (run.parent == kNone || run.call == kNone) return;
    if (const EventIndex call = statementAround(run.call, run.parent); call != kNone)
        guards(*m_look.events()[call].stmt(), run.call, run.parent, out);
}

std::optional<image::Place> Slicer::fixedPlace(const tree::Place& place, const Activation& activation) const {
    uint32_t offset = 0;
    for (const tree::Place* p = &place; p; p = p->base) {
        offset += p->offset;
        if (p->kind == tree::PlaceKind::Absolute) return image::Place{place.type, offset, place.bit};
        if (p->kind == tree::PlaceKind::Instance)
            return image::Place{place.type, offset + activation.instance, place.bit};
        if (p->kind != tree::PlaceKind::Field) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace plc::inside
