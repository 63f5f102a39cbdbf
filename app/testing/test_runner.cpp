#include "app/testing/test_runner.h"

#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "projects/session/session.h"

namespace plc::app {

TestRunner::TestRunner(editor::Workspace& workspace, QObject* parent) : QObject(parent), m_workspace(workspace) {}

TestRunner::~TestRunner() {
    if (m_work) m_work->cancel();
    if (m_thread.joinable()) m_thread.join();
}

void TestRunner::run(const std::vector<std::string>& titles) {
    if (!m_workspace.isOpen() || m_work) return;
    projects::Project project = m_workspace.project(); // with the texts as they are edited
    project.sources = m_workspace.buildInput().files;
    project.tests.clear();
    for (const QString& file : m_workspace.files())
        if (editor::Workspace::isTestFile(file)) project.tests.push_back({file.toStdString(), m_workspace.text(file)});
    if (m_thread.joinable()) m_thread.join();
    m_work = std::make_shared<Progress>();
    emit started(m_work);
    m_thread = std::thread([this, work = m_work, project = std::move(project), titles, covers = m_covers] {
        testing::Options options;
        options.watched = work.get();
        options.titles = titles;
        if (!project.folder.empty()) options.recordingFolder = project.folder + "/.stepwise/tests";
        options.progress = [this](const testing::TestResult& result) {
            kit::post(this,
                      [this, shared = std::make_shared<const testing::TestResult>(result)] { emit testEnded(shared); });
        };
        std::optional<inside::Coverage> coverage;
        std::shared_ptr<const image::CompiledProgram> program;
        if (covers)
            options.finished = [&](session::Session& session) {
                if (!program) coverage.emplace(program = session.program());
                (void)coverage->addAll(session.history(), work.get());
            };
        auto report = std::make_shared<Result<testing::Report>>(testing::runTests(project, options));
        std::vector<inside::FunctionCoverage> all;
        if (coverage) all = coverage->functions();
        kit::post(this, [this, report, work, program, all = std::move(all)] {
            m_work = nullptr;
            if (program) emit covered(program, all);
            emit workEnded(work);
            if (!*report) return emit failed(kit::messageText(report->error()));
            emit ended(std::make_shared<const testing::Report>(std::move(**report)), work->isCancelled());
        });
    });
}

} // namespace plc::app
