#include "projects/devices/engine.h"

#include "projects/devices/configuration/errors.h"

#include <cstring>

namespace plc::devices {

using controller::EventKind;

namespace {

void write(controller::EdgeWriter& writer, const Target& target, std::span<const std::byte> bytes,
           const std::string& origin) {
    writer.put(target.place, bytes.first(target.size), origin);
}

} // namespace

struct Engine::BoundInput {
    size_t channel = 0;
    Target target;
    OnLoss onLoss{};
    std::vector<std::byte> bytes, safe; // safe: empty when the channel has none
    bool hasBytes = false, isLost = false;
};

struct Engine::BoundOutput {
    size_t channel = 0;
    Target target;
    std::vector<std::byte> bytes; // as last taken
    Sample value, safe;
};

/// A quality or online variable.
struct Engine::BoundState {
    std::optional<size_t> channel; // none: the device
    Target target;
    std::array<std::byte, 8> bytes{};
};

struct Engine::BoundDevice {
    Port* port = nullptr;
    std::string origin; // "device Pump"
    uint64_t seenInputs = ~uint64_t(0), outputVersion = 0;
    std::vector<BoundInput> inputs;
    std::vector<BoundOutput> outputs;
    std::vector<BoundState> states;
    std::vector<std::byte> scratch; // as large as the largest input
    bool isUnsent = false, isSafe = true;
    const BoundInput* faulty = nullptr;
};

Engine::Engine(const std::vector<Device>& devices, std::string projectFolder) : m_folder(std::move(projectFolder)) {
    for (const Device& device : devices)
        if (device.isEnabled) m_ports.push_back(std::make_unique<Port>(device));
    m_bound.resize(m_ports.size());
    for (size_t i = 0; i < m_ports.size(); ++i) {
        m_bound[i].port = m_ports[i].get();
        m_bound[i].origin = "device " + m_ports[i]->device.name;
    }
}

Engine::~Engine() { disconnect(); }

void Engine::attach(controller::Controller& controller) {
    m_controller = &controller;
    controller.addObserver(*this); // tells the program at once
    controller::setScanEdge(controller, this);
}

void Engine::connect() {
    if (isConnected()) return;
    m_links = makeLinks(m_ports, m_folder);
    for (const std::unique_ptr<Link>& link : m_links) link->start();
}

void Engine::disconnect() {
    for (const std::unique_ptr<Link>& link : m_links) link->askToStop();
    for (const std::unique_ptr<Link>& link : m_links) link->join();
    m_links.clear();
}

// ---------------------------------------------------------------- which variables

void Engine::programChanged(std::shared_ptr<const image::CompiledProgram> program) {
    for (BoundDevice& device : m_bound) bind(device, *program);
}

void Engine::bind(BoundDevice& device, const image::CompiledProgram& program) {
    const Device& described = device.port->device;
    device.inputs.clear();
    device.outputs.clear();
    device.states.clear();
    device.faulty = nullptr;
    device.seenInputs = ~uint64_t(0);
    const auto bindState = [&](const std::string& path, std::optional<size_t> channel) {
        if (path.empty()) return;
        if (const Result<Target> target = resolve(program.layout, path, WireType::Bool);
            target && (target->family == types::Family::Bool || types::isInteger(target->family)))
            device.states.push_back({channel, *target, {}});
    };
    bindState(described.online, {});
    for (size_t c = 0; c < described.channels.size(); ++c) {
        const Channel& channel = described.channels[c];
        bindState(channel.quality, c);
        const Result<Target> target = resolve(program.layout, channel.variable, channel.type);
        if (!target || !canCarry(channel, *target)) continue; // the checks have said so
        if (channel.direction == Direction::Out) {
            BoundOutput output{
                c, *target, std::vector<std::byte>(target->size), decode(*target, program.initialImage), {}};
            output.safe = channel.safe ? Sample::of(*channel.safe) : output.value;
            device.outputs.push_back(std::move(output));
            continue;
        }
        BoundInput input{c, *target, channel.onLoss, std::vector<std::byte>(target->size), {}};
        if (channel.safe) {
            input.safe.resize(target->size);
            if (!encode(Sample::of(*channel.safe), *target, input.safe)) input.safe.clear();
        }
        if (target->size > device.scratch.size()) device.scratch.resize(target->size);
        device.inputs.push_back(std::move(input));
    }
    device.isUnsent = !device.outputs.empty() && device.outputVersion > 0;
}

// ---------------------------------------------------------------- before the scan

void Engine::beforeScan(controller::EdgeWriter& writer) {
    m_plcRuns = writer.plcRuns();
    for (BoundDevice& device : m_bound) {
        const uint64_t version = device.port->inputVersion();
        if (version == 0) continue; // never connected: a simulation may set its variables
        const bool isNew = version != device.seenInputs;
        if (isNew) {
            device.seenInputs = version;
            refresh(device);
        }
        if (!isNew && device.port->state() == LinkState::Off) continue; // not any more: they are free again
        for (const BoundInput& input : device.inputs)
            if (input.hasBytes) write(writer, input.target, input.bytes, device.origin);
        for (const BoundState& state : device.states) write(writer, state.target, state.bytes, device.origin);
        if (!device.faulty || !m_plcRuns) continue;
        const Device& described = device.port->device;
        const std::string& name = described.channels[device.faulty->channel].name;
        Message why = device.port->tryProblem();
        writer.fault(why.isEmpty() ? errors::FaultOnLoss(name, described.name)
                                   : errors::FaultOnLossWhy(name, described.name, std::move(why)));
    }
}

/// Something came: the bytes to be put from now on.
void Engine::refresh(BoundDevice& device) {
    device.faulty = nullptr;
    std::vector<std::byte>& fresh = device.scratch;
    device.port->readInputs([&](const std::vector<ChannelState>& channels) {
        for (BoundInput& input : device.inputs) {
            const ChannelState& state = channels[input.channel];
            bool isGood = state.quality == Quality::Good;
            if (isGood) {
                const bool fits = encode(state.sample, input.target, fresh);
                device.port->setFits(input.channel, fits);
                isGood = fits;
                if (fits) std::memcpy(input.bytes.data(), fresh.data(), input.target.size);
                input.hasBytes |= fits;
            }
            input.isLost = !isGood;
            if (isGood) continue;
            if (input.onLoss == OnLoss::Safe && !input.safe.empty()) {
                input.bytes = input.safe;
                input.hasBytes = true;
            }
            if (input.onLoss == OnLoss::Fault && state.quality != Quality::Waiting) device.faulty = &input;
        }
        for (BoundState& state : device.states) {
            if (!state.channel) continue;
            Quality quality = channels[*state.channel].quality;
            for (const BoundInput& input : device.inputs)
                if (input.channel == *state.channel && input.isLost && quality == Quality::Good)
                    quality = Quality::Unfit;
            const bool isFlag = state.target.family == types::Family::Bool;
            state.bytes = {};
            state.bytes[0] = std::byte(isFlag ? (quality == Quality::Good ? 1 : 0) : static_cast<int>(quality));
        }
    });
    for (BoundState& state : device.states)
        if (!state.channel) state.bytes[0] = std::byte(device.port->state() == LinkState::Online ? 1 : 0);
}

// ---------------------------------------------------------------- after the scan

void Engine::scanFinished(std::span<const std::byte> image, uint64_t, controller::Nanoseconds) {
    // What a scan computed before it faulted is not sent: the fault makes the outputs safe right after this.
    if (!m_plcRuns || m_controller->context().fault != image::FaultCode::None) return;
    for (BoundDevice& device : m_bound)
        if (!device.outputs.empty()) takeOutputs(device, image);
}

void Engine::takeOutputs(BoundDevice& device, std::span<const std::byte> image) {
    bool isChanged = device.outputVersion == 0 || device.isSafe || device.isUnsent;
    for (BoundOutput& output : device.outputs) {
        const std::byte* at = image.data() + output.target.place.offset;
        std::byte bit{};
        if (output.target.place.bit >= 0) {
            bit = (*at >> output.target.place.bit) & std::byte(1);
            at = &bit;
        }
        if (!isChanged && std::memcmp(output.bytes.data(), at, output.target.size) == 0) continue;
        isChanged = true;
        std::memcpy(output.bytes.data(), at, output.target.size);
        output.value = decode(output.target, image);
    }
    if (!isChanged) return;
    if (device.isSafe || device.isUnsent) // all of them: bytes and values may be of another time
        for (BoundOutput& output : device.outputs) output.value = decode(output.target, image);
    device.isSafe = false;
    publish(device);
}

void Engine::publish(BoundDevice& device) {
    Port::Outputs* next = device.port->beginOutputs();
    device.isUnsent = !next;
    if (!next) return;
    const size_t count = device.port->device.channels.size();
    next->values.resize(count);
    next->safe.resize(count);
    for (const BoundOutput& output : device.outputs) {
        next->values[output.channel] = device.isSafe ? output.safe : output.value;
        next->safe[output.channel] = output.safe;
    }
    next->version = ++device.outputVersion;
    device.port->publishOutputs();
}

void Engine::eventHappened(const controller::Event& event) {
    const bool hasEnded =
        event.kind == EventKind::Stopped || event.kind == EventKind::Fault || event.kind == EventKind::Reset;
    if (hasEnded && m_controller && m_controller->state() != controller::State::Running) makeSafe();
}

void Engine::makeSafe() {
    for (BoundDevice& device : m_bound) {
        if (device.outputs.empty() || device.outputVersion == 0) continue;
        device.isSafe = true;
        do publish(device); // readers hold a value for some instructions only
        while (device.isUnsent);
    }
}

// ---------------------------------------------------------------- what others see

std::vector<DeviceStatus> Engine::status() const {
    std::vector<DeviceStatus> all;
    for (const std::unique_ptr<Port>& port : m_ports) {
        DeviceStatus status{port->device.name, port->device.protocol, port->state(),
                            port->problem(),   port->figures(),       {}};
        const std::vector<ChannelState> states = port->channels();
        std::vector<Sample> outputs;
        uint64_t seen = 0;
        (void)port->outputs(outputs, seen);
        for (size_t c = 0; c < states.size(); ++c) {
            const Channel& channel = port->device.channels[c];
            const bool isOut = channel.direction == Direction::Out;
            const Sample* value = isOut ? (c < outputs.size() ? &outputs[c] : nullptr) : &states[c].sample;
            status.channels.push_back({channel.name, channel.variable, channel.direction, states[c].quality,
                                       value ? value->shown() : std::string()});
        }
        all.push_back(std::move(status));
    }
    return all;
}

} // namespace plc::devices
