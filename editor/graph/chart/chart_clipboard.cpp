// Copying and pasting in the chart. The clipboard holds text as it is in the file, so that a step can also be pasted
// into a text; what is pasted goes behind what is selected, as one step of undo.
#include "editor/graph/chart/chart_unit.h"
#include "editor/graph/chart/chart_view.h"
#include "editor/kit/texts.h"
#include "runtime/compiler/parse/parser.h"

#include <QApplication>
#include <QClipboard>

namespace plc::editor {

using chart::StepId;
using chart::TransitionId;

namespace {

/// A text parsed as the body of a program, with its chart.
struct Piece {
    explicit Piece(std::string wrapped) : text(std::move(wrapped)) {
        diagnostics::Sink sink;
        file = parse::parseFile(FileId(size_t(0)), text, sink);
        const ChartPlace place = findChart(*file, "P");
        pou = place.pou;
        if (place && !sink.hasErrors()) chart = std::make_unique<chart::Chart>(chart::build(*place.chart));
    }
    std::string_view slice(SourceRange range) const {
        return std::string_view(text).substr(range.begin, range.length());
    }
    std::string text;
    std::unique_ptr<syntax::SyntaxFile> file;
    const syntax::Pou* pou = nullptr;
    std::unique_ptr<chart::Chart> chart;
};

struct Association {
    std::string name, qualifier, time;
};

std::vector<Association> associationsOf(const syntax::StepDecl& step, const Piece& piece) {
    std::vector<Association> out;
    for (const syntax::ActionAssociation& each : step.actions)
        out.push_back({std::string(each.action.text), std::string(each.qualifier.text),
                       each.time ? std::string(piece.slice(each.time->range)) : std::string()});
    return out;
}

/// What the clipboard holds: a step with its actions, actions alone, or a condition.
struct Copied {
    std::string step; // its name; empty: none
    std::vector<Association> actions;
    std::string condition;
};

Copied readCopied(const std::string& text) {
    Copied out;
    const std::string open = "PROGRAM P\n", close = "\nEND_PROGRAM\n", first = "INITIAL_STEP Q_: END_STEP\n";
    if (const Piece steps(open + first + text + close); steps.chart && steps.chart->steps.size() == 2) {
        out.step = steps.chart->steps[1].decl->name.text;
        out.actions = associationsOf(*steps.chart->steps[1].decl, steps);
    } else if (steps.chart && steps.chart->steps.size() == 1 && steps.chart->transitions.size() == 1) {
        if (const auto* condition = steps.chart->transitions[0].decl->condition)
            out.condition = steps.slice(condition->range);
    } else if (const Piece actions(open + "INITIAL_STEP Q_:\n" + text + "\nEND_STEP" + close);
               actions.chart && actions.chart->steps.size() == 1) {
        out.actions = associationsOf(*actions.chart->steps[0].decl, actions);
    }
    return out;
}

/// One replacement that makes `after` of `before`.
diagnostics::Edits difference(std::string_view before, std::string_view after) {
    size_t head = 0, tail = 0;
    while (head < std::min(before.size(), after.size()) && before[head] == after[head]) ++head;
    while (tail < std::min(before.size(), after.size()) - head &&
           before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    if (head == before.size() && head == after.size()) return {};
    return {{{FileId(size_t(0)), static_cast<uint32_t>(head), static_cast<uint32_t>(before.size() - tail)},
             std::string(after.substr(head, after.size() - tail - head))}};
}

/// The chart of a text that edits have made, to go on from there.
struct Next {
    Next(std::string made, const std::string& unit) : text(std::move(made)) {
        diagnostics::Sink sink;
        file = parse::parseFile(FileId(size_t(0)), text, sink);
        place = findChart(*file, unit);
        if (place) chart = std::make_unique<chart::Chart>(chart::build(*place.chart));
    }
    std::string text;
    std::unique_ptr<syntax::SyntaxFile> file;
    ChartPlace place;
    std::unique_ptr<chart::Chart> chart;
};

/// `text` with the actions added to a step.
Result<std::string> withActions(std::string text, const std::string& unit, const std::string& step,
                                const std::vector<Association>& actions) {
    for (const auto& [name, qualifier, time] : actions) {
        const Next next(std::move(text), unit);
        const StepId at = next.chart ? next.chart->find(step) : StepId();
        text = next.text;
        if (!at.isValid()) break;
        const auto edits = chart::ChartEditor(next.text, *next.place.pou, *next.chart)
                               .insertAction(at, (*next.chart)[at].decl->actions.size(), name,
                                             qualifier.empty() ? "N" : qualifier, time);
        if (!edits) return edits.error();
        text = chart::applyEdits(next.text, *edits);
    }
    return text;
}

} // namespace

void ChartView::addClipboardCommands() {
    const auto add = [this](const char* name, auto run) {
        auto* command = new QAction(this);
        command->setObjectName(QLatin1String(name)); // the Edit menu finds it by this name
        connect(command, &QAction::triggered, this, run);
        addAction(command);
    };
    add("copy", &ChartView::copySelected);
    add("cut", &ChartView::cutSelected);
    add("paste", &ChartView::paste);
}

void ChartView::copySelected() {
    const Picked p = picked();
    if (!m_chart || m_isStale || p.kind == ChartScene::None) return emit failed(tr("Select what is to be copied"));
    const SourceRange range = rangeOf(p);
    QApplication::clipboard()->setText(kit::fromView(std::string_view(m_text).substr(range.begin, range.length())));
}

void ChartView::cutSelected() {
    if (picked().kind == ChartScene::None) return emit failed(tr("Select what is to be cut"));
    copySelected();
    deleteSelected();
}

void ChartView::paste() {
    const Picked p = picked();
    if (!m_chart || m_isStale) return;
    const Copied copied = readCopied(QApplication::clipboard()->text().toStdString());
    if (copied.step.empty() && copied.actions.empty() && copied.condition.empty())
        return emit failed(tr("The clipboard contains no step, action or transition; copy one first"));
    if (p.kind == ChartScene::None) return emit failed(tr("Select the step or transition to paste after"));
    const auto pasteActions = [&](std::string text, const std::string& step) {
        const Result<std::string> made = withActions(std::move(text), m_unit.toStdString(), step, copied.actions);
        if (!made) return request(made.error());
        request(difference(m_text, *made), QString::fromStdString(step));
    };
    if (!copied.condition.empty()) {
        if (p.kind != ChartScene::Transition) return emit failed(tr("Select the transition that gets the condition"));
        return request(editor().setCondition(TransitionId(p.index), copied.condition));
    }
    if (copied.step.empty()) {
        if (p.kind == ChartScene::Transition) return emit failed(tr("Select the step that gets the action"));
        const std::string step(m_chart->steps[static_cast<size_t>(p.index)].decl->name.text);
        return pasteActions(m_text, step);
    }
    const std::string name = m_chart->find(copied.step).isValid() ? editor().freeStepName() : copied.step;
    const auto inserted = p.kind == ChartScene::Transition ? editor().insertStepAfter(TransitionId(p.index), name)
                                                           : editor().insertStepAfter(StepId(p.index), name);
    if (!inserted) return request(inserted);
    pasteActions(chart::applyEdits(m_text, *inserted), name);
}

} // namespace plc::editor
