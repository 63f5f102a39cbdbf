#include "tests/fuzz/grammar.h"

#include "runtime/compiler/parse/parser.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace plc::fuzz {

namespace {

enum class Piece : uint8_t { Declaration, Section, Variable, Type, Statement, Expression, Number, Bound, Name, Count };
constexpr size_t kPieces = static_cast<size_t>(Piece::Count);
constexpr size_t kLongest = 64 * 1024; // a text that doubles itself stops here

/// One that a std::stoll takes, too.
bool isNumber(std::string_view text) {
    return !text.empty() && text.size() <= 18 &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The ranges of all pieces of a text, by kind.
class Pieces {
public:
    explicit Pieces(std::string_view text) : m_text(text) {
        diagnostics::Sink sink;
        m_file = parse::parseFile(FileId(size_t(0)), text, sink, nullptr, parse::Branches::All);
        for (const syntax::Decl* each : m_file->declarations) declaration(*each);
    }
    [[nodiscard]] const std::vector<SourceRange>& of(Piece piece) const { return m_found[static_cast<size_t>(piece)]; }

private:
    void add(Piece piece, SourceRange range) {
        if (range.end > range.begin) m_found[static_cast<size_t>(piece)].push_back(range);
    }
    void addNumber(Piece piece, SourceRange range) {
        if (isNumber(m_text.substr(range.begin, range.end - range.begin))) add(piece, range);
    }
    void bound(const syntax::Expr* expr) {
        expression(expr);
        if (expr) addNumber(Piece::Bound, expr->range);
    }
    void expression(const syntax::Expr* expr) {
        if (!expr) return;
        add(Piece::Expression, expr->range);
        addNumber(Piece::Number, expr->range);
        add(Piece::Name, expr->name.range);
        expression(expr->base);
        expression(expr->right);
        arguments(expr->arguments);
    }
    void arguments(const std::vector<syntax::Argument>& all) {
        for (const syntax::Argument& each : all) {
            expression(each.value);
            if (each.instructions) block(*each.instructions);
        }
    }
    void type(const syntax::TypeSpec* spec) {
        if (!spec) return;
        add(Piece::Type, spec->range);
        expression(spec->length);
        for (const syntax::Bounds& each : spec->bounds) bound(each.low), bound(each.high);
        type(spec->element);
        for (const syntax::EnumeratorDecl& each : spec->enumerators) expression(each.value);
        for (const syntax::VarDecl* each : spec->fields) variable(*each);
    }
    void variable(const syntax::VarDecl& decl) {
        add(Piece::Variable, decl.range);
        for (const syntax::Name& name : decl.names) add(Piece::Name, name.range);
        type(decl.type);
        expression(decl.initial);
    }
    void sections(const std::vector<syntax::VarSection*>& all) {
        for (const syntax::VarSection* section : all) {
            add(Piece::Section, section->range);
            for (const syntax::VarDecl* each : section->declarations) variable(*each);
        }
    }
    void block(const syntax::Block& body) {
        for (const syntax::Stmt* each : body)
            if (each) statement(*each);
    }
    void statement(const syntax::Stmt& stmt) {
        add(Piece::Statement, stmt.range);
        for (const syntax::Expr* each : {stmt.target, stmt.value, stmt.from, stmt.to, stmt.by}) expression(each);
        block(stmt.body);
        for (const syntax::IfBranch& branch : stmt.branches) expression(branch.condition), block(branch.body);
        for (const syntax::CaseArm& arm : stmt.arms) {
            for (const syntax::CaseLabel& label : arm.labels) expression(label.low), expression(label.high);
            block(arm.body);
        }
        block(stmt.elseBody);
        if (!stmt.il) return;
        add(Piece::Name, stmt.il->op.range);
        expression(stmt.il->operand);
        arguments(stmt.il->arguments);
        block(stmt.il->body);
    }
    void body(const syntax::Body& body) {
        block(body.statements);
        if (!body.chart) return;
        for (const syntax::StepDecl* step : body.chart->steps) add(Piece::Statement, step->range);
        for (const syntax::TransitionDecl* each : body.chart->transitions) {
            add(Piece::Statement, each->range);
            expression(each->condition);
            block(each->ilCondition);
        }
        actions(body.chart->actions);
    }
    void actions(const std::vector<syntax::ActionDecl*>& all) {
        for (const syntax::ActionDecl* each : all) add(Piece::Declaration, each->range), body(each->body);
    }
    void pou(const syntax::Pou* pou) {
        if (!pou) return;
        add(Piece::Declaration, pou->range);
        add(Piece::Name, pou->name.range);
        type(pou->result);
        sections(pou->sections);
        body(pou->body);
        for (const syntax::Pou* method : pou->methods) this->pou(method);
        for (const syntax::Property* each : pou->properties) {
            add(Piece::Declaration, each->range);
            type(each->type);
            this->pou(each->get);
            this->pou(each->set);
        }
        actions(pou->actions);
    }
    void declaration(const syntax::Decl& decl) {
        add(Piece::Declaration, decl.range);
        pou(decl.pou);
        if (decl.type) type(decl.type->spec), expression(decl.type->initial);
        if (decl.globals) sections({decl.globals->section});
        if (decl.test) sections(decl.test->sections), block(decl.test->body);
        if (decl.configuration) sections(decl.configuration->sections);
        if (decl.space)
            for (const syntax::Decl* each : decl.space->declarations) declaration(*each);
    }

    std::string_view m_text;
    std::unique_ptr<syntax::SyntaxFile> m_file;
    std::array<std::vector<SourceRange>, kPieces> m_found;
};

class Random {
public:
    explicit Random(uint32_t seed) : m_state(seed * 2654435761u + 1) {}
    /// [0, below); 0 where below is.
    size_t next(size_t below) {
        m_state = m_state * 1664525u + 1013904223u;
        return below == 0 ? 0 : (m_state >> 8) % below;
    }

private:
    uint32_t m_state;
};

/// What an expression or a literal may be made to: where arithmetic and types have their edges.
constexpr std::string_view kEdges[] = {"0",
                                       "-1",
                                       "1",
                                       "TRUE",
                                       "FALSE",
                                       "32767",
                                       "-32768",
                                       "65535",
                                       "16#FFFF",
                                       "2147483647",
                                       "-2147483648",
                                       "LINT#-9223372036854775808",
                                       "1.0E308",
                                       "-1.0E-308",
                                       "T#0s",
                                       "T#49d",
                                       "LTIME#292y",
                                       "''",
                                       "'$00'",
                                       "NULL",
                                       "DT#1970-01-01-00:00:00",
                                       "REAL#0.0 / REAL#0.0",
                                       "THIS^",
                                       "ADR(x)",
                                       "[3(0)]",
                                       "(a := 1)"};

std::string sliceOf(std::string_view text, SourceRange range) {
    return std::string(text.substr(range.begin, range.end - range.begin));
}

constexpr Piece kAllPieces[] = {Piece::Declaration, Piece::Section, Piece::Variable, Piece::Type, Piece::Statement,
                                Piece::Expression,  Piece::Number,  Piece::Bound,    Piece::Name};
static_assert(std::size(kAllPieces) == kPieces);
constexpr Piece kDeclaring[] = {Piece::Variable, Piece::Bound, Piece::Type, Piece::Bound};

/// A range of one of the kinds that the text has, of the kinds by chance; false: it has none of any.
bool choose(const Pieces& pieces, std::span<const Piece> kinds, Random& random, Piece& kind, SourceRange& range) {
    const size_t first = random.next(kinds.size());
    for (size_t i = 0; i < kinds.size(); ++i) {
        kind = kinds[(first + i) % kinds.size()];
        const std::vector<SourceRange>& all = pieces.of(kind);
        if (all.empty()) continue;
        range = all[random.next(all.size())];
        return true;
    }
    return false;
}

std::string changedOnce(const std::string& text, std::string_view donor, const Pieces& lent,
                        std::span<const Piece> kinds, Random& random) {
    const Pieces own(text);
    Piece kind{};
    SourceRange here;
    if (!choose(own, kinds, random, kind, here)) return text + std::string(donor);
    const std::vector<SourceRange>&same = own.of(kind), &others = lent.of(kind);
    const std::string before = text.substr(0, here.begin), piece = sliceOf(text, here), after = text.substr(here.end);
    if ((kind == Piece::Number || kind == Piece::Bound) &&
        random.next(3) > 0) // bounds, ends of loops, lengths: one too many, one too few
        return before + std::to_string(std::stoll(piece) + (random.next(2) ? 1 : -1)) + after;
    switch (random.next(7)) {
    case 0: // one of the donor's in its place
        if (!others.empty()) return before + sliceOf(donor, others[random.next(others.size())]) + after;
        [[fallthrough]];
    case 1: // another of its own
        return before + sliceOf(text, same[random.next(same.size())]) + after;
    case 2: // one of the donor's behind it
        if (!others.empty()) return before + piece + "\n" + sliceOf(donor, others[random.next(others.size())]) + after;
        [[fallthrough]];
    case 3: // twice
        return before + piece + "\n" + piece + after;
    case 5: // one more of a list: arguments, indices, labels, values, dimensions
        return before + piece + ", " + sliceOf(text, same[random.next(same.size())]) + after;
    case 4:
        if (kind == Piece::Expression) return before + std::string(kEdges[random.next(std::size(kEdges))]) + after;
        return before + after; // not at all
    default:                   // the expression is part of a larger one
        if (kind != Piece::Expression) return before + after;
        return before + "(" + piece + (random.next(2) ? " + " : " = ") + sliceOf(text, same[random.next(same.size())]) +
               ")" + after;
    }
}

} // namespace

std::string mutateByGrammar(std::string_view text, std::string_view donor, uint32_t seed) {
    Random random(seed);
    std::string out(text);
    const Pieces lent(donor);
    // mostly one: of two, one is usually a mistake
    for (size_t changes = random.next(2) ? 1 : 1 + random.next(4); changes > 0 && out.size() < kLongest; --changes)
        out = changedOnce(out, donor, lent, kAllPieces, random);
    return out;
}

std::string redeclaredByGrammar(std::string_view text, uint32_t seed) {
    Random random(seed);
    std::string out(text);
    const Pieces lent(text);
    for (size_t changes = 1 + random.next(3); changes > 0 && out.size() < kLongest; --changes)
        out = changedOnce(out, text, lent, kDeclaring, random);
    return out;
}

} // namespace plc::fuzz
