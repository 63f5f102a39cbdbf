#include "app/frame/kept_size.h"

#include "editor/kit/post.h"

#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QResizeEvent>
#include <QScreen>

namespace plc::app {

void KeptSize::keep(QMainWindow& window, QSize size) {
    for (KeptSize* before : window.findChildren<KeptSize*>(QString(), Qt::FindDirectChildrenOnly)) {
        size = size.boundedTo(before->m_size); // what it has not been able to give back yet
        delete before;
    }
    if (window.isMaximized() || window.isFullScreen()) return;
    new KeptSize(window, size);
}

KeptSize::KeptSize(QMainWindow& window, QSize size) : QObject(&window), m_window(window), m_size(size) {
    constexpr int kRest = 1000; // ms without a question of the layout
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, &KeptSize::rest);
    window.installEventFilter(this);
    window.layout()->activate();
    giveBack();
    m_rest.start();
}

/// Not every change of what docks need is heard of: until the window fits, it is tried again.
void KeptSize::rest() {
    constexpr int kTries = 30;
    giveBack();
    const bool fits = m_window.width() <= m_size.width() && m_window.height() <= m_size.height();
    if (fits || ++m_tries >= kTries)
        deleteLater();
    else
        m_rest.start();
}

void KeptSize::giveBack() {
    if (!m_window.isMaximized() && !m_window.isFullScreen()) m_window.resize(m_window.size().boundedTo(m_size));
}

bool KeptSize::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) {
        m_rest.start();
        kit::post(this, [this] { giveBack(); }); // when it has been answered
    }
    if (event->type() == QEvent::Resize) {
        const auto* resized = static_cast<QResizeEvent*>(event);
        const QSize least = m_window.minimumSize();
        const bool isForced = least.width() > m_size.width() || least.height() > m_size.height();
        if (resized->spontaneous()) // by the user, or an echo of what has just been given back
            m_size = resized->size().boundedTo(m_window.screen()->availableSize().expandedTo(m_size));
        else if (isForced)
            kit::post(this, [this] { giveBack(); });
        else
            m_size = resized->size(); // on purpose
    }
    return QObject::eventFilter(object, event);
}

} // namespace plc::app
