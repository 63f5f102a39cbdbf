// What the server tells about itself: as JSON for scripts, as Prometheus text for monitoring. Functions, main thread.
#pragma once
#include "projects/devices/engine.h"
#include "projects/session/session.h"

#include <QByteArray>

namespace plc::serve {

struct ServerFigures {
    std::string project;
    size_t browsers = 0, operators = 0, studios = 0;
    uint64_t sentBytes = 0, sentFrames = 0;
    uint64_t refusedConnections = 0, refusedLogIns = 0, droppedBrowsers = 0;
    double uptimeSeconds = 0;
    std::string recordingProblem;
    uint64_t recordingBytes = 0, recordingFiles = 0;
    std::vector<devices::DeviceStatus> devices;
};

[[nodiscard]] QByteArray statusJson(const session::Session& session, const ServerFigures& figures);
[[nodiscard]] QByteArray prometheusText(const session::Session& session, const ServerFigures& figures);

} // namespace plc::serve
