#include "runtime/inside/recorder.h"

#include <algorithm>
#include <cstring>

namespace plc::inside {

using image::WatchKind;

namespace {
constexpr uint64_t kLargestCopy = 4096; // bytes of a text or an aggregate

bool contains(const SourceRange& outer, const SourceRange& inner) {
    return outer.file == inner.file && outer.begin <= inner.begin && inner.end <= outer.end;
}
} // namespace

Recorder::Recorder(Look& look, const LookOptions& options) : m_look(look), m_options(options) {}

void Recorder::attach(image::RuntimeContext& context) {
    // The controller's context lies at the start of a watched one.
    auto& watched = reinterpret_cast<image::WatchedContext&>(context);
    watched.watch = &Recorder::receive;
    watched.watcher = this;
    m_look.m_events.clear();
    m_look.m_activations.clear();
    m_look.m_copies.clear();
    m_look.m_passes.clear();
    m_look.m_leftOut = 0;
    m_look.m_isCut = false;
    m_running.clear();
    m_lastCall = kNone;
}

void Recorder::receive(image::RuntimeContext* context, const void* node, WatchKind kind, uint64_t where, uint64_t a,
                       uint64_t b) {
    static_cast<Recorder*>(reinterpret_cast<image::WatchedContext*>(context)->watcher)
        ->report(*context, node, kind, where, a, b);
}

void Recorder::report(image::RuntimeContext& context, const void* node, WatchKind kind, uint64_t where, uint64_t a,
                      uint64_t b) {
    if (kind == WatchKind::Begin) begin(where, static_cast<uint32_t>(a), context.depth);
    while (!m_running.empty() && m_running.back().depth > context.depth) m_running.pop_back(); // left by a caught fault
    if (m_running.empty()) return;
    if (kind == WatchKind::Pass && !m_options.each) pass(*static_cast<const tree::Stmt*>(node));
    if (kind == WatchKind::Load) return load(context, *static_cast<const tree::Expr*>(node), where, a, b);
    Event event;
    event.kind = kind;
    event.node = node;
    event.activation = m_running.back().activation;
    event.passes = m_running.back().passes;
    event.bits = a;
    if (kind == WatchKind::Read || kind == WatchKind::Write) {
        const auto at = static_cast<size_t>(a - reinterpret_cast<uint64_t>(context.image));
        event.size = static_cast<uint32_t>(b);
        event.bit = static_cast<int16_t>(static_cast<int>(b >> 32) - 1);
        if (at >= context.imageSize || event.size > context.imageSize - at) return; // a constant
        event.offset = static_cast<uint32_t>(at);
        event.bits = 0;
        std::memcpy(&event.bits, context.image + at, std::min<size_t>(8, event.size));
        if (kind == WatchKind::Write && event.size > sizeof event.bits)
            event.copy = static_cast<uint32_t>(copyOf(a, event.size));
    } else if (kind == WatchKind::Text || kind == WatchKind::Bytes) {
        const uint64_t width = kind == WatchKind::Text && (b >> 32 & 1) != 0 ? 2 : 1;
        uint64_t size = b & 0xffffffffu;
        if (kind == WatchKind::Text) size = (size + 1) * width;
        event.bits = copyOf(a, size);
        event.size = static_cast<uint32_t>(size);
        event.bit = width == 2 ? 1 : -1;
    }
    if (m_options.each) {
        m_options.each(m_look, event, m_running.back().function);
        if (kind == WatchKind::End) m_running.pop_back();
        return;
    }
    if (isLeftOut(node, kind)) {
        ++m_look.m_leftOut;
    } else {
        if (kind == WatchKind::Call) m_lastCall = static_cast<EventIndex>(m_look.m_events.size());
        m_look.m_events.push_back(event);
    }
    if (kind == WatchKind::End) end();
}

/// The read of a variable, and the value that its bytes are.
void Recorder::load(image::RuntimeContext& context, const tree::Expr& expr, uint64_t where, uint64_t a, uint64_t b) {
    report(context, expr.place, WatchKind::Read, where, a, b);
    const int bit = static_cast<int>(b >> 32) - 1;
    uint64_t bits = 0;
    std::memcpy(&bits, reinterpret_cast<const void*>(a), std::min<size_t>(sizeof bits, b & 0xffffffffu));
    report(context, &expr, WatchKind::Value, where, bit >= 0 ? bits >> bit & 1 : bits, 0);
}

bool Recorder::isLeftOut(const void*, WatchKind kind) {
    if (m_running.back().isLeftOut) return true;
    if (kind == WatchKind::Begin || kind == WatchKind::End) return false;
    if (m_look.m_events.size() >= m_options.eventLimit) {
        m_look.m_isCut = true;
        return true;
    }
    // What was written counts for what is read later.
    return kind != WatchKind::Write &&
           std::any_of(m_running.begin(), m_running.end(), [](const Running& r) { return r.outside != nullptr; });
}

uint64_t Recorder::copyOf(uint64_t address, uint64_t size) {
    if (m_options.each || m_look.m_events.size() >= m_options.eventLimit) return kNone;
    const auto* first = reinterpret_cast<const std::byte*>(address);
    m_look.m_copies.emplace_back(first, first + std::min(size, kLargestCopy));
    return m_look.m_copies.size() - 1;
}

/// The task whose program has this body on this instance.
static uint32_t taskOf(const image::CompiledProgram& program, uint32_t function, uint32_t instance) {
    for (uint32_t t = 0; t < program.tasks.size(); ++t)
        for (const image::TaskProgram& part : program.tasks[t].programs)
            if ((part.function == function || part.connectIn == function || part.connectOut == function) &&
                program.layout.roots[part.root].offset == instance)
                return t;
    return kNone;
}

void Recorder::begin(uint64_t where, uint32_t function, uint32_t depth) {
    while (!m_running.empty() && m_running.back().depth >= depth) m_running.pop_back(); // left by a fault
    if (m_options.each) return m_running.push_back({static_cast<uint32_t>(m_running.size()), depth, function});
    if (m_look.m_activations.size() >= m_options.eventLimit / 2 && !m_running.empty()) {
        Running caller = m_running.back();
        caller.depth = depth;
        caller.isLeftOut = true;
        m_running.push_back(caller);
        m_look.m_isCut = true;
        return;
    }
    Activation activation;
    activation.function = function;
    activation.instance = static_cast<uint32_t>(where);
    activation.frame = static_cast<uint32_t>(where >> 32);
    activation.begin = static_cast<EventIndex>(m_look.m_events.size());
    if (m_running.empty()) {
        activation.task = taskOf(m_look.program(), function, activation.instance);
    } else {
        activation.parent = m_running.back().activation;
        activation.task = m_look.m_activations[activation.parent].task;
        if (m_lastCall != kNone && m_look.m_events[m_lastCall].activation == activation.parent)
            activation.call = m_lastCall;
    }
    m_running.push_back({static_cast<uint32_t>(m_look.m_activations.size()), depth, function});
    m_look.m_activations.push_back(activation);
}

void Recorder::end() {
    if (m_running.back().isLeftOut) {
        m_running.pop_back();
        return;
    }
    m_look.m_activations[m_running.back().activation].end = static_cast<EventIndex>(m_look.m_events.size() - 1);
    m_running.pop_back();
}

namespace {

/// A loop's own text may end with its head: with what lies in it.
void widen(SourceRange& extent, const std::vector<tree::Stmt*>& body) {
    for (const tree::Stmt* stmt : body) {
        if (!stmt) continue;
        if (stmt->range.file == extent.file) {
            extent.begin = std::min(extent.begin, stmt->range.begin);
            extent.end = std::max(extent.end, stmt->range.end);
        }
        widen(extent, stmt->body);
        widen(extent, stmt->elseBody);
        for (const tree::CaseArm& arm : stmt->arms) widen(extent, arm.body);
    }
}

} // namespace

SourceRange Recorder::extentOf(const tree::Stmt& loop) {
    const auto [known, isNew] = m_extents.try_emplace(&loop, loop.range);
    if (isNew) {
        widen(known->second, loop.body);
        if (loop.a) known->second.end = std::max(known->second.end, loop.a->range.end); // UNTIL
    }
    return known->second;
}

const PassWindow* Recorder::windowOf(const tree::Stmt& loop) const {
    for (const PassWindow& window : m_options.windows)
        if (window.loop.file == loop.range.file && window.loop.begin == loop.range.begin) return &window;
    return nullptr;
}

void Recorder::pass(const tree::Stmt& loop) {
    Running& running = m_running.back();
    // Loops that ran within this one are over; one beside it stays in the chain and is distinguished by its text.
    uint32_t at = running.passes;
    while (at != kNone && m_look.m_passes[at].loop != &loop) at = m_look.m_passes[at].around;
    uint64_t number = 0;
    uint32_t around = running.passes;
    if (at != kNone) {
        number = m_look.m_passes[at].pass + 1;
        around = m_look.m_passes[at].around;
    }
    while (around != kNone && !contains(m_look.m_passes[around].extent, loop.range))
        around = m_look.m_passes[around].around;
    if (m_look.m_passes.size() < m_options.eventLimit || at == kNone) {
        running.passes = static_cast<uint32_t>(m_look.m_passes.size());
        m_look.m_passes.push_back({&loop, number, around, extentOf(loop)});
    } else {
        m_look.m_passes[at].pass = number;
        running.passes = at;
    }
    if (running.outside && contains(extentOf(loop), running.outside->range)) running.outside = nullptr;
    if (const PassWindow* window = windowOf(loop))
        running.outside = number >= window->first && number - window->first < window->count ? nullptr : &loop;
}

} // namespace plc::inside
