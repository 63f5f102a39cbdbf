// The devices of a running project (D8, D16): puts what they brought into the image before each scan, takes the outputs
// after it, and keeps a link for each connection on a thread of its own. attach() before the session's scan thread
// starts; it must outlive the session. connect() and disconnect() from one thread; status() from any.
#pragma once
#include "projects/devices/link.h"
#include "runtime/controller/controller.h"
#include "runtime/controller/scan_edge.h"

namespace plc::devices {

struct ChannelStatus {
    std::string name, variable;
    Direction direction{};
    Quality quality{};
    std::string value; // as it came or goes
};
struct DeviceStatus {
    std::string name;
    Protocol protocol{};
    LinkState state{};
    Message problem;
    Figures figures;
    std::vector<ChannelStatus> channels;
};

class Engine final : public controller::ScanEdge, public controller::ScanObserver {
public:
    /// Devices that are not enabled are left out. `projectFolder`: where password and certificate files are.
    explicit Engine(const std::vector<Device>& devices, std::string projectFolder = {});
    ~Engine() override; // disconnects

    void attach(controller::Controller& controller);
    void connect();
    void disconnect(); // outputs get their safe values first
    [[nodiscard]] bool isConnected() const { return !m_links.empty(); }
    [[nodiscard]] std::vector<DeviceStatus> status() const;

    // scan thread
    void beforeScan(controller::EdgeWriter& writer) override;
    void scanFinished(std::span<const std::byte> image, uint64_t scan, controller::Nanoseconds time) override;
    void programChanged(std::shared_ptr<const image::CompiledProgram> program) override;
    void eventHappened(const controller::Event& event) override;

private:
    struct BoundInput;
    struct BoundOutput;
    struct BoundState;
    struct BoundDevice;
    void bind(BoundDevice& device, const image::CompiledProgram& program);
    void refresh(BoundDevice& device);
    void takeOutputs(BoundDevice& device, std::span<const std::byte> image);
    void publish(BoundDevice& device);
    void makeSafe();

    std::string m_folder;
    std::vector<std::unique_ptr<Port>> m_ports;
    std::vector<std::unique_ptr<Link>> m_links;
    // the scan thread's
    controller::Controller* m_controller = nullptr;
    std::vector<BoundDevice> m_bound;
    bool m_plcRuns = false;
};

} // namespace plc::devices
