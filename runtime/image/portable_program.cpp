#include "runtime/image/portable_program.h"

#include <bit>
#include <cstring>
#include <type_traits>

namespace plc::image {

namespace {

static_assert(std::endian::native == std::endian::little, "images and programs are little endian");
constexpr uint64_t kFormat = 0x31304d4152475250; // "PRGRAM01"

/// One list of members serves both directions: each(archive, value) names them, the archive writes or reads.
class Writing {
public:
    static constexpr bool kReads = false;
    void bytes(const void* data, size_t size) { out.append(static_cast<const char*>(data), size); }
    size_t count(size_t size) {
        const auto number = static_cast<uint64_t>(size);
        bytes(&number, sizeof number);
        return size;
    }
    std::string out;
};

class Reading {
public:
    static constexpr bool kReads = true;
    explicit Reading(std::string_view bytes) : m_rest(bytes) {}
    void bytes(void* data, size_t size) {
        if (size > m_rest.size()) m_isGood = false;
        if (!m_isGood || size == 0) return;
        std::memcpy(data, m_rest.data(), size);
        m_rest.remove_prefix(size);
    }
    /// Of elements that take a byte each at least: a larger number is damage.
    size_t count(size_t) {
        uint64_t number = 0;
        bytes(&number, sizeof number);
        if (number > m_rest.size()) m_isGood = false;
        return m_isGood ? static_cast<size_t>(number) : 0;
    }
    [[nodiscard]] bool isGood() const { return m_isGood; }
    [[nodiscard]] bool isComplete() const { return m_isGood && m_rest.empty(); }

private:
    std::string_view m_rest;
    bool m_isGood = true;
};

template <class A, class T> void each(A& a, T& value);

template <class T> struct IsVector : std::false_type {};
template <class T> struct IsVector<std::vector<T>> : std::true_type {};
template <class T> struct IsPair : std::false_type {};
template <class F, class S> struct IsPair<std::pair<F, S>> : std::true_type {};
template <class T> struct IsOptional : std::false_type {};
template <class T> struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
constexpr bool isPlain =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::byte> || std::is_same_v<T, types::TypeId> ||
    std::is_same_v<T, FileId> || std::is_same_v<T, std::chrono::nanoseconds>;

template <class A, class... T> void all(A& a, T&... values) { (each(a, values), ...); }

template <class A> void members(A& a, SourceRange& v) { all(a, v.file, v.begin, v.end); }
template <class A> void members(A& a, types::Field& v) {
    all(a, v.name, v.type, v.offset, v.section, v.retain, v.persistent, v.constant, v.isPrivate, v.aliases,
        v.declaration, v.comment, v.bit, v.isLocated);
}
template <class A> void members(A& a, types::Enumerator& v) { all(a, v.name, v.value, v.declaration, v.comment); }
template <class A> void members(A& a, types::Dimension& v) { all(a, v.low, v.high); }
template <class A> void members(A& a, types::Type& v) {
    all(a, v.kind, v.name, v.space, v.size, v.align, v.element, v.low, v.high, v.capacity, v.dimensions, v.fields,
        v.enumerators, v.qualifiedOnly, v.isStrict, v.base, v.interfaces, v.blockNumber, v.initial, v.declaration,
        v.comment);
}
template <class A> void members(A& a, Root& v) {
    all(a, v.name, v.list, v.space, v.type, v.offset, v.bit, v.area, v.retain, v.persistent, v.constant, v.isSimulation,
        v.isHidden, v.programType, v.address, v.declaration, v.comment);
}
template <class A> void members(A& a, AreaRange& v) { all(a, v.begin, v.size); }
template <class A> void members(A& a, Place& v) { all(a, v.type, v.offset, v.bit); }
template <class A> void members(A& a, TaskProgram& v) { all(a, v.root, v.function, v.connectIn, v.connectOut); }
template <class A> void members(A& a, Task& v) {
    all(a, v.name, v.kind, v.interval, v.priority, v.trigger, v.watchdog, v.watchdogSensitivity, v.isSimulation,
        v.programs, v.declaration);
}
template <class A> void members(A& a, FunctionLocal& v) {
    all(a, v.name, v.type, v.frameOffset, v.isInOut, v.isHidden);
}
template <class A> void members(A& a, FunctionInfo& v) {
    all(a, v.name, v.library, v.instanceType, v.locals, v.frameSize, v.declaration);
}
template <class A> void members(A& a, Site& v) { all(a, v.function, v.range); }

template <class A, class T> void elements(A& a, T& list) {
    list.resize(a.count(list.size()));
    for (auto& element : list) each(a, element);
}

template <class A, class T> void each(A& a, T& value) {
    if constexpr (std::is_same_v<T, bool>) { // a byte of a damaged program may be anything
        uint8_t byte = value ? 1 : 0;
        a.bytes(&byte, 1);
        value = byte != 0;
    } else if constexpr (isPlain<T>) {
        a.bytes(&value, sizeof value);
    } else if constexpr (std::is_same_v<T, std::string>) {
        value.resize(a.count(value.size()));
        a.bytes(value.data(), value.size());
    } else if constexpr (std::is_same_v<T, std::vector<std::byte>>) {
        value.resize(a.count(value.size()));
        a.bytes(value.data(), value.size());
    } else if constexpr (IsVector<T>::value) {
        elements(a, value);
    } else if constexpr (IsPair<T>::value) {
        all(a, value.first, value.second);
    } else if constexpr (IsOptional<T>::value) {
        bool has = value.has_value();
        each(a, has);
        if (A::kReads && has) value.emplace();
        if (has) each(a, *value);
    } else {
        members(a, value);
    }
}

/// Elementary types are in every table; those behind are declared in their order, so that ids stay.
template <class A> void typesOf(A& a, types::TypeTable& table) {
    const size_t known = types::TypeTable().count();
    const size_t count = a.count(table.count());
    for (size_t i = known; i < count; ++i) {
        if constexpr (A::kReads) {
            if (!a.isGood()) return;
            table.declare(types::TypeKind::Unknown, {});
        }
        each(a, table.edit(types::TypeId(static_cast<uint32_t>(i))));
    }
}

template <class A> void sourcesOf(A& a, SourceSet& sources) {
    const size_t count = a.count(sources.files.size());
    for (size_t i = 0; i < count; ++i) {
        std::string path, text;
        if constexpr (!A::kReads) {
            path = sources.files[i].path();
            text = sources.files[i].text();
        }
        all(a, path, text);
        if constexpr (A::kReads) (void)sources.add(std::move(path), std::move(text));
    }
}

template <class A> void programOf(A& a, CompiledProgram& p) {
    typesOf(a, *p.layout.types);
    all(a, p.layout.roots, p.layout.inputs, p.layout.outputs, p.layout.memory, p.layout.dataEnd, p.layout.frameBegin,
        p.layout.imageSize, p.initialImage, p.initializer, p.tasks, p.functions, p.sites, p.version);
    sourcesOf(a, p.sources);
}

template <class A> bool everything(A& a, PortableProgram& p) {
    uint64_t format = kFormat;
    each(a, format);
    if (format != kFormat) return false;
    programOf(a, *p.program);
    all(a, p.name, p.calendarStartNs, p.sources, p.libraries, p.libraryTexts);
    return true;
}

} // namespace

std::string toBytes(const PortableProgram& portable) {
    Writing writer;
    PortableProgram copy = portable; // the lists of members are those of reading; nothing is changed
    (void)everything(writer, copy);
    return std::move(writer.out);
}

std::optional<PortableProgram> fromBytes(std::string_view bytes) {
    PortableProgram portable;
    portable.program = std::make_shared<CompiledProgram>();
    portable.program->layout.types = std::make_shared<types::TypeTable>();
    Reading reader(bytes);
    if (!everything(reader, portable) || !reader.isComplete()) return {};
    for (const std::string& setting : portable.libraries) // as recordings keep them, "%strings=UTF-8"
        if (setting.starts_with("%strings="))
            if (const auto code = types::stringCodeNamed(setting.substr(9))) {
                portable.program->layout.types->strings = *code;
                types::prepare(*code);
            }
    nameReferences(portable.program);
    return portable;
}

void nameReferences(const std::shared_ptr<CompiledProgram>& program) {
    const std::weak_ptr<const CompiledProgram> weak = program;
    types::TypeTable& types = *program->layout.types;
    types.referenceText = [weak](types::TypeId type, int64_t offset) -> std::string {
        const auto owner = weak.lock();
        if (!owner || offset < int64_t(sizeof(ImageHeader)) || offset >= owner->layout.dataEnd) return {};
        const types::Type& shown = (*owner->layout.types)[owner->layout.types->storage(type)];
        const types::TypeId wanted = shown.kind == types::TypeKind::Interface ? type : shown.element;
        return owner->layout.pathAt(static_cast<uint32_t>(offset), wanted);
    };
}

} // namespace plc::image
