// Power flow of the examples: at the recorded scans of their tests, what a ladder and a function block diagram show is
// held against every sub-expression evaluated for itself, by the evaluator of watches, on the image as it was when its
// statement began; the variables of methods and functions, which lie in frames, are put into the expression as they
// were then. STEPWISE_LONG=1 takes every scan.
#include "tests/examples/example_names.h"

#include "projects/session/session.h"
#include "projects/storage/project_file.h"
#include "projects/testing/test_run.h"
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/flow.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/inside/place_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

namespace plc {
namespace {

using inside::Event;
using inside::Look;
using ladder::NodeId;
using ladder::NodeKind;
using ladder::Power;

/// Three values: not executed, or not known to the evaluator.
using Truth = std::optional<bool>;
struct Known {
    Truth truth;
    std::string text;
    bool isExecuted = false;
};

constexpr size_t kClockEnd = 24; // of the image's header

uint64_t keyOf(SourceRange range) { return uint64_t(range.begin) << 32 | range.end; }

/// A unit of the project's sources in both forms.
struct Drawn {
    ladder::Unit unit;
    std::vector<uint32_t> functions; // of the program, that run it
    std::vector<ladder::Diagram> forms;
    std::vector<SourceRange> statements; // as they are reported
    bool mayLeave = false;               // by RETURN or a jump: then a rung need not be executed
    /// What is asked of each statement: its sub-expressions.
    std::map<uint64_t, std::vector<SourceRange>> asked;
};

struct Text {
    FileId id;
    std::string_view text;
    std::unique_ptr<syntax::SyntaxFile> file;
    std::vector<Drawn> units;
};

void gatherStatements(const syntax::Block& block, std::vector<SourceRange>& out, bool& mayLeave) {
    for (const syntax::Stmt* stmt : block) {
        mayLeave |= stmt->kind == syntax::StmtKind::Return || stmt->kind == syntax::StmtKind::Jump;
        if (stmt->kind == syntax::StmtKind::Empty || stmt->kind == syntax::StmtKind::Label) continue;
        if (stmt->kind == syntax::StmtKind::Repeat)
            out.push_back(stmt->value->range);
        else if (stmt->kind != syntax::StmtKind::Case)
            out.push_back(ladder::reportedRange(*stmt));
        else
            out.push_back({stmt->range.file, stmt->range.begin, stmt->value->range.end});
        for (size_t i = 1; i < stmt->branches.size(); ++i)
            if (stmt->branches[i].condition) out.push_back(stmt->branches[i].condition->range);
        for (const syntax::IfBranch& branch : stmt->branches) gatherStatements(branch.body, out, mayLeave);
        for (const syntax::CaseArm& arm : stmt->arms) gatherStatements(arm.body, out, mayLeave);
        gatherStatements(stmt->body, out, mayLeave);
        gatherStatements(stmt->elseBody, out, mayLeave);
    }
}

/// The innermost statement whose text holds the place.
std::optional<SourceRange> ownerOf(const Drawn& drawn, SourceRange place) {
    std::optional<SourceRange> best;
    for (const SourceRange& each : drawn.statements)
        if (each.begin <= place.begin && place.end <= each.end && (!best || each.length() < best->length()))
            best = each;
    return best;
}

void ask(Drawn& drawn, SourceRange place) {
    if (place.length() == 0) return;
    if (const auto owner = ownerOf(drawn, place)) {
        auto& all = drawn.asked[keyOf(*owner)];
        if (std::find(all.begin(), all.end(), place) == all.end()) all.push_back(place);
    }
}

/// What was compared in all scans.
struct Counts {
    size_t compared = 0, unknown = 0, values = 0, notExecuted = 0, inFrames = 0;
};

class Flow {
public:
    Flow(const session::Session& session, Counts& counts)
        : m_session(&session), m_counts(counts), m_program(session.program()) {
        std::vector<const syntax::SyntaxFile*> files;
        for (size_t i = 0; i < m_program->sources.files.size(); ++i) {
            const SourceText& source = m_program->sources.files[i];
            diagnostics::Sink sink;
            m_texts.push_back({FileId(i), source.text(), parse::parseFile(FileId(i), source.text(), sink), {}});
            files.push_back(m_texts.back().file.get());
        }
        m_types = std::make_unique<ladder::DeclaredTypes>(files);
        std::set<size_t> own;
        for (const image::FunctionInfo& function : m_program->functions)
            if (function.library.empty() && function.declaration.file.isValid())
                own.insert(function.declaration.file.index());
        for (Text& text : m_texts)
            if (own.count(text.id.index())) draw(text);
    }

