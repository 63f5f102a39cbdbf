// The bodies, included once per program. Broken promises abort: libFuzzer and the test runner both see that.
#pragma once
#include "tests/fuzz/entries.h"
#include "tests/fuzz/grammar.h"
#include "tests/fuzz/promise.h"

#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/format/format.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/controller/controller.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <vector>

namespace plc::fuzz {

void lexText(std::string_view bytes) {
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(size_t(0)), bytes, sink);
    promise(!list.tokens.empty() && list.tokens.back().kind == lex::TokenKind::EndOfFile);
    uint32_t end = 0;
    for (const lex::Token& token : list.tokens) {
        promise(token.begin >= end && token.end >= token.begin && token.end <= bytes.size());
        end = token.end;
    }
}

void parseText(std::string_view bytes) {
    const std::string text(bytes);
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    promise(file != nullptr);
    for (const diagnostics::Diagnostic& d : sink.all())
        promise(d.range.begin <= d.range.end && d.range.end <= text.size());
    const std::string once = format::format(text, {});
    promise(format::format(once, {}) == once);
}

inline uint32_t hashOf(std::string_view bytes) {
    uint32_t hash = 2166136261u;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return hash;
}
/// Decided by the bytes, so that a finding repeats.
inline bool isOneOf(uint32_t number, std::string_view bytes) { return (hashOf(bytes) >> 7) % number == 0; }

/// A text with its libraries, which `decidedBy` decides: declaring the whole standard library takes longer than
/// checking what is fuzzed, so most texts get four blocks of it.
inline driver::BuildInput inputOf(std::string_view decidedBy, std::string text) {
    static const std::string fewBlocks = R"(
FUNCTION_BLOCK R_TRIG VAR_INPUT CLK : BOOL; END_VAR VAR_OUTPUT Q : BOOL; END_VAR VAR M : BOOL; END_VAR
Q := CLK AND NOT M; M := CLK; END_FUNCTION_BLOCK
FUNCTION_BLOCK SR VAR_INPUT S1, R : BOOL; END_VAR VAR_OUTPUT Q1 : BOOL; END_VAR
Q1 := S1 OR (Q1 AND NOT R); END_FUNCTION_BLOCK
FUNCTION_BLOCK CTU VAR_INPUT CU : BOOL R_EDGE; R : BOOL; PV : INT; END_VAR VAR_OUTPUT Q : BOOL; CV : INT; END_VAR
IF R THEN CV := 0; ELSIF CU AND CV < 32767 THEN CV := CV + 1; END_IF; Q := CV >= PV; END_FUNCTION_BLOCK
FUNCTION_BLOCK TON VAR_INPUT IN : BOOL; PT : TIME; END_VAR VAR_OUTPUT Q : BOOL; ET : TIME; END_VAR
VAR since : TIME; END_VAR
IF NOT IN THEN since := TIME(); END_IF; ET := TIME() - since; Q := IN AND ET >= PT; END_FUNCTION_BLOCK
)";
    driver::BuildInput input;
    input.files.push_back({"fuzz.st", std::move(text)});
    if (!isOneOf(128, decidedBy)) input.libraryTexts.emplace_back("standard/few.st", fewBlocks);
    return input;
}
inline driver::BuildInput inputOf(std::string_view bytes) { return inputOf(bytes, std::string(bytes)); }

inline controller::Settings boundedSettings() {
    controller::Settings settings;
    settings.loopBudgetPerScan = 20'000;
    return settings;
}

inline void someScans(controller::Controller& controller) {
    for (int scan = 0; scan < 8 && controller.state() == controller::State::Running; ++scan) controller.scan();
}

/// Code, place and number of what is reported are the same.
inline bool reportsTheSame(const driver::Checked& a, const driver::Checked& b) {
    return std::ranges::equal(a.analysis->diagnostics, b.analysis->diagnostics,
                              [](const diagnostics::Diagnostic& x, const diagnostics::Diagnostic& y) {
                                  return x.kind == y.kind && x.range == y.range;
                              });
}

/// Checked as the editor does, with what was kept of the text before; that is decided by the bytes too, so that a
/// finding repeats: mostly nothing, now and then a relative.
inline driver::Checked checkedAfterAnEdit(std::string_view bytes) {
    static driver::KeptFiles kept; // the libraries are read once
    (void)driver::check(inputOf(bytes, isOneOf(8, bytes) ? mutateByGrammar(bytes, bytes, hashOf(bytes)) : ""), kept);
    return driver::check(inputOf(bytes), kept);
}

