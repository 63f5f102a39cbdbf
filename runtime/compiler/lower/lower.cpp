#include "runtime/compiler/lower/lower.h"

#include "runtime/base/text.h"
#include "runtime/compiler/chart/chart.h"
#include "runtime/compiler/lower/chart.h"
#include "runtime/compiler/lower/instruction_list.h"

#include <span>

namespace plc::lower {

using syntax::ActionDecl;
using syntax::Body;
using syntax::BodyLanguage;
using syntax::Decl;
using syntax::Pou;
using syntax::PouKind;

namespace {

class FileLowering {
public:
    FileLowering(syntax::SyntaxFile& file, diagnostics::Sink& sink, Keep results)
        : m_file(file), m_builder(file), m_sink(sink), m_results(results) {}

    void run(size_t first) {
        collectBlocks(m_file.declarations);
        declarations(std::span(m_file.declarations).subspan(first));
    }

private:
    void collectBlocks(const std::vector<Decl*>& list) {
        for (const Decl* decl : list) {
            if (decl->space) collectBlocks(decl->space->declarations);
            if (decl->pou && decl->pou->kind == PouKind::FunctionBlock)
                m_blocks.push_back(foldCase(decl->pou->name.text));
        }
    }
    void declarations(std::span<Decl* const> list) {
        for (Decl* decl : list) {
            if (decl->space) declarations(decl->space->declarations);
            if (decl->pou) unit(*decl->pou);
        }
    }

    static bool isGraphic(const Body& body) {
        return body.language == BodyLanguage::Il || body.language == BodyLanguage::Sfc;
    }
    static bool needsLowering(const Pou& pou) {
        if (isGraphic(pou.body)) return true;
        for (const ActionDecl* action : pou.actions)
            if (isGraphic(action->body)) return true;
        return false;
    }

    void unit(Pou& pou) {
        if (pou.kind == PouKind::Interface) return;
        for (Pou* method : pou.methods) unit(*method);
        for (syntax::Property* property : pou.properties) {
            if (property->get) unit(*property->get);
            if (property->set) unit(*property->set);
        }
        if (!needsLowering(pou)) return;
        syntax::VarSection* section = m_builder.section(syntax::SectionKind::Var, pou.name.range);
        ChartUnit charts{pou, *section, {}, {}, m_blocks};
        gatherActions(pou, pou.body);
        for (size_t i = 0; i < pou.actions.size(); ++i) gatherActions(pou, pou.actions[i]->body);
        for (const ActionDecl* action : pou.actions) charts.actions.insert(foldCase(action->name.text));
        body(pou.body, pou, charts);
        for (ActionDecl* action : pou.actions) body(action->body, pou, charts);
        if (!section->declarations.empty()) pou.sections.push_back(section);
    }

    /// The actions written inside a chart belong to the unit, as those behind it do.
    static void gatherActions(Pou& pou, const Body& body) {
        if (body.language != BodyLanguage::Sfc || !body.chart) return;
        pou.actions.insert(pou.actions.end(), body.chart->actions.begin(), body.chart->actions.end());
    }

    void body(Body& body, Pou& pou, ChartUnit& charts) {
        if (body.language == BodyLanguage::Il) {
            const bool isStatic = pou.kind == PouKind::Program || pou.kind == PouKind::FunctionBlock;
            const ListContext context{m_builder,
                                      pou.sections,
                                      m_blocks,
                                      charts.section,
                                      charts.instructionVariables,
                                      m_sink,
                                      isStatic ? m_results : Keep::Needed,
                                      pou.kind == PouKind::Function && pou.result ? pou.name : syntax::Name{}};
            body.instructions = std::move(body.statements);
            body.statements = lowerInstructions(body.instructions, context, false).statements;
        } else if (body.language == BodyLanguage::Sfc && body.chart) {
            if (pou.kind != PouKind::Program && pou.kind != PouKind::FunctionBlock) {
                m_sink.emit(pou.name.range, findings::NotAllowedHere(phrases::AChart(), pou.kind == PouKind::Function
                                                                                            ? phrases::InAFunction()
                                                                                            : phrases::InAMethod()));
                return;
            }
            chart::check(chart::build(*body.chart), m_sink);
            const SourceRange place = body.chart->steps.empty() ? pou.name.range : body.chart->steps[0]->name.range;
            body.statements = lowerChart(*body.chart, place, charts, m_builder, m_sink);
        }
    }

    syntax::SyntaxFile& m_file;
    Builder m_builder;
    diagnostics::Sink& m_sink;
    Keep m_results;
    std::vector<std::string> m_blocks;
};

} // namespace

void lowerFile(syntax::SyntaxFile& file, diagnostics::Sink& sink, Keep results, size_t first) {
    FileLowering(file, sink, results).run(first);
}

} // namespace plc::lower