    [[nodiscard]] bool isOf(const session::Session& session) const { return session.program() == m_program; }
    /// Of the same program.
    void setSession(const session::Session& session) { m_session = &session; }

    void compareScan(const Look& look, const std::shared_ptr<const Look>& owner) {
        ASSERT_TRUE(look.isExact());
        if (look.fault()) return;                                 // a scan that was left in the middle
        std::unordered_map<uint32_t, std::vector<uint32_t>> runs; // by function
        for (uint32_t i = 0; i < look.activations().size(); ++i) runs[look.activations()[i].function].push_back(i);
        std::vector<UnitRun> units;
        for (const Text& text : m_texts)
            for (const Drawn& drawn : text.units)
                for (const uint32_t function : drawn.functions)
                    if (const auto found = runs.find(function); found != runs.end())
                        addRuns(text, drawn, function, found->second, look, units);
        follow(look, units);
        for (const UnitRun& unit : units) {
            const inside::PlaceValues places(owner, unit.text->id, unit.instance);
            for (const ladder::Diagram& diagram : unit.drawn->forms) compareDiagram(unit, diagram, places);
        }
    }

private:
    using KnownAt = std::map<uint64_t, Known>;

    void draw(Text& text) {
        for (const ladder::Unit& unit : ladder::unitsOf(*text.file)) {
            if (unit.body->language != syntax::BodyLanguage::St) continue;
            Drawn drawn;
            drawn.unit = unit;
            gatherStatements(unit.body->statements, drawn.statements, drawn.mayLeave);
            for (const ladder::Form form : {ladder::Form::Ladder, ladder::Form::Blocks}) {
                drawn.forms.push_back(ladder::project(text.text, *text.file, unit, *m_types, form));
                const ladder::Diagram& diagram = drawn.forms.back();
                for (size_t i = 0; i < diagram.nodes.size(); ++i) {
                    ask(drawn, ladder::questionOf(text.text, diagram, NodeId(i)).range);
                    if (diagram.nodes[i].expr) ask(drawn, diagram.nodes[i].expr->range);
                }
            }
            for (size_t i = 0; i < m_program->functions.size(); ++i)
                if (m_program->functions[i].name == unit.name && m_program->functions[i].declaration.file == text.id)
                    drawn.functions.push_back(static_cast<uint32_t>(i));
            text.units.push_back(std::move(drawn));
        }
    }

    /// The run of a method or function whose variables lie in a frame.
    struct Frame {
        const image::FunctionInfo* function = nullptr;
        uint32_t offset = 0;
    };

    /// The only run of a unit's instance in a scan, and what was found of it.
    struct UnitRun {
        const Text* text;
        const Drawn* drawn;
        std::string instance;
        uint32_t activation;
        Frame frame;
        KnownAt known;
    };

    /// A variable of the frame as ST writes its value; nothing where that cannot be written or is not its own.
    std::optional<std::string> literalOf(const image::FunctionLocal& local, const Frame& frame,
                                         std::span<const std::byte> image) const {
        const types::TypeTable& types = *m_program->layout.types;
        const bool isPlain = !local.isInOut && !types.isAggregate(local.type) && !types.isText(local.type) &&
                             types.kind(local.type) == types.storageKind(local.type);
        const size_t at = size_t(frame.offset) + local.frameOffset;
        if (!isPlain || at + types[local.type].size > image.size()) return std::nullopt;
        const std::string text = types::toText(types, types::readValue(types, local.type, image.subspan(at), -1));
        if (text.empty() || text.find_first_of("0123456789TF") == std::string::npos) return std::nullopt; // no number
        const bool isTyped =
            types::isInteger(types.family(local.type)) || types.family(local.type) == types::Family::Real;
        return "(" + (isTyped ? types[local.type].name + "#" + text : text) + ")";
    }

    /// The expression with the frame's variables as values; nothing where one has none.
    std::optional<std::string> withValues(const std::string& words, const Frame& frame,
                                          std::span<const std::byte> image) const {
        if (words.find_first_of("'\"{") != std::string::npos) return std::nullopt;
        const auto isWord = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
        std::string out;
        for (size_t i = 0; i < words.size();) {
            size_t end = i;
            while (end < words.size() && isWord(words[end])) ++end;
            if (end == i) {
                out += words[i++];
                continue;
            }
            const std::string word = words.substr(i, end - i);
            const bool isMember = i > 0 && (words[i - 1] == '.' || words[i - 1] == '#');
            const auto& locals = frame.function->locals;
            const auto local = std::find_if(locals.begin(), locals.end(), [&](const image::FunctionLocal& each) {
                return foldCase(each.name) == foldCase(word);
            });
            i = end;
            if (isMember || local == locals.end()) {
                out += word;
                continue;
            }
            const auto literal = literalOf(*local, frame, image);
            if (!literal) return std::nullopt;
            out += *literal;
        }
        return out;
    }

