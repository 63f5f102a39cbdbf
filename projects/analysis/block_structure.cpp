#include "projects/analysis/block_structure.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"

#include <algorithm>

namespace plc::analysis {

using lex::Token;
using lex::TokenKind;

namespace {

struct Opener {
    std::string_view open, close;
    bool isFlat = false; // what is inside begins at its own column, as the formatter has it
};
constexpr Opener kOpeners[] = {
    {"IF", "END_IF"},
    {"CASE", "END_CASE"},
    {"FOR", "END_FOR"},
    {"WHILE", "END_WHILE"},
    {"REPEAT", "END_REPEAT"},
    {"STRUCT", "END_STRUCT"},
    {"UNION", "END_UNION"},
    {"TYPE", "END_TYPE"},
    {"VAR", "END_VAR"},
    {"VAR_INPUT", "END_VAR"},
    {"VAR_OUTPUT", "END_VAR"},
    {"VAR_IN_OUT", "END_VAR"},
    {"VAR_TEMP", "END_VAR"},
    {"VAR_STAT", "END_VAR"},
    {"VAR_INST", "END_VAR"},
    {"VAR_GLOBAL", "END_VAR"},
    {"VAR_EXTERNAL", "END_VAR"},
    {"VAR_ACCESS", "END_VAR"},
    {"VAR_CONFIG", "END_VAR"},
    {"PROGRAM", "END_PROGRAM", true},
    {"FUNCTION", "END_FUNCTION", true},
    {"FUNCTION_BLOCK", "END_FUNCTION_BLOCK", true},
    {"METHOD", "END_METHOD"},
    {"PROPERTY", "END_PROPERTY"},
    {"ACTION", "END_ACTION", true},
    {"INTERFACE", "END_INTERFACE"},
    {"CLASS", "END_CLASS", true},
    {"NAMESPACE", "END_NAMESPACE", true},
    {"STEP", "END_STEP"},
    {"INITIAL_STEP", "END_STEP"},
    {"TRANSITION", "END_TRANSITION"},
    {"CONFIGURATION", "END_CONFIGURATION"},
    {"RESOURCE", "END_RESOURCE"},
    {"TEST", "END_TEST", true},
};

struct Scan {
    std::vector<BlockPair> pairs;
    struct Open {
        const Opener* opener;
        BlockPair pair;
    };
    std::vector<Open> open;
    std::vector<Open> unclosed; // an outer END_ came first
};

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
    return out;
}

// By tokens and not by the tree: while a block is being typed its END is missing, and the tree is that of the recovery.
Scan scanBlocks(std::string_view text, uint32_t upTo) {
    Scan scan;
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(size_t(0)), text, sink);
    std::vector<BlockMark> regions;
    for (size_t i = 0; i < list.tokens.size(); ++i) {
        const Token& token = list.tokens[i];
        if (token.begin >= upTo) break;
        if (token.kind == TokenKind::Pragma) { // {region 'name'} … {endregion}, REGION name … END_REGION
            const std::string words = upper(text.substr(token.begin, token.end - token.begin));
            const size_t first = words.find_first_not_of("{ \t");
            if (first == std::string::npos) continue;
            if (words.compare(first, 6, "REGION") == 0) regions.push_back({token.begin, token.end});
            const bool isEnd = words.compare(first, 9, "ENDREGION") == 0 || words.compare(first, 10, "END_REGION") == 0;
            if (isEnd && !regions.empty()) {
                scan.pairs.push_back({regions.back(), {token.begin, token.end}, {}, 0});
                regions.pop_back();
            }
            continue;
        }
        const bool isWord = lex::isKeyword(token.kind) || token.soft != lex::SoftWord::None;
        if (!isWord) continue;
        const std::string word = upper(text.substr(token.begin, token.end - token.begin));
        const BlockMark mark{token.begin, token.end};
        if (word == "ELSE" || word == "ELSIF" || word == "UNTIL") {
            if (!scan.open.empty()) scan.open.back().pair.middle.push_back(mark);
            continue;
        }
        if (word.starts_with("END_")) {
            for (size_t k = scan.open.size(); k-- > 0;) {
                if (scan.open[k].opener->close != word) continue;
                scan.open[k].pair.close = mark;
                scan.pairs.push_back(scan.open[k].pair);
                // An END of an outer block ends those inside whose own is missing.
                scan.unclosed.insert(scan.unclosed.end(), scan.open.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                                     scan.open.end());
                scan.open.resize(k);
                break;
            }
            continue;
        }
        for (const Opener& opener : kOpeners) {
            if (opener.open != word) continue;
            // Soft words open only at a line's begin; PROGRAM … WITH inside a RESOURCE is one line.
            const bool atLineBegin = token.afterNewline || i == 0;
            if (token.kind == TokenKind::Identifier && !atLineBegin &&
                !(i > 0 && list.tokens[i - 1].kind == TokenKind::Identifier && list.tokens[i - 1].afterNewline))
                break;
            if (token.kind == TokenKind::Identifier && i + 1 < list.tokens.size() &&
                list.tokens[i + 1].kind != TokenKind::Identifier &&
                list.tokens[i + 1].kind != TokenKind::StringLiteral && word != "TRANSITION")
                break;
            if (word == "PROGRAM" && !scan.open.empty() &&
                (scan.open.back().opener->open == "RESOURCE" || scan.open.back().opener->open == "CONFIGURATION"))
                break;
            BlockPair pair;
            pair.open = mark;
            pair.depth = static_cast<int>(scan.open.size());
            scan.open.push_back({&opener, pair});
            break;
        }
    }
    for (const lex::Comment& comment : list.comments)
        if (comment.kind == lex::TriviaKind::BlockComment && comment.end <= upTo &&
            text.substr(comment.begin, comment.end - comment.begin).find('\n') != std::string_view::npos)
            scan.pairs.push_back({{comment.begin, comment.begin + 2}, {comment.end - 2, comment.end}, {}, 0});
    std::sort(scan.pairs.begin(), scan.pairs.end(),
              [](const BlockPair& a, const BlockPair& b) { return a.open.begin < b.open.begin; });
    return scan;
}

