// The image: areas sized by the addresses in use, globals, statics, program instances, and their initial bytes.
#include "runtime/compiler/sema/layout/layout.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/addresses.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/values/constants.h"

#include "runtime/base/text.h"

#include <cstdlib>
#include <map>

namespace plc::sema {

using image::Area;

static void checkAddressSize(WorldBuilder& world, const Variable& variable, std::string_view text, SourceRange range);
static void checkOverlaps(WorldBuilder& world);

namespace {
constexpr uint32_t kHeader = sizeof(image::ImageHeader);
// Frames of functions are in the image, so that a halted scan can be recorded and shown with its locals. This much is
// there for recursion and for expressions of the debugger.
constexpr uint32_t kMinimumFrames = 256 << 10;

uint32_t aligned(uint64_t offset, uint32_t align) {
    return static_cast<uint32_t>((offset + align - 1) / align * align);
}
} // namespace

// The three areas follow the header; a driver exchanges each with one copy.
image::AreaRange areaOf(const World& world, Area area) {
    const uint32_t outputs = aligned(kHeader + world.rangeOfInputs, 8),
                   memory = aligned(outputs + world.rangeOfOutputs, 8);
    switch (area) {
    case Area::Input:
        return {kHeader, world.rangeOfInputs};
    case Area::Output:
        return {outputs, world.rangeOfOutputs};
    default:
        return {memory, world.rangeOfMemory};
    }
}

/// Gives a variable with a complete address its place (again once the areas are measured).
///   wrong: x AT %IX99999999.0 : BOOL;  (P2034)
void locate(WorldBuilder& world, Variable& variable, std::string_view text) {
    const auto address = addressIn(world, text);
    const SourceRange range = variable.declaration && variable.declaration->addressRange.file.isValid()
                                  ? variable.declaration->addressRange
                                  : variable.range;
    // locate runs twice for variables of blocks: when their type is completed, which may be before the areas are
    // measured, and once more afterwards.
    if (!address && world.rangeOfInputs == 0) return; // a hierarchical one: its place is measured later
    if (!address || address->byte > kMaximumAddress) {
        // The lexer has said what is wrong with it.
        if (hasSyntaxErrorAt(world, range)) return;
        world.emit(range, findings::AddressOutOfRange(text, addressAreas()));
        return;
    }
    variable.offset = areaOf(world, address->area).begin + address->byte;
    const TypeKind kind = world.types.storageKind(variable.type);
    // %QX0.1 of a BOOL is a bit in a byte that others share; every other type begins at a byte.
    variable.bit = -1;
    if (address->kind == TypeKind::Bool && address->bit >= 0) {
        if (kind == TypeKind::Bool)
            variable.bit = address->bit;
        else if (kind != TypeKind::Unknown && address->bit != 0)
            return (void)world.emit(range, findings::TypeMismatch(text, world.nameOf(variable.type)));
    }
    checkAddressSize(world, variable, text, range);
}

/// The letter of an address and the type say the same size.
///   ok:    a AT %IW4 : INT; b AT %QX0.1 : BOOL;      wrong: a AT %IX4.0 : INT; b AT %QW0 : BOOL;  (P3037)
void checkAddressSize(WorldBuilder& world, const Variable& variable, std::string_view text, SourceRange range) {
    const auto address = addressIn(world, text);
    const types::Family family = world.types.family(variable.type);
    const bool isNumber = types::isInteger(family) || family == types::Family::Real || family == types::Family::Bool;
    const unsigned has = types::bitsOf(world.types.storageKind(variable.type)), holds = types::bitsOf(address->kind);
    if (!isNumber || has == holds || address->isOpen) return;
    // The fix keeps the place and changes the letter, because the type is what the rest of the program relies on.
    const TypeKind letter = has == 1    ? TypeKind::Bool
                            : has == 8  ? TypeKind::Byte
                            : has == 16 ? TypeKind::Word
                            : has == 32 ? TypeKind::Dword
                                        : TypeKind::Lword;
    const std::string own = withLetter(world, text, letter);
    auto& diagnostic = world.emit(range, findings::AddressSize(text, holds, world.nameOf(variable.type), has, own));
    if (range != variable.range) diagnostic.fixes.push_back({fixes::Write(own), {{range, own}}});
}

namespace {

/// The image: header, the three areas of addresses, then every global and program instance as a root of its own. An
/// offset is fixed here once for all; what runs, records and shows knows nothing but these.
class GlobalLayout {
public:
    explicit GlobalLayout(WorldBuilder& world) : m_world(world), m_layout(world.program->layout) {}

