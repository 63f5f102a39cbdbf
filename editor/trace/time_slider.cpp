#include "editor/trace/time_slider.h"

#include "editor/kit/message_text.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_model.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/trace/curves/trace_plot.h"

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>

namespace plc::trace {

namespace {
constexpr double Edge = 9;
}

TimeBar::TimeBar(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Time"));
    setCursor(Qt::PointingHandCursor);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&kit::Theme::current(), &kit::Theme::changed, this, qOverload<>(&QWidget::update));
}

void TimeBar::setRange(int64_t recordedFrom, int64_t to) {
    if (m_from == recordedFrom && m_to == to) return;
    m_from = recordedFrom;
    m_to = to;
    update();
}

void TimeBar::setEvents(std::vector<Event> events) {
    m_events = std::move(events);
    update();
}

void TimeBar::setBranches(std::vector<int64_t> branches) {
    m_branches = std::move(branches);
    update();
}

void TimeBar::setTime(std::optional<int64_t> time) {
    m_time = time;
    update();
}

double TimeBar::xOf(int64_t time) const {
    if (m_to <= 0) return Edge;
    return Edge + (width() - 2 * Edge) * static_cast<double>(time) / static_cast<double>(m_to);
}

int64_t TimeBar::timeAt(double x) const {
    const double part = std::clamp((x - Edge) / std::max(1.0, width() - 2 * Edge), 0.0, 1.0);
    return static_cast<int64_t>(part * static_cast<double>(m_to));
}

void TimeBar::paintEvent(QPaintEvent*) {
    const kit::ThemeColors& c = kit::colors();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = height() / 2.0;
    const QRectF groove(Edge, middle - 3, width() - 2 * Edge, 6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.hover);
    painter.drawRoundedRect(groove, 3, 3);
    if (m_to <= 0) return;
    painter.setBrush(QBrush(c.border, Qt::BDiagPattern)); // no longer kept
    if (m_from > 0)
        painter.drawRect(QRectF(QPointF(groove.left(), groove.top()), QPointF(xOf(m_from), groove.bottom())));
    QColor kept = c.accent;
    kept.setAlphaF(0.45f);
    painter.setBrush(kept);
    painter.drawRoundedRect(QRectF(QPointF(xOf(m_from), groove.top()), QPointF(xOf(m_to), groove.bottom())), 3, 3);
    for (const Event& event : m_events) {
        painter.setBrush(event.color);
        painter.drawRoundedRect(QRectF(xOf(event.time) - 1, middle - 9, 2, 18), 1, 1);
    }
    painter.setPen(QPen(c.plotTrigger, 1.6));
    painter.setBrush(c.window);
    for (int64_t branch : m_branches) {
        const QPointF p(xOf(branch), middle);
        painter.drawPolygon(QPolygonF({p + QPointF(-5, 0), p + QPointF(0, -5), p + QPointF(5, 0), p + QPointF(0, 5)}));
    }
    const double x = xOf(m_time.value_or(m_to));
    painter.setPen(QPen(c.base, 2));
    painter.setBrush(m_time ? c.accent : c.good);
    painter.drawEllipse(QPointF(x, middle), 7, 7);
    if (hasFocus()) {
        painter.setPen(QPen(c.accent, 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(x, middle), 10, 10);
    }
}

void TimeBar::wantAt(double x) {
    // At the very end means live: the newest scan, whatever comes.
    if (x >= width() - Edge - 2)
        emit liveWanted();
    else
        emit timeWanted(std::max(timeAt(x), m_from));
}

void TimeBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_to > 0) wantAt(event->position().x());
}

void TimeBar::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton && m_to > 0) wantAt(event->position().x());
}

bool TimeBar::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    auto* help = static_cast<QHelpEvent*>(event);
    QString text = m_to > 0 ? plot::momentText(timeAt(help->pos().x()) / 1'000'000 * 1'000'000) : QString();
    for (const Event& e : m_events)
        if (std::abs(xOf(e.time) - help->pos().x()) <= 4)
            text = QStringLiteral("%1\n%2").arg(e.text, plot::momentText(e.time));
    for (int64_t branch : m_branches)
        if (std::abs(xOf(branch) - help->pos().x()) <= 6)
            text = tr("Resumed from here\n%1").arg(plot::momentText(branch));
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

