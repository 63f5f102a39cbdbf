#include "app/serve/metrics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace plc::serve {

namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(controller::State state) {
    switch (state) {
    case controller::State::Stopped:
        return "stopped";
    case controller::State::Running:
        return "running";
    case controller::State::Paused:
        return "paused";
    case controller::State::Halted:
        return "halted";
    case controller::State::Fault:
        return "fault";
    }
    return "";
}

Json faultJson(const std::optional<controller::Fault>& fault) {
    return fault ? Json(fault->message.english()) : Json(nullptr);
}

Json tasksJson(const session::Session& session) {
    Json tasks = Json::array();
    for (const controller::TaskStatistics& task : session.taskStatistics())
        tasks.push_back({{"name", task.name},
                         {"count", task.count},
                         {"overruns", task.overruns},
                         {"last_ns", task.lastNs},
                         {"min_ns", task.minNs},
                         {"max_ns", task.maxNs},
                         {"mean_ns", task.meanNs},
                         {"jitter_ns", task.jitterNs}});
    return tasks;
}

Json histogramJson(const session::TimeHistogram& of) {
    return {{"mean_ns", of.meanNs()}, {"most_ns", of.mostNs()}, {"below_us_powers_of_two", of.buckets()}};
}

/// The worst scans are numbers of the recording, in which each can be replayed.
Json scanTimesJson(const session::ScanTimes& times) {
    Json worst = Json::array();
    for (const session::ScanTime& scan : times.worst)
        worst.push_back({{"scan", scan.scan},
                         {"time_ns", scan.at.count()},
                         {"wake_up_ns", scan.wakeUpNs},
                         {"execution_ns", scan.executionNs}});
    return {{"wake_up", histogramJson(times.wakeUp)},
            {"execution", histogramJson(times.execution)},
            {"end", histogramJson(times.end)},
            {"worst", worst}};
}

const char* nameOf(devices::LinkState state) {
    switch (state) {
    case devices::LinkState::Off:
        return "off";
    case devices::LinkState::Connecting:
        return "connecting";
    case devices::LinkState::Online:
        return "online";
    case devices::LinkState::Lost:
        return "lost";
    }
    return "";
}

size_t goodChannels(const devices::DeviceStatus& device) {
    return static_cast<size_t>(
        std::count_if(device.channels.begin(), device.channels.end(),
                      [](const devices::ChannelStatus& channel) { return channel.quality == devices::Quality::Good; }));
}

Json devicesJson(const std::vector<devices::DeviceStatus>& all) {
    Json out = Json::array();
    for (const devices::DeviceStatus& device : all)
        out.push_back({{"name", device.name},
                       {"state", nameOf(device.state)},
                       {"problem", device.problem.isEmpty() ? Json(nullptr) : Json(device.problem.english())},
                       {"channels", device.channels.size()},
                       {"good_channels", goodChannels(device)},
                       {"requests", device.figures.requests},
                       {"errors", device.figures.errors},
                       {"connections", device.figures.connects},
                       {"bytes_in", device.figures.bytesIn},
                       {"bytes_out", device.figures.bytesOut},
                       {"latency_mean_ns", device.figures.meanLatencyNs},
                       {"latency_most_ns", device.figures.worstLatencyNs}});
    return out;
}

/// One metric after the other, as the text format of Prometheus wants it.
class Metrics {
public:
    void add(const char* name, const char* type, const char* help, double value) {
        begin(name, type, help);
        line(name, {}, value);
    }
    void begin(const char* name, const char* type, const char* help) {
        m_text += QByteArray("# HELP ") + name + ' ' + help + "\n# TYPE " + name + ' ' + type + '\n';
    }
    void line(const QByteArray& name, const QByteArray& labels, double value) {
        m_text += name;
        if (!labels.isEmpty()) m_text += '{' + labels + '}';
        m_text += ' ' + QByteArray::number(value, 'g', 15) + '\n';
    }
    QByteArray text() const { return m_text; }

private:
    QByteArray m_text;
};

QByteArray quoted(const std::string& text) {
    QByteArray out = QByteArray::fromStdString(text);
    return '"' + out.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n") + '"';
}

