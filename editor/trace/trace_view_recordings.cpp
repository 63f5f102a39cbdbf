// The recordings behind a trace: the running one, one from a file, one laid beneath to compare.
#include "editor/kit/edit_history.h"
#include "editor/kit/long_task.h"
#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "editor/trace/recording/run_recording.h"
#include "editor/trace/trace_view.h"
#include "runtime/base/messages.h"

#include <QDir>
#include <QGuiApplication>

namespace plc::trace {

void TraceView::setRecording(const Recording* recording) {
    m_live = recording;
    if (!m_opened) showRecording(recording);
}

/// Null when it was cancelled. The program in the file is compiled again, which takes longest.
Result<std::shared_ptr<RunRecording>> TraceView::readFile(const QString& path) {
    Result<std::shared_ptr<RunRecording>> opened = std::shared_ptr<RunRecording>();
    const bool isDone =
        kit::LongTask::runAside(tr("Opening %1…").arg(QFileInfo(path).fileName()), this, [&](Progress& progress) {
            opened = RunRecording::open(path.toStdString(), &progress);
        });
    if (!isDone) return std::shared_ptr<RunRecording>();
    if (opened)
        for (const Message& note : (*opened)->notes())
            emit noted(QStringLiteral("%1: %2").arg(QFileInfo(path).fileName(), kit::messageText(note)));
    return opened;
}

Result<void> TraceView::saveRecording(const QString& path) {
    if (!m_recording) return Error{errors::NothingRecorded(), path.toStdString()};
    const std::shared_ptr<void> held = m_hold ? m_hold() : nullptr;
    Result<void> saved;
    const bool isDone =
        kit::LongTask::runAside(tr("Saving the recording…"), this, [&, recording = m_recording](Progress& progress) {
            saved = recording->save(path.toStdString(), &progress);
        });
    return isDone ? saved : Result<void>();
}

Result<void> TraceView::openRecording(const QString& path) {
    auto opened = readFile(path);
    if (!opened) return opened.error();
    if (!*opened) return {};
    showRecording(nullptr);
    m_opened = *opened;
    m_openedName = QFileInfo(path).fileName();
    showRecording(m_opened.get());
    m_feed->pumpAll();
    m_plot->setFollowing(false);
    m_plot->fit();
    emit recordingShown();
    return {};
}

TraceView::Kept TraceView::kept() const {
    const plot::PlotModel& model = m_plot->model();
    Kept kept{m_setup,    m_path,   m_openedName, isModified(), m_plot->isFollowing(),
              model.from, model.to, m_opened,     m_beneath,    m_compared};
    kept.setup.span = model.to - model.from;
    kept.setup.cursorA = model.cursorA;
    kept.setup.cursorB = model.cursorB;
    return kept;
}

void TraceView::restore(Kept kept) {
    m_path = kept.path;
    m_compared = kept.compared; // it need not be read again
    if (kept.beneath) m_olderFeed = std::make_unique<TraceFeed>(*kept.beneath, m_store);
    m_beneath = std::move(kept.beneath);
    setSetup(std::move(kept.setup));
    if (kept.isModified) m_undo.resetClean();
    if (kept.opened) {
        showRecording(nullptr);
        m_opened = std::move(kept.opened);
        m_openedName = kept.openedName;
        showRecording(m_opened.get());
        m_feed->pumpAll();
        emit recordingShown();
    }
    m_plot->setFollowing(kept.isFollowing);
    m_plot->edit([&](plot::PlotModel& model) {
        model.from = kept.from;
        model.to = kept.to;
    });
    emit setupChanged();
}

void TraceView::closeRecording() {
    if (!m_opened) return;
    showRecording(nullptr);
    m_opened.reset();
    showRecording(m_live);
    m_plot->setFollowing(true);
    emit recordingShown();
}

QString TraceView::inProject(const QString& path) const {
    const QDir project(m_folder.isEmpty() ? QString() : m_folder + QStringLiteral("/.."));
    return QDir::cleanPath(path.isEmpty() ? project.absolutePath() : project.absoluteFilePath(path));
}

Result<void> TraceView::compareWith(const QString& path) {
    if (path.isEmpty()) {
        m_compared.clear();
        change(tr("Compare"), [](TraceSetup& s) { s.compareWith.clear(); });
        setBeneath(nullptr);
        return {};
    }
    auto opened = readFile(path);
    if (!opened) return opened.error();
    if (!*opened) return {};
    const QString shown = m_folder.isEmpty() ? path : QDir(inProject({})).relativeFilePath(path);
    m_compared = shown;
    change(tr("Compare"), [&](TraceSetup& s) { s.compareWith = shown.toStdString(); });
    setBeneath(*opened);
    return {};
}

/// The set-up names what lies beneath: after opening one, and after undo.
void TraceView::followCompareWith() {
    const QString wanted = QString::fromStdString(m_setup.compareWith);
    if (wanted == m_compared) return;
    m_compared = wanted;
    if (wanted.isEmpty()) {
        m_olderFeed.reset();
        m_beneath.reset();
        return;
    }
    auto opened = readFile(inProject(wanted));
    if (!opened) {
        emit failed(kit::messageText(opened.error()));
        return;
    }
    if (!*opened) return;
    m_beneath = *opened;
    m_olderFeed = std::make_unique<TraceFeed>(*m_beneath, m_store);
}

void TraceView::showRecording(const Recording* recording) {
    m_plot->edit([](plot::PlotModel& model) {
        model.curves.clear();
        model.markers.clear();
        model.trigger.reset();
        model.present.reset();
        model.origin = 0;
    });
    m_feed.reset();
    m_recording = recording;
    m_marks = SIZE_MAX;
    m_variables.setProgram(recording ? recording->program() : nullptr);
    if (recording) m_feed = std::make_unique<TraceFeed>(*recording, m_store);
    setupTaken();
}

void TraceView::programChanged() {
    if (!m_recording) return;
    m_variables.setProgram(m_recording->program());
    m_feed->retryProblems();
    rebuildModel();
}

void TraceView::setBeneath(std::shared_ptr<const Recording> recording) {
    m_plot->edit([](plot::PlotModel& model) {
        for (plot::PlotCurve& curve : model.curves) curve.beneath.clear();
    });
    m_olderFeed.reset();
    m_beneath = std::move(recording);
    if (m_beneath) m_olderFeed = std::make_unique<TraceFeed>(*m_beneath, m_store);
    setupTaken();
}

} // namespace plc::trace
