// Runs the project's TESTs on a thread of its own, all or some. Owned by the main window; GUI thread.
#pragma once
#include "editor/workspace/workspace.h"
#include "projects/testing/test_run.h"
#include "runtime/inside/coverage.h"

#include <QObject>

#include <memory>
#include <thread>

namespace plc::app {

class TestRunner : public QObject {
    Q_OBJECT
public:
    explicit TestRunner(editor::Workspace& workspace, QObject* parent = nullptr);
    ~TestRunner() override;
    [[nodiscard]] bool isRunning() const { return m_work != nullptr; }
    /// Those with these titles; none: all. Nothing while they run already.
    void run(const std::vector<std::string>& titles = {});
    /// From the next run on, what the tests cover is gathered as well; takes longer.
    void setCovers(bool covers) { m_covers = covers; }
    [[nodiscard]] bool covers() const { return m_covers; }

signals:
    void started(const std::shared_ptr<plc::Progress>& work);
    void testEnded(const std::shared_ptr<const plc::testing::TestResult>& result);
    void ended(const std::shared_ptr<const plc::testing::Report>& report, bool isCancelled);
    /// What they covered together, and the program that it is of.
    void covered(const std::shared_ptr<const plc::image::CompiledProgram>& program,
                 const std::vector<plc::inside::FunctionCoverage>& all);
    void failed(const QString& message); // nothing could be run
    void workEnded(const std::shared_ptr<plc::Progress>& work);

private:
    editor::Workspace& m_workspace;
    bool m_covers = false;
    std::shared_ptr<Progress> m_work; // null: none run
    std::thread m_thread;
};

} // namespace plc::app