    void run() {
        // The order decides all offsets. Program instances come last: they grow most often, and what is before them
        // stays where it is when the program is changed online.
        areas();
        globals();
        statics();
        instances();
        // Reported once for all, with the sum; the offsets are then all 0 and nothing is built.
        if (m_isTooLarge) reportSize();
        m_layout.dataEnd = aligned(m_next, 64);
        // Only now are initial values written: they may name the address of any variable.
        m_world.image.assign(m_layout.dataEnd, std::byte{});
        for (const auto& [variable, index] : m_placed) {
            if (m_world.types.kind(variable->type) == TypeKind::Unknown || m_isTooLarge) continue;
            write(*variable, initialOf(*variable));
            Symbol* symbol = variable->symbol.isValid() ? &m_world.symbols[variable->symbol.index()] : nullptr;
            if (symbol && symbol->path.empty()) symbol->path = image::Layout::pathOf(m_layout.roots[index]);
        }
        namePaths();
    }

private:
    void areas() {
        m_layout.types = m_world.program->types;
        m_layout.inputs = areaOf(m_world, Area::Input);
        m_layout.outputs = areaOf(m_world, Area::Output);
        m_layout.memory = areaOf(m_world, Area::Memory);
        m_layout.addressing = m_world.options.addressing;
        m_layout.hierarchical = hierarchicalAddresses(m_world);
        // 64 bytes are a cache line: I/O copied by a driver shares none with the program's data.
        m_next = aligned(m_layout.memory.begin + m_layout.memory.size, 64);
    }

    void globals() {
        for (Variable& variable : m_world.globals)
            // `globals` holds instances and VAR_EXTERNAL as well, which have their place elsewhere.
            if (!variable.isProgramInstance && variable.kind == syntax::SectionKind::Global)
                place(variable, Area::Global, variable.list ? variable.list->name : std::string());
    }

    /// VAR_STAT of functions and methods: one for all calls, so it is no part of an instance.
    void statics() {
        for (Unit& unit : m_world.units) {
            for (Variable& variable : unit.variables) {
                if (variable.storage != Storage::Absolute) continue;
                std::string list = unit.owner ? unit.owner->name + "." + unit.name : unit.name;
                if (unit.kind == UnitKind::Program && unit.instance) list = unit.instance->name;
                place(variable, Area::Global, std::move(list));
            }
        }
    }

    /// Each begins a cache line.
    void instances() {
        m_next = aligned(m_next, 64);
        for (Instance& instance : m_world.instances) {
            Variable& variable = *instance.variable;
            place(variable, Area::Program, instance.resourceName);
            image::Root& root = m_layout.roots.back();
            root.programType = variable.program->name;
            root.isSimulation = variable.program->isSimulation;
            // Paths of instances have no namespace: Main.x and not Plant.Main.x, as tasks and recordings name them.
            root.space.clear();
            if (instance.declaration) root.retain = instance.declaration->retain;
            instance.root = static_cast<uint32_t>(m_layout.roots.size() - 1);
            m_next = aligned(m_next, 64);
        }
    }

    void place(Variable& variable, Area area, std::string list) {
        variable.storage = Storage::Absolute;
        if (variable.isLocated && variable.declaration && placeAtAddress(variable, list)) return;
        const types::Type& type = m_world.types[variable.type];
        // Natural alignment: the generated code reads and writes words directly.
        m_next = aligned(m_next, std::max(1u, type.align));
        // m_next has 64 bits: a sum of large arrays cannot wrap.
        if (m_next + type.size > kMaximumData) m_isTooLarge = true;
        variable.offset = m_isTooLarge ? 0 : static_cast<uint32_t>(m_next);
        if (!m_isTooLarge) m_next += type.size;
        addRoot(variable, area, std::move(list));
    }

    /// False: it gets a place among the others, because its address is open (AT %I*) or wrong.
    bool placeAtAddress(Variable& variable, const std::string& list) {
        const auto address = addressIn(m_world, variable.declaration->address);
        if (address && !address->isOpen) {
            locate(m_world, variable, variable.declaration->address);
            addRoot(variable, address->area, list);
            return true;
        }
        const SourceRange written = variable.declaration->addressRange;
        if (!address && !hasSyntaxErrorAt(m_world, written))
            m_world.emit(written.file.isValid() ? written : variable.range,
                         findings::AddressOutOfRange(variable.declaration->address, addressAreas()));
        else if (address)
            // AT %I* keeps its value here until VAR_CONFIG or devices.json say where it comes from.
            m_world.openAddresses.push_back({&variable, false});
        return false;
    }

