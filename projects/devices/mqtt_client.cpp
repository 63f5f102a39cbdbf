// An MQTT client: one connection to a broker, in this thread alone (mosquitto_loop). Topics of inputs are subscribed
// to, outputs are published when they change and again after each connection.
#include "projects/devices/configuration/errors.h"
#include "projects/devices/configuration/wire.h"
#include "projects/devices/link.h"
#include "runtime/platform/sockets.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mosquitto.h>

namespace plc::devices {

namespace {

struct FreeMosquitto {
    void operator()(mosquitto* client) const { mosquitto_destroy(client); }
};
using Mosquitto = std::unique_ptr<mosquitto, FreeMosquitto>;

constexpr int kShortestKeepAlive = 5; // seconds; the protocol library takes no less

std::string firstLine(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    while (!line.empty() && (line.back() == '\r' || line.back() == '\n')) line.pop_back();
    return line;
}

class MqttClient final : public Link {
public:
    MqttClient(Port& port, std::string folder)
        : m_port(port), m_folder(std::move(folder)), m_backOff(port.device.retry) {
        static std::once_flag once;
        std::call_once(once, [] { mosquitto_lib_init(); });
    }

protected:
    void run() override;

private:
    void connect();
    void round();
    void lose(Message why);
    [[nodiscard]] bool setUp();
    void connected(int code);
    void received(const mosquitto_message& message);
    void publishOutputs(bool isLeaving);
    void publishTopic(const std::string& topic, bool isLeaving);
    void leave();