TimeSlider::TimeSlider(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Time slider"));
    setFocusPolicy(Qt::StrongFocus);
    m_bar = new TimeBar(this);
    m_label = new QLabel(this);
    m_label->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("scan 00000000  0:00:00.000")));
    m_variable = new kit::ExpressionEdit(this);
    m_variable->setPlaceholderText(tr("Variable"));
    m_variable->setAccessibleName(tr("Variable whose changes to step to"));
    m_variable->setToolTip(tr("The arrows beside step to its previous and next change"));
    m_variable->setMaximumWidth(170);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 2, 8, 2);
    layout->setSpacing(3);
    m_steps = {
        makeButton(kit::Icon::StepBack, tr("One scan back (Left)"), [this] { stepScans(-1); }),
        makeButton(kit::Icon::Step, tr("One scan forward (Right)"), [this] { stepScans(1); }),
        makeButton(kit::Icon::PreviousChange, tr("Previous change of the variable (Ctrl+Left)"),
                   [this] { stepChange(-1); }),
        makeButton(kit::Icon::NextChange, tr("Next change of the variable (Ctrl+Right)"), [this] { stepChange(1); })};
    layout->addWidget(m_steps[0]);
    layout->addWidget(m_steps[1]);
    layout->addWidget(m_bar, 1);
    layout->addWidget(m_label);
    layout->addWidget(m_steps[2]);
    layout->addWidget(m_variable);
    layout->addWidget(m_steps[3]);
    m_resume = makeButton(kit::Icon::Resume, tr("Resume the controller from this scan"), [this] {
        if (m_position) emit resumeRequested(*m_position);
    });
    m_live = makeButton(kit::Icon::Live, tr("Back to the newest scan (End)"), [this] { goLive(); });
    layout->addWidget(m_resume);
    layout->addWidget(m_live);
    connect(m_bar, &TimeBar::timeWanted, this, [this](qint64 time) {
        if (!m_recording) return;
        if (const auto position = m_recording->positionAt(time))
            setPosition(std::max(*position, m_recording->extent().first));
    });
    connect(m_bar, &TimeBar::liveWanted, this, &TimeSlider::goLive);
    connect(m_variable, &QLineEdit::returnPressed, this, [this] { stepChange(-1); });
    m_timer.setInterval(150);
    connect(&m_timer, &QTimer::timeout, this, &TimeSlider::refresh);
    showState();
}

QToolButton* TimeSlider::makeButton(kit::Icon icon, const QString& tip, std::function<void()> run) {
    auto* button = new QToolButton(this);
    button->setIcon(kit::icon(icon));
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    connect(button, &QToolButton::clicked, this, std::move(run));
    return button;
}

void TimeSlider::setRecording(const Recording* recording) {
    m_recording = recording;
    if (m_position) {
        m_position.reset();
        emit positionChanged(m_position);
    }
    refresh();
}

std::vector<PositionRange> TimeSlider::chain() const {
    return history::chainTo(m_recording->branches(), m_recording->extent().second);
}

void TimeSlider::setPosition(std::optional<Position> position) {
    if (position && (!m_recording || !m_recording->stamp(*position))) return;
    if (position == m_position) return;
    m_position = position;
    showState();
    emit positionChanged(m_position);
}

void TimeSlider::stepScans(int scans) {
    if (!m_recording || m_recording->extent().second == 0) return;
    const auto path = chain();
    const Position oldest = m_recording->extent().first;
    std::optional<Position> at = m_position ? *m_position : m_recording->extent().second - 1;
    for (; scans != 0 && at; scans += scans > 0 ? -1 : 1) {
        const auto next = scans > 0 ? nextOnChain(path, *at) : previousOnChain(path, *at);
        if (scans > 0 && !next) {
            goLive(); // beyond the newest
            return;
        }
        if (!next || *next < oldest) {
            emit message(tr("Older scans are no longer kept."));
            break;
        }
        at = next;
    }
    setPosition(at);
}

