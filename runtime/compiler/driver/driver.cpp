#include "runtime/compiler/driver/driver.h"
#include "runtime/base/messages.h"

#include "runtime/base/text.h"
#include "runtime/compiler/codegen/codegen.h"
#include "runtime/compiler/driver/expression_compiler.h"
#include "runtime/compiler/driver/keeps_analysis.h"
#include "runtime/compiler/facts/debug_map.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/compiler/sema/kept_bodies.h"
#include "runtime/image/portable_program.h"
#include "runtime/library/sources.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace plc::driver {

namespace {

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

bool isNameByte(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

/// Every name in a text, folded; ".name" when it stands behind a dot.
void gatherNames(std::string_view text, std::unordered_set<std::string>& out) {
    for (size_t at = 0; at < text.size();) {
        if (!isNameByte(text[at])) {
            ++at;
            continue;
        }
        const size_t begin = at;
        while (at < text.size() && isNameByte(text[at])) ++at;
        const bool isMember = begin > 0 && text[begin - 1] == '.';
        out.insert((isMember ? "." : "") + foldCase(text.substr(begin, at - begin)));
    }
}

uint64_t mix(uint64_t hash, std::string_view bytes) {
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    return (hash ^ bytes.size()) * 1099511628211ull;
}

/// Names code and layout: the same sources give the same version.
uint64_t versionOf(const BuildInput& input) {
    uint64_t hash = 14695981039346656037ull;
    for (const SourceFile& file : input.files) hash = mix(mix(hash, file.path), file.text);
    for (const std::string& library : input.libraries) hash = mix(hash, library);
    for (const std::string& define : input.defines) hash = mix(hash, define);
    if (input.addressing == image::Addressing::Words) hash = mix(hash, "%word");
    if (input.memoryForNew) hash = mix(hash, "%new" + std::to_string(input.memoryForNew));
    if (input.strings != types::StringCode::Latin1) hash = mix(mix(hash, "%strings"), nameOf(input.strings));
    for (const auto& [name, text] : input.libraryTexts) hash = mix(mix(hash, name), text);
    return hash;
}

std::shared_ptr<image::CompiledProgram> assemble(const Checked& checked, facts::DebugMap&& debug, uint64_t version) {
    const tree::Program& tree = *checked.analysis->program;
    const std::shared_ptr<image::CompiledProgram> program(new image::CompiledProgram, KeepsAnalysis{checked.analysis});
    program->layout = tree.layout;
    // its own: references are named by the program (nameReferences), and several may be made of what was checked once
    program->layout.types = std::make_shared<types::TypeTable>(*tree.layout.types);
    program->initialImage = tree.initialImage;
    program->initialImage.resize(program->layout.imageSize);
    program->initializer = tree.initializer.isValid() ? tree.initializer.value : 0;
    program->tasks = tree.tasks;
    program->functions = std::move(debug.functions);
    program->sites = std::move(debug.sites);
    program->sources = *checked.sources;
    program->version = version;
    image::nameReferences(program);
    return program;
}

} // namespace

std::vector<std::string> recordedSettings(const BuildInput& input) {
    std::vector<std::string> out = input.libraries;
    for (const std::string& define : input.defines) out.push_back("#" + define);
    if (input.addressing == image::Addressing::Words) out.push_back("%word");
    if (input.memoryForNew) out.push_back("%new" + std::to_string(input.memoryForNew));
    if (input.strings != types::StringCode::Latin1) out.push_back("%strings=" + std::string(nameOf(input.strings)));
    return out;
}

void setRecordedSettings(BuildInput& input, const std::vector<std::string>& settings) {
    for (const std::string& each : settings)
        if (each.starts_with("#"))
            input.defines.push_back(each.substr(1));
        else if (each.starts_with("%new"))
            input.memoryForNew = static_cast<uint32_t>(std::strtoul(each.c_str() + 4, nullptr, 10));
        else if (each.starts_with("%strings="))
            input.strings = types::stringCodeNamed(each.substr(9)).value_or(types::StringCode::Latin1);
        else if (each == "%word")
            input.addressing = image::Addressing::Words;
        else
            input.libraries.push_back(each);
}

std::vector<std::pair<std::string, std::string>> libraryTexts(const BuildInput& input) {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const LibraryText& each : libraryTextsOf(input)) texts.emplace_back(each.name, std::string(each.text));
    return texts;
}