    Known evaluate(const Text& text, SourceRange range, const std::string& instance, std::span<const std::byte> image,
                   const Frame& frame) {
        Known known;
        known.isExecuted = true;
        std::string words(text.text.substr(range.begin, range.length()));
        if (frame.function) {
            auto filled = withValues(words, frame, image);
            if (!filled) return known;
            words = std::move(*filled);
        }
        const auto expression = m_session->expression(words, instance);
        if (!expression) return known;
        const expression::Outcome outcome = expression->evaluate(image);
        if (!outcome.hasValue()) return known;
        known.text = types::toText(expression->types(), outcome.value);
        if (expression->types().storageKind(expression->type()) == types::TypeKind::Bool)
            known.truth = outcome.value.isTrue();
        return known;
    }

    [[nodiscard]] bool isOfSimulation(const Look& look, uint32_t activation) const {
        const uint32_t task = look.activations()[activation].task;
        return task < m_program->tasks.size() && m_program->tasks[task].isSimulation;
    }

    /// Between the simulation and the tasks of the PLC, once: each program reads what the one before it wrote.
    static void applyForces(const Look& look, std::vector<std::byte>& image) {
        for (const image::ForcedBytes& force : look.input().start.forces) {
            if (force.bit < 0) {
                std::copy(force.bytes.begin(), force.bytes.end(), image.begin() + force.offset);
                continue;
            }
            const auto mask = static_cast<std::byte>(1 << force.bit);
            image[force.offset] = (image[force.offset] & ~mask) | (force.bytes.at(0) & mask);
        }
    }

    /// The bytes of a long write that later ones of the scan overwrite: the image at its end does not have them.
    static void addOverwritten(const Look& look, size_t write, std::set<uint32_t>& bytes) {
        const Event& whole = look.events()[write];
        for (size_t i = write + 1; i < look.events().size(); ++i) {
            const Event& event = look.events()[i];
            if (event.kind != image::WatchKind::Write) continue;
            const uint32_t begin = std::max(event.offset, whole.offset + 8);
            const uint32_t end = std::min(event.offset + event.size, whole.offset + whole.size);
            for (uint32_t byte = begin; byte < end; ++byte) bytes.insert(byte);
        }
    }

    /// Follows the scan's writes and evaluates what each statement of the units asks, as it begins.
    void follow(const Look& look, std::vector<UnitRun>& units) {
        std::unordered_map<uint32_t, std::vector<UnitRun*>> byActivation;
        for (UnitRun& unit : units) byActivation[unit.activation].push_back(&unit);
        std::vector<std::byte> image = look.input().image;
        std::memcpy(image.data(), look.image().data(), kClockEnd); // set when the scan began
        bool isForced = false;
        std::set<uint32_t> doubtful; // bytes of a long write that a later one has overwritten: not known in between
        for (size_t i = 0; i < look.events().size(); ++i) {
            const Event& event = look.events()[i];
            if (event.kind == image::WatchKind::Begin && !isForced && !isOfSimulation(look, event.activation)) {
                applyForces(look, image);
                isForced = true;
            }
            if (event.kind == image::WatchKind::Write && event.offset + event.size <= image.size()) {
                doubtful.erase(doubtful.lower_bound(event.offset), doubtful.lower_bound(event.offset + event.size));
                if (event.size > 8) {
                    addOverwritten(look, i, doubtful);
                    std::memcpy(image.data() + event.offset, look.image().data() + event.offset, event.size);
                }
                std::memcpy(image.data() + event.offset, &event.bits, std::min<uint32_t>(event.size, 8));
            }
            if (event.kind != image::WatchKind::Statement) continue;
            const auto found = byActivation.find(event.activation);
            if (found == byActivation.end()) continue;
            for (UnitRun* unit : found->second)
                if (event.stmt()->range.file == unit->text->id) askAt(event.stmt()->range, *unit, image, doubtful);
        }
    }