Reach checkText(std::string_view bytes) {
    const driver::Checked checked = checkedAfterAnEdit(bytes);
    bool hasErrors = false, isRead = true;
    for (const diagnostics::Diagnostic& d : checked.analysis->diagnostics) {
        if (d.severity == diagnostics::Severity::Error) {
            hasErrors = true;
            isRead = isRead && !diagnostics::codeOf(d.kind).starts_with("P1");
        }
        if (!d.range.file.isValid()) continue;
        promise(d.range.file.index() < checked.sources->files.size());
        promise(d.range.begin <= d.range.end && d.range.end <= (*checked.sources)[d.range.file].text().size());
    }
    promise(hasErrors == checked.analysis->hasErrors);
    if (isOneOf(16, bytes)) promise(reportsTheSame(checked, driver::check(inputOf(bytes))));
    return isRead ? Reach::Meant : Reach::Short;
}

/// What eight scans leave behind.
struct Ran {
    std::vector<std::byte> image;
    std::optional<controller::Fault> fault;
};

inline Ran ran(const std::shared_ptr<const image::CompiledProgram>& program) {
    controller::Controller controller(program, boundedSettings());
    controller.start();
    someScans(controller);
    return {{controller.image().begin(), controller.image().end()}, controller.fault()};
}

/// Every variable has the same value; not every byte: a NaN is a NaN, and what lies between variables is nobody's.
inline bool holdsTheSame(const image::CompiledProgram& program, std::span<const std::byte> a,
                         std::span<const std::byte> b) {
    const image::Layout& layout = program.layout;
    const auto text = [&](std::span<const std::byte> image, const image::Place& at) {
        return types::toText(*layout.types, types::readValue(*layout.types, at.type, image.subspan(at.offset), at.bit));
    };
    bool isSame = true;
    for (const image::Root& root : layout.roots) {
        layout.forEachLeaf(image::Layout::pathOf(root), {root.type, root.offset, root.bit},
                           [&](const std::string&, const image::Place& at) {
                               isSame = text(a, at) == text(b, at);
                               return isSame;
                           });
        if (!isSame) return false;
    }
    return true;
}

/// Optimised code does what quick code does. After a watchdog fault the image is not exact (docs/performance.md).
inline void promiseSameOptimised(const driver::Built& built, const Ran& quick) {
    if (quick.fault && quick.fault->code == image::FaultCode::Watchdog) return;
    promise(bool(driver::optimise(built)));
    const Ran optimised = ran(built.program);
    promise(quick.fault.has_value() == optimised.fault.has_value());
    if (quick.fault)
        promise(quick.fault->code == optimised.fault->code && quick.fault->range == optimised.fault->range);
    promise(holdsTheSame(*built.program, quick.image, optimised.image));
}

Reach runText(std::string_view bytes) {
    const driver::Built built = driver::build(inputOf(bytes));
    if (!built.program) return Reach::Short;
    const Ran quick = ran(built.program);
    if (isOneOf(4, bytes)) promiseSameOptimised(built, quick);
    return Reach::Meant;
}

/// A variable lies there, and has an address.
inline bool isAlive(const image::Layout& layout, uint64_t target) {
    if (target < sizeof(image::ImageHeader) || target >= layout.dataEnd) return false;
    const Result<image::Place> place = layout.find(layout.pathAt(static_cast<uint32_t>(target)));
    return place && place->bit < 0;
}

/// A pointer to what a unit had on its own, such as the place of a literal, leads nowhere when the unit has ended, and
/// neither does one that was calculated: a change makes it NULL.
inline void forgetDeadPointers(const image::Layout& layout, std::span<std::byte> image) {
    for (const image::Root& root : layout.roots)
        layout.forEachLeaf(image::Layout::pathOf(root), {root.type, root.offset, root.bit},
                           [&](const std::string&, const image::Place& at) {
                               const types::TypeKind kind = layout.types->kind(at.type);
                               if (kind != types::TypeKind::Pointer && kind != types::TypeKind::Reference) return true;
                               uint64_t target = 0;
                               std::memcpy(&target, image.data() + at.offset, sizeof target);
                               if (!isAlive(layout, target)) std::memset(image.data() + at.offset, 0, sizeof target);
                               return true;
                           });
}

inline bool mayHoldPointer(const types::TypeTable& types, types::TypeId id) {
    const types::Type& type = types[id];
    if (type.kind == types::TypeKind::Array) return mayHoldPointer(types, type.element);
    return type.kind == types::TypeKind::Pointer || type.kind == types::TypeKind::Reference ||
           type.kind == types::TypeKind::Interface ||
           std::ranges::any_of(type.fields, [&](const types::Field& each) { return mayHoldPointer(types, each.type); });
}

