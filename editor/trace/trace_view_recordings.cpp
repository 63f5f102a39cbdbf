// The recordings behind a trace: the running one, one from a file, one laid beneath to compare.
#include "editor/kit/edit_history.h"
#include "editor/kit/long_task.h"
#include "editor/kit/theme.h"
#include "editor/trace/session_recording.h"
#include "editor/trace/trace_view.h"

#include <QDir>
#include <QGuiApplication>

namespace plc::trace {

void TraceView::setRecording(const Recording* recording) {
    m_live = recording;
    if (!m_opened) showRecording(recording);
}

Result<void> TraceView::openRecording(const QString& path) {
    QGuiApplication::setOverrideCursor(Qt::WaitCursor); // the program in it is compiled again
    auto opened = FileRecording::open(path.toStdString());
    QGuiApplication::restoreOverrideCursor();
    if (!opened) return opened.error();
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
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    auto opened = FileRecording::open(path.toStdString());
    QGuiApplication::restoreOverrideCursor();
    if (!opened) return opened.error();
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
    auto opened = FileRecording::open(inProject(wanted).toStdString());
    if (!opened) {
        emit failed(QString::fromStdString(opened.error().text()));
        return;
    }
    m_beneath = *opened;
    m_olderFeed = std::make_unique<TraceFeed>(*m_beneath, m_store);
}

void TraceView::showRecording(const Recording* recording) {
    m_plot->edit([](kit::PlotModel& model) {
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
    m_plot->edit([](kit::PlotModel& model) {
        for (kit::PlotCurve& curve : model.curves) curve.beneath.clear();
    });
    m_olderFeed.reset();
    m_beneath = std::move(recording);
    if (m_beneath) m_olderFeed = std::make_unique<TraceFeed>(*m_beneath, m_store);
    setupTaken();
}

} // namespace plc::trace
