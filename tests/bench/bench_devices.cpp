// A hundred Modbus devices of a hundred registers, polled every 100 ms, beside a program that is scanned every 10 ms:
// what they take of one core, what the exchange at the scan's edge takes, and what happens when none answers for ten
// seconds. The devices are another process.
#include "projects/devices/engine.h"
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <csignal>
#include <cstdio>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace plc;
using namespace std::chrono_literals;

namespace {

constexpr int kDevices = 100, kRegisters = 100;
constexpr uint16_t kFirstPort = 21'000;

std::vector<devices::Device> describe(devices::Protocol protocol) {
    std::vector<devices::Device> all;
    for (int d = 0; d < kDevices; ++d) {
        devices::Device device;
        device.name = "D" + std::to_string(d);
        device.protocol = protocol;
        device.host = "127.0.0.1";
        device.port = static_cast<uint16_t>(kFirstPort + d);
        for (int r = 0; r < kRegisters; ++r) {
            devices::Channel channel;
            channel.name = "r" + std::to_string(r);
            channel.variable = "values[" + std::to_string(d * kRegisters + r) + "]";
            channel.address = static_cast<uint32_t>(r);
            device.channels.push_back(std::move(channel));
        }
        if (protocol == devices::Protocol::ModbusServer) device.timeout = {};
        all.push_back(std::move(device));
    }
    return all;
}

double cpuSeconds() {
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

struct Figures {
    double share = 0;
    int64_t edgeNs = 0, worstNs = 0;
    uint64_t requests = 0, errors = 0;
};

Figures measure(session::Session& session, devices::Engine& engine, std::chrono::seconds length) {
    Figures out;
    controller::Controller& controller = session.controller();
    const auto begin = std::chrono::steady_clock::now();
    const double cpu = cpuSeconds();
    const auto due = controller.nextDue();
    int64_t sum = 0, scans = 0;
    while (std::chrono::steady_clock::now() - begin < length) {
        std::this_thread::sleep_until(begin + (controller.nextDue() - due)); // a duration: the controller's interval
        const auto before = std::chrono::steady_clock::now();
        (void)controller.scan();
        const int64_t taken = (std::chrono::steady_clock::now() - before).count();
        sum += taken;
        ++scans;
        out.worstNs = std::max(out.worstNs, taken);
    }
    out.share = (cpuSeconds() - cpu) / std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    out.edgeNs = sum / std::max<int64_t>(1, scans);
    for (const devices::DeviceStatus& status : engine.status()) {
        out.requests += status.figures.requests;
        out.errors += status.figures.errors;
    }
    return out;
}

void print(const char* title, const Figures& figures) {
    std::printf("%-12s %5.1f %% of a core, scan %lld us, slowest %lld us, %llu requests, %llu errors\n", title,
                figures.share * 100, static_cast<long long>(figures.edgeNs / 1000),
                static_cast<long long>(figures.worstNs / 1000), static_cast<unsigned long long>(figures.requests),
                static_cast<unsigned long long>(figures.errors));
}

} // namespace

int main() {
    const pid_t peers = ::fork();
    if (peers == 0) {
        devices::Engine servers(describe(devices::Protocol::ModbusServer));
        servers.connect();
        for (;;) ::pause();
    }
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back(
        {"main.st",
         "VAR_GLOBAL values : ARRAY[0..9999] OF INT; END_VAR\nPROGRAM Main VAR n : DINT; END_VAR n := n + 1; "
         "END_PROGRAM\n"
         "CONFIGURATION Plc RESOURCE Cpu ON Pc TASK T(INTERVAL := T#10ms, PRIORITY := 1); PROGRAM Main WITH T : Main; "
         "END_RESOURCE END_CONFIGURATION\n"});
    const driver::Built built = driver::build(input);
    devices::Engine engine(describe(devices::Protocol::ModbusTcp));
    session::Session session(built);
    engine.attach(session.controller());
    session.controller().start();
    print("unconnected", measure(session, engine, 3s));
    engine.connect();
    (void)measure(session, engine, 2s); // everybody has connected
    print("connected", measure(session, engine, 10s));
    ::kill(peers, SIGSTOP); // nobody answers for ten seconds
    print("cut", measure(session, engine, 10s));
    ::kill(peers, SIGCONT);
    (void)measure(session, engine, 6s);
    print("again", measure(session, engine, 3s));
    engine.disconnect();
    ::kill(peers, SIGTERM);
    ::waitpid(peers, nullptr, 0);
    return 0;
}
