// Where a place of the program that runs is in the text as it is written now: lines that were added or removed above it
// move it. A value; the thread that may read the text.
#pragma once
#include "runtime/base/source.h"
#include "runtime/image/program.h"

#include <QString>

#include <functional>
#include <optional>

namespace plc::editor {

struct TextPlace {
    QString file;
    int line = 0;        // from 1
    uint32_t offset = 0; // of the place, or of the line when the text there was edited
    uint32_t length = 0;
};

/// The text of a file as it is written now; `built` is the program's.
using TextNow = std::function<std::string(const QString& file, const SourceText& built)>;

[[nodiscard]] std::optional<TextPlace> placeInText(SourceRange range, const image::CompiledProgram& program,
                                                   const TextNow& textNow);

} // namespace plc::editor