    Port& m_port;
    std::string m_folder;
    BackOff m_backOff;
    Mosquitto m_client;
    bool m_isUp = false, m_isDirty = false;
    SteadyClock::time_point m_since{};
    Message m_refusal;
    std::vector<Sample> m_outputs;
    std::map<std::string, std::string> m_sent; // by topic
    uint64_t m_seenOutputs = 0;
};

void MqttClient::run() {
    m_port.setState(LinkState::Connecting);
    while (!isStopping()) {
        if (!m_client)
            connect();
        else
            round();
    }
    leave();
}

/// False: the authority's file cannot be read. Nothing is said without TLS then.
bool MqttClient::setUp() {
    const Device& device = m_port.device;
    mosquitto* client = m_client.get();
    mosquitto_connect_callback_set(
        client, [](mosquitto*, void* self, int code) { static_cast<MqttClient*>(self)->connected(code); });
    mosquitto_message_callback_set(client, [](mosquitto*, void* self, const mosquitto_message* message) {
        static_cast<MqttClient*>(self)->received(*message);
    });
    if (!device.user.empty()) {
        const std::string password = device.passwordFile.empty()
                                         ? std::string()
                                         : firstLine((std::filesystem::path(m_folder) / device.passwordFile).string());
        mosquitto_username_pw_set(client, device.user.c_str(), password.empty() ? nullptr : password.c_str());
    }
    if (!device.tls) return true;
    const std::string authority =
        device.caFile.empty() ? std::string() : (std::filesystem::path(m_folder) / device.caFile).string();
    return mosquitto_tls_set(client, authority.empty() ? nullptr : authority.c_str(),
                             authority.empty() ? "/etc/ssl/certs" : nullptr, nullptr, nullptr,
                             nullptr) == MOSQ_ERR_SUCCESS;
}

void MqttClient::connect() {
    const Device& device = m_port.device;
    const std::string where = device.host + ":" + std::to_string(device.port);
    // First whether somebody listens: the library would wait for minutes.
    if (const int code = platform::reach(device.host, device.port, device.timeout); code != 0)
        return lose(errors::NotConnected(where, code == ETIMEDOUT ? errors::NoAnswer(device.timeout.count())
                                                                  : errors::ofSystem(code)));
    if (isStopping()) return;
    m_client.reset(mosquitto_new(device.clientId.empty() ? nullptr : device.clientId.c_str(), true, this));
    if (!m_client) return lose(errors::NotConnected(where, errors::ofSystem(errno)));
    if (!setUp()) return lose(errors::NotConnected(where, errors::ofSystem(ENOENT)));
    const int keepAlive = std::max<int>(kShortestKeepAlive, static_cast<int>(device.timeout.count() / 1000));
    const int done = mosquitto_connect(m_client.get(), device.host.c_str(), device.port, keepAlive);
    if (done != MOSQ_ERR_SUCCESS) {
        const Message why = done == MOSQ_ERR_ERRNO ? errors::ofSystem(errno)
                                                   : errors::SystemSays(std::string(mosquitto_strerror(done)));
        return lose(errors::NotConnected(where, why));
    }
    platform::limitUnconfirmed(mosquitto_socket(m_client.get()), device.timeout);
    m_since = SteadyClock::now();
    m_refusal = {};
}

void MqttClient::round() {
    const auto wait = static_cast<int>(std::clamp<int64_t>(m_port.device.poll.count(), 1, 100));
    const int done = mosquitto_loop(m_client.get(), wait, 1);
    if (m_isUp && std::exchange(m_isDirty, false)) m_port.publish();
    if (done != MOSQ_ERR_SUCCESS) {
        Message why = done == MOSQ_ERR_ERRNO ? errors::ofSystem(errno)
                                             : errors::SystemSays(std::string(mosquitto_strerror(done)));
        return lose(m_refusal.isEmpty() ? errors::ConnectionEnded(std::move(why)) : m_refusal);
    }
    if (m_isUp)
        publishOutputs(false);
    else if (!m_refusal.isEmpty())
        lose(m_refusal);
    else if (SteadyClock::now() - m_since > m_port.device.timeout)
        lose(errors::NoAnswer(m_port.device.timeout.count()));
}

void MqttClient::connected(int code) {
    if (code != 0) {
        m_refusal = errors::BrokerRefuses(std::string(mosquitto_connack_string(code)));
        return;
    }
    m_port.countConnect();
    m_backOff.succeeded();
    m_isUp = true;
    m_sent.clear();
    m_port.setState(LinkState::Online);
    std::map<std::string, int> topics;
    for (size_t c = 0; c < m_port.device.channels.size(); ++c) {
        const Channel& channel = m_port.device.channels[c];
        const bool isIn = channel.direction == Direction::In;
        // What it said before may be of another time: an input is good again with its next message.
        m_port.setQuality(c, isIn ? Quality::Waiting : Quality::Good);
        if (isIn) topics[channel.topic] = std::max(topics[channel.topic], channel.qos);
    }
    m_isDirty = true;
    for (const auto& [topic, qos] : topics) mosquitto_subscribe(m_client.get(), nullptr, topic.c_str(), qos);
}

void MqttClient::received(const mosquitto_message& message) {
    const std::string_view payload(static_cast<const char*>(message.payload),
                                   static_cast<size_t>(std::max(0, message.payloadlen)));
    m_port.countRequest(0, payload.size() + std::strlen(message.topic) + 4, {});
    for (size_t c = 0; c < m_port.device.channels.size(); ++c) {
        const Channel& channel = m_port.device.channels[c];
        if (channel.direction != Direction::In || channel.topic != message.topic) continue;
        Sample sample = fromMessage(channel, payload);
        m_isDirty = true;
        if (sample.kind != Sample::Kind::None) {
            m_port.set(c, Quality::Good, std::move(sample));
            continue;
        }
        m_port.setQuality(c, Quality::Unfit);
        m_port.countError();
        m_port.note(errors::UnreadableMessage(channel.name));
    }
}

void MqttClient::publishOutputs(bool isLeaving) {
    const bool isNew = isLeaving ? m_port.safeOutputs(m_outputs) : m_port.outputs(m_outputs, m_seenOutputs);
    if (!isNew && !(m_sent.empty() && !m_outputs.empty())) return;
    std::vector<std::string> topics;
    for (const Channel& channel : m_port.device.channels)
        if (channel.direction == Direction::Out &&
            std::find(topics.begin(), topics.end(), channel.topic) == topics.end())
            topics.push_back(channel.topic);
    for (const std::string& topic : topics) publishTopic(topic, isLeaving);
}

void MqttClient::publishTopic(const std::string& topic, bool isLeaving) {
    std::vector<const Channel*> channels;
    std::vector<const Sample*> samples;
    int qos = 0;
    bool retain = false;
    for (size_t c = 0; c < m_port.device.channels.size() && c < m_outputs.size(); ++c) {
        const Channel& channel = m_port.device.channels[c];
        if (channel.direction != Direction::Out || channel.topic != topic || m_outputs[c].kind == Sample::Kind::None)
            continue;
        channels.push_back(&channel);
        samples.push_back(&m_outputs[c]);
        qos = std::max(qos, channel.qos);
        retain = retain || channel.retain;
    }
    if (channels.empty()) return;
    const std::string message = toMessage(channels, samples);
    if (const auto before = m_sent.find(topic); before != m_sent.end() && before->second == message) return;
    const int done = mosquitto_publish(m_client.get(), nullptr, topic.c_str(), static_cast<int>(message.size()),
                                       message.data(), qos, retain);
    if (done != MOSQ_ERR_SUCCESS) return; // the next loop says why
    m_port.countRequest(message.size() + topic.size() + 4, 0, {});
    if (!isLeaving) m_sent[topic] = message;
}

void MqttClient::lose(Message why) {
    m_client.reset();
    m_isUp = false;
    m_port.countError();
    m_port.setAll(Quality::Lost);
    m_port.setState(LinkState::Lost, std::move(why));
    m_port.publish();
    waitUntil(m_backOff.failed());
}

/// The safe outputs go out before the connection ends.
void MqttClient::leave() {
    if (m_client && m_isUp) {
        m_sent.clear();
        publishOutputs(true);
        const auto end = SteadyClock::now() + std::min(m_port.device.timeout, Milliseconds(1000));
        while (mosquitto_want_write(m_client.get()) && SteadyClock::now() < end &&
               mosquitto_loop(m_client.get(), 20, 1) == MOSQ_ERR_SUCCESS) {
        }
        mosquitto_disconnect(m_client.get());
        (void)mosquitto_loop(m_client.get(), 0, 1);
    }
    m_client.reset();
    m_port.setAll(Quality::Waiting);
    m_port.setState(LinkState::Off);
    m_port.publish();
}

} // namespace

std::unique_ptr<Link> makeMqttClient(Port& port, const std::string& projectFolder) {
    return std::make_unique<MqttClient>(port, projectFolder);
}

} // namespace plc::devices
