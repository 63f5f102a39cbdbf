// One ST expression as seen from an instance (D7): checked against the finished program, which is only read.
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/values/expressions.h"

namespace plc::sema {

CheckedExpression checkExpression(const Analysis& analysis, const SourceSet&, std::string_view text,
                                  std::string_view scopePath, Arena& arena) {
    CheckedExpression out;
    // Without a World (a program that was loaded, not compiled) there is nothing to look names up in.
    if (!analysis.scopes) return out;
    const World& world = *static_cast<const World*>(analysis.scopes.get());
    // Runs on any thread, beside others: the World is const, what the check gathers is this call's own.
    Gathered gathered(*analysis.program->types, arena); // thrown away, but for what is reported
    diagnostics::Sink& sink = gathered.sink;
    syntax::SyntaxFile file; // lives as long as the checking; the result refers to none of it
    const syntax::Expr* parsed = parse::parseExpression(file, text, sink);
    if (!parsed || sink.hasErrors()) {
        out.diagnostics = sink.take();
        return out;
    }
    Scope scope{nullptr, &world.top, nullptr};
    Context checker({world, gathered}, scope, sink, arena);
    checker.isExpression = true;
    checker.expressionText = text;
    // "Main.motor": names are looked up as inside of that block's instance, and its fields have addresses.
    if (!scopePath.empty()) {
        const auto place = world.program->layout.find(scopePath);
        Unit* unit = place ? world.unitOf(place->type) : nullptr;
        if (unit) {
            checker.scope.unit = unit;
            checker.scope.space = unit->space;
            checker.scope.file = unit->file;
            checker.instanceBase = place->offset;
        }
    }
    Operand value = settled(checker, expression(checker, *parsed));
    if (!value.isUnknown() && checker.isKind(value.type(), TypeKind::Void))
        checker.emit(parsed->range, findings::NoValue(text));
    out.diagnostics = sink.take();
    const bool isWrong =
        std::any_of(out.diagnostics.begin(), out.diagnostics.end(),
                    [](const diagnostics::Diagnostic& d) { return d.severity == diagnostics::Severity::Error; });
    if (!isWrong && !value.isUnknown()) out.root = value.expr;
    // Every refusal should have its message; this one keeps an empty answer from being shown as nothing at all.
    else if (!isWrong) { // wrong without a word: say what is known
        checker.emit(parsed->range, findings::NoValue(text));
        for (diagnostics::Diagnostic& diagnostic : sink.take()) out.diagnostics.push_back(std::move(diagnostic));
    }
    return out;
}

} // namespace plc::sema
