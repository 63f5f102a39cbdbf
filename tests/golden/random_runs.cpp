#include "tests/golden/random_runs.h"

#include <algorithm>

namespace plc::golden {

controller::Settings randomSettings() {
    controller::Settings made;
    made.loopBudgetPerScan = 1'000'000;
    return made;
}

void takeFault(const controller::Controller& controller, Scanned& into) {
    if (!controller.fault()) return;
    const controller::Fault& fault = *controller.fault();
    const SourceSet& sources = controller.program().sources;
    const auto line = [&](const SourceRange& range) {
        if (!range.file.isValid()) return std::string("?");
        return std::to_string(sources[range.file].lineColumn(range.begin).line);
    };
    into.faultMessage = fault.message.english();
    into.fault = into.faultMessage + " at line " + line(fault.range);
    for (const controller::FaultFrame& frame : fault.calls)
        into.fault += ", in " + frame.function + " (" + frame.instance + ") line " + line(frame.range);
    if (!fault.range.file.isValid()) return;
    const std::string_view text = sources[fault.range.file].text();
    const size_t begin = text.rfind('\n', fault.range.begin) + 1; // npos + 1 == 0
    into.faultLine = text.substr(begin, text.find('\n', begin) - begin);
}

void askAtEveryStatement(controller::Controller& controller, size_t& stops) {
    controller.useQuickCode(true);
    controller.setSiteHook([&stops](uint32_t, uint32_t, uint32_t) { ++stops; });
    std::ranges::fill(controller.siteFlags(), uint8_t(1));
}

std::string differenceIn(const image::CompiledProgram& program, const image::Root& root,
                         const std::vector<std::byte>& a, const std::vector<std::byte>& b, uint32_t from) {
    if (a == b) return {};
    std::string difference;
    const auto& types = *program.layout.types;
    program.layout.forEachLeaf(
        root.name, {root.type, root.offset, root.bit}, [&](const std::string& path, const image::Place& place) {
            const auto text = [&](const std::vector<std::byte>& image) {
                return types::toText(types, types::readValue(types, place.type,
                                                             std::span(image).subspan(place.offset - from), place.bit));
            };
            if (text(a) == text(b)) return true;
            difference = path + ": " + text(a) + " and " + text(b);
            return false;
        });
    return difference;
}

std::string differenceBetween(const image::CompiledProgram& program, const image::Root& root, const Scanned& a,
                              const Scanned& b, uint32_t from) {
    if (a.fault != b.fault) return "fault: " + a.fault + "\nother: " + b.fault;
    if (a.images.size() != b.images.size()) return "one run has made fewer scans";
    for (size_t i = 0; i < a.images.size(); ++i)
        if (const std::string difference = differenceIn(program, root, a.images[i], b.images[i], from);
            !difference.empty())
            return "scan " + std::to_string(i) + ", " + difference;
    return {};
}

namespace {

/// One watched expression on an image; `stored` is what the program computed, or the fault that it had there.
std::string otherwise(const driver::Built& built, const std::string& instance, const std::string& expr,
                      const image::Place& place, const std::string* fault, std::span<const std::byte> image) {
    const auto expression = driver::compileExpression(built.checked, expr, instance);
    if (!expression) { // calls of functions are not for watches
        const bool calls = expr.find("Mixed(") != std::string::npos || expr.find(".Add(") != std::string::npos ||
                           expr.find(".Share(") != std::string::npos || expr.find(".Level") != std::string::npos;
        return calls ? std::string() : expr + ": " + expression.error().message.english();
    }
    const auto& types = expression->types();
    const auto outcome = expression->evaluate(image);
    const std::string value = outcome.hasValue() ? types::toText(types, outcome.value) : outcome.reason.english();
    if (types.isText(place.type) && outcome.hasValue() && !fault &&
        std::get<std::string>(outcome.value.data).size() > types[place.type].capacity)
        return {}; // cut when it was stored
    const std::string computed =
        fault ? *fault
              : types::toText(types, types::readValue(types, place.type, image.subspan(place.offset), place.bit));
    return value == computed ? std::string() : expr + ": evaluated " + value + ", computed " + computed;
}

} // namespace

std::string evaluatedOtherwise(const driver::Built& built, const std::string& instance, const RandomProgram& program,
                               const Scanned& run, std::span<const std::byte> image) {
    const auto isFaulty = [&](const auto& watched) { return run.faultLine.starts_with(watched.first + " := "); };
    const bool isWatched = std::ranges::any_of(program.watched, isFaulty);
    if (!run.fault.empty() && !isWatched) return {}; // the expressions have values of the scan before
    for (const auto& watched : program.watched) {
        const auto place = built.program->layout.find(instance + "." + watched.first);
        if (!place) return place.error().english();
        const bool isFault = !run.fault.empty() && isFaulty(watched);
        const std::string found =
            otherwise(built, instance, watched.second, *place, isFault ? &run.faultMessage : nullptr, image);
        if (!found.empty() || isFault) return found;
    }
    return {};
}

bool isByChance(const diagnostics::Diagnostic& diagnostic) {
    return diagnostic.kind == diagnostics::Kind::ConstantIndexOutOfRange ||
           diagnostic.kind == diagnostics::Kind::DivisionByConstantZero;
}

} // namespace plc::golden
