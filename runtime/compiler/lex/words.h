// The table of keywords and soft words, built at compile time: one probe per word of the source. Values, any thread.
#pragma once
#include "runtime/compiler/lex/token.h"

#include <array>

namespace plc::lex {

struct Word {
    std::string_view spelling;
    TokenKind kind = TokenKind::Identifier;
    SoftWord soft = SoftWord::None;
};

namespace detail {

constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

constexpr uint32_t hashWord(std::string_view word) {
    uint32_t hash = 2166136261u;
    for (char c : word) hash = (hash ^ static_cast<unsigned char>(upper(c))) * 16777619u;
    return hash ^ (hash >> 15);
}

inline constexpr size_t kTableSize = 1024;

consteval std::array<Word, kTableSize> makeTable() {
    std::array<Word, kTableSize> table{};
    const auto insert = [&table](std::string_view spelling, TokenKind kind, SoftWord soft) {
        size_t at = hashWord(spelling) % kTableSize;
        while (!table[at].spelling.empty()) at = (at + 1) % kTableSize;
        table[at] = {spelling, kind, soft};
    };
#define PLC_TOKEN(Name, Spelling)
#define PLC_KEYWORD(Name, Spelling) insert(Spelling, TokenKind::Name, SoftWord::None);
#define PLC_SOFT(Name, Spelling) insert(Spelling, TokenKind::Identifier, SoftWord::Name);
#include "runtime/compiler/lex/tokens.def"
    return table;
}

inline constexpr std::array<Word, kTableSize> kWords = makeTable();

} // namespace detail

/// Kind and soft word of a name, in any case.
inline Word lookUpWord(std::string_view text) {
    if (text.size() < 2 || text.size() > 20) return {};
    size_t at = detail::hashWord(text) % detail::kTableSize;
    for (; !detail::kWords[at].spelling.empty(); at = (at + 1) % detail::kTableSize) {
        const Word& word = detail::kWords[at];
        if (word.spelling.size() != text.size()) continue;
        size_t same = 0;
        while (same < text.size() && detail::upper(text[same]) == word.spelling[same]) ++same;
        if (same == text.size()) return word;
    }
    return {};
}

} // namespace plc::lex
