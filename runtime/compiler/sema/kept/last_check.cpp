// What of the last check still holds, decided per file: the same file object, the same text but for bodies, or nothing.
#include "runtime/compiler/sema/kept/last_check.h"

namespace plc::sema {

namespace {

bool isSameFile(const LastCheck& last, size_t index, const syntax::SyntaxFile& now, const SourceText& text) {
    const syntax::SyntaxFile& before = *last.files[index];
    // the conditions of one that asks for names are decided by other files: its text does not say what it declares
    return last.sources[index].path() == text.path() && before.library == now.library && !before.asksForNames &&
           !now.asksForNames;
}

} // namespace

bool StillValid::isChanged(const Unit& unit) const {
    const SourceRange range = unit.action ? unit.action->body.range : unit.pou->body.range;
    if (!range.file.isValid() || range.file.index() >= changed.size()) return false;
    const std::vector<bool>& ofFile = changed[range.file.index()];
    if (ofFile.empty()) return false;
    const FileShape& shape = *(*shapes)[range.file.index()];
    auto body = shape.bodyAt(range.begin);
    // A body without statements may begin where the word behind it does, which is outside.
    if (!body && range.begin > 0) body = shape.bodyAt(range.begin - 1);
    return body && ofFile[*body];
}

StillValid stillValid(const LastCheck* last, const World& world,
                      const std::vector<std::shared_ptr<const syntax::SyntaxFile>>& files) {
    StillValid out;
    auto shapes = std::make_shared<Shapes>(files.size());
    out.changed.resize(files.size());
    const LastCheck::Rules rules{world.options.strict, world.options.addressing, world.options.memoryForNew,
                                 world.options.strings};
    out.isAny = last && last->files.size() == files.size() && last->rules == rules;
    for (size_t i = 0; i < files.size(); ++i) {
        const SourceText& text = world.sources[FileId(i)];
        const bool hasBefore = last && i < last->files.size();
        // The same object: KeptFiles found the text unchanged. This is the case of all files but one at a keystroke.
        if (hasBefore && last->files[i] == files[i]) {
            (*shapes)[i] = (*last->shapes)[i];
            continue;
        }
        // Also where nothing is kept any more: the next check needs it.
        (*shapes)[i] = shapeOf(*files[i], text.text());
        if (!out.isAny) continue;
        out.isAny = isSameFile(*last, i, *files[i], text);
        if (!out.isAny) continue;
        const FileShape& before = *(*last->shapes)[i];
        auto changed = changedBodies(before, last->sources[i].text(), *(*shapes)[i], text.text());
        out.isAny = changed.has_value();
        if (!changed) continue;
        out.changed[i] = std::move(*changed);
        // An edit that keeps all lengths (a letter for a letter): records need no moving.
        if (before.bodies == (*shapes)[i]->bodies) (*shapes)[i] = (*last->shapes)[i]; // nothing moved
    }
    out.shapes = std::move(shapes);
    return out;
}

std::vector<uint64_t> summaryOf(const WorldBuilder& world) {
    // What bodies see of the declarations, as numbers. A number more costs nothing; one too few keeps a wrong tree, so
    // whatever a body can read of a declaration has to be in here or in the text.
    std::vector<uint64_t> out{world.types.count(), world.functions.size(), world.symbols.size(), world.units.size(),
                              world.rangeOfInputs, world.rangeOfOutputs,   world.rangeOfMemory,  world.image.size()};
    const auto add = [&](const Variable& variable) {
        out.push_back(uint64_t(variable.offset) << 32 | uint64_t(variable.type.value) << 8 |
                      uint64_t(variable.storage) << 1 | uint64_t(variable.isConstant));
    };
    // %IW3.1 is placed after what flat addresses use, those in bodies included.
    for (const auto& [name, place] : world.hierarchical) {
        for (const char c : name) out.push_back(static_cast<unsigned char>(c));
        out.push_back(uint64_t(place.address.byte) << 32 | place.size);
    }
    for (const Variable& variable : world.globals) add(variable);
    for (const Unit& unit : world.units) {
        out.push_back(uint64_t(unit.variables.size()) << 32 | uint64_t(unit.hasImplicitEno) << 8 | uint64_t(unit.kind));
        for (const Variable& variable : unit.variables) add(variable);
    }
    return out;
}

} // namespace plc::sema
