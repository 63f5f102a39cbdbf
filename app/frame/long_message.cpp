#include "app/frame/long_message.h"

#include <QEvent>
#include <QStatusBar>

#include <algorithm>

namespace plc::app {

LongMessage::LongMessage(QStatusBar& bar, QWidget& window) : QLabel(&window), m_bar(bar), m_window(window) {
    setObjectName("longMessage");
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setMargin(8);
    setFrameStyle(QFrame::Box | QFrame::Plain);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    setForegroundRole(QPalette::ToolTipText);
    hide();
    connect(&bar, &QStatusBar::messageChanged, this, &LongMessage::showWhole);
    window.installEventFilter(this);
}

void LongMessage::showWhole(const QString& text) {
    const bool fits = m_bar.fontMetrics().horizontalAdvance(text) <= room();
    setText(fits ? QString() : text);
    setVisible(!fits);
    if (!fits) place();
}

int LongMessage::room() const {
    constexpr int kMargins = 18; // as QStatusBar leaves them around its text
    int end = m_bar.width();
    for (const QWidget* each : m_bar.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (each->isVisible() && each->width() > 0) end = std::min(end, each->x());
    return end - kMargins;
}

void LongMessage::place() {
    constexpr int kWidest = 720, kGap = 6;
    const int width = std::min(kWidest, m_window.width() - 2 * kGap);
    resize(width, heightForWidth(width));
    move(kGap, m_bar.geometry().top() - kGap - height());
    raise();
}

bool LongMessage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && isVisible()) place();
    return QLabel::eventFilter(watched, event);
}

void LongMessage::mousePressEvent(QMouseEvent*) { hide(); }

} // namespace plc::app
