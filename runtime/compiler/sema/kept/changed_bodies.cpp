// Checks the bodies that changed and takes what the others gave the last time: diagnostics, references, labels, calls,
// uses of variables, types of texts, and the tree. Exact, because a body is kept only where checking it again could not
// differ: the declarations are the same text and came to the same numbers, and so did what bodies before it added to
// the World (ids in trees would mean something else). When in doubt, it is checked.
#include "runtime/compiler/sema/kept/last_check.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/statements/bodies.h"

#include <algorithm>

namespace plc::sema {

namespace {

/// Each use once; false: of a variable that has no number.
// Uses are counted as "is read at all" and "is written at all"; how often is of no interest, so a body needs each once.
bool makeUnique(std::vector<VariableUse>& uses) {
    const auto order = [](const VariableUse& a, const VariableUse& b) {
        return std::tuple(a.variable, a.isRead, a.isWrite) < std::tuple(b.variable, b.isRead, b.isWrite);
    };
    std::sort(uses.begin(), uses.end(), order);
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    return uses.empty() || uses.back().variable != Id<int>::kNone;
}

class ChangedBodies {
public:
    ChangedBodies(WorldBuilder& world, const LastCheck* last, StillValid valid)
        : m_world(world), m_last(last), m_valid(std::move(valid)), m_arena(std::make_shared<Arena>()),
          m_declaredSymbols(static_cast<uint32_t>(world.symbols.size())) {}

    size_t run(std::vector<std::shared_ptr<const BodyRecord>>& records) {
        records.resize(m_world.units.size());
        for (size_t i = 0; i < m_world.units.size(); ++i) {
            Unit& unit = m_world.units[i];
            // Units without a body (prototypes, those that a lowering took over) have no record either.
            if (!beginBody(m_world, unit)) continue;
            const std::shared_ptr<const BodyRecord> before = m_valid.isAny ? m_last->records[i] : nullptr;
            if (before && isStillGood(*before, unit)) {
                take(*before, unit);
                // Shared, not copied: the record keeps the shapes of the text that it was made from, however many
                // keystrokes ago.
                records[i] = before;
            } else {
                records[i] = check(unit);
                ++m_checked;
                // what follows is only kept if this one adds the same to what they share
                if (m_valid.isAny && (!before || !addsTheSame(*before, *records[i], unit))) m_valid.isAny = false;
            }
        }
        return m_checked;
    }

private:
    [[nodiscard]] bool isStillGood(const BodyRecord& record, const Unit& unit) const {
        if (!record.isKeepable || m_valid.isChanged(unit)) return false;
        // Suggestions are limited for the whole program; a body's messages depend on the count before it as soon as the
        // limit is near.
        const size_t most = std::max(record.suggestionsBefore, m_world.suggestions) + record.suggestions;
        return record.suggestionsBefore == m_world.suggestions || most <= kMaximumSuggestions;
    }

    [[nodiscard]] bool addsTheSame(const BodyRecord& before, const BodyRecord& now, const Unit& unit) const {
        // the same text completes the same things that others share; a changed one may complete another, or none
        return before.texts == now.texts && (!m_valid.isChanged(unit) || (before.isKeepable && now.isKeepable));
    }