    /// What is asked at a statement that begins.
    void askAt(SourceRange statement, UnitRun& unit, std::vector<std::byte>& image,
               const std::set<uint32_t>& doubtful) {
        unit.known[keyOf(statement)].isExecuted = true;
        const auto asked = unit.drawn->asked.find(keyOf(statement));
        if (asked == unit.drawn->asked.end()) return;
        for (const SourceRange& range : asked->second) {
            Known value = evaluate(*unit.text, range, unit.instance, image, unit.frame);
            if (!doubtful.empty()) { // what changes with them is not known
                const auto flip = [&] {
                    for (const uint32_t byte : doubtful) image[byte] = ~image[byte];
                };
                flip();
                if (evaluate(*unit.text, range, unit.instance, image, unit.frame).text != value.text) value = {};
                flip();
            }
            Known& at = unit.known[keyOf(range)];
            value.isExecuted = true;
            at = std::move(value);
        }
    }

    void addRuns(const Text& text, const Drawn& drawn, uint32_t functionIndex, const std::vector<uint32_t>& all,
                 const Look& look, std::vector<UnitRun>& units) {
        const image::FunctionInfo& function = m_program->functions[functionIndex];
        std::map<std::string, std::vector<uint32_t>> runs; // by instance
        for (const uint32_t i : all)
            runs[function.instanceType.isValid() ? look.instanceOf(i) : std::string()].push_back(i);
        for (const auto& [instance, activations] : runs) {
            if (activations.size() != 1) continue; // places tell of the last run only
            Frame frame;
            if (!function.locals.empty()) frame = {&function, look.activations()[activations[0]].frame};
            m_counts.inFrames += frame.function ? 1 : 0;
            units.push_back({&text, &drawn, instance, activations[0], frame, {}});
        }
    }

    void compareDiagram(const UnitRun& unit, const ladder::Diagram& diagram, const inside::PlaceValues& places) {
        const Text& text = *unit.text;
        const KnownAt& known = unit.known;
        const ladder::Answers answers = [&](const ladder::Question& question) {
            if (const auto* value = places.at(question.range)) return value->value.isTrue() ? Power::On : Power::Off;
            // Not computed, so a constant: a variable of a frame is none.
            const Known constant = evaluate(text, question.range, unit.instance, places.look().image(), unit.frame);
            return !constant.truth ? Power::Unknown : *constant.truth ? Power::On : Power::Off;
        };
        const ladder::Executed isExecuted = [&](SourceRange range) { return places.isExecuted(range); };
        std::vector<Power> power(diagram.nodes.size(), Power::Unknown);
        for (const ladder::Rung& rung : diagram.rungs) {
            ladder::computeFlow(text.text, diagram, rung, answers, power, isExecuted);
            const std::string where = m_session->program()->sources.files[text.id.index()].path() + " " +
                                      unit.instance + " scan " + std::to_string(places.look().position()) + ": " +
                                      std::string(text.text.substr(rung.range.begin, rung.range.length()));
            const bool isReached = ladder::isRungExecuted(diagram, rung, isExecuted);
            m_counts.notExecuted += isReached ? 0 : 1;
            const bool mustBe = rung.depth == 0 && rung.kind == ladder::RungKind::Logic && !unit.drawn->mayLeave;
            EXPECT_TRUE(isReached || !mustBe) << where;
            const Truth rail = isReached ? Truth(true) : Truth();
            const Truth shared =
                rung.power.isValid() ? compareNode(diagram, rung.power, rail, known, power, where) : rail;
            for (const ladder::Branch& branch : rung.branches)
                if (branch.tail.isValid()) (void)compareNode(diagram, branch.tail, shared, known, power, where);
        }
        for (size_t i = 0; i < diagram.nodes.size(); ++i) compareValue(text, diagram, NodeId(i), known, places);
    }

    static Truth both(Truth a, Truth b) {
        if ((a && !*a) || (b && !*b)) return false;
        return a && b ? Truth(true) : Truth();
    }

    /// What the sub-expressions say is behind a node; held against the picture.
    Truth compareNode(const ladder::Diagram& diagram, NodeId id, Truth before, const KnownAt& known,
                      const std::vector<Power>& power, const std::string& where) {
        const ladder::Node& node = diagram[id];
        Truth behind;
        if (node.kind == NodeKind::Series) {
            Truth at = before;
            for (const NodeId child : node.children) at = compareNode(diagram, child, at, known, power, where);
            behind = at;
            if (node.expr) behind = both(before, valueOf(known, node.expr->range));
        } else if (node.kind == NodeKind::Parallel || node.kind == NodeKind::Invert) {
            for (const NodeId child : node.children)
                if (!node.isShort) (void)compareNode(diagram, child, before, known, power, where);
            behind = both(before, valueOf(known, node.expr->range));
        } else if (node.kind == NodeKind::Box && !node.instance.empty()) {
            return flowOf(power[id.index()]);        // its output is the next statement's
        } else if (node.kind == NodeKind::Operand) { // a circle at the pin inverts it
            behind = both(before, valueOf(known, node.operand->range));
        } else if (node.expr) {
            behind = both(before, valueOf(known, node.expr->range));
        }
        if (!behind) {
            ++m_counts.unknown;
            return behind;
        }
        ++m_counts.compared;
        EXPECT_EQ(static_cast<int>(power[id.index()]), static_cast<int>(*behind ? Power::On : Power::Off))
            << where << "\n  behind " << node.label << " " << node.op;
        return behind;
    }

