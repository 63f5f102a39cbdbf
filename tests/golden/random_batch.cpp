#include "tests/golden/random_batch.h"

#include "runtime/compiler/driver/reading.h"

#include <algorithm>
#include <ctime>
#include <set>

namespace plc::golden {

namespace {

/// A program of the batch in what was built.
struct Member {
    RandomProgram program;
    image::Root root;
    uint32_t function = 0;
};

class Batch {
public:
    Batch(uint32_t firstSeed, uint32_t count, Faults faults, BatchReport& report) : m_report(report) {
        for (uint32_t seed = firstSeed; seed < firstSeed + count; ++seed)
            m_programs.push_back(randomProgram(seed, faults, "P" + std::to_string(seed)));
    }

    void run(Depth depth) {
        const std::clock_t begin = std::clock();
        runQuick();
        m_report.quickSeconds = secondsSince(begin);
        if (depth == Depth::Full && !m_quick.empty()) compareRest();
        m_report.seconds = secondsSince(begin);
    }

private:
    [[nodiscard]] static double secondsSince(std::clock_t begin) {
        return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    }
    void runQuick() {
        if (!build()) return;
        m_quick = runs(m_built, m_members, Run::Newest);
        for (const Scanned& each : m_quick) ++(each.fault.empty() ? m_report.finished : m_report.faulted);
        compareEvaluator(m_quick);
    }
    void compareRest() {
        const std::vector<Scanned> asked = runs(m_built, m_members, Run::Asked);
        compare(m_quick, asked, "asked at every statement");
        for (size_t i = 0; i < asked.size(); ++i)
            if (asked[i].stops == 0) differs(i, "it was never asked");
        changeOnline(m_quick);
        if (const auto done = driver::optimise(m_built); !done) return differs(0, done.error().message.english());
        if (!hasOptimisedEntries()) return differs(0, "there is no optimised code of a program");
        compare(m_quick, runs(m_built, m_members, Run::Newest), "optimised");
    }

    void differs(size_t member, std::string what) {
        m_report.differences.push_back({m_members[member].program.seed, std::move(what)});
    }

    [[nodiscard]] static driver::BuildInput inputOf(const std::vector<RandomProgram>& programs,
                                                    const std::string& declaration = {}) {
        driver::BuildInput input;
        input.files.push_back({"prelude.st", randomPrelude()});
        std::string instances;
        for (const RandomProgram& each : programs) {
            std::string text = each.text;
            text.insert(text.find("\nVAR\n") + 5, declaration);
            input.files.push_back({each.name + ".st", std::move(text)});
            instances += "PROGRAM i" + each.name + " WITH T : " + each.name + ";\n";
        }
        input.files.push_back({"configuration.st", "CONFIGURATION C\nRESOURCE R ON PLC\n"
                                                   "TASK T(INTERVAL := T#10ms, PRIORITY := 1);\n" +
                                                       instances + "END_RESOURCE\nEND_CONFIGURATION\n"});
        return input;
    }

    /// Drops what has an error by chance, until the rest has none; false: there is an error that should not be.
    bool build() {
        driver::KeptFiles kept;
        for (;;) {
            const driver::BuildInput input = inputOf(m_programs);
            const driver::Checked checked = driver::check(input, kept);
            if (checked.analysis->hasErrors) {
                if (!dropMistaken(checked)) return false;
                continue;
            }
            m_built = driver::build(checked, input);
            if (m_built.program) break;
            m_report.differences.push_back({m_programs.front().seed, "it is not built: " + m_built.failure.english()});
            return false;
        }
        m_members = membersOf(m_built, m_programs);
        return !m_members.empty();
    }
    bool dropMistaken(const driver::Checked& checked) {
        std::set<std::string> mistaken;
        for (const diagnostics::Diagnostic& each : checked.analysis->diagnostics) {
            if (each.severity != diagnostics::Severity::Error) continue;
            const std::string path((*checked.sources)[each.range.file].path());
            mistaken.insert(path);
            if (isByChance(each)) continue;
            const uint32_t seed = path.front() == 'P' ? std::strtoul(path.c_str() + 1, nullptr, 10) : 0;
            m_report.differences.push_back({seed, diagnostics::renderText(*checked.sources, each, false)});
            return false;
        }
        m_report.dropped += std::erase_if(
            m_programs, [&](const RandomProgram& program) { return mistaken.contains(program.name + ".st"); });
        return !m_programs.empty();
    }
    [[nodiscard]] static std::vector<Member> membersOf(const driver::Built& built,
                                                       const std::vector<RandomProgram>& programs) {
        std::vector<Member> members;
        const image::Task& task = built.program->tasks.front();
        for (size_t i = 0; i < programs.size() && i < task.programs.size(); ++i)
            members.push_back(
                {programs[i], built.program->layout.roots[task.programs[i].root], task.programs[i].function});
        return members;
    }

