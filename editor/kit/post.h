// What another thread gives to the thread of a QObject: results of builds, analyses and tests, news of alarms. Header
// only, owns nothing; post may be called on any thread. Qt's queue hands calls over by locks that the thread sanitizer
// cannot see, since Qt is not built with it; the lock here it does see, so that all these hand-overs stay watched
// (tests/sanitizers).
#pragma once
#include <QMetaObject>
#include <QObject>

#include <mutex>
#include <utility>

namespace plc::kit {

inline std::mutex& handOver() {
    static std::mutex mutex;
    return mutex;
}

/// Calls `call` on the thread of `receiver` when it comes to its events, and not at all if `receiver` is gone by then.
template <class Call> void post(QObject* receiver, Call call) {
    const std::lock_guard given(handOver());
    QMetaObject::invokeMethod(
        receiver,
        [call = std::move(call)]() mutable {
            { const std::lock_guard taken(handOver()); }
            call();
        },
        Qt::QueuedConnection);
}

} // namespace plc::kit
