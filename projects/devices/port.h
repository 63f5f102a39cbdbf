// One connected device between the scan and its link: what came in, what goes out, how it does. The link's thread
// writes the inputs and figures, the scan thread the outputs; neither ever waits for the other. Owned by the Engine.
#pragma once
#include "projects/devices/configuration/sample.h"
#include "runtime/base/published.h"

#include <array>
#include <atomic>
#include <memory>
#include <mutex>

namespace plc::devices {

enum class LinkState : uint8_t { Off, Connecting, Online, Lost };

struct ChannelState {
    Quality quality = Quality::Waiting;
    Sample sample;
};

struct Figures {
    uint64_t requests = 0, errors = 0, connects = 0, bytesIn = 0, bytesOut = 0;
    int64_t lastLatencyNs = 0, worstLatencyNs = 0;
    double meanLatencyNs = 0;
    uint64_t clients = 0; // of a server
};

class Port {
public:
    explicit Port(Device device);
    const Device device;

    // --- the link's thread
    void set(size_t channel, Quality quality, Sample sample);
    void setQuality(size_t channel, Quality quality); // the sample stays
    void setAll(Quality quality);
    void setState(LinkState state, Message problem = {});
    void note(Message problem); // of one channel; the device is online
    void publish();             // what was set since
    [[nodiscard]] const ChannelState& now(size_t channel) const { return m_now[channel]; }
    /// The outputs by channel when they are others than `seen` says; false: the same, or none yet.
    bool outputs(std::vector<Sample>& into, uint64_t& seen) const;
    /// What the outputs are to be when nobody sets them any more; false: the program never ran.
    bool safeOutputs(std::vector<Sample>& into) const;
    void countRequest(size_t bytesOut, size_t bytesIn, std::chrono::nanoseconds latency);
    void countBytes(size_t bytesOut, size_t bytesIn);
    void countError() { m_errors.fetch_add(1, std::memory_order_relaxed); }
    void countConnect() { m_connects.fetch_add(1, std::memory_order_relaxed); }
    void setClients(uint64_t count) { m_clients.store(count, std::memory_order_relaxed); }

    // --- the scan's thread
    [[nodiscard]] uint64_t inputVersion() const { return m_inputVersion.load(std::memory_order_acquire); }
    template <class Read> void readInputs(Read&& read) const {
        (void)m_inputs.read([&](const std::vector<ChannelState>& channels) { read(channels); });
    }
    /// Null when readers hold every spare one: try again at the next scan.
    struct Outputs {
        std::vector<Sample> values, safe;
        uint64_t version = 0;
    };
    [[nodiscard]] Outputs* beginOutputs() { return m_outputs.begin(); }
    void publishOutputs() { m_outputs.publish(); }
    void setFits(size_t channel, bool fits) { m_unfit[channel].store(!fits, std::memory_order_relaxed); }
    /// The problem, when nobody is writing it at this moment.
    [[nodiscard]] Message tryProblem() const;

    // --- any thread
    [[nodiscard]] LinkState state() const { return m_state.load(std::memory_order_acquire); }
    [[nodiscard]] Message problem() const;
    [[nodiscard]] Figures figures() const;
    [[nodiscard]] std::vector<ChannelState> channels() const;

private:
    std::vector<ChannelState> m_now;
    Published<std::vector<ChannelState>> m_inputs;
    Published<Outputs> m_outputs;
    std::atomic<uint64_t> m_inputVersion{0};
    std::unique_ptr<std::atomic<bool>[]> m_unfit;
    std::atomic<LinkState> m_state{LinkState::Off};
    mutable std::mutex m_mutex;
    Message m_problem;
    std::atomic<uint64_t> m_requests{0}, m_errors{0}, m_connects{0}, m_bytesIn{0}, m_bytesOut{0}, m_clients{0};
    std::atomic<int64_t> m_lastLatency{0}, m_worstLatency{0}, m_latencySum{0};
};

} // namespace plc::devices
