#include "app/frame/status_line.h"

#include "app/project/problems_view.h"
#include "editor/debug/fault_scan.h"
#include "editor/kit/icons.h"
#include "editor/kit/message_text.h"
#include "editor/kit/occurrence_text.h"
#include "editor/kit/theme.h"
#include "editor/kit/work_strip.h"
#include "editor/plot/model/plot_scale.h"

#include <QCoreApplication>
#include <QLabel>
#include <QLocale>
#include <QStatusBar>
#include <QToolButton>

namespace plc::app {

namespace {
/// The line speaks as part of the window.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(plc::app::MainWindow)
};
} // namespace

StatusLine::StatusLine(QStatusBar& bar, editor::RunControl& control, editor::Workspace& workspace,
                       ProblemsView& problems)
    : QObject(&bar), m_control(control), m_problems(problems) {
    makeButtons(bar);
    makeLabels(bar);
    connect(&control, &editor::RunControl::statusChanged, this, &StatusLine::statusChanged);
    connect(&control, &editor::RunControl::sessionChanged, this, &StatusLine::refresh);
    connect(&control, &editor::RunControl::viewedChanged, this, &StatusLine::refresh);
    connect(&problems, &ProblemsView::countsChanged, this, &StatusLine::refresh);
    connect(&workspace, &editor::Workspace::closed, this, &StatusLine::refresh);
    connect(&kit::Theme::current(), &kit::Theme::changed, this, &StatusLine::refresh);
}

void StatusLine::makeButtons(QStatusBar& bar) {
    m_faultButton = new QToolButton(&bar);
    m_faultButton->setAutoRaise(true);
    m_faultButton->setAccessibleName(Words::tr("Controller fault"));
    m_faultButton->setIcon(kit::icon(kit::Icon::Error));
    m_faultButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_faultButton->hide();
    bar.addPermanentWidget(m_faultButton);
    m_work = new kit::WorkStrip(&bar);
    bar.addPermanentWidget(m_work);
    m_problemButton = new QToolButton(&bar);
    m_problemButton->setAutoRaise(true);
    m_problemButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_problemButton->setIcon(kit::icon(kit::Icon::Good));
    bar.addPermanentWidget(m_problemButton);
    connect(m_faultButton, &QToolButton::clicked, this, &StatusLine::goToFault);
    connect(m_problemButton, &QToolButton::clicked, this, &StatusLine::problemsRequested);
}

void StatusLine::makeLabels(QStatusBar& bar) {
    const auto label = [&](int width) {
        auto* made = new QLabel(&bar);
        made->setMinimumWidth(width);
        made->setContentsMargins(6, 0, 6, 0);
        bar.addPermanentWidget(made);
        return made;
    };
    m_cursor = label(90);
    m_history = label(80);
    m_time = label(150);
    m_load = label(130);
    m_state = label(90);
    QFont bold = m_state->font();
    bold.setBold(true);
    m_state->setFont(bold);
    m_state->setAlignment(Qt::AlignCenter);
    m_state->setAccessibleName(Words::tr("State of the controller"));
}

void StatusLine::hideCursor() { m_cursor->clear(); }

void StatusLine::showCursor(int line, int column) { m_cursor->setText(Words::tr("%1 : %2").arg(line).arg(column)); }

QString StatusLine::speedText(session::RunMode mode) {
    if (mode.pace == session::Pace::Fastest) return Words::tr("at full speed");
    return Words::tr("%1 ×").arg(QLocale().toString(mode.pace == session::Pace::Real ? 1.0 : mode.factor, 'g', 6));
}

void StatusLine::statusChanged() {
    // Figures are read by people; a change of state is shown at once.
    const auto now = m_control.status().state;
    if (now == m_shownState && now == controller::State::Running && m_sinceStatus.isValid() &&
        m_sinceStatus.elapsed() < 150)
        return;
    if (now != m_shownState && now == controller::State::Fault) emit failed();
    m_shownState = now;
    m_sinceStatus.start();
    refresh();
}

