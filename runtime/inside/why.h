// "Who set this?", "Why?" and "Why not?" (D13): answers from recorded scans. What is named as the trigger or as a way
// to another result was tried: the scan was run again with it taken back, or changed. One thread; the values it hands
// out are plain.
#pragma once
#include "runtime/compiler/driver/driver.h"
#include "runtime/inside/slice.h"

#include <map>

namespace plc::inside {

/// What is asked about: an ST expression, as seen from an instance, in whichever version of the program made the scan.
struct Question {
    std::string text;  // "IO.K1", "Main.level > 80"
    std::string scope; // "" = top
};

// ---------------------------------------------------------------- who

enum class WriterKind : uint8_t {
    Statement,
    Written,
    Forced,
    Reset,
    OnlineChange,
    Retain,
    Initial,
    SafeState,
    Resumed,
    Test,
    Unknown
};
struct CallStep {
    std::string function, instance;
    SourceRange range; // of the call; the outermost has none
};
struct Writer {
    WriterKind kind = WriterKind::Unknown;
    history::ScanStamp at;
    std::string path;          // of the variable that was written
    std::string before, value; // of the question, in words of ST; before: "" at the recording's begin
    std::string origin;        // Written, Forced: "panel Main, button Start"
    SourceRange range;         // Statement
    std::string function, instance, task;
    std::vector<CallStep> calls; // outermost first
    std::shared_ptr<const image::CompiledProgram> program;
};

// ---------------------------------------------------------------- why

/// A variable that plays a part, and since when it has its value.
struct Part {
    std::string path;
    std::string value, before; // before: of a trigger
    image::Place place;
    bool isClock = false, isFirstScan = false, isForces = false; // no variable
    std::string condition;                                       // the text that read it: "level > 80"
    bool isVerified = false;
    std::optional<Writer> writer; // who gave it its value
    std::vector<Part> because;    // of a trigger: its own triggers, a few levels deep
};

struct Explanation {
    Question question;
    std::string value;
    history::ScanStamp asked;  // the scan asked about
    history::ScanStamp since;  // it has had this value since then
    bool isSinceBegin = false; // of the recording
    std::string before;
    std::optional<Writer> writer; // that changed it, at `since`
    std::vector<Part> triggers;   // what changed
    std::vector<Part> enablers;   // what had to hold
    std::vector<Part> holding;    // what holds it in the scan asked about, where that is another one
    std::vector<Reason> steps;    // the way from the writer to the leaves, to unfold
    std::shared_ptr<const image::CompiledProgram> program;
    Message doubt; // where the scan did not come out as recorded
};

struct Change {
    std::string path, from, to;
    image::Place place;
};
struct WhyNot {
    Question question;
    std::string value, wanted;
    history::ScanStamp asked;
    std::vector<std::vector<Change>> ways; // each tried; the smallest first
    std::vector<Reason> steps;             // what kept it
    std::vector<Leaf> leaves;
    std::shared_ptr<const image::CompiledProgram> program;
    Message doubt;
};

class Reasoner {
public:
    explicit Reasoner(Insight& insight) : m_insight(insight) {}

    /// Who gave it the value that it has after the scan.
    [[nodiscard]] Result<Writer> lastWriter(const Question& question, Position at);
    /// All its changes in [from, to), oldest first, `limit` at most, those of the recording's first scan too; before
    /// them who gave it the value that the recording begins with, where that was written, forced or retained.
    [[nodiscard]] Result<std::vector<Writer>> writers(const Question& question, Position from, Position to,
                                                      size_t limit);
    /// The same at and before `at`, newest first; last who gave it the value it began with, where that is known.
    [[nodiscard]] Result<std::vector<Writer>> writersBackFrom(const Question& question, Position at, size_t limit);
    [[nodiscard]] Result<Explanation> why(const Question& question, Position at, uint32_t depth = 3);
    [[nodiscard]] Result<WhyNot> whyNot(const Question& question, Position at);

private:
    struct Asked;
    [[nodiscard]] Result<Asked> ask(const Question& question, Position at);
    [[nodiscard]] history::Recompile recompile(const Question& question) const;
    [[nodiscard]] std::vector<image::Place> placesOf(const Asked& asked) const;
    [[nodiscard]] Result<Writer> writerOf(const Question& question, const image::Place& place, Position at);
    [[nodiscard]] std::optional<Writer> outsideWriter(const image::Place& place, Position at,
                                                      const std::shared_ptr<const image::CompiledProgram>& program);
    [[nodiscard]] std::optional<Writer> firstWriter(const Question& question, Position first);
    [[nodiscard]] std::optional<Position> lastChange(const expression::Expression& expression, const Question& question,
                                                     Position at);
    void findTriggers(Explanation& answer, const Asked& asked, Position changed, const Slice& slice, uint32_t depth);
    void findEnablers(Explanation& answer, const Asked& asked, Position changed, const Slice& slice);
    [[nodiscard]] Part partOf(const Leaf& leaf, Position at, const image::CompiledProgram& program);
    [[nodiscard]] Position previousRun(Position at, uint32_t task, const image::CompiledProgram& program) const;
    [[nodiscard]] std::string outcomeOf(history::ScanInput input, const expression::Expression& expression);
    [[nodiscard]] const StatementMap& mapOf(const Look& look);

    /// The expression in a version of the program; kept.
    [[nodiscard]] Result<expression::Expression> compile(const Question& question,
                                                         const image::CompiledProgram& program) const;

    Insight& m_insight;
    mutable std::map<const image::CompiledProgram*, driver::Checked> m_checked;
    mutable std::map<std::tuple<const image::CompiledProgram*, std::string, std::string>,
                     Result<expression::Expression>>
        m_expressions;
    std::map<const tree::Program*, std::unique_ptr<StatementMap>> m_maps;
};

} // namespace plc::inside
