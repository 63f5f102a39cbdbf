#include "runtime/debug/frames.h"

#include <cstring>

namespace plc::debug {

namespace {

class FrameReader {
public:
    FrameReader(const image::CompiledProgram& program, std::span<const std::byte> image)
        : m_types(*program.layout.types), m_image(image) {}

    types::Value variable(types::TypeId type, uint64_t offset, int bit = -1) const {
        const uint64_t size = bit >= 0 ? 1 : m_types[type].size;
        if (offset == 0 || offset + size > m_image.size()) return {};
        return types::readValue(m_types, type, m_image.subspan(offset, size), bit);
    }
    /// What a VAR_IN_OUT refers to; its slot lies at `offset`.
    types::Value referred(types::TypeId type, uint64_t offset) const {
        if (offset + 8 > m_image.size() || m_types.kind(type) == types::TypeKind::OpenArray) return {};
        uint64_t target = 0;
        std::memcpy(&target, m_image.data() + offset, sizeof target);
        return target < m_image.size() ? variable(type, target) : types::Value();
    }

private:
    const types::TypeTable& m_types;
    std::span<const std::byte> m_image;
};

} // namespace

std::vector<FrameVariable> frameVariables(const image::CompiledProgram& program, std::span<const std::byte> image,
                                          const controller::FaultFrame& frame) {
    std::vector<FrameVariable> variables;
    if (frame.functionIndex == 0 || frame.functionIndex >= program.functions.size()) return variables;
    const image::FunctionInfo& function = program.functions[frame.functionIndex];
    const FrameReader reader(program, image);
    if (frame.frameOffset)
        for (const image::FunctionLocal& local : function.locals) {
            if (local.isHidden) continue;
            const uint64_t at = uint64_t(frame.frameOffset) + local.frameOffset;
            variables.push_back(
                {local.name, local.isInOut ? reader.referred(local.type, at) : reader.variable(local.type, at), true});
        }
    if (frame.instanceOffset && function.instanceType.isValid())
        for (const types::Field& field : (*program.layout.types)[function.instanceType].fields) {
            if (field.isPrivate || field.section == types::FieldSection::External) continue;
            const uint64_t at = uint64_t(frame.instanceOffset) + field.offset;
            const types::TypeId type = field.bit >= 0 ? types::TypeTable::of(types::TypeKind::Bool) : field.type;
            variables.push_back({field.name,
                                 field.section == types::FieldSection::InOut ? reader.referred(type, at)
                                                                             : reader.variable(type, at, field.bit),
                                 false});
        }
    return variables;
}

} // namespace plc::debug