    static Truth flowOf(Power power) { return power == Power::Unknown ? Truth() : Truth(power == Power::On); }

    static Truth valueOf(const KnownAt& known, SourceRange range) {
        const auto at = known.find(keyOf(range));
        return at == known.end() ? Truth() : at->second.truth;
    }

    /// What stands at pins and contacts is the value that was read there.
    void compareValue(const Text& text, const ladder::Diagram& diagram, NodeId id, const KnownAt& known,
                      const inside::PlaceValues& places) {
        const ladder::Question question = ladder::questionOf(text.text, diagram, id);
        const auto at = known.find(keyOf(question.range));
        const auto* shown = places.at(question.range);
        if (!shown || at == known.end() || at->second.text.empty()) return;
        const types::TypeTable& types = *m_program->layout.types;
        // Of a long write only the beginning is known here, so texts cannot be followed; a REAL whose literals stand
        // alone is computed as LREAL by the evaluator.
        if (!shown->value.type.isValid() || types.isText(shown->value.type) || types.isAggregate(shown->value.type))
            return;
        ++m_counts.values;
        if (types.family(shown->value.type) == types::Family::Real) {
            const double here = std::strtod(types::toText(types, shown->value).c_str(), nullptr);
            const double there = std::strtod(at->second.text.c_str(), nullptr);
            // what is left of a difference has the rounding of its operands
            EXPECT_LE(std::abs(here - there), 1e-5 * std::max({std::abs(here), std::abs(there), 0.1})) << question.text;
            return;
        }
        EXPECT_EQ(types::toText(*m_program->layout.types, shown->value), at->second.text)
            << question.text << " scan " << places.look().position();
    }

    const session::Session* m_session;
    Counts& m_counts;
    std::shared_ptr<const image::CompiledProgram> m_program;
    std::vector<Text> m_texts;
    std::unique_ptr<ladder::DeclaredTypes> m_types;
};

class ExampleFlow : public ::testing::TestWithParam<std::string> {};

TEST_P(ExampleFlow, IsTheValueOfEverySubExpressionWhereItWasComputed) {
    const auto project = projects::openProject({exampleFolder(GetParam())});
    ASSERT_TRUE(project) << project.error().english();
    // of each test; with sanitizers, which are after something else, fewer
    const char* given = std::getenv("STEPWISE_FLOW_SCANS");
    const history::Position wanted = given ? std::max(1, std::atoi(given)) : 40;
    const bool takesAll = std::getenv("STEPWISE_LONG") != nullptr;
    size_t scans = 0;
    Counts counts;
    std::optional<Flow> flow; // drawn once: the TESTs run the same program
    const auto code = std::make_shared<inside::WatchedCode>();
    plc::testing::Options options;
    options.finished = [&](session::Session& session) {
        if (flow && flow->isOf(session))
            flow->setSession(session);
        else
            flow.emplace(session, counts);
        inside::Insight insight(session.history(), code);
        const history::Statistics all = session.history().statistics();
        const history::Position step = takesAll ? 1 : std::max<history::Position>(1, (all.end - all.first) / wanted);
        for (history::Position at = all.first; at < all.end; at += step) {
            const auto look = insight.look(at);
            if (!look) continue; // the first one of an evicted recording
            if ((*look)->leftOut() > 0) continue;
            flow->compareScan(**look, *look);
            ++scans;
        }
    };
    const auto report = plc::testing::runTests(*project, options);
    ASSERT_TRUE(report) << report.error().english();
    std::printf("%s: %zu scans, %zu places of power, %zu values, %zu rungs not executed, %zu runs of methods and "
                "functions, %zu not known\n",
                GetParam().c_str(), scans, counts.compared, counts.values, counts.notExecuted, counts.inFrames,
                counts.unknown);
    EXPECT_GT(scans, 0u);
    EXPECT_GT(counts.compared + counts.values, 0u);
}

INSTANTIATE_TEST_SUITE_P(All, ExampleFlow, ::testing::ValuesIn(exampleNames()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace plc
