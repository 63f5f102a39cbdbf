#include "runtime/inside/look.h"

#include "runtime/base/messages.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/inside/recorder.h"
#include "runtime/inside/texts.h"

#include <algorithm>
#include <cstring>

namespace plc::inside {

using image::WatchKind;

namespace {

constexpr size_t kCodesKept = 4, kLooksKept = 8;

uint64_t keyOf(const SourceRange& range) {
    return (uint64_t(range.file.value) << 44) ^ (uint64_t(range.begin) << 22) ^ range.end;
}

bool overlaps(const Event& event, uint32_t offset, uint32_t size, int bit) {
    if (event.offset + event.size <= offset || offset + size <= event.offset) return false;
    return event.bit < 0 || bit < 0 || event.bit == bit;
}

} // namespace

/// Events by the text of their node.
struct Look::Index {
    std::unordered_map<uint64_t, std::vector<EventIndex>> values, statements;
    std::vector<EventIndex> writes;
};

const Look::Index& Look::index() const {
    // Most looks answer one question about one statement; the index is made by the first that searches.
    std::call_once(m_indexed, [this] {
        auto index = std::make_shared<Index>();
        for (EventIndex i = 0; i < m_events.size(); ++i) {
            const Event& event = m_events[i];
            switch (event.kind) {
            case WatchKind::Value:
            case WatchKind::Text:
            case WatchKind::Bytes:
                index->values[keyOf(event.expr()->range)].push_back(i);
                break;
            case WatchKind::Statement:
                index->statements[keyOf(event.stmt()->range)].push_back(i);
                break;
            case WatchKind::Write:
                index->writes.push_back(i);
                break;
            default:
                break;
            }
        }
        m_index = std::move(index);
    });
    return *m_index;
}

Message Look::doubt() const {
    if (!m_rerun.doubt.isEmpty()) return m_rerun.doubt;
    if (!isExact()) return texts::CameOutOtherwise();
    return m_isCut ? texts::NotAllIsKept() : Message();
}

types::Value Look::valueOf(const Event& event) const {
    const types::TypeTable& types = *m_tree->types;
    types::TypeId type;
    switch (event.kind) {
    case WatchKind::Value:
    case WatchKind::Text:
    case WatchKind::Bytes:
        type = event.expr()->type;
        break;
    case WatchKind::Read:
        type = event.place()->type;
        break;
    case WatchKind::Write:
        if (event.node && event.stmt()->place) type = event.stmt()->place->type;
        break;
    default:
        return {};
    }
    if (!type.isValid()) return {};
    if (event.kind == WatchKind::Text || event.kind == WatchKind::Bytes) {
        if (event.bits >= m_copies.size()) return {};
        std::vector<std::byte> bytes = m_copies[event.bits];
        const size_t size = types[types.storage(type)].size;
        if (event.kind == WatchKind::Bytes && bytes.size() < size) return {}; // too large to keep
        bytes.resize(std::max(size, bytes.size() + 2));
        return types::readValue(types, type, bytes);
    }
    std::byte bytes[8];
    std::memcpy(bytes, &event.bits, sizeof bytes);
    if (types.isText(type) || types.isAggregate(type) || types[types.storage(type)].size > sizeof bytes) return {};
    // A write of another width than its type is one of several pieces (a copy of a structure): its bits are no value.
    if (event.kind == WatchKind::Write && event.bit < 0 && types[types.storage(type)].size != event.size) return {};
    return types::readValue(types, type, bytes, event.kind == WatchKind::Value ? -1 : event.bit);
}

std::span<const std::byte> Look::bytesOf(const Event& event) const {
    if (event.copy >= m_copies.size()) return {};
    return m_copies[event.copy];
}

std::string Look::instanceOf(uint32_t at) const {
    while (at != kNone) {
        const Activation& activation = m_activations[at];
        const types::TypeId type = m_tree->functions[activation.function].instanceType;
        if (type.isValid()) return program().layout.pathAt(activation.instance, type);
        at = activation.parent;
    }
    return {};
}

std::vector<uint64_t> Look::passesAt(EventIndex at) const {
    const Event& event = m_events[at];
    SourceRange range;
    if (event.kind == WatchKind::Statement || event.kind == WatchKind::Arm ||
        (event.kind == WatchKind::Write && event.node))
        range = event.stmt()->range;
    else if (event.kind == WatchKind::Read)
        range = event.place()->range;
    else if (event.kind == WatchKind::Value || event.kind == WatchKind::Text || event.kind == WatchKind::Bytes)
        range = event.expr()->range;
    std::vector<uint64_t> passes;
    for (uint32_t p = event.passes; p != kNone; p = m_passes[p].around) {
        const SourceRange& loop = m_passes[p].extent;
        if (loop.file == range.file && loop.begin <= range.begin && range.end <= loop.end)
            passes.push_back(m_passes[p].pass);
    }
    std::reverse(passes.begin(), passes.end());
    return passes;
}

std::vector<bool> Look::activationsIn(const std::string& instance) const {
    std::vector<bool> counts(m_activations.size(), instance.empty());
    if (instance.empty()) return counts;
    const Result<image::Place> place = program().layout.find(instance);
    if (!place) return counts;
    const types::TypeTable& types = *m_tree->types;
    for (uint32_t i = 0; i < m_activations.size(); ++i) {
        const Activation& a = m_activations[i];
        const types::TypeId type = m_tree->functions[a.function].instanceType;
        if (!type.isValid())
            counts[i] = a.parent != kNone && counts[a.parent]; // a function: its caller's
        else
            counts[i] = a.instance == place->offset && (place->type == type || types.isDerivedFrom(place->type, type));
    }
    return counts;
}

std::vector<Seen> Look::valuesOf(SourceRange range, const std::string& instance) const {
    const auto& values = index().values;
    const auto found = values.find(keyOf(range));
    if (found == values.end()) return {};
    const std::vector<bool> counts = activationsIn(instance);
    std::vector<Seen> all;
    for (const EventIndex i : found->second) {
        const Event& event = m_events[i];
        if (!(event.expr()->range == range) || !counts[event.activation]) continue;
        Seen seen{valueOf(event), i, event.activation, passesAt(i)};
        // A conversion that the compiler made has the text of what it converts: that one is meant.
        const bool isSame = !all.empty() && all.back().activation == seen.activation &&
                            all.back().passes == seen.passes && event.expr()->kind == tree::ExprKind::Convert;
        if (!isSame) all.push_back(std::move(seen));
    }
    return all;
}

uint64_t Look::timesExecuted(SourceRange statement, const std::string& instance) const {
    const auto& statements = index().statements;
    const auto found = statements.find(keyOf(statement));
    if (found == statements.end()) return 0;
    const std::vector<bool> counts = activationsIn(instance);
    return static_cast<uint64_t>(std::count_if(found->second.begin(), found->second.end(), [&](EventIndex i) {
        return m_events[i].stmt()->range == statement && counts[m_events[i].activation];
    }));
}

std::vector<EventIndex> Look::writesTo(uint32_t offset, uint32_t size, int bit) const {
    std::vector<EventIndex> all;
    for (const EventIndex i : index().writes)
        if (overlaps(m_events[i], offset, size, bit)) all.push_back(i);
    return all;
}

EventIndex Look::lastWriteBefore(EventIndex before, uint32_t offset, uint32_t size, int bit) const {
    const std::vector<EventIndex>& writes = index().writes;
    auto at = std::lower_bound(writes.begin(), writes.end(), before);
    while (at != writes.begin())
        if (overlaps(m_events[*--at], offset, size, bit)) return *at;
    return kNone;
}

// ---------------------------------------------------------------- WatchedCode

Result<std::shared_ptr<const image::Code>> WatchedCode::of(const std::shared_ptr<const image::CompiledProgram>& program,
                                                           const std::vector<uint32_t>& functions) {
    {
        const std::lock_guard lock(m_mutex);
        for (const Known& known : m_known) {
            if (known.program != program) continue;
            const bool holds =
                known.functions.empty() ||
                (!functions.empty() && std::all_of(functions.begin(), functions.end(), [&](uint32_t f) {
                    return std::find(known.functions.begin(), known.functions.end(), f) != known.functions.end();
                }));
            if (holds) return known.code;
        }
    }
    auto code = driver::compileWatched(program, functions);
    if (!code) return code.error();
    const std::lock_guard lock(m_mutex);
    if (m_known.size() >= kCodesKept) m_known.erase(m_known.begin());
    m_known.push_back({program, functions, *code});
    return *code;
}

// ---------------------------------------------------------------- Insight

namespace {

/// The events that a look has kept.
void tell(const Look& look, const LookOptions& options) {
    std::vector<uint32_t> depths;
    for (const Activation& activation : look.activations())
        depths.push_back(activation.parent == kNone ? 0 : depths[activation.parent] + 1);
    for (Event event : look.events()) {
        const uint32_t function = look.activations()[event.activation].function;
        event.activation = depths[event.activation];
        options.each(look, event, function);
    }
}

} // namespace

Result<std::shared_ptr<const Look>> Insight::look(Position position, const LookOptions& options) {
    const bool isPlain = options.windows.empty() && options.functions.empty() && !options.each;
    if (isPlain)
        for (const auto& known : m_looks)
            if (known->position() == position) return known;
    Result<history::ScanInput> input = m_history.inputOf(position);
    if (!input) return input.error();
    if (options.each && stoodAtBreakpoint(*input)) { // it is made more than once
        LookOptions kept = options;
        kept.each = nullptr;
        auto look = this->look(position, kept);
        if (look) tell(**look, options);
        return look;
    }
    auto code = m_code->of(input->program, options.functions);
    if (!code) return code.error();
    auto look = std::make_shared<Look>();
    look->m_position = position;
    look->m_code = *code;
    look->m_tree = driver::treeOf(input->program);
    look->m_rerun.input.program = input->program;
    Recorder recorder(*look, options);
    auto rerun = m_rerunner.run(position, {*code, [&](image::RuntimeContext& context) { recorder.attach(context); }});
    if (!rerun) return rerun.error();
    look->m_rerun = std::move(*rerun);
    if (!isPlain) return std::shared_ptr<const Look>(look);
    if (m_looks.size() >= kLooksKept) m_looks.erase(m_looks.begin());
    m_looks.push_back(look);
    return m_looks.back();
}

Result<std::shared_ptr<const Look>> Insight::lookFrom(history::ScanInput input, const LookOptions& options) {
    auto code = m_code->of(input.program, options.functions);
    if (!code) return code.error();
    auto look = std::make_shared<Look>();
    look->m_code = *code;
    look->m_tree = driver::treeOf(input.program);
    look->m_rerun.input.program = input.program;
    Recorder recorder(*look, options);
    look->m_rerun = m_rerunner.runFrom(std::move(input),
                                       {*code, [&](image::RuntimeContext& context) { recorder.attach(context); }});
    if (isCancelled()) return Error{errors::Cancelled(), ""};
    return std::shared_ptr<const Look>(look);
}

} // namespace plc::inside