    void addRoot(Variable& variable, Area area, std::string list) {
        image::Root& root = m_layout.roots.emplace_back();
        root.name = variable.name;
        root.list = std::move(list);
        root.space = variable.space && variable.space != &m_world.top ? variable.space->qualified : std::string();
        root.type = variable.type;
        root.offset = variable.offset;
        root.bit = variable.bit;
        root.area = area;
        root.constant = variable.isConstant;
        root.declaration = variable.range;
        if (variable.section) {
            root.retain = variable.section->retain;
            root.persistent = variable.section->persistent;
        }
        if (variable.declaration) root.comment = std::string(variable.declaration->comment);
        if (variable.isLocated && variable.declaration) root.address = std::string(variable.declaration->address);
        m_placed.emplace_back(&variable, m_layout.roots.size() - 1);
    }

    void reportSize() {
        uint64_t total = 0;
        for (const image::Root& root : m_layout.roots) total += m_world.types[root.type].size;
        m_world.emit({}, findings::ImageTooLarge(total, kMaximumData));
    }

    InitialValue initialOf(Variable& variable) {
        const types::Type& type = m_world.types[variable.type];
        InitialValue initial;
        initial.bytes = type.initial;
        initial.bytes.resize(std::max(1u, type.size));
        if (variable.isProgramInstance) {
            if (needsConstruction(m_world, variable.type)) {
                DynamicInit dynamic;
                dynamic.type = variable.type;
                dynamic.isConstruction = true;
                initial.dynamics.push_back(dynamic);
            }
            // A constant with storage is there for the watch: in code it is folded, so its bytes are only written once.
        } else if (variable.isConstant && isFoldable(m_world.types, variable.type)) {
            if (const types::Value* value = constantOf(m_world, variable))
                writeConstant(m_world, initial, variable.type, 0, -1, *value);
        } else {
            setInitial(m_world, initial, variable, 0);
        }
        return initial;
    }

    void write(const Variable& variable, const InitialValue& initial) {
        std::vector<std::byte>& image = m_world.image;
        if (variable.bit >= 0) {
            // Only ever set: another variable at the same bit may have said TRUE.
            const auto mask = static_cast<std::byte>(1u << variable.bit);
            if (initial.bytes[0] != std::byte{}) image[variable.offset] |= mask;
        } else if (variable.offset + initial.bytes.size() <= image.size()) {
            const bool isZero =
                std::all_of(initial.bytes.begin(), initial.bytes.end(), [](std::byte b) { return b == std::byte{}; });
            // another variable may have the same address: the one that says a value wins over the one that does not
            if (!isZero || !variable.isLocated)
                std::copy(initial.bytes.begin(), initial.bytes.end(), image.begin() + variable.offset);
        }
        for (DynamicInit dynamic : initial.dynamics) {
            dynamic.offset += variable.offset;
            if (variable.bit >= 0) dynamic.bit = variable.bit;
            m_world.programInits.push_back(dynamic);
        }
    }

    /// Variables of a program with one instance have one path.
    void namePaths() {
        for (Unit& unit : m_world.units) {
            if (unit.kind != UnitKind::Program || !unit.instance) continue;
            for (Variable& variable : unit.variables)
                if (variable.symbol.isValid() && variable.storage == Storage::Instance)
                    m_world.symbols[variable.symbol.index()].path = unit.instance->name + "." + variable.name;
        }
    }

