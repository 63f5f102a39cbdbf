#include "projects/exchange/base/string_encoding.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/diagnostics/diagnostic.h"

#include <algorithm>
#include <set>

namespace plc::exchange {

using types::StringCode;

namespace {

/// The characters of STRING constants that Latin-1 does not have; `file` is that of the first.
std::set<char32_t> foreignCharacters(const Imported& imported, std::string& firstFile) {
    std::set<char32_t> out;
    for (const ImportedFile& file : imported.files) {
        if (std::all_of(file.text.begin(), file.text.end(), [](char c) { return static_cast<signed char>(c) >= 0; }))
            continue;
        diagnostics::Sink sink;
        for (const lex::Token& token : lex::tokenize(FileId(0), file.text, sink).tokens) {
            if (token.kind != lex::TokenKind::StringLiteral) continue;
            for (size_t at = token.begin; at < token.end;)
                if (const char32_t c = decodeUtf8(file.text, at); c > 0xFF) {
                    if (out.empty()) firstFile = file.path;
                    out.insert(c);
                }
        }
    }
    return out;
}

} // namespace

void chooseStringEncoding(Imported& imported) {
    if (imported.strings != StringCode::Latin1) return; // one of our exports says it
    std::string file;
    const std::set<char32_t> characters = foreignCharacters(imported, file);
    if (characters.empty()) return;
    constexpr StringCode kOfWindows[] = {StringCode::Windows1252, StringCode::Windows1251, StringCode::Windows1250,
                                         StringCode::Windows1253, StringCode::Windows1254, StringCode::Windows1257};
    const auto* const found = std::find_if(std::begin(kOfWindows), std::end(kOfWindows), [&](StringCode code) {
        return std::all_of(characters.begin(), characters.end(),
                           [&](char32_t c) { return types::bytesOfCharacter(code, c).size > 0; });
    });
    imported.strings = found == std::end(kOfWindows) ? StringCode::Utf8 : *found;
    std::string shown;
    appendUtf8(shown, *characters.begin());
    imported.report.add(file, remarks::StringEncoding(shown, nameOf(imported.strings)));
}

} // namespace plc::exchange