void StatusLine::refresh() {
    showState();
    showFigures();
    showFault();
    const int errors = m_problems.errorCount(), warnings = m_problems.warningCount();
    m_problemButton->setIcon(kit::icon(errors ? kit::Icon::Error : warnings ? kit::Icon::Warning : kit::Icon::Good));
    m_problemButton->setText(errors || warnings ? QString("%1 / %2").arg(errors).arg(warnings)
                                                : Words::tr("no problems"));
    emit changed();
}

namespace {

struct Look {
    QString text;
    QColor ground, ink;
};

Look lookOf(controller::State state, session::RunMode mode) {
    using controller::State;
    const kit::ThemeColors& c = kit::colors();
    switch (state) {
    case State::Running:
        return {mode.pace == session::Pace::Real ? Words::tr("RUN")
                                                 : Words::tr("RUN %1").arg(StatusLine::speedText(mode)),
                c.good, c.base};
    case State::Paused:
        return {Words::tr("PAUSE"), c.warning, c.base};
    case State::Halted:
        return {Words::tr("HALT"), c.warning, c.base};
    case State::Fault:
        return {Words::tr("FAULT"), c.bad, c.base};
    case State::Stopped:
        break;
    }
    return {Words::tr("STOP"), c.alternate, c.text};
}

} // namespace

void StatusLine::showState() {
    const kit::ThemeColors& c = kit::colors();
    Look look{Words::tr("OFFLINE"), c.alternate, c.muted};
    if (m_control.showsRecorded())
        look = {Words::tr("RECORDING"), c.info, c.base};
    else if (m_control.isOnline() && m_control.viewed() && !m_control.faultScan().isShown())
        look = {Words::tr("PAST"), c.info, c.base};
    else if (m_control.isOnline())
        look = lookOf(m_control.status().state, m_control.mode());
    m_state->setText(look.text);
    const QString sheet = QString("QLabel { background: %1; color: %2; border-radius: 3px; margin: 2px; }")
                              .arg(look.ground.name(), look.ink.name());
    if (m_state->styleSheet() != sheet) m_state->setStyleSheet(sheet);
}

void StatusLine::showFigures() {
    if (!m_control.isOnline()) {
        for (QLabel* each : {m_time, m_load, m_history}) each->clear();
        return;
    }
    const session::Status& status = m_control.status();
    m_time->setText(
        Words::tr("%1 · scan %2").arg(plot::momentText(status.time.count() / 1'000'000 * 1'000'000)).arg(status.scans));
    m_load->setText(Words::tr("%1 µs · %2 % load")
                        .arg(QLocale().toString(static_cast<double>(status.lastScanNs) / 1e3, 'f', 1),
                             QLocale().toString(100 * status.load, 'f', 1)));
    const history::Statistics all = m_control.session()->history().statistics();
    m_history->setText(Words::tr("%1 MB recorded").arg(all.bytes >> 20));
    m_history->setToolTip(Words::tr("%1 scans of %2 MB at most").arg(all.scans).arg(all.budget >> 20));
}

void StatusLine::showFault() {
    const session::Status& status = m_control.status();
    const auto& fault = status.fault ? status.fault : status.simulationFault;
    m_faultButton->setVisible(m_control.isOnline() && fault.has_value());
    if (!fault) return;
    // The button is as wide as its text: what to do about it is in the tip, and in the log.
    m_faultButton->setText(kit::occurrenceText(fault->message));
    m_faultButton->setToolTip(kit::messageText(fault->message) + u'\n' + Words::tr("Go to the line"));
}

void StatusLine::goToFault() {
    const session::Status& status = m_control.status();
    const auto& fault = status.fault ? status.fault : status.simulationFault;
    if (const auto place = fault ? m_control.placeInText(fault->range) : std::nullopt)
        emit placeRequested(place->file, place->offset, place->length);
}

} // namespace plc::app
