// Runs what is posted: layouts, calls of kit::post, timers of no time, widgets that are deleted later, and what those
// post in turn. No time is waited for: what takes time has a condition, and QTest::qWaitFor waits for it. GUI thread.
#pragma once
#include <QCoreApplication>
#include <QEvent>

namespace plc {

inline void settle() {
    for (int round = 0; round < 5; ++round) {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

} // namespace plc
