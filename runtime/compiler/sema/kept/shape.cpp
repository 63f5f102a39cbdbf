// A file as its bodies and what is between them. Everything that a check keeps relies on bodyAt and changedBodies being
// right: two readings that differ outside of bodies are different declarations.
#include "runtime/compiler/sema/kept/shape.h"

#include "runtime/base/text.h"

#include <algorithm>

namespace plc::sema {

namespace {

using syntax::Body;
using syntax::BodyLanguage;
using syntax::Decl;
using syntax::Pou;
using Piece = FileShape::Piece;

class Gathering {
public:
    Gathering(const syntax::SyntaxFile& file, std::string_view text) : m_file(file), m_size(text.size()) {}

    std::vector<Piece> run() {
        declarations(m_file.declarations);
        // By begin, and of equal begins the longer first: what contains another comes before it.
        std::sort(m_found.begin(), m_found.end(),
                  [](Piece a, Piece b) { return std::pair(a.begin, b.end) < std::pair(b.begin, a.end); });
        std::vector<Piece> apart;
        for (size_t i = 0; i < m_found.size(); ++i) {
            // statements before and after a method are one body with the method in it: that one declares
            const bool holdsNext = i + 1 < m_found.size() && m_found[i + 1].begin < m_found[i].end;
            if (!holdsNext && (apart.empty() || apart.back().end <= m_found[i].begin)) apart.push_back(m_found[i]);
        }
        return apart;
    }

private:
    void declarations(const std::vector<Decl*>& list) {
        for (const Decl* decl : list) {
            if (decl->space) declarations(decl->space->declarations);
            if (decl->pou) unit(*decl->pou);
        }
    }

    static bool isLowered(const Body& body) {
        return body.language == BodyLanguage::Il || body.language == BodyLanguage::Sfc;
    }

    void unit(const Pou& pou) {
        // Prototypes have no bodies.
        if (pou.kind == syntax::PouKind::Interface) return;
        for (const Pou* method : pou.methods) unit(*method);
        for (const syntax::Property* property : pou.properties) {
            if (property->get) unit(*property->get);
            if (property->set) unit(*property->set);
        }
        bool declares = isLowered(pou.body); // lowering charts and lists adds variables to the unit
        for (const syntax::ActionDecl* action : pou.actions) declares = declares || isLowered(action->body);
        // A section behind a statement or a wrong word is an error, but its variables are declared.
        const SourceRange body = pou.body.range;
        for (const syntax::VarSection* section : pou.sections)
            declares = declares || (section->range.begin >= body.begin && section->range.begin < body.end);
        // The whole body counts as declaration: a changed step is a changed variable.
        if (declares) return;
        add(pou.body);
        for (const syntax::ActionDecl* action : pou.actions) add(action->body);
    }

    // Comments and spaces at the edges belong to the body: typing there is the most frequent edit of all.
    /// From the end of the token before it to the begin of the one after it.
    void add(const Body& body) {
        if (body.range.file != m_file.file) return;
        const auto& tokens = m_file.tokens.tokens;
        const auto from = [&](uint32_t offset) {
            return std::lower_bound(tokens.begin(), tokens.end(), offset,
                                    [](const lex::Token& token, uint32_t at) { return token.begin < at; });
        };
        const auto first = from(body.range.begin);
        const auto next = from(std::max(body.range.begin, body.range.end));
        Piece piece;
        piece.begin = first == tokens.begin() ? 0 : (first - 1)->end;
        piece.end = next == tokens.end() ? static_cast<uint32_t>(m_size) : next->begin;
        if (piece.begin < piece.end) m_found.push_back(piece);
    }

    const syntax::SyntaxFile& m_file;
    size_t m_size;
    std::vector<Piece> m_found;
};

} // namespace

std::optional<size_t> FileShape::bodyAt(uint32_t offset) const {
    auto after = std::upper_bound(bodies.begin(), bodies.end(), offset,
                                  [](uint32_t at, const Piece& piece) { return at < piece.begin; });
    if (after == bodies.begin() || offset >= (after - 1)->end) return {};
    return static_cast<size_t>(after - 1 - bodies.begin());
}

std::shared_ptr<const FileShape> shapeOf(const syntax::SyntaxFile& file, std::string_view text) {
    auto shape = std::make_shared<FileShape>();
    shape->bodies = Gathering(file, text).run();
    return shape;
}

std::optional<std::vector<bool>> changedBodies(const FileShape& before, std::string_view textBefore,
                                               const FileShape& now, std::string_view textNow) {
    if (before.bodies.size() != now.bodies.size()) return {};
    std::vector<bool> changed(now.bodies.size());
    uint32_t endBefore = 0, endNow = 0;
    for (size_t i = 0; i < now.bodies.size(); ++i) {
        const Piece a = before.bodies[i], b = now.bodies[i];
        // Text between two bodies, comments included: they are shown with declarations.
        if (textBefore.substr(endBefore, a.begin - endBefore) != textNow.substr(endNow, b.begin - endNow)) return {};
        const std::string_view bodyBefore = textBefore.substr(a.begin, a.end - a.begin);
        const std::string_view bodyNow = textNow.substr(b.begin, b.end - b.begin);
        changed[i] = bodyBefore != bodyNow;
        // a conditional pragma decides about text beyond the body as well
        if (changed[i] && (bodyBefore.find('{') != bodyBefore.npos || bodyNow.find('{') != bodyNow.npos)) return {};
        endBefore = a.end;
        endNow = b.end;
    }
    if (textBefore.substr(endBefore) != textNow.substr(endNow)) return {};
    return changed;
}

SourceRange Moves::operator()(SourceRange range) const {
    if (!m_isNeeded || !range.file.isValid() || range.file.index() >= m_from.size()) return range;
    const FileShape &from = *m_from[range.file.index()], &to = *m_to[range.file.index()];
    if (&from == &to) return range;
    const auto moved = [&](uint32_t offset) {
        // the last body that begins at or before it: it is in there, or in what follows
        // Places between bodies move by as much as the body before them.
        const auto after = std::upper_bound(from.bodies.begin(), from.bodies.end(), offset,
                                            [](uint32_t at, const Piece& piece) { return at < piece.begin; });
        if (after == from.bodies.begin()) return offset;
        const auto index = static_cast<size_t>(after - 1 - from.bodies.begin());
        const Piece was = from.bodies[index], is = to.bodies[index];
        return offset < was.end ? is.begin + (offset - was.begin) : is.end + (offset - was.end);
    };
    return {range.file, moved(range.begin), moved(range.end)};
}

} // namespace plc::sema
