// The dock that tunes a control loop out of the recording: the steps that were found, the model drawn over them, the
// settings by a rule with two sliders, what they would have done, and the buttons that write them in one scan and take
// them back. Owned by its dock; GUI thread; the search runs on a thread of its own and holds the session meanwhile.
#pragma once
#include "editor/debug/run_control.h"
#include "projects/loops/call_constants.h"
#include "projects/loops/trial.h"
#include "projects/tuning/loop_report.h"

#include <QTimer>
#include <QWidget>

#include <map>
#include <thread>

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QTreeWidget;

namespace plc::plot {
class FigureView;
}

namespace plc::editor {

class TuningView : public QWidget {
    Q_OBJECT
public:
    explicit TuningView(RunControl& control, QWidget* parent = nullptr);
    ~TuningView() override;

    void findSteps();
    void writeParameters();
    void takeBack();
    void saveReport();
    /// As the suffix says: .pdf, else HTML.
    void writeReport(const QString& path);

signals:
    void message(const QString& text, bool isError);
    /// Constants of a call, to be changed in the editors; one undo takes them back.
    void textEdits(const std::map<QString, std::vector<diagnostics::TextEdit>>& edits);

private:
    struct Finding { // of the search; immutable once shown
        loops::Loop loop;
        loops::ProgramPointer program;
        std::shared_ptr<const driver::BuildInput> input; // null: a recording from a file
        loops::RecordedSeries recorded;
        tuning::Study study;          // without models where none was found:
        std::optional<Error> problem; // why
        tuning::Health health;
        loops::Settings settings;
    };
    QWidget* makeHead();
    QWidget* makeSettings();
    QWidget* makeCharts();
    QWidget* makeHealth();
    void listLoops();
    void runAside(std::function<Result<std::shared_ptr<Finding>>()> work);
    void show(std::shared_ptr<Finding> finding);
    void showSteps();
    void fitChosenSteps();
    void propose();
    void showCharts();
    void showBode();
    void showHealth();
    void showModelWords();
    void clearProposal();
    [[nodiscard]] tuning::LoopReport report() const;
    void showTable();
    void tryOut();
    [[nodiscard]] size_t triedStep() const;
    [[nodiscard]] Result<loops::TrialRun> trialOf(const tuning::FoundStep& step, const session::Run& run);
    void showConstants();
    struct Parameters { // of a block, as they shall be
        loops::Loop loop;
        std::vector<tuning::ParameterValue> values;
    };
    static Result<session::Together> together(std::vector<loops::ParameterWrite> wanted, const loops::Loop& loop,
                                              const image::CompiledProgram& program);
    bool put(const std::vector<loops::ParameterWrite>& wanted, const std::vector<loops::ConstantEdit>& edits,
             const loops::Loop& loop);
    /// They are in force now: the comparison starts from them.
    void takeOver(const Parameters& parameters);
    void refreshButtons();
    [[nodiscard]] std::optional<loops::Loop> chosenLoop() const;
    [[nodiscard]] tuning::Wish wish() const;
    [[nodiscard]] size_t modelIndex() const;
    [[nodiscard]] tuning::ProcessModel model() const;
    static Result<std::shared_ptr<Finding>> searched(std::shared_ptr<Finding> finding, const history::History& history,
                                                     std::span<const std::byte> image);
    static void look(Finding& finding);
    [[nodiscard]] std::vector<loops::ParameterWrite> writes() const;
    [[nodiscard]] std::vector<loops::ConstantEdit> constantEdits() const;

    RunControl& m_control;
    QComboBox *m_loop, *m_model, *m_rule, *m_kind;
    QPushButton *m_find, *m_report, *m_write, *m_back;
    QSlider *m_brisk, *m_tracking;
    QTreeWidget *m_steps, *m_figures, *m_healthFigures;
    QLabel *m_state, *m_formula, *m_words, *m_constants, *m_healthWords;
    plot::FigureView *m_data, *m_setPoint, *m_load, *m_trial, *m_bode, *m_recorded;
    std::shared_ptr<Finding> m_finding;
    std::optional<tuning::Assessment> m_now, m_proposal;
    std::vector<tuning::ParameterValue> m_parameters;
    std::vector<loops::ParameterWrite> m_before; // what the last write replaced
    std::optional<Parameters> m_replaced;        // the same as the block had it
    struct Edited {                              // constants of a call as they were written before
        loops::Loop loop;
        std::vector<tuning::ParameterValue> before;
    };
    std::optional<Edited> m_edited;
    loops::ProgramPointer m_listed; // whose loops can be chosen
    QTimer m_trialTimer;            // a trial follows when the slider rests
    std::thread m_worker;
    bool m_isSearching = false;
    bool m_isFilling = false; // the view changes its own controls
};

} // namespace plc::editor
