#include "app/frame/kept_size.h"

#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QResizeEvent>
#include <QScreen>

namespace plc::app {

void KeptSize::keep(QMainWindow& window, QSize size) {
    for (KeptSize* before : window.findChildren<KeptSize*>(QString(), Qt::FindDirectChildrenOnly)) delete before;
    if (window.isMaximized() || window.isFullScreen()) return;
    new KeptSize(window, size);
}

KeptSize::KeptSize(QMainWindow& window, QSize size) : QObject(&window), m_window(window), m_size(size) {
    constexpr int kRest = 1000; // ms without a question of the layout
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    connect(&m_rest, &QTimer::timeout, this, &QObject::deleteLater);
    window.installEventFilter(this);
    window.layout()->activate();
    giveBack();
    m_rest.start();
}

void KeptSize::giveBack() {
    if (!m_window.isMaximized() && !m_window.isFullScreen()) m_window.resize(m_window.size().boundedTo(m_size));
}

bool KeptSize::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) {
        m_rest.start();
        QMetaObject::invokeMethod(this, &KeptSize::giveBack, Qt::QueuedConnection); // when it has been answered
    }
    if (event->type() == QEvent::Resize) {
        const auto* resized = static_cast<QResizeEvent*>(event);
        if (resized->spontaneous()) // by the user, or an echo of what has just been given back
            m_size = resized->size().boundedTo(m_window.screen()->availableSize().expandedTo(m_size));
        else
            QMetaObject::invokeMethod(this, &KeptSize::giveBack, Qt::QueuedConnection);
    }
    return QObject::eventFilter(object, event);
}

} // namespace plc::app
