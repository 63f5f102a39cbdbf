// How a ladder or function block diagram is shown, as the user chose it: symbols, what stands above a contact, high
// contrast. A value, kept as bits in the settings; any thread.
#pragma once
#include "runtime/compiler/ladder/picture.h"

namespace plc::editor {

struct LadderLook {
    ladder::LayoutOptions layout;
    ladder::Symbols symbols = ladder::Symbols::Bars;
    bool isHighContrast = false;
    bool operator==(const LadderLook&) const = default;

    [[nodiscard]] int bits() const {
        return (symbols == ladder::Symbols::Circuit ? 1 : 0) | (layout.showsComments ? 2 : 0) |
               (layout.showsNotes ? 0 : 4) | static_cast<int>(layout.naming) << 3 | (isHighContrast ? 32 : 0);
    }
    [[nodiscard]] static LadderLook fromBits(int bits) {
        LadderLook look;
        look.symbols = bits & 1 ? ladder::Symbols::Circuit : ladder::Symbols::Bars;
        look.layout.showsComments = bits & 2;
        look.layout.showsNotes = !(bits & 4);
        const int naming = bits >> 3 & 3;
        look.layout.naming = static_cast<ladder::Naming>(naming > 2 ? 0 : naming);
        look.isHighContrast = bits & 32;
        return look;
    }
};

} // namespace plc::editor