uint32_t lineOf(const std::vector<uint32_t>& lineBegins, uint32_t offset) {
    return static_cast<uint32_t>(std::upper_bound(lineBegins.begin(), lineBegins.end(), offset) - lineBegins.begin()) -
           1;
}

} // namespace

std::vector<BlockPair> findBlocks(std::string_view text) {
    return scanBlocks(text, static_cast<uint32_t>(text.size()) + 1).pairs;
}

std::vector<FoldLine> foldLines(std::string_view text) {
    std::vector<uint32_t> begins{0};
    for (uint32_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') begins.push_back(i + 1);
    std::vector<int> change(begins.size() + 1);
    std::vector<FoldLine> out(begins.size());
    for (const BlockPair& pair : findBlocks(text)) {
        const uint32_t first = lineOf(begins, pair.open.begin), last = lineOf(begins, pair.close.begin);
        if (last <= first) continue;
        out[first].isHeader = true;
        ++change[first + 1];
        --change[last + 1];
    }
    int level = 0;
    for (size_t line = 0; line < out.size(); ++line) {
        level += change[line];
        out[line].level = level;
    }
    return out;
}

std::string missingEnd(std::string_view text, uint32_t offset) {
    const Scan before = scanBlocks(text, offset);
    if (before.open.empty()) return {};
    Scan whole = scanBlocks(text, static_cast<uint32_t>(text.size()) + 1);
    whole.open.insert(whole.open.end(), whole.unclosed.begin(), whole.unclosed.end());
    const uint32_t openAt = before.open.back().pair.open.begin;
    // Closed properly only when its own END has not been taken from an outer block: an unclosed opener anywhere outside
    // means one END is missing.
    for (const Scan::Open& open : whole.open)
        if (open.opener->close == before.open.back().opener->close && open.pair.open.begin <= openAt)
            return std::string(before.open.back().opener->close);
    return {};
}

int indentAfter(std::string_view text, uint32_t offset, int step) {
    const size_t lineBegin = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1; // npos + 1 == 0
    size_t at = lineBegin;
    while (at < text.size() && at < offset && (text[at] == ' ' || text[at] == '\t')) ++at;
    const int own = static_cast<int>(at - lineBegin);
    const std::string_view line = text.substr(lineBegin, offset - lineBegin);
    const Scan scan = scanBlocks(text, offset);
    for (const Scan::Open& open : scan.open) {
        if (open.pair.open.begin >= lineBegin) return open.opener->isFlat ? own : own + step;
        for (const BlockMark& middle : open.pair.middle)
            if (middle.begin >= lineBegin && middle.begin < offset) return own + step;
    }
    // "3:" of a CASE opens its statements, too.
    size_t end = line.find_last_not_of(" \t");
    if (end != std::string_view::npos && line[end] == ':' && !scan.open.empty() &&
        scan.open.back().opener->open == "CASE")
        return own + step;
    return own;
}

bool opensBlock(std::string_view text, uint32_t offset) {
    const size_t lineBegin = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1; // npos + 1 == 0
    const Scan scan = scanBlocks(text, offset);
    return !scan.open.empty() && scan.open.back().pair.open.begin >= lineBegin;
}

bool closesBlock(std::string_view lineText) {
    const size_t at = lineText.find_first_not_of(" \t");
    if (at == std::string_view::npos) return false;
    const std::string word = upper(lineText.substr(at, 24));
    const auto is = [&](std::string_view w) {
        return word.starts_with(w) &&
               (word.size() == w.size() ||
                !(std::isalnum(static_cast<unsigned char>(word[w.size()])) || word[w.size()] == '_'));
    };
    return word.starts_with("END_") || is("ELSE") || is("ELSIF") || is("UNTIL");
}

} // namespace plc::analysis