    /// Each program for itself from the initial image: a fault of one leaves the others alone.
    [[nodiscard]] static std::vector<Scanned> runs(const driver::Built& built, const std::vector<Member>& members,
                                                   Run run) {
        controller::Controller controller(built.program, randomSettings());
        size_t stops = 0;
        if (run == Run::Asked) askAtEveryStatement(controller, stops);
        const std::vector<std::byte> initial(controller.image().begin(), controller.image().end());
        std::vector<Scanned> all;
        for (const Member& member : members) {
            controller.resumeFrom(built.program, initial, 0, {});
            stops = 0;
            all.push_back(runsOf(controller, member));
            all.back().stops = stops;
        }
        return all;
    }
    [[nodiscard]] static Scanned runsOf(controller::Controller& controller, const Member& member) {
        Scanned out;
        const uint32_t size = controller.program().layout.types->operator[](member.root.type).size;
        for (int i = 0; i < kScans && !controller.fault(); ++i) {
            (void)controller.runFunction(member.function, member.root.offset);
            const auto bytes = controller.image().subspan(member.root.offset, size);
            out.images.emplace_back(bytes.begin(), bytes.end());
        }
        takeFault(controller, out);
        return out;
    }

    void compare(const std::vector<Scanned>& quick, const std::vector<Scanned>& other, const std::string& how) {
        for (size_t i = 0; i < quick.size(); ++i) {
            const image::Root& root = m_members[i].root;
            const std::string found = differenceBetween(*m_built.program, root, quick[i], other[i], root.offset);
            if (!found.empty()) differs(i, how + ": " + found);
        }
    }
    void compareEvaluator(const std::vector<Scanned>& quick) {
        std::vector<std::byte> image(m_built.program->initialImage);
        for (size_t i = 0; i < quick.size(); ++i) {
            const Member& member = m_members[i];
            std::ranges::copy(quick[i].images.back(), image.begin() + member.root.offset);
            const std::string found =
                evaluatedOtherwise(m_built, image::Layout::pathOf(member.root), member.program, quick[i], image);
            if (!found.empty()) differs(i, found);
        }
    }
    bool hasOptimisedEntries() const {
        const auto& entries = m_built.program->optimised.load()->entries;
        return std::ranges::all_of(m_members,
                                   [&](const Member& member) { return entries[member.function] != nullptr; });
    }

    /// Half way the project gets a variable more in each program, which moves all others: no value changes.
    void changeOnline(const std::vector<Scanned>& expected) {
        const driver::Built other = driver::build(inputOf(m_programs, "added : LINT := 7;\n"));
        if (!other.program) return differs(0, "it is not built with a variable more");
        const std::vector<Member> after = membersOf(other, m_programs);
        controller::Controller controller(m_built.program, randomSettings());
        const auto runAll = [&](const std::vector<Member>& members) {
            for (int scan = 0; scan < kScans / 2; ++scan)
                for (size_t i = 0; i < members.size(); ++i)
                    if (expected[i].fault.empty() &&
                        !controller.runFunction(members[i].function, members[i].root.offset))
                        return differs(i, "it faulted beside an online change");
        };
        runAll(m_members);
        const auto report = controller.changeProgram(other.program);
        if (!report.refusal.isEmpty()) return differs(0, report.refusal.english());
        if (!report.lost.empty()) return differs(0, "an online change lost " + report.lost.front());
        runAll(after);
        for (size_t i = 0; i < after.size(); ++i)
            if (expected[i].fault.empty()) compareChanged(controller, i, expected[i]);
    }
    void compareChanged(const controller::Controller& controller, size_t index, const Scanned& expected) {
        const image::Root& root = m_members[index].root;
        const auto& types = *m_built.program->layout.types;
        m_built.program->layout.forEachLeaf(
            image::Layout::pathOf(root), {root.type, root.offset, root.bit},
            [&](const std::string& path, const image::Place& place) {
                if (types.kind(place.type) == types::TypeKind::Interface) return true; // another offset, the same block
                const auto now = controller.read(path);
                const std::string before = types::toText(
                    types,
                    types::readValue(types, place.type,
                                     std::span(expected.images.back()).subspan(place.offset - root.offset), place.bit));
                const std::string text =
                    now ? types::toText(*controller.program().layout.types, *now) : now.error().message.english();
                if (text == before) return true;
                differs(index, "after an online change, " + path + ": " + before + " and " + text);
                return false;
            });
    }

    std::vector<RandomProgram> m_programs;
    BatchReport& m_report;
    driver::Built m_built;
    std::vector<Member> m_members;
    std::vector<Scanned> m_quick;
};

} // namespace

BatchReport runBatch(uint32_t firstSeed, uint32_t count, Faults faults, Depth depth) {
    BatchReport report;
    Batch(firstSeed, count, faults, report).run(depth);
    return report;
}

} // namespace plc::golden
