#include "projects/exchange/graphs/flow.h"

#include <algorithm>
#include <cctype>

namespace plc::exchange {

namespace {

/// A name with members and indices, an address, a literal, a call: nothing an operator stands in at the outermost
/// level.
bool isPrimary(const std::string& text) {
    int depth = 0;
    char quote = 0;
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0) {
            if (c == quote) quote = 0;
            continue;
        }
        if (c == '\'' || c == '"')
            quote = c;
        else if (c == '(' || c == '[')
            ++depth;
        else if (c == ')' || c == ']')
            --depth;
        else if (depth == 0 && !(std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '^' ||
                                 c == '#' || c == '%' || static_cast<unsigned char>(c) >= 0x80))
            return false;
    }
    return depth == 0 && quote == 0 && !text.empty();
}

} // namespace

Flow Flow::ofUser(std::string text) {
    const int level = isPrimary(text) ? kPrimary : kUnknown;
    return {std::move(text), level};
}

std::string Flow::operand(int level) const {
    std::string out = text();
    return m_level < level ? "(" + out + ")" : out;
}

std::string Flow::text() const {
    if (m_parts.empty()) return m_text;
    std::string out;
    for (const Flow& part : m_parts)
        out += (out.empty() ? "" : m_level == kAnd ? " AND " : " OR ") + part.operand(m_level + 1);
    return out;
}

std::vector<Flow> Flow::factors() const {
    if (m_level == kAnd && !m_parts.empty()) return m_parts;
    return {*this};
}

Flow Flow::joined(std::vector<Flow> parts, int level) {
    if (parts.empty()) return yes();
    if (parts.size() == 1) return std::move(parts.front());
    Flow out;
    out.m_level = level;
    out.m_parts = std::move(parts);
    return out;
}

Flow Flow::both(const Flow& a, const Flow& b) {
    if (a.isTrue()) return b;
    if (b.isTrue()) return a;
    std::vector<Flow> parts = a.factors();
    for (Flow& part : b.factors()) parts.push_back(std::move(part));
    return joined(std::move(parts), kAnd);
}

Flow Flow::any(const std::vector<Flow>& all) {
    std::vector<std::vector<Flow>> terms;
    std::vector<std::string> seen;
    for (const Flow& each : all) {
        if (each.isTrue()) return yes();
        std::string text = each.text();
        if (std::find(seen.begin(), seen.end(), text) != seen.end()) continue;
        seen.push_back(std::move(text));
        terms.push_back(each.factors());
    }
    if (terms.size() == 1) return joined(std::move(terms.front()), kAnd);
    size_t common = 0; // a beginning that all share
    for (;; ++common) {
        const auto same = [&](const std::vector<Flow>& term) {
            return common < term.size() && term[common].text() == terms.front()[common].text();
        };
        if (common >= terms.front().size() || !std::all_of(terms.begin(), terms.end(), same)) break;
    }
    std::vector<Flow> parts(terms.front().begin(), terms.front().begin() + static_cast<std::ptrdiff_t>(common));
    std::vector<Flow> rest;
    for (std::vector<Flow>& term : terms) {
        term.erase(term.begin(), term.begin() + static_cast<std::ptrdiff_t>(common));
        if (term.empty()) return joined(std::move(parts), kAnd); // a wire beside contacts
        Flow one = joined(std::move(term), kAnd);
        if (one.m_level == kOr && !one.m_parts.empty())
            for (Flow& part : one.m_parts) rest.push_back(std::move(part));
        else
            rest.push_back(std::move(one));
    }
    parts.push_back(joined(std::move(rest), kOr));
    return joined(std::move(parts), kAnd);
}

Flow Flow::negated() const {
    if (m_parts.empty() && m_text == "TRUE") return {"FALSE", kPrimary};
    return {"NOT " + operand(kPrimary), kUnary};
}

} // namespace plc::exchange
