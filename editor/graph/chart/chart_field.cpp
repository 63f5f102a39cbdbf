// Names, conditions and actions edited in place: the field over the drawing, what completes it and what it complains
// of.
#include "editor/graph/chart/chart_items.h"
#include "editor/graph/chart/chart_view.h"
#include "editor/kit/errors.h"
#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/compiler/sema/sema.h"

#include <algorithm>

namespace plc::editor {

using chart::StepId;
using chart::TransitionId;

namespace {

/// "D T#2s Lamp", "S Motor" or just the name.
struct ActionWords {
    std::string name, qualifier = "N", time;
    explicit ActionWords(const QString& text) {
        QStringList words = text.simplified().split(' ', Qt::SkipEmptyParts);
        if (words.isEmpty()) return;
        name = words.takeLast().toStdString();
        if (!words.isEmpty()) qualifier = words.takeFirst().toStdString();
        time = words.join(' ').toStdString();
    }
};

constexpr const char* kQualifiers[] = {"N", "R", "S", "L", "D", "P", "SD", "DS", "SL", "P0", "P1"};

/// Where an instance of the unit lies: conditions are checked as seen from there.
std::string instanceOf(const sema::Analysis& analysis, std::string_view unit) {
    if (!analysis.program) return {};
    const auto& layout = analysis.program->layout;
    const types::TypeTable& types = *analysis.program->types;
    const std::string wanted = foldCase(unit);
    std::string found;
    const auto walk = [&](auto&& self, const std::string& path, types::TypeId type, int depth) -> void {
        const types::Type& t = types[type];
        if (!found.empty() || (t.kind != types::TypeKind::Block && t.kind != types::TypeKind::Struct)) return;
        if (foldCase(t.name) == wanted) {
            found = path;
            return;
        }
        if (depth < 5)
            for (const types::Field& field : t.fields)
                if (field.section != types::FieldSection::InOut && field.section != types::FieldSection::External)
                    self(self, path + "." + field.name, field.type, depth + 1);
    };
    for (const image::Root& root : layout.roots)
        if (!root.isHidden) walk(walk, root.list.empty() ? root.name : root.list + "." + root.name, root.type, 0);
    return found;
}

/// Errors of a chart's text, by message: those that an edit adds are shown to the user.
std::vector<Message> errorsIn(std::string_view text, std::string_view unit) {
    std::vector<Message> out;
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    const ChartPlace place = findChart(*file, unit);
    const auto keep = [&](const diagnostics::Sink& from) {
        for (const diagnostics::Diagnostic& d : from.all())
            if (d.severity == diagnostics::Severity::Error) out.push_back(d.message);
    };
    keep(sink);
    if (!place) return out;
    diagnostics::Sink checks;
    chart::check(chart::build(*place.chart), checks);
    keep(checks);
    return out;
}

} // namespace

QString ChartView::complaintOf(const QString& text) const {
    if (!m_makeEdits || !m_chart || text.trimmed().isEmpty() || text == m_fieldBegin) return {};
    const Result<chart::Edits> edits = m_makeEdits(text.trimmed());
    if (!edits) return kit::messageText(edits.error());
    const std::string unit = m_unit.toStdString();
    std::vector<Message> before = errorsIn(m_text, unit);
    for (const Message& error : errorsIn(chart::applyEdits(m_text, *edits), unit)) {
        const auto known = std::find(before.begin(), before.end(), error);
        if (known == before.end()) return kit::messageText(error);
        before.erase(known);
    }
    if (m_fieldKind != FieldKind::Condition || !m_model) return {};
    const sema::Analysis& analysis = *m_model->checked().analysis;
    const std::string scope = instanceOf(analysis, unit.substr(0, unit.find('.')));
    if (scope.empty()) return {};
    Arena arena;
    const sema::CheckedExpression checked =
        sema::checkExpression(analysis, m_model->sources(), text.toStdString(), scope, arena);
    for (const diagnostics::Diagnostic& d : checked.diagnostics) {
        if (d.kind == diagnostics::Kind::NotAllowedInExpression) return {}; // a call: a program may, a watch may not
        if (d.severity == diagnostics::Severity::Error) return kit::messageText(d.message);
    }
    if (checked.root && analysis.program->types->storageKind(checked.root->type) != types::TypeKind::Bool)
        return tr("A condition is a BOOL; add a comparison");
    return {};
}

std::vector<kit::Completion> ChartView::completions(const QString& text, int cursor) const {
    std::vector<kit::Completion> out;
    if (!m_model || !m_place.pou || m_fieldKind == FieldKind::Name) return out;
    if (m_fieldKind == FieldKind::Action) {
        if (!text.left(cursor).contains(' '))
            for (const char* qualifier : kQualifiers) out.push_back({qualifier, tr("qualifier")});
        for (const auto* list : {&m_place.chart->actions, &m_place.pou->actions})
            for (const syntax::ActionDecl* action : *list)
                if (std::none_of(out.begin(), out.end(),
                                 [&](const kit::Completion& c) { return c.text == kit::fromView(action->name.text); }))
                    out.push_back({kit::fromView(action->name.text), tr("action"), kit::Icon::Action});
    }
    const bool isAction = m_fieldKind == FieldKind::Action;
    for (kit::Completion& each :
         namesAt(text, cursor, [isAction](const QString& type) { return !isAction || type == "BOOL"; }))
        out.push_back(std::move(each));
    return out;
}

void ChartView::insertAction() {
    const Picked p = picked();
    if (!m_chart || m_isStale || (p.kind != ChartScene::Step && p.kind != ChartScene::Action))
        return emit failed(tr("Select the step that gets the action"));
    const int step = p.index;
    const syntax::StepDecl& decl = *m_chart->steps[static_cast<size_t>(step)].decl;
    const QRectF box = m_scene->stepRect(step);
    const double below = decl.actions.empty()
                             ? box.top()
                             : m_scene->actionRect(step, static_cast<int>(decl.actions.size()) - 1).bottom();
    openField(QRectF(box.right() + kActionGap, below, 150, kActionHeight), {}, FieldKind::Action, decl.range.begin,
              [this, step](const QString& text) {
                  const ActionWords words(text);
                  return editor().insertAction(StepId(step),
                                               m_chart->steps[static_cast<size_t>(step)].decl->actions.size(),
                                               words.name, words.qualifier, words.time);
              });
}

void ChartView::editSelected() {
    const Picked p = picked();
    if (!m_chart || m_isStale || p.kind == ChartScene::None) return;
    const auto index = static_cast<size_t>(p.index);
    if (p.kind == ChartScene::Step) {
        const syntax::StepDecl& step = *m_chart->steps[index].decl;
        return openField(
            m_scene->stepRect(p.index), kit::fromView(step.name.text), FieldKind::Name, step.range.begin,
            [this, p](const QString& text) { return editor().renameStep(StepId(p.index), text.toStdString()); }, true);
    }
    if (p.kind == ChartScene::Transition) {
        const syntax::TransitionDecl& decl = *m_chart->transitions[index].decl;
        QString present; // a list becomes an expression
        if (decl.condition)
            present = kit::fromView(
                std::string_view(m_text).substr(decl.condition->range.begin, decl.condition->range.length()));
        const uint32_t at = decl.condition ? decl.condition->range.begin : decl.range.begin;
        return openField(m_scene->conditionRect(p.index).adjusted(-4, -2, 120, 2), present, FieldKind::Condition, at,
                         [this, p](const QString& text) {
                             return editor().setCondition(TransitionId(p.index), text.toStdString());
                         });
    }
    const syntax::ActionAssociation& action = m_chart->steps[index].decl->actions[static_cast<size_t>(p.sub)];
    openField(m_scene->actionRect(p.index, p.sub),
              qualifierOf(action, m_text) + " " + kit::fromView(action.action.text), FieldKind::Action,
              action.range.begin, [this, p](const QString& text) {
                  const ActionWords words(text);
                  return editor().changeAction(StepId(p.index), static_cast<size_t>(p.sub), words.name, words.qualifier,
                                               words.time);
              });
}

void ChartView::editPriority() {
    const Picked p = picked();
    if (!m_chart || m_isStale || p.kind != ChartScene::Transition) return;
    const syntax::TransitionDecl& decl = *m_chart->transitions[static_cast<size_t>(p.index)].decl;
    const QString present =
        decl.priority
            ? kit::fromView(std::string_view(m_text).substr(decl.priority->range.begin, decl.priority->range.length()))
            : QStringLiteral("0");
    openField(m_scene->barRect(p.index).adjusted(-60, 10, -20, -10), present, FieldKind::Name, decl.range.begin,
              [this, p](const QString& text) -> Result<chart::Edits> {
                  bool isNumber = false;
                  const int priority = text.toInt(&isNumber);
                  if (!isNumber) return Error{errors::PriorityNotNumber(), {}};
                  return editor().setPriority(TransitionId(p.index), priority);
              });
}

void ChartView::openField(const QRectF& sceneRect, const QString& text, FieldKind kind, uint32_t at, MakeEdits make,
                          bool keepsSelection) {
    m_fieldKind = kind;
    GraphView::openField(sceneRect, text, at, std::move(make), keepsSelection);
}

} // namespace plc::editor
