#include "projects/exchange/base/addresses.h"

#include "runtime/compiler/lex/token.h"
#include "runtime/diagnostics/diagnostic.h"
#include "runtime/image/address.h"

#include <algorithm>

namespace plc::exchange {
namespace {

using image::Addressing;

/// Visits the addresses of a text in order, with their place.
template <class Visit> void forEachAddress(std::string_view text, Visit visit) {
    diagnostics::Sink sink;
    for (const lex::Token& token : lex::tokenize(FileId(0), text, sink).tokens) {
        if (token.kind != lex::TokenKind::DirectAddress) continue;
        const std::string_view written = text.substr(token.begin, token.end - token.begin);
        const auto address = image::parseAddress(written, Addressing::Bytes);
        if (address && !address->isOpen && !address->isHierarchical && types::bitsOf(address->kind) > 8)
            visit(token.begin, written, *address);
    }
}

} // namespace

bool hasCountedAddress(std::string_view text) {
    bool any = false;
    if (text.find('%') == std::string_view::npos) return false;
    forEachAddress(text, [&](size_t, std::string_view, const image::DirectAddress&) { any = true; });
    return any;
}

std::string addressesInWords(std::string_view text, const std::string& path, Report& report) {
    if (text.find('%') == std::string_view::npos) return std::string(text);
    std::string out;
    size_t done = 0;
    forEachAddress(text, [&](size_t begin, std::string_view written, const image::DirectAddress& address) {
        const auto counted = image::addressText(address, Addressing::Words);
        if (!counted) {
            const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
            report.add(path + ":" + std::to_string(line), remarks::AddressNotInWords(written));
            return;
        }
        out += text.substr(done, begin - done);
        out += *counted;
        done = begin + written.size();
    });
    return out + std::string(text.substr(done));
}

} // namespace plc::exchange
