#include "editor/tuning/tuning_view.h"

#include "editor/kit/message_text.h"
#include "editor/kit/texts.h"
#include "editor/plot/figure_view.h"
#include "editor/plot/model/plot_sample.h"
#include "editor/plot/model/plot_scale.h"
#include "projects/loops/errors.h"
#include "projects/tuning/bode_plot.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>

namespace plc::editor {

namespace {

QString seconds(double value) {
    return value > 0 ? QString("%1 s").arg(plot::valueText(value, 4)) : QStringLiteral("–");
}

waveform::Curve curveOf(const tuning::Trajectory& trajectory, const QString& name, int colour) {
    waveform::Curve out{name.toStdString(), {}, trajectory.output, colour, waveform::CurveStyle::Line};
    for (size_t i = 0; i < out.y.size(); ++i) out.x.push_back(static_cast<double>(i) * trajectory.cycle);
    return out;
}

/// A trial looks at no more of the recording than this.
constexpr uint64_t kMostTried = 20'000;

} // namespace

// ------------------------------------------------------------------ settings

tuning::Wish TuningView::wish() const {
    return {static_cast<tuning::ControllerKind>(m_kind->currentData().toInt()), m_brisk->value() / 100.0,
            m_tracking->value() / 100.0, tuning::samplingDelay(m_finding->settings.cycle)};
}

size_t TuningView::modelIndex() const {
    return std::min(static_cast<size_t>(std::max(m_model->currentIndex(), 0)), m_finding->study.models.size() - 1);
}

tuning::ProcessModel TuningView::model() const { return m_finding->study.models[modelIndex()].model; }

/// The formula, how well its parameters are known, and whether the gain is the same everywhere.
void TuningView::showModelWords() {
    const tuning::Identified& shown = m_finding->study.models[modelIndex()];
    QStringList lines{kit::fromView(formula(shown.model))}, bounds;
    for (const Message& bound : boundWords(shown)) bounds << kit::messageText(bound);
    if (!bounds.isEmpty()) lines << bounds.join(QStringLiteral(", "));
    for (const Message& words : gainWords(shown)) lines << kit::messageText(words);
    m_formula->setText(lines.join(QLatin1Char('\n')));
}

void TuningView::propose() {
    if (m_isFilling || !m_finding || m_finding->study.models.empty()) return;
    const tuning::ProcessModel process = model();
    tuning::LoopConditions conditions{m_finding->settings.cycle, tuning::noiseOf(m_finding->recorded.series.output), 0};
    const auto rule = static_cast<tuning::Rule>(m_rule->currentData().toInt());
    const auto gains = tuning::tune(process, rule, wish());
    conditions.duration = tuning::trialDuration(process, gains.value_or(m_finding->settings.gains));
    m_now = tuning::assess(process, m_finding->settings.gains, conditions);
    m_proposal.reset();
    m_parameters.clear();
    if (gains) {
        m_parameters = tuning::parametersOf(*m_finding->loop.form, *gains, m_finding->settings.cycle);
        m_proposal = tuning::assess(process, *gains, conditions);
    }
    showModelWords();
    QStringList words;
    if (!m_proposal) words << tr("The rule does not apply to this process; choose another rule.");
    if (m_proposal)
        words << kit::messageText(robustnessWords(*m_proposal)) << kit::messageText(overshootWords(*m_proposal));
    if (const Message caution = cautionOf(rule); !caution.isEmpty()) words << kit::messageText(caution);
    m_words->setText(words.join(' '));
    showConstants();
    showTable();
    showCharts();
    m_trialTimer.start();
    refreshButtons();
}

void TuningView::showTable() {
    m_figures->clear();
    const auto row = [&](const QString& what, const auto& value) {
        new QTreeWidgetItem(m_figures,
                            {what, m_now ? value(*m_now) : QString(), m_proposal ? value(*m_proposal) : QString()});
    };
    using tuning::Assessment;
    const auto number = [](double value) { return std::isfinite(value) ? plot::valueText(value, 4) : tr("any"); };
    row(tr("Gain"), [&](const Assessment& a) { return number(a.gains.gain); });
    row(tr("Integral time"), [&](const Assessment& a) { return seconds(a.gains.integralTime); });
    row(tr("Derivative time"), [&](const Assessment& a) { return seconds(a.gains.derivativeTime); });
    row(tr("Sensitivity Ms"),
        [&](const Assessment& a) { return a.figures.isStable ? number(a.figures.sensitivity) : tr("unstable"); });
    row(tr("Gain margin"), [&](const Assessment& a) { return number(a.figures.gainMargin); });
    row(tr("Phase margin"),
        [&](const Assessment& a) { return tr("%1°").arg(number(std::round(a.figures.phaseMargin))); });
    row(tr("Overshoot"), [&](const Assessment& a) {
        return a.figures.isStable ? tr("%1 %").arg(number(std::round(a.setPoint.overshoot))) : QStringLiteral("–");
    });
    row(tr("Settling time"), [&](const Assessment& a) {
        return a.figures.isStable ? seconds(a.setPoint.settlingTime) : QStringLiteral("–");
    });
    row(tr("Error after a load step"),
        [&](const Assessment& a) { return a.figures.isStable ? number(a.load.integratedError) : QStringLiteral("–"); });
    row(tr("Control effort"),
        [&](const Assessment& a) { return a.figures.isStable ? number(a.setPoint.effort) : QStringLiteral("–"); });
    row(tr("Noise in the output"), [&](const Assessment& a) { return number(a.noise); });
    for (size_t i = 0; i < m_parameters.size(); ++i) {
        const QString before =
            i < m_finding->settings.values.size() ? plot::valueText(m_finding->settings.values[i], 6) : QString();
        new QTreeWidgetItem(m_figures,
                            {kit::fromView(m_parameters[i].member), before, kit::fromView(m_parameters[i].text)});
    }
    m_figures->resizeColumnToContents(0);
}

void TuningView::showCharts() {
    const tuning::Study& study = m_finding->study;
    const size_t index = modelIndex();
    waveform::Chart data{tr("Recorded and modelled").toStdString(), tr("time [s]").toStdString(), {}, {}, false};
    waveform::Chart residual{tr("Residuals of the model").toStdString(), tr("time [s]").toStdString(), {}, {}, false};
    for (size_t i = 0; i < study.used.size(); ++i) {
        const auto times = timesOf(m_finding->recorded.series, study.steps[study.used[i]], study.excerpts[i]);
        const auto name = [&](const QString& what) { return i == 0 ? what.toStdString() : std::string(); };
        data.curves.push_back({name(tr("recorded")), times, study.excerpts[i].output, 2, waveform::CurveStyle::Dots});
        data.curves.push_back(
            {name(tr("model")), times, study.models[index].simulated[i], 0, waveform::CurveStyle::Line});
        waveform::Curve left{name(tr("recorded minus model")), times, {}, 1, waveform::CurveStyle::Line};
        for (size_t s = 0; s < std::min(study.excerpts[i].output.size(), study.models[index].simulated[i].size()); ++s)
            left.y.push_back(study.excerpts[i].output[s] - study.models[index].simulated[i][s]);
        residual.curves.push_back(std::move(left));
    }
    m_data->setFigure({{std::move(data), std::move(residual)}, {}});
    const auto response = [&](const QString& title, tuning::Trajectory tuning::Assessment::*which) {
        waveform::Chart chart{title.toStdString(), tr("time [s]").toStdString(), {}, {}, false};
        if (m_now && m_now->figures.isStable) chart.curves.push_back(curveOf((*m_now).*which, tr("now"), 3));
        if (m_proposal && m_proposal->figures.isStable)
            chart.curves.push_back(curveOf((*m_proposal).*which, tr("proposed"), 0));
        return chart;
    };
    m_setPoint->setChart(response(tr("Set point"), &tuning::Assessment::setPointTrajectory));
    m_load->setChart(response(tr("Disturbance"), &tuning::Assessment::loadTrajectory));
    showBode();
}

void TuningView::showBode() {
    std::vector<tuning::PlottedLoop> loops;
    if (m_now && m_now->figures.isStable)
        loops.push_back({tr("loop now").toStdString(), m_now->gains, m_now->figures, 3, false});
    if (m_proposal)
        loops.push_back({tr("loop as proposed").toStdString(), m_proposal->gains, m_proposal->figures, 0,
                         m_proposal->figures.isStable});
    tuning::BodeWords words{tr("Bode plot").toStdString(),   tr("gain [dB]").toStdString(),
                            tr("phase [°]").toStdString(),   tr("frequency [rad/s]").toStdString(),
                            tr("process").toStdString(),     tr("gain margin").toStdString(),
                            tr("phase margin").toStdString()};
    auto charts = tuning::bodeCharts(model(), loops, tuning::samplingDelay(m_finding->settings.cycle), words);
    m_bode->setFigure({{std::move(charts[0]), std::move(charts[1])}, {}});
}

std::vector<loops::ConstantEdit> TuningView::constantEdits() const {
    return m_finding ? loops::editsFor(m_finding->loop, m_finding->program, m_parameters)
                     : std::vector<loops::ConstantEdit>();
}

/// What Write Parameters does besides writing variables, and what it cannot do.
void TuningView::showConstants() {
    QStringList inText, elsewhere;
    std::vector<std::string> missing;
    (void)loops::writesOf(m_finding->loop, m_finding->program, m_parameters, &missing);
    const auto constants = loops::callConstants(m_finding->loop, m_finding->program);
    for (const std::string& member : missing) {
        const bool isConstant =
            std::any_of(constants.begin(), constants.end(), [&](const auto& each) { return each.member == member; });
        (isConstant ? inText : elsewhere) << kit::fromView(member);
    }
    QStringList words;
    if (!inText.isEmpty())
        words << tr("Constants in the call: %1. Write Parameters changes them in the text and in the running "
                    "controller by an online change.")
                     .arg(inText.join(QStringLiteral(", ")));
    if (!elsewhere.isEmpty())
        words << tr("Computed in the call and not written: %1.").arg(elsewhere.join(QStringLiteral(", ")));
    m_constants->setText(words.join(QLatin1Char(' ')));
    m_constants->setVisible(!words.isEmpty());
}

std::vector<loops::ParameterWrite> TuningView::writes() const {
    return m_finding ? loops::writesOf(m_finding->loop, m_finding->program, m_parameters)
                     : std::vector<loops::ParameterWrite>();
}

/// The change that is selected in the list, else the last one that the model was made from.
size_t TuningView::triedStep() const {
    const int selected = m_steps->indexOfTopLevelItem(m_steps->currentItem());
    const size_t count = m_finding->study.steps.size();
    return selected >= 0 && static_cast<size_t>(selected) < count ? static_cast<size_t>(selected)
                                                                  : m_finding->study.used.back();
}

Result<loops::TrialRun> TuningView::trialOf(const tuning::FoundStep& step, const session::Run& run) {
    const loops::RecordedSeries& recorded = m_finding->recorded;
    auto [from, to] = recorded.scansOf(step.begin, std::min(step.end, recorded.series.size()));
    if (to - from > kMostTried) from = to - kMostTried;
    auto plan = loops::planFor(m_finding->loop, run.history(), from, to);
    if (!plan) return plan.error();
    plan->writes = writes();
    for (loops::ParameterWrite& write : loops::bumplessWrites(m_finding->loop, *m_finding->program))
        plan->writes.push_back(std::move(write));
    if (const auto edits = constantEdits(); !edits.empty()) {
        if (!m_finding->input) return Error{loops::errors::ConstantsOfRecording(), ""};
        auto changed = loops::withConstants(*m_finding->input, m_finding->program, edits);
        if (!changed) return changed.error();
        plan->program = std::move(*changed);
    }
    return loops::tryOut(run.history(), *plan, model());
}

/// The block itself, over the recorded change that is selected.
void TuningView::tryOut() {
    if (!m_finding || m_finding->study.models.empty()) return;
    const tuning::FoundStep& step = m_finding->study.steps[triedStep()];
    const QString title = step.moved == tuning::Moved::Load ? tr("The recorded disturbance with these settings")
                                                            : tr("The recorded step with these settings");
    waveform::Chart chart{title.toStdString(), tr("time [s]").toStdString(), {}, {}, false};
    const session::Run* run = m_control.run();
    // another run has other scans at these positions
    const auto programs = run ? run->history().programs() : std::vector<loops::ProgramPointer>();
    if (m_proposal && std::find(programs.begin(), programs.end(), m_finding->program) != programs.end()) {
        const auto tried = trialOf(step, *run);
        if (tried) {
            chart.curves.push_back({tr("recorded").toStdString(), tried->before.time, tried->before.output, 2,
                                    waveform::CurveStyle::Line});
            chart.curves.push_back({tr("proposed").toStdString(), tried->series.time, tried->series.output, 0,
                                    waveform::CurveStyle::Line});
        } else {
            chart.title = kit::messageText(tried.error()).toStdString();
        }
    }
    m_trial->setChart(std::move(chart));
}

// ------------------------------------------------------------------ writing

void TuningView::refreshButtons() {
    const bool isOnline = m_control.session() && !m_control.showsRecorded();
    m_report->setEnabled(!m_isSearching && m_finding != nullptr);
    m_find->setEnabled(!m_isSearching && m_control.run() && m_loop->count() > 0);
    m_write->setEnabled(!m_isSearching && isOnline && m_proposal && (!writes().empty() || !constantEdits().empty()));
    m_back->setEnabled(isOnline && (!m_before.empty() || m_edited));
}

namespace {
/// As ST writes it, for the log.
QStringList described(const std::vector<loops::ParameterWrite>& writes) {
    QStringList out;
    for (const loops::ParameterWrite& write : writes)
        out << QStringLiteral("%1 := %2")
                   .arg(kit::fromView(write.path),
                        kit::fromView(plot::exactText(write.value, plot::PlotValueKind::Single)));
    return out;
}

QStringList described(const std::vector<loops::ConstantEdit>& edits) {
    QStringList out;
    for (const loops::ConstantEdit& edit : edits)
        out << QStringLiteral("%1 := %2").arg(kit::fromView(edit.place.member), kit::fromView(edit.text));
    return out;
}
} // namespace

/// As a version of the program holds them, with what lets the output go on from where it is.
Result<session::Together> TuningView::together(std::vector<loops::ParameterWrite> wanted, const loops::Loop& loop,
                                               const image::CompiledProgram& program) {
    for (loops::ParameterWrite& write : loops::bumplessWrites(loop, program)) wanted.push_back(std::move(write));
    session::Together out{{}, tr("Tuning").toStdString()};
    for (const loops::ParameterWrite& write : wanted) {
        auto value = loops::valueFor(program, write.path, write.value);
        if (!value) return value.error();
        out.values.push_back({write.path, std::move(*value)});
    }
    return out;
}

/// All of them before one scan; where some are constants in the text, before the first scan of the changed program.
bool TuningView::put(const std::vector<loops::ParameterWrite>& wanted, const std::vector<loops::ConstantEdit>& edits,
                     const loops::Loop& loop) {
    if (wanted.empty() && edits.empty()) return true; // it is as it shall be
    if (!edits.empty() && (!m_control.isUpToDate() || m_control.isBuilding())) {
        emit message(tr("The text was changed since the controller was started: change the constants after the next "
                        "start or online change."),
                     true);
        return false;
    }
    session::Session* session = m_control.session();
    auto values = together(wanted, loop, *session->program());
    if (!values) {
        emit message(kit::messageText(values.error()), true);
        return false;
    }
    const bool isChange = !edits.empty() && m_control.isRunning();
    if (!isChange && !wanted.empty()) session->writeTogether(std::move(values->values), values->origin);
    std::map<QString, std::vector<diagnostics::TextEdit>> byFile;
    for (const loops::ConstantEdit& edit : edits)
        byFile[kit::fromView(edit.place.file)].push_back({edit.place.range, edit.text});
    if (!byFile.empty()) emit textEdits(byFile);
    if (isChange)
        m_control.onlineChange([wanted, loop](const image::CompiledProgram& program) {
            auto values = together(wanted, loop, program);
            return values ? std::move(*values) : session::Together();
        });
    return true;
}

void TuningView::takeOver(const Parameters& parameters) {
    if (!m_finding || m_finding->loop.name != parameters.loop.name || m_isSearching) return;
    const std::vector<loops::Target> targets = loops::targetsOf(m_finding->loop, m_finding->program);
    const auto constants = loops::callConstants(m_finding->loop, m_finding->program);
    auto changed = std::make_shared<Finding>(*m_finding);
    const std::vector<tuning::ParameterForm>& forms = changed->loop.form->parameters;
    for (size_t i = 0; i < forms.size() && i < changed->settings.values.size(); ++i)
        for (const tuning::ParameterValue& value : parameters.values)
            if (const bool isChanged = !targets[i].path.empty() ||
                                       std::any_of(constants.begin(), constants.end(),
                                                   [&](const auto& each) { return each.member == value.member; });
                value.member == forms[i].member && isChanged)
                changed->settings.values[i] = value.value * (forms[i].unit == tuning::Unit::Milliseconds ? 1e3 : 1);
    changed->settings.gains = tuning::gainsOf(*changed->loop.form, changed->settings.values);
    m_finding = std::move(changed);
    propose();
}

void TuningView::writeParameters() {
    const session::Session* session = m_control.session();
    if (!session || !m_proposal || session->program() == nullptr) return;
    const std::vector<loops::ParameterWrite> wanted = writes();
    // of the program that runs now: an online change moved the text
    const std::vector<loops::ConstantEdit> edits = loops::editsFor(m_finding->loop, session->program(), m_parameters);
    std::vector<loops::ParameterWrite> before;
    const auto image = session->snapshot();
    for (const loops::ParameterWrite& write : wanted)
        before.push_back({write.path, loops::numberAt(*session->program(), image, write.path).value_or(0)});
    Parameters replaced{m_finding->loop, {}};
    for (const tuning::ParameterForm& form : m_finding->loop.form->parameters) {
        const double value = loops::numberAt(*session->program(), image, m_finding->loop.pin(form.member)).value_or(0);
        const bool isMilliseconds = form.unit == tuning::Unit::Milliseconds;
        replaced.values.push_back({std::string(form.member), {}, value * (isMilliseconds ? 1e-3 : 1), false});
    }
    const Parameters written{m_finding->loop, m_parameters};
    if (!put(wanted, edits, m_finding->loop)) return;
    m_before = std::move(before);
    m_replaced = std::move(replaced);
    m_edited.reset();
    if (!edits.empty()) {
        m_edited.emplace(Edited{m_finding->loop, {}});
        for (const loops::ConstantEdit& edit : edits)
            m_edited->before.push_back({edit.place.member, edit.place.text, 0, false});
    }
    emit message(tr("Written: %1").arg((described(wanted) + described(edits)).join(QStringLiteral(", "))), false);
    takeOver(written);
    refreshButtons();
}

void TuningView::takeBack() {
    const session::Session* session = m_control.session();
    if (!session || !m_replaced || (m_before.empty() && !m_edited)) return;
    const std::vector<loops::ConstantEdit> edits =
        m_edited ? loops::editsFor(m_edited->loop, session->program(), m_edited->before)
                 : std::vector<loops::ConstantEdit>();
    if (!put(m_before, edits, m_replaced->loop)) return;
    emit message(tr("Taken back: %1").arg((described(m_before) + described(edits)).join(QStringLiteral(", "))), false);
    const Parameters replaced = *m_replaced;
    m_before.clear();
    m_edited.reset();
    m_replaced.reset();
    takeOver(replaced);
    refreshButtons();
}

} // namespace plc::editor
