#include "projects/devices/port.h"

#include <thread>

namespace plc::devices {

Port::Port(Device d)
    : device(std::move(d)), m_now(device.channels.size()),
      m_unfit(std::make_unique<std::atomic<bool>[]>(device.channels.size())) {}

void Port::set(size_t channel, Quality quality, Sample sample) { m_now[channel] = {quality, std::move(sample)}; }

void Port::setQuality(size_t channel, Quality quality) { m_now[channel].quality = quality; }

void Port::setAll(Quality quality) {
    for (ChannelState& channel : m_now) channel.quality = quality;
}

void Port::setState(LinkState state, Message problem) {
    {
        const std::lock_guard lock(m_mutex);
        m_problem = std::move(problem);
    }
    m_state.store(state, std::memory_order_release);
    m_inputVersion.fetch_add(1, std::memory_order_release); // a variable may show the state
}

void Port::note(Message problem) {
    const std::lock_guard lock(m_mutex);
    m_problem = std::move(problem);
}

void Port::publish() {
    std::vector<ChannelState>* next = m_inputs.begin();
    for (; !next; next = m_inputs.begin()) std::this_thread::yield(); // readers are quick; nothing may get lost
    *next = m_now;
    m_inputs.publish();
    m_inputVersion.fetch_add(1, std::memory_order_release);
}

bool Port::outputs(std::vector<Sample>& into, uint64_t& seen) const {
    bool isNew = false;
    (void)m_outputs.read([&](const Outputs& outputs) {
        isNew = outputs.version != seen;
        if (!isNew) return;
        into = outputs.values;
        seen = outputs.version;
    });
    return isNew;
}

bool Port::safeOutputs(std::vector<Sample>& into) const {
    return m_outputs.read([&](const Outputs& outputs) { into = outputs.safe; });
}

void Port::countBytes(size_t bytesOut, size_t bytesIn) {
    m_bytesOut.fetch_add(bytesOut, std::memory_order_relaxed);
    m_bytesIn.fetch_add(bytesIn, std::memory_order_relaxed);
}

void Port::countRequest(size_t bytesOut, size_t bytesIn, std::chrono::nanoseconds latency) {
    countBytes(bytesOut, bytesIn);
    m_requests.fetch_add(1, std::memory_order_relaxed);
    m_lastLatency.store(latency.count(), std::memory_order_relaxed);
    m_latencySum.fetch_add(latency.count(), std::memory_order_relaxed);
    if (latency.count() > m_worstLatency.load(std::memory_order_relaxed))
        m_worstLatency.store(latency.count(), std::memory_order_relaxed);
}

Message Port::tryProblem() const {
    const std::unique_lock lock(m_mutex, std::try_to_lock);
    return lock ? m_problem : Message();
}

Message Port::problem() const {
    const std::lock_guard lock(m_mutex);
    return m_problem;
}

Figures Port::figures() const {
    Figures f;
    f.requests = m_requests.load(std::memory_order_relaxed);
    f.errors = m_errors.load(std::memory_order_relaxed);
    f.connects = m_connects.load(std::memory_order_relaxed);
    f.bytesIn = m_bytesIn.load(std::memory_order_relaxed);
    f.bytesOut = m_bytesOut.load(std::memory_order_relaxed);
    f.clients = m_clients.load(std::memory_order_relaxed);
    f.lastLatencyNs = m_lastLatency.load(std::memory_order_relaxed);
    f.worstLatencyNs = m_worstLatency.load(std::memory_order_relaxed);
    if (f.requests > 0)
        f.meanLatencyNs =
            static_cast<double>(m_latencySum.load(std::memory_order_relaxed)) / static_cast<double>(f.requests);
    return f;
}

std::vector<ChannelState> Port::channels() const {
    std::vector<ChannelState> all(device.channels.size());
    (void)m_inputs.read([&](const std::vector<ChannelState>& channels) { all = channels; });
    for (size_t i = 0; i < all.size(); ++i)
        if (m_unfit[i].load(std::memory_order_relaxed) && all[i].quality == Quality::Good)
            all[i].quality = Quality::Unfit;
    return all;
}

} // namespace plc::devices
