#include "runtime/compiler/facts/frames.h"

#include "runtime/base/messages.h"

#include <algorithm>

namespace plc::facts {

using tree::Function;
using tree::Local;
using tree::LocalKind;
using types::TypeKind;

namespace {
uint64_t aligned(uint64_t offset, uint32_t align) { return (offset + align - 1) / align * align; }
} // namespace

uint64_t frameRoom(const tree::Program& program) {
    const image::Layout& layout = program.layout;
    return layout.imageSize > layout.frameBegin ? layout.imageSize - layout.frameBegin : 0;
}

Error tooLarge(const tree::Program& program, uint32_t function, uint64_t bytes) {
    return {errors::LocalsTooLarge(program.functions[function].name, bytes, frameRoom(program)), ""};
}

bool isScalar(const types::TypeTable& types, types::TypeId type) {
    return !types.isAggregate(type) && !types.isText(type) && types.kind(type) != TypeKind::OpenArray;
}

uint32_t slotSize(const types::TypeTable& types, const Local& local) {
    if (!local.isInOut) return std::max(1u, types[local.type].size);
    return types.kind(local.type) == TypeKind::OpenArray ? types[local.type].size : 8;
}

FrameLayout layFrameOut(const types::TypeTable& types, const Function& function, const std::vector<bool>& inMemory) {
    FrameLayout layout;
    layout.offsets.assign(function.locals.size(), kNoFrame);
    const auto place = [&](size_t i) {
        if (layout.offsets[i] != kNoFrame || !inMemory[i]) return;
        const Local& local = function.locals[i];
        const uint32_t align = local.isInOut ? 8 : std::max(1u, types[local.type].align);
        layout.size = aligned(layout.size, align);
        layout.offsets[i] = static_cast<uint32_t>(std::min(layout.size, kMaximumFrame));
        layout.size += slotSize(types, local);
    };
    const auto isShared = [&](size_t i) {
        return !function.locals[i].isInOut && !isScalar(types, function.locals[i].type);
    };
    const uint32_t result = function.resultLocal;
    if (result < function.locals.size() && isShared(result)) place(result);
    for (size_t i = 0; i < function.locals.size(); ++i)
        if ((function.locals[i].kind == LocalKind::Input || function.locals[i].kind == LocalKind::Output) &&
            isShared(i))
            place(i);
    for (size_t i = 0; i < function.locals.size(); ++i) place(i);
    layout.size = aligned(layout.size, 16);
    return layout;
}

} // namespace plc::facts