/// Counts by powers of two of a microsecond, the last one of all that is longer.
template <class Counts>
void addBuckets(Metrics& out, const QByteArray& name, const QByteArray& label, const Counts& counts, double seconds) {
    const QByteArray before = label.isEmpty() ? QByteArray() : label + ',';
    uint64_t sum = 0;
    for (size_t i = 0; i < counts.size(); ++i) {
        sum += counts[i];
        const double limit = std::ldexp(1e-6, static_cast<int>(i));
        const bool isLast = i + 1 == counts.size();
        out.line(name + "_bucket",
                 before + "le=\"" + (isLast ? QByteArray("+Inf") : QByteArray::number(limit, 'g', 9)) + '"',
                 static_cast<double>(sum));
    }
    out.line(name + "_sum", label, seconds);
    out.line(name + "_count", label, static_cast<double>(sum));
}

void addTasks(Metrics& out, const session::Session& session) {
    const std::vector<controller::TaskStatistics> tasks = session.taskStatistics();
    const auto each = [&](const char* name, const char* type, const char* help, auto value) {
        out.begin(name, type, help);
        for (const controller::TaskStatistics& task : tasks) out.line(name, "task=" + quoted(task.name), value(task));
    };
    using Task = controller::TaskStatistics;
    each("stepwise_task_runs_total", "counter", "Runs of the task.", [](const Task& t) { return double(t.count); });
    each("stepwise_task_overruns_total", "counter", "Runs that took longer than the task's interval.",
         [](const Task& t) { return double(t.overruns); });
    each("stepwise_task_jitter_seconds_max", "gauge", "Greatest deviation of a start from its due time.",
         [](const Task& t) { return double(t.jitterNs) * 1e-9; });
    out.begin("stepwise_task_duration_seconds", "histogram", "Execution time of the task.");
    for (const Task& task : tasks) {
        addBuckets(out, "stepwise_task_duration_seconds", "task=" + quoted(task.name), task.histogram,
                   task.meanNs * static_cast<double>(task.count) * 1e-9);
    }
}

void addScanTimes(Metrics& out, const session::ScanTimes& times) {
    const auto each = [&](const char* name, const char* help, const session::TimeHistogram& of) {
        out.begin(name, "histogram", help);
        addBuckets(out, name, {}, of.buckets(), of.meanNs() * static_cast<double>(of.count()) * 1e-9);
    };
    each("stepwise_scan_wake_up_seconds", "How late scans began.", times.wakeUp);
    each("stepwise_scan_execution_seconds", "How long scans took.", times.execution);
    each("stepwise_scan_end_seconds", "How long after they were due scans ended.", times.end);
}

void addDevices(Metrics& out, const std::vector<devices::DeviceStatus>& all) {
    if (all.empty()) return;
    const auto each = [&](const char* name, const char* type, const char* help, auto value) {
        out.begin(name, type, help);
        for (const devices::DeviceStatus& device : all)
            out.line(name, "device=" + quoted(device.name), static_cast<double>(value(device)));
    };
    using Device = devices::DeviceStatus;
    each("stepwise_device_up", "gauge", "1 while the device is connected.",
         [](const Device& d) { return d.state == devices::LinkState::Online ? 1 : 0; });
    each("stepwise_device_channels", "gauge", "Channels of the device.",
         [](const Device& d) { return d.channels.size(); });
    each("stepwise_device_good_channels", "gauge", "Channels with a good value.",
         [](const Device& d) { return goodChannels(d); });
    each("stepwise_device_requests_total", "counter", "Requests to the device.",
         [](const Device& d) { return d.figures.requests; });
    each("stepwise_device_errors_total", "counter", "Requests without a good answer.",
         [](const Device& d) { return d.figures.errors; });
    each("stepwise_device_connections_total", "counter", "How often a connection was made.",
         [](const Device& d) { return d.figures.connects; });
    each("stepwise_device_received_bytes_total", "counter", "Bytes from the device.",
         [](const Device& d) { return d.figures.bytesIn; });
    each("stepwise_device_sent_bytes_total", "counter", "Bytes to the device.",
         [](const Device& d) { return d.figures.bytesOut; });
    each("stepwise_device_latency_seconds", "gauge", "Mean time from a request to its answer.",
         [](const Device& d) { return d.figures.meanLatencyNs * 1e-9; });
    each("stepwise_device_latency_most_seconds", "gauge", "Longest time from a request to its answer.",
         [](const Device& d) { return double(d.figures.worstLatencyNs) * 1e-9; });
}

} // namespace