std::vector<std::string> libraryNames() {
    std::vector<std::string> names;
    for (const library::Source& source : library::sources()) {
        const std::string name(source.library);
        if (name != "standard" && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

namespace {

/// Where a build stands after checking; the rest is code.
constexpr double kChecked = 0.3;

/// Nothing when it was cancelled.
std::optional<Checked> checkWatched(const BuildInput& input, KeptFiles& kept, sema::KeptBodies* bodies,
                                    Progress* progress) {
    std::optional<ReadFiles> read = kept.read(input, progress);
    if (!read) return {};
    Checked checked;
    checked.sources = read->sources;
    sema::Options options;
    options.strict = input.strict;
    options.addressing = input.addressing;
    options.memoryForNew = input.memoryForNew;
    options.strings = input.strings;
    for (const std::string& text : input.companions) gatherNames(text, options.usedElsewhere);
    checked.analysis =
        sema::analyze(*read->sources, std::move(read->trees), std::move(read->diagnostics), options, bodies);
    if (!goesOn(progress, kChecked)) return {};
    return checked;
}

} // namespace

Checked check(const BuildInput& input) {
    KeptFiles kept;
    return *checkWatched(input, kept, nullptr, nullptr);
}

Checked check(const BuildInput& input, KeptFiles& kept) { return *checkWatched(input, kept, &kept.bodies(), nullptr); }

Built build(const BuildInput& input, Progress* progress) {
    const auto begin = std::chrono::steady_clock::now();
    KeptFiles kept;
    const std::optional<Checked> checked = checkWatched(input, kept, nullptr, progress);
    if (!checked) {
        Built built;
        built.isCancelled = true;
        return built;
    }
    const double checkMs = millisecondsSince(begin);
    Built built = build(*checked, input, progress);
    built.checkMs = checkMs;
    nameReferences(built);
    return built;
}

void nameReferences(const Built& built) {
    if (built.program)
        built.checked.analysis->program->types->referenceText = built.program->layout.types->referenceText;
}

Built build(const Checked& checked, const BuildInput& input, Progress* progress) {
    Built built;
    built.checked = checked;
    if (checked.analysis->hasErrors || !checked.analysis->program) return built;
    built.checked.analysis = sema::withTreesInPlace(checked.analysis);
    const auto codeBegin = std::chrono::steady_clock::now();
    const tree::Program& tree = *built.checked.analysis->program;
    codegen::Options options;
    options.threadSanitizer = input.threadSanitizer;
    options.progress = progress;
    options.progressFrom = kChecked;
    auto code = jit::compile(tree, options);
    built.isCancelled = isCancelled(progress);
    if (built.isCancelled) return built;
    if (!code) {
        built.failure = code.error().message;
        return built;
    }
    built.program = assemble(built.checked, facts::makeDebugMap(tree), versionOf(input));
    built.program->quick = std::move(code.value());
    built.input = std::make_shared<const BuildInput>(input);
    built.codeMs = millisecondsSince(codeBegin);
    return built;
}

Result<void> optimise(const Built& built, Progress* progress) {
    if (!built.program) return Error{errors::NothingToOptimise(), ""};
    codegen::Options options;
    options.tier = codegen::Tier::Optimised;
    options.threadSanitizer = built.input->threadSanitizer;
    options.progress = progress;
    auto code = jit::compile(*built.checked.analysis->program, options);
    if (!code) return code.error();
    if (isCancelled(progress)) return Error{errors::Cancelled(), ""};
    built.program->optimisedOwner = std::move(code.value());
    built.program->optimised.store(built.program->optimisedOwner.get(), std::memory_order_release);
    return {};
}

Result<expression::Expression> compileExpression(const Checked& checked, std::string_view text,
                                                 std::string_view scope) {
    if (!checked.analysis || !checked.analysis->program) return Error{errors::NotAnExpression(), std::string(text)};
    Arena arena;
    const sema::CheckedExpression result =
        sema::checkExpression(*checked.analysis, *checked.sources, text, scope, arena);
    if (!result.root) {
        return Error{result.diagnostics.empty() ? errors::NotAnExpression() : result.diagnostics.front().message,
                     std::string(text)};
    }
    return compile(*result.root, checked.analysis->program->types, std::string(text));
}

} // namespace plc::driver