    WorldBuilder& m_world;
    image::Layout& m_layout;
    uint64_t m_next = 0; // the first free byte
    bool m_isTooLarge = false;
    std::vector<std::pair<Variable*, size_t>> m_placed; // with the root's index
};

} // namespace

void layoutGlobals(WorldBuilder& world) {
    measureAddresses(world);
    GlobalLayout(world).run();
    checkOverlaps(world);
}

namespace {
/// Stretches of bits that something has, joined where they touch.
class TakenBits {
public:
    void add(uint64_t begin, uint64_t end) {
        auto at = m_ends.upper_bound(begin);
        if (at != m_ends.begin() && std::prev(at)->second >= begin) --at;
        for (; at != m_ends.end() && at->first <= end; at = m_ends.erase(at)) {
            begin = std::min(begin, at->first);
            end = std::max(end, at->second);
        }
        m_ends.emplace(begin, end);
    }
    /// The first of `from`, `from + step`, … with so many free bits behind it.
    [[nodiscard]] uint64_t nextFree(uint64_t from, uint64_t size, uint64_t step) const {
        for (uint64_t at = from;;) {
            auto next = m_ends.lower_bound(at + size);
            if (next == m_ends.begin() || (--next)->second <= at) return at;
            at += (next->second - at + step - 1) / step * step;
        }
    }

private:
    std::map<uint64_t, uint64_t> m_ends; // by begin
};
} // namespace

///   ok:    a AT %MW0 : WORD; b AT %MB2 : BYTE;      advice: a AT %MW0 : WORD; b AT %MB1 : BYTE;  (P3011)
void checkOverlaps(WorldBuilder& world) {
    struct Used {
        const Variable* variable;
        uint64_t begin, end; // in bits
    };
    std::vector<Used> used;
    const auto add = [&](const Variable& variable) {
        if (!variable.isLocated || variable.storage != Storage::Absolute || !variable.declaration ||
            variable.declaration->address.find('*') != std::string_view::npos)
            return;
        // Nobody can change a library's addresses.
        if (isLibraryFile(world, variable.range.file)) return;
        const uint64_t begin = uint64_t(variable.offset) * 8 + static_cast<uint64_t>(std::max<int>(0, variable.bit));
        used.push_back(
            {&variable, begin, begin + (variable.bit >= 0 ? 1 : std::max(1u, world.types[variable.type].size) * 8ull)});
    };
    for (const Variable& variable : world.globals) add(variable);
    for (const Unit& unit : world.units)
        for (const Variable& variable : unit.variables) add(variable);
    std::stable_sort(used.begin(), used.end(), [](const Used& a, const Used& b) { return a.begin < b.begin; });
    if (used.empty()) return;
    // what the code addresses directly is taken as well
    TakenBits taken;
    // The fix offers a place that is really free, so everything that anybody uses has to be known.
    for (const Used& one : used) taken.add(one.begin, one.end);
    for (const syntax::SyntaxFile* file : world.fileOf) {
        if (!file || !file->library.empty()) continue;
        for (const lex::Token& token : file->tokens.tokens) {
            if (token.kind != lex::TokenKind::DirectAddress) continue;
            const auto address =
                addressIn(world, world.sources[file->file].text().substr(token.begin, token.end - token.begin));
            if (!address || address->isOpen || address->byte > kMaximumAddress) continue;
            const uint64_t begin = (uint64_t(areaOf(world, address->area).begin) + address->byte) * 8 +
                                   static_cast<uint64_t>(std::max<int>(0, address->bit));
            taken.add(begin, begin + types::bitsOf(address->kind));
        }
    }
    std::map<std::pair<Area, uint64_t>, uint64_t> searched;
    const auto nextFree = [&](const Variable& variable, uint64_t begin, uint64_t end) -> std::string {
        const std::string_view text = variable.declaration->address;
        if (world.hierarchical.contains(image::hierarchicalName(text))) return freeHierarchical(world, text);
        const DirectAddress address = addressIn(world, text).value_or(DirectAddress());
        const uint64_t area = uint64_t(areaOf(world, address.area).begin) * 8, size = end - begin;
        const uint64_t step = address.bit >= 0 && variable.bit >= 0 ? 1 : std::max(8u, types::bitsOf(address.kind));
        uint64_t& from = searched[{address.area, step}]; // those sought come in order: nothing before is free
        const uint64_t at = taken.nextFree(std::max(begin + step, from), size, step);
        taken.add(at, at + size);
        from = at;
        DirectAddress free = address;
        free.byte = static_cast<uint32_t>((at - area) / 8);
        if (free.bit >= 0) free.bit = static_cast<int16_t>(at % 8);
        return image::addressText(free, world.options.addressing).value_or(std::string(text));
    };
    for (size_t i = 1; i < used.size(); ++i) {
        // An advice and not an error: seeing %MW0 as two bytes is what overlapping addresses are used for.
        const Used &a = used[i - 1], &b = used[i];
        if (b.begin >= a.end) continue;
        const SourceRange range = b.variable->declaration->addressRange.file.isValid()
                                      ? b.variable->declaration->addressRange
                                      : b.variable->range;
        const std::string free = nextFree(*b.variable, b.begin, b.end);
        auto& diagnostic = world.emit(range, findings::OverlappingAddress(a.variable->name, b.variable->name,
                                                                          b.variable->declaration->address, free));
        diagnostic.related.push_back({a.variable->range, notes::DeclaredHere()});
        if (b.variable->declaration->addressRange.file.isValid())
            diagnostic.fixes.push_back({fixes::MoveTo(b.variable->name, free), {{range, free}}});
    }
}

void finishLayout(WorldBuilder& world) {
    image::Layout& layout = world.program->layout;
    layout.frameBegin = aligned(layout.dataEnd, 64);
    uint64_t frames = kMinimumFrames;
    // Twice the room of every function at once: an upper bound for calls without recursion, since each is at most once
    // in a chain.
    for (const tree::Function& function : world.functions)
        for (const tree::Local& local : function.locals)
            frames += aligned(world.types[local.type].size + 8, 8) * uint64_t(2);
    // A gigabyte: above it 32-bit offsets come near their end.
    layout.imageSize = aligned(std::min<uint64_t>(layout.frameBegin + frames, uint64_t(1) << 30), 64);
    // Frames begin as zeros and are not part of the initial image.
    world.image.resize(layout.dataEnd);
    world.program->initialImage = std::move(world.image);
}

} // namespace plc::sema
