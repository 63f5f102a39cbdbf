// A program made by hand for tests of controller, history and debugger: variables laid out one by one, C++ functions as
// its code.
#pragma once
#include "runtime/image/program.h"

#include <cstring>
#include <memory>
#include <string>

namespace plc::testing {

using image::RuntimeContext;
using types::TypeKind;

class HandMade {
public:
    HandMade() {
        m_program->layout.types = std::make_shared<types::TypeTable>();
        layout().inputs = {64, 16};
        layout().outputs = {80, 16};
        layout().memory = {96, 16};
        m_end = 112;
        m_program->functions.resize(1);
        m_program->sites.resize(1);
        m_code->entries.resize(1, nullptr);
        m_program->version = 1;
    }
    types::TypeTable& types() { return *layout().types; }
    image::Layout& layout() { return m_program->layout; }
    image::CompiledProgram& program() { return *m_program; }

    /// A global (or a program instance with Area::Program).
    image::Root& add(const std::string& name, types::TypeId type, image::Area area = image::Area::Global) {
        const types::Type& t = types()[type];
        const uint32_t align = std::max(1u, t.align);
        image::Root root;
        root.name = name;
        root.type = type;
        root.area = area;
        root.offset = (m_end + align - 1) / align * align;
        if (area == image::Area::Program) root.programType = t.name;
        m_end = root.offset + t.size;
        layout().roots.push_back(root);
        return layout().roots.back();
    }
    image::Root& add(const std::string& name, TypeKind kind, image::Area area = image::Area::Global) {
        return add(name, types::TypeTable::of(kind), area);
    }
    image::Root& locate(const std::string& name, TypeKind kind, const std::string& address, uint32_t offset,
                        int16_t bit, image::Area area) {
        image::Root root;
        root.name = name;
        root.type = types::TypeTable::of(kind);
        root.area = area;
        root.offset = offset;
        root.bit = bit;
        root.address = address;
        layout().roots.push_back(root);
        return layout().roots.back();
    }
    types::TypeId structure(const std::string& name, std::vector<types::Field> fields, TypeKind kind = TypeKind::Struct,
                            uint32_t start = 0) {
        const types::TypeId id = types().declare(kind, name);
        types().edit(id).fields = std::move(fields);
        types().layoutFields(id, start);
        return id;
    }
    static types::Field field(const std::string& name, types::TypeId type) {
        types::Field f;
        f.name = name;
        f.type = type;
        return f;
    }
    static types::Field field(const std::string& name, TypeKind kind) {
        return field(name, types::TypeTable::of(kind));
    }

    uint32_t function(const std::string& name, image::Entry entry, types::TypeId instance = {}) {
        image::FunctionInfo info;
        info.name = name;
        info.instanceType = instance;
        m_program->functions.push_back(info);
        m_code->entries.push_back(entry);
        return static_cast<uint32_t>(m_code->entries.size() - 1);
    }
    uint32_t site(uint32_t function, SourceRange range) {
        m_program->sites.push_back({function, range});
        return static_cast<uint32_t>(m_program->sites.size() - 1);
    }
    image::Task& task(const std::string& name, uint32_t function, std::chrono::nanoseconds interval, int priority = 0,
                      size_t root = 0) {
        image::Task t;
        t.name = name;
        t.interval = interval;
        t.priority = priority;
        t.programs.push_back({static_cast<uint32_t>(root), function, 0, 0});
        m_program->tasks.push_back(t);
        return m_program->tasks.back();
    }
    /// Initial values are the types' own; `set` may change them before.
    template <class T> void initial(uint32_t offset, T value) {
        m_initial.push_back({offset, std::string(reinterpret_cast<const char*>(&value), sizeof value)});
    }

    std::shared_ptr<image::CompiledProgram> finish(uint32_t frameSize = 256) {
        image::Layout& l = layout();
        l.dataEnd = m_end;
        l.frameBegin = (m_end + 63) / 64 * 64;
        l.imageSize = l.frameBegin + frameSize;
        m_program->initialImage.assign(l.imageSize, std::byte{});
        for (const image::Root& root : l.roots) {
            const types::Type& t = types()[root.type];
            if (!t.initial.empty()) std::memcpy(m_program->initialImage.data() + root.offset, t.initial.data(), t.size);
        }
        for (const auto& [offset, bytes] : m_initial)
            std::memcpy(m_program->initialImage.data() + offset, bytes.data(), bytes.size());
        m_code->hasSites = true;
        m_program->quick = m_code;
        return m_program;
    }

private:
    std::shared_ptr<image::CompiledProgram> m_program = std::make_shared<image::CompiledProgram>();
    std::shared_ptr<image::Code> m_code = std::make_shared<image::Code>();
    std::vector<std::pair<uint32_t, std::string>> m_initial;
    uint32_t m_end = 0;
};

template <class T> T& at(std::byte* image, uint32_t offset) { return *reinterpret_cast<T*>(image + offset); }
template <class T> T valueAt(std::span<const std::byte> image, uint32_t offset) {
    T value{};
    std::memcpy(&value, image.data() + offset, sizeof value);
    return value;
}

} // namespace plc::testing