    std::shared_ptr<const BodyRecord> check(Unit& unit) {
        WorldBuilder& world = m_world;
        auto record = std::make_shared<BodyRecord>();
        const size_t completions = world.completions, types = world.types.count(), found = world.sink.all().size(),
                     references = world.references.size(), symbols = world.symbols.size(), calls = world.calls.size();
        record->suggestionsBefore = world.suggestions;
        // Gathered by the body alone, so that the record knows its own.
        world.uses.clear();
        checkBody({world, world}, unit, *m_arena);
        noteUses(world, world.uses);

        record->shapes = m_valid.shapes;
        record->arena = m_arena;
        const tree::Function& function = world.functions[unit.function.index()];
        record->body = function.body;
        record->locals = function.locals;
        record->labelCount = function.labelCount;
        record->diagnostics.assign(world.sink.all().begin() + static_cast<std::ptrdiff_t>(found),
                                   world.sink.all().end());
        record->references.assign(world.references.begin() + static_cast<std::ptrdiff_t>(references),
                                  world.references.end());
        // Numbers of labels depend on the bodies before. In the record they count from m_declaredSymbols.
        for (Reference& reference : record->references) // its own labels from the first of them on
            if (reference.symbol.index() >= m_declaredSymbols)
                reference.symbol = SymbolId(reference.symbol.index() - symbols + m_declaredSymbols);
        record->symbols.assign(world.symbols.begin() + static_cast<std::ptrdiff_t>(symbols), world.symbols.end());
        record->calls.assign(world.calls.begin() + static_cast<std::ptrdiff_t>(calls), world.calls.end());
        record->uses = world.uses;
        record->suggestions = world.suggestions - record->suggestionsBefore;
        // A body that completed something shared (a constant, a type of a local) must run again: without it nobody
        // would.
        record->isKeepable = world.completions == completions && makeUnique(record->uses);
        for (size_t i = types; i < world.types.count(); ++i) {
            const types::Type& type = world.types[TypeId(i)];
            record->texts.emplace_back(type.kind, type.capacity);
            record->isKeepable =
                record->isKeepable && (type.kind == TypeKind::String || type.kind == TypeKind::Wstring);
        }
        return record;
    }

    /// As if it had been checked.
    void take(const BodyRecord& record, Unit& unit) {
        WorldBuilder& world = m_world;
        const Moves moved(*record.shapes, *m_valid.shapes);
        for (const auto& [kind, capacity] : record.texts)
            // Texts are numbered in the order of their first use: taking a record has to use them in the same order.
            (void)(kind == TypeKind::String ? world.types.string(capacity) : world.types.wstring(capacity));
        for (const diagnostics::Diagnostic& each : record.diagnostics) world.sink.add(inPlace(each, moved));
        const auto firstLabel = static_cast<uint32_t>(world.symbols.size());
        for (Reference reference : record.references) {
            reference.range = moved(reference.range);
            if (reference.symbol.index() >= m_declaredSymbols)
                reference.symbol = SymbolId(reference.symbol.index() - m_declaredSymbols + firstLabel);
            world.references.push_back(reference);
        }
        for (const Symbol& label : record.symbols) {
            world.symbols.push_back(label);
            world.symbols.back().declaration = moved(label.declaration);
        }
        for (Call call : record.calls) {
            call.range = moved(call.range);
            world.calls.push_back(call);
        }
        noteUses(world, record.uses);
        world.suggestions += record.suggestions;
        tree::Function& function = world.functions[unit.function.index()];
        function.body = record.body;
        function.locals = record.locals;
        // Trees are not moved here; withTreesInPlace does it for those who build.
        if (moved.isNeeded())
            for (tree::Local& local : function.locals) local.declaration = moved(local.declaration);
        function.labelCount = record.labelCount;
    }

    static diagnostics::Diagnostic inPlace(diagnostics::Diagnostic diagnostic, const Moves& moved) {
        if (!moved.isNeeded()) return diagnostic;
        diagnostic.range = moved(diagnostic.range);
        for (diagnostics::Fix& fix : diagnostic.fixes)
            for (diagnostics::TextEdit& edit : fix.edits) edit.range = moved(edit.range);
        for (diagnostics::Related& related : diagnostic.related) related.range = moved(related.range);
        return diagnostic;
    }

    WorldBuilder& m_world;
    const LastCheck* m_last;
    StillValid m_valid;
    std::shared_ptr<Arena> m_arena;
    uint32_t m_declaredSymbols;
    size_t m_checked = 0;
};

} // namespace

size_t checkChangedBodies(WorldBuilder& world, const std::vector<std::shared_ptr<const syntax::SyntaxFile>>& files,
                          const LastCheck* last) {
    numberVariables(world);
    auto check = std::make_shared<LastCheck>();
    check->files = files;
    check->sources = world.sources.files;
    check->rules = {world.options.strict, world.options.addressing, world.options.memoryForNew, world.options.strings};
    check->declared = summaryOf(world);
    StillValid valid = stillValid(last, world, files);
    // The same text is not enough: a file of a library may have changed what it means.
    valid.isAny = valid.isAny && last->declared == check->declared;
    check->shapes = valid.shapes;
    const size_t checked = ChangedBodies(world, last, std::move(valid)).run(check->records);
    world.check = std::move(check);
    return checked;
}

} // namespace plc::sema
