#include "app/test_runner.h"

#include "editor/kit/message_text.h"
#include "editor/kit/post.h"

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
    m_thread = std::thread([this, work = m_work, project = std::move(project), titles] {
        testing::Options options;
        options.watched = work.get();
        options.titles = titles;
        if (!project.folder.empty()) options.recordingFolder = project.folder + "/.stepwise/tests";
        options.progress = [this](const testing::TestResult& result) {
            kit::post(this,
                      [this, shared = std::make_shared<const testing::TestResult>(result)] { emit testEnded(shared); });
        };
        auto report = std::make_shared<Result<testing::Report>>(testing::runTests(project, options));
        kit::post(this, [this, report, work] {
            m_work = nullptr;
            emit workEnded(work);
            if (!*report) return emit failed(kit::messageText(report->error()));
            emit ended(std::make_shared<const testing::Report>(std::move(**report)), work->isCancelled());
        });
    });
}

} // namespace plc::app