bool TimeSlider::stepChange(int direction) {
    const std::string variable = m_variable->text().trimmed().toStdString();
    if (!m_recording || m_recording->extent().second == 0 || variable.empty()) return false;
    if (const auto type = m_recording->typeOf(variable); !type) {
        emit message(kit::messageText(type.error().message));
        return false;
    }
    const Position from = m_position ? *m_position : m_recording->extent().second - 1;
    const auto found = m_recording->findChange(
        variable, from, direction < 0 ? history::History::Direction::Backward : history::History::Direction::Forward);
    if (!found) {
        emit message(direction < 0 ? tr("%1 does not change before this scan.").arg(m_variable->text())
                                   : tr("%1 does not change after this scan.").arg(m_variable->text()));
        return false;
    }
    setPosition(found);
    return true;
}

QString TimeSlider::positionText() const {
    if (!m_recording || m_recording->extent().second == 0) return tr("No recording");
    const Position position = m_position ? *m_position : m_recording->extent().second - 1;
    const auto stamp = m_recording->stamp(position);
    if (!stamp) return tr("no longer kept");
    return tr("scan %1  %2").arg(stamp->scan).arg(plot::momentText(stamp->time.count()));
}

void TimeSlider::refresh() {
    if (!m_recording) {
        m_bar->setRange(0, 0);
        showState();
        return;
    }
    const auto [first, end] = m_recording->extent();
    const auto path = chain();
    const auto newest = end > 0 ? m_recording->stamp(end - 1) : std::nullopt;
    std::optional<history::ScanStamp> oldest;
    for (const PositionRange& range : path)
        if (!oldest && range.end > first) oldest = m_recording->stamp(std::max(first, range.begin));
    m_bar->setRange(oldest ? oldest->time.count() : 0, newest ? newest->time.count() : 0);
    if (m_position && *m_position < first)
        setPosition(oldest ? std::optional(oldest->position) : std::nullopt); // evicted under our feet
    plot::PlotModel marks;
    applyMarks(marks, *m_recording, path);
    std::vector<TimeBar::Event> events;
    for (const plot::PlotMarker& marker : marks.markers)
        if (marker.kind != plot::MarkerKind::Branch)
            events.push_back({marker.time, plot::markerColor(marker.kind), marker.text});
    m_bar->setEvents(std::move(events));
    std::vector<int64_t> branches;
    for (const history::Branch& branch : m_recording->branches())
        if (branch.first > 0)
            if (const auto stamp = m_recording->stamp(branch.parent)) branches.push_back(stamp->time.count());
    m_bar->setBranches(std::move(branches));
    showState();
}

void TimeSlider::showState() {
    const bool any = m_recording && m_recording->extent().second > 0;
    m_label->setText(positionText());
    const auto stamp = m_position && m_recording ? m_recording->stamp(*m_position) : std::nullopt;
    m_bar->setTime(stamp ? std::optional(stamp->time.count()) : std::nullopt);
    m_bar->setEnabled(any);
    for (QToolButton* button : m_steps) button->setEnabled(any);
    m_live->setEnabled(any && m_position);
    m_resume->setEnabled(any && m_position);
}

void TimeSlider::keyPressEvent(QKeyEvent* event) {
    const bool control = event->modifiers() & Qt::ControlModifier;
    switch (event->key()) {
    case Qt::Key_Left:
        control ? (void)stepChange(-1) : stepScans(-1);
        return;
    case Qt::Key_Right:
        control ? (void)stepChange(1) : stepScans(1);
        return;
    case Qt::Key_PageUp:
        stepScans(-100);
        return;
    case Qt::Key_PageDown:
        stepScans(100);
        return;
    case Qt::Key_End:
        goLive();
        return;
    case Qt::Key_Home:
        if (m_recording)
            for (const PositionRange& range : chain())
                if (range.end > m_recording->extent().first) {
                    setPosition(std::max(range.begin, m_recording->extent().first));
                    return;
                }
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void TimeSlider::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
    m_timer.start();
}

void TimeSlider::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    m_timer.stop();
}

} // namespace plc::trace