/// A program that is exchanged for itself keeps every value. A union that may hold a pointer begins again, and the
/// report says so: which of its members counts is not known, and a pointer would have to be moved.
inline void promiseKept(controller::Controller& controller) {
    std::vector<std::byte> before(controller.image().begin(), controller.image().end());
    const image::Layout& layout = controller.program().layout;
    forgetDeadPointers(layout, before);
    const controller::OnlineChangeReport report = controller.changeProgram(controller.sharedProgram());
    promise(report.lost == report.initialised);
    for (const std::string& path : report.initialised) {
        const Result<image::Place> place = layout.find(path);
        promise(place && layout.types->kind(place->type) == types::TypeKind::Union &&
                mayHoldPointer(*layout.types, place->type));
        std::ranges::copy(controller.image().subspan(place->offset, (*layout.types)[place->type].size),
                          before.begin() + place->offset);
    }
    promise(holdsTheSame(controller.program(), before, controller.image()));
}

/// Whether a leaf belongs to what a report calls kept: "Main", "Main.block" or, of an array that was resized,
/// "Main.a[2..5]".
inline bool isUnder(std::string_view leaf, std::string_view kept) {
    const size_t dots = kept.rfind("..");
    if (dots != std::string_view::npos) {
        const size_t open = kept.rfind('[');
        if (!leaf.starts_with(kept.substr(0, open + 1))) return false;
        const long long index = std::atoll(leaf.data() + open + 1);
        return index >= std::atoll(kept.data() + open + 1) && index <= std::atoll(kept.data() + dots + 2);
    }
    return leaf.starts_with(kept) &&
           (leaf.size() == kept.size() || leaf[kept.size()] == '.' || leaf[kept.size()] == '[');
}

using Leaves = std::map<std::string, std::pair<std::string, std::string>>; // path → name of its type, value

inline std::string nameOf(const types::Type& type) {
    return std::to_string(static_cast<int>(type.kind)) + type.name + std::to_string(type.capacity);
}

constexpr size_t kMostLeaves = 2'000; // of a program, and of the paths in a report

/// Of what has no address (two of those may share their bytes) and refers to nothing (what it refers to moves).
inline Leaves leavesOf(const image::Layout& layout, std::span<const std::byte> image) {
    Leaves out;
    for (const image::Root& root : layout.roots) {
        if (!root.address.empty() || root.constant || root.isHidden) continue;
        layout.forEachLeaf(image::Layout::pathOf(root), {root.type, root.offset, root.bit},
                           [&](const std::string& path, const image::Place& at) {
                               const types::TypeKind kind = layout.types->storageKind(at.type);
                               if (kind == types::TypeKind::Pointer || kind == types::TypeKind::Reference ||
                                   kind == types::TypeKind::Interface)
                                   return true;
                               const types::Value value =
                                   types::readValue(*layout.types, at.type, image.subspan(at.offset), at.bit);
                               out[path] = {nameOf((*layout.types)[at.type]), types::toText(*layout.types, value)};
                               return out.size() < kMostLeaves;
                           });
    }
    return out;
}

/// What the report calls kept has the value it had.
inline void promiseCarried(const Leaves& before, const Leaves& after, const controller::OnlineChangeReport& report) {
    for (const std::string& kept : report.kept | std::views::take(kMostLeaves))
        for (auto leaf = before.lower_bound(kept.substr(0, kept.find('['))); leaf != before.end(); ++leaf) {
            if (!leaf->first.starts_with(kept.substr(0, kept.find('[')))) break;
            if (!isUnder(leaf->first, kept)) continue;
            const auto now = after.find(leaf->first);
            promise(now == after.end() || now->second.first != leaf->second.first ||
                    now->second.second == leaf->second.second);
        }
}

/// Mostly with other declarations, which is what moves values; now and then with anything else changed.
inline std::string relativeOf(std::string_view bytes) {
    const uint32_t seed = hashOf(bytes);
    return isOneOf(4, bytes) ? mutateByGrammar(bytes, bytes, seed) : redeclaredByGrammar(bytes, seed);
}

Reach changeText(std::string_view bytes) {
    const driver::Built first = driver::build(inputOf(bytes));
    if (!first.program) return Reach::Short;
    const driver::Built second = driver::build(inputOf(relativeOf(bytes)));
    if (!second.program) return Reach::Short;
    controller::Controller controller(first.program, boundedSettings());
    controller.start();
    someScans(controller);
    promiseKept(controller);
    for (const driver::Built* next : {&second, &first}) {
        const Leaves before = leavesOf(controller.program().layout, controller.image());
        const controller::OnlineChangeReport report = controller.changeProgram(next->program);
        if (report.refusal.isEmpty())
            promiseCarried(before, leavesOf(controller.program().layout, controller.image()), report);
        someScans(controller);
        promiseKept(controller);
    }
    return Reach::Meant;
}

} // namespace plc::fuzz