QByteArray statusJson(const session::Session& session, const ServerFigures& figures) {
    const session::Status status = session.status();
    const history::Statistics recorded = session.history().statistics();
    const Json json = {
        {"project", figures.project},
        {"state", nameOf(status.state)},
        {"scans", status.scans},
        {"time_s", static_cast<double>(status.time.count()) * 1e-9},
        {"load", status.load},
        {"last_scan_ns", status.lastScanNs},
        {"skipped_scans", status.skippedScans},
        {"fault", faultJson(status.fault)},
        {"simulation_fault", faultJson(status.simulationFault)},
        {"retain_problem", status.retainProblem.isEmpty() ? Json(nullptr) : Json(status.retainProblem.english())},
        {"forced", session.forces().size()},
        {"tasks", tasksJson(session)},
        {"recording",
         {{"scans_in_memory", recorded.scans},
          {"bytes_in_memory", recorded.bytes},
          {"files", figures.recordingFiles},
          {"bytes_on_disk", figures.recordingBytes},
          {"problem", figures.recordingProblem.empty() ? Json(nullptr) : Json(figures.recordingProblem)}}},
        {"scan_times", scanTimesJson(session.scanTimes())},
        {"devices", devicesJson(figures.devices)},
        {"browsers", figures.browsers},
        {"studios", figures.studios},
        {"operators", figures.operators},
        {"uptime_s", figures.uptimeSeconds}};
    return QByteArray::fromStdString(json.dump(1, ' ', false, Json::error_handler_t::replace)) + '\n';
}

QByteArray prometheusText(const session::Session& session, const ServerFigures& figures) {
    const session::Status status = session.status();
    Metrics out;
    out.begin("stepwise_state", "gauge", "1 for the state that the controller is in.");
    for (const auto state : {controller::State::Stopped, controller::State::Running, controller::State::Paused,
                             controller::State::Halted, controller::State::Fault})
        out.line("stepwise_state", QByteArray("state=\"") + nameOf(state) + '"', status.state == state ? 1 : 0);
    out.add("stepwise_scans_total", "counter", "Finished scans.", static_cast<double>(status.scans));
    out.add("stepwise_skipped_scans_total", "counter", "Scans left out because the machine was late.",
            static_cast<double>(status.skippedScans));
    out.add("stepwise_plc_time_seconds", "counter", "Clock of the controller.",
            static_cast<double>(status.time.count()) * 1e-9);
    out.add("stepwise_load_ratio", "gauge", "Share of time spent in scans.", status.load);
    out.add("stepwise_last_scan_seconds", "gauge", "Execution time of the last scan.",
            static_cast<double>(status.lastScanNs) * 1e-9);
    addTasks(out, session);
    addScanTimes(out, session.scanTimes());
    addDevices(out, figures.devices);
    out.add("stepwise_recording_bytes", "gauge", "Size of the recording on disk.",
            static_cast<double>(figures.recordingBytes));
    out.add("stepwise_browsers", "gauge", "Connected browsers.", static_cast<double>(figures.browsers));
    out.add("stepwise_studios", "gauge", "Attached studios.", static_cast<double>(figures.studios));
    out.add("stepwise_operators", "gauge", "Browsers in which somebody logged in.",
            static_cast<double>(figures.operators));
    out.add("stepwise_panel_sent_bytes_total", "counter", "Bytes sent to browsers.",
            static_cast<double>(figures.sentBytes));
    out.add("stepwise_panel_frames_total", "counter", "Pictures sent to browsers.",
            static_cast<double>(figures.sentFrames));
    out.add("stepwise_refused_connections_total", "counter",
            "Connections refused: too many, too slow or not understood.",
            static_cast<double>(figures.refusedConnections));
    out.add("stepwise_refused_logins_total", "counter", "Attempts to log in that were refused.",
            static_cast<double>(figures.refusedLogIns));
    out.add("stepwise_dropped_browsers_total", "counter", "Browsers dropped: hanging, too fast or not understood.",
            static_cast<double>(figures.droppedBrowsers));
    out.add("stepwise_uptime_seconds", "gauge", "Seconds since the start.", figures.uptimeSeconds);
    return out.text();
}

} // namespace plc::serve
