#include "app/start/tour.h"

#include "editor/kit/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

namespace plc::app {

Tour::Tour(std::vector<TourStop> stops, QWidget* window) : QWidget(window), m_stops(std::move(stops)) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Tour"));
    m_card = new QWidget(this);
    m_card->setAutoFillBackground(true);
    m_card->setBackgroundRole(QPalette::Base);
    m_title = new QLabel(m_card);
    QFont bold = m_title->font();
    bold.setBold(true);
    bold.setPointSizeF(bold.pointSizeF() * 1.2);
    m_title->setFont(bold);
    m_text = new QLabel(m_card);
    m_text->setWordWrap(true);
    m_count = new QLabel(m_card);
    m_back = new QPushButton(tr("Back"), m_card);
    m_next = new QPushButton(tr("Next"), m_card);
    m_next->setDefault(true);
    auto* end = new QPushButton(tr("End the tour"), m_card);
    end->setFlat(true);
    auto* row = new QHBoxLayout;
    row->addWidget(m_count);
    row->addStretch();
    row->addWidget(end);
    row->addWidget(m_back);
    row->addWidget(m_next);
    auto* layout = new QVBoxLayout(m_card);
    layout->setContentsMargins(18, 14, 18, 12);
    layout->addWidget(m_title);
    layout->addWidget(m_text);
    layout->addLayout(row);
    m_card->setFixedWidth(400);
    connect(m_next, &QPushButton::clicked, this, &Tour::next);
    connect(m_back, &QPushButton::clicked, this, &Tour::back);
    connect(end, &QPushButton::clicked, this, [this] {
        hide();
        emit finished();
    });
    window->installEventFilter(this);
    hide();
}

void Tour::begin() {
    setGeometry(parentWidget()->rect());
    for (QWidget* beside : parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (beside != this) beside->installEventFilter(this);
    raise();
    show();
    showStop(0);
}

void Tour::next() {
    if (m_current + 1 < count()) return showStop(m_current + 1);
    hide();
    emit finished();
}
void Tour::back() {
    if (m_current > 0) showStop(m_current - 1);
}

void Tour::showStop(int index) {
    m_current = index;
    const TourStop& stop = m_stops[static_cast<size_t>(index)];
    if (stop.prepare) stop.prepare();
    raise(); // docks that were shown now are above otherwise
    m_target = stop.target ? stop.target() : nullptr;
    m_title->setText(stop.title);
    m_text->setText(stop.text);
    m_count->setText(tr("%1 of %2").arg(index + 1).arg(count()));
    m_back->setEnabled(index > 0);
    m_next->setText(index + 1 < count() ? tr("Next") : tr("Done"));
    place();
    m_next->setFocus();
}

void Tour::place() {
    // Of a text that wraps, the size hint is a guess: only its height for this width has room for all of it.
    m_card->layout()->activate();
    m_card->resize(m_card->width(), m_card->heightForWidth(m_card->width()));
    const QRect area = rect().adjusted(12, 12, -12, -12);
    QPoint at = area.center() - QPoint(m_card->width() / 2, m_card->height() / 2);
    if (m_target && m_target->isVisible()) {
        const QRect target(m_target->mapTo(parentWidget(), QPoint(0, 0)), m_target->size());
        if (target.bottom() + m_card->height() + 16 < area.bottom())
            at = {target.left(), target.bottom() + 12};
        else if (target.top() - m_card->height() - 16 > area.top())
            at = {target.left(), target.top() - m_card->height() - 12};
        else if (target.right() + m_card->width() + 16 < area.right())
            at = {target.right() + 12, target.top()};
        else
            at = {target.left() - m_card->width() - 12, target.top() + 30};
    }
    at.setX(std::clamp(at.x(), area.left(), std::max(area.left(), area.right() - m_card->width())));
    at.setY(std::clamp(at.y(), area.top(), std::max(area.top(), area.bottom() - m_card->height())));
    m_card->move(at);
    update();
}

void Tour::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath shade;
    shade.addRect(rect());
    if (m_target && m_target->isVisible()) {
        const QRectF target = QRectF(QPointF(m_target->mapTo(parentWidget(), QPoint(0, 0))), QSizeF(m_target->size()))
                                  .adjusted(-4, -4, 4, 4);
        QPainterPath hole;
        hole.addRoundedRect(target, 6, 6);
        shade = shade.subtracted(hole);
        painter.setPen(QPen(kit::colors().accent, 2));
        painter.drawPath(hole);
    }
    painter.fillPath(shade, QColor(0, 0, 0, 110));
}

void Tour::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        hide();
        emit finished();
    } else if (event->key() == Qt::Key_Right) {
        next();
    } else if (event->key() == Qt::Key_Left) {
        back();
    }
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) {
        setGeometry(parentWidget()->rect());
        place();
    }
    // Somebody who runs the program meanwhile: the dock of a fault comes to the front.
    if (watched != parentWidget() && event->type() == QEvent::ZOrderChange && isVisible()) raise();
    return QWidget::eventFilter(watched, event);
}

} // namespace plc::app
