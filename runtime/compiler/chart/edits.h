// Edits of a chart as replacements in its text, minimal and byte preserving: comment lines directly above an element
// and the rest of its last line move and die with it. Pure functions over a text and the tree parsed from it; any
// thread.
#pragma once
#include "runtime/base/result.h"
#include "runtime/compiler/chart/chart.h"
#include "runtime/diagnostics/text_edits.h"

#include <string>

namespace plc::chart {

using diagnostics::applyEdits;
using diagnostics::Edits;
using diagnostics::inverseOf;
using diagnostics::TextEdit;

enum class Place : uint8_t { Before, After };

/// Edits of one unit's chart. `text` is the whole file's; `pou` and `chart` are of the tree parsed from it.
class ChartEditor {
public:
    ChartEditor(std::string_view text, const syntax::Pou& pou, const Chart& chart);

    /// A new step and transition behind a step: what followed the step follows the new one. Names are made up when
    /// empty.
    [[nodiscard]] Result<Edits> insertStepAfter(StepId step, std::string name = {}) const;
    /// A new step and transition behind a transition, before the step it leads to (the first one).
    [[nodiscard]] Result<Edits> insertStepAfter(TransitionId transition, std::string name = {}) const;
    /// The step goes with the transition behind it; those that led to it lead on.
    [[nodiscard]] Result<Edits> deleteStep(StepId step) const;
    /// A step with the one transition behind it goes behind another transition. Only names change.
    [[nodiscard]] Result<Edits> moveStep(StepId step, TransitionId behind) const;

    [[nodiscard]] Result<Edits> insertTransition(StepId from, StepId to, std::string_view condition = "TRUE") const;
    [[nodiscard]] Result<Edits> deleteTransition(TransitionId transition) const;
    /// Left to right is the order in the text.
    [[nodiscard]] Result<Edits> moveTransition(TransitionId transition, Place place, TransitionId anchor) const;
    /// Of the steps that a transition activates, or those that it ends: another order from left to right.
    [[nodiscard]] Result<Edits> moveParallel(TransitionId transition, size_t from, size_t to) const;
    [[nodiscard]] Result<Edits> setCondition(TransitionId transition, std::string_view condition) const;
    [[nodiscard]] Result<Edits> setPriority(TransitionId transition, int priority) const; // 0: none
    [[nodiscard]] Result<Edits> setTarget(TransitionId transition, StepId from, StepId to) const;

    /// A branch beside the transitions behind `step`: a transition, a step and a transition to where the last branch
    /// leads.
    [[nodiscard]] Result<Edits> insertAlternativeBranch(StepId step, std::string name = {}) const;
    /// A step beside those that `transition` activates; it joins where they do.
    [[nodiscard]] Result<Edits> insertSimultaneousBranch(TransitionId transition, std::string name = {}) const;
    /// The transition and every step and transition that can be reached through it only.
    [[nodiscard]] Result<Edits> deleteBranch(TransitionId first) const;

    [[nodiscard]] Result<Edits> insertAction(StepId step, size_t index, std::string_view action,
                                             std::string_view qualifier, std::string_view time = {}) const;
    [[nodiscard]] Result<Edits> deleteAction(StepId step, size_t index) const;
    [[nodiscard]] Result<Edits> moveAction(StepId step, size_t from, size_t to) const;
    [[nodiscard]] Result<Edits> changeAction(StepId step, size_t index, std::string_view action,
                                             std::string_view qualifier, std::string_view time) const;
    /// An empty ACTION behind the chart.
    [[nodiscard]] Result<Edits> declareAction(std::string_view name) const;

    /// With every FROM, TO and `name.X` in the unit.
    [[nodiscard]] Result<Edits> renameStep(StepId step, std::string_view name) const;
    /// With every association and call in the unit.
    [[nodiscard]] Result<Edits> renameAction(std::string_view action, std::string_view name) const;
    [[nodiscard]] Result<Edits> setInitial(StepId step) const;
    /// minTime or maxTime; an empty time removes the pragma.
    [[nodiscard]] Result<Edits> setStepTime(StepId step, std::string_view key, std::string_view time) const;

    /// The first free name "Step1", "Step2"…
    [[nodiscard]] std::string freeStepName() const;

private:
    [[nodiscard]] std::string slice(SourceRange range) const {
        return std::string(m_text.substr(range.begin, range.length()));
    }
    [[nodiscard]] std::string lineEnd() const;
    [[nodiscard]] std::string indentOf(uint32_t at) const;
    [[nodiscard]] uint32_t lineBehind(uint32_t at) const;
    [[nodiscard]] std::string stepText(const std::string& indent, const std::string& name) const;
    [[nodiscard]] std::string transitionText(const std::string& indent, const std::string& from, const std::string& to,
                                             std::string_view condition) const;
    [[nodiscard]] std::string nameOf(StepId step) const { return std::string(m_chart[step].decl->name.text); }
    [[nodiscard]] Result<std::string> checkedName(std::string name) const;
    [[nodiscard]] TextEdit insertBehind(SourceRange extent, std::string text) const;
    [[nodiscard]] TextEdit eraseExtent(SourceRange extent) const;
    [[nodiscard]] TextEdit setNames(const std::vector<syntax::Name>& list, const std::vector<std::string>& names) const;
    [[nodiscard]] std::string associationText(std::string_view action, std::string_view qualifier,
                                              std::string_view time) const;
    [[nodiscard]] Result<Edits> finish(Edits edits) const;

    std::string_view m_text;
    const syntax::Pou& m_pou;
    const Chart& m_chart;
};

/// An empty chart for a unit without a body.
[[nodiscard]] std::string emptyChart(std::string_view indent, std::string_view lineEnd);

} // namespace plc::chart
