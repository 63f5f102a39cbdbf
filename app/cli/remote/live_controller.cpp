#include "app/cli/remote/live_controller.h"

#include "app/cli/remote/attached.h"

#include <iostream>

namespace plc::cli {

using remote::Json;

namespace {
constexpr std::chrono::milliseconds kEvery{250}, kAgain{2000};
}

LiveController::LiveController(editor::RemoteController::Address address)
    : m_address(std::move(address)), m_thread([this](const std::stop_token& stop) { follow(stop); }) {}

void LiveController::want(std::vector<std::string> expressions) {
    const std::lock_guard lock(m_mutex);
    m_wanted = std::move(expressions);
}

std::optional<std::string> LiveController::valueOf(const std::string& expression) const {
    const std::lock_guard lock(m_mutex);
    const auto it = m_values.find(expression);
    return it == m_values.end() ? std::nullopt : std::optional(it->second);
}

uint64_t LiveController::revision() const {
    const std::lock_guard lock(m_mutex);
    return m_revision;
}

std::vector<std::string> LiveController::wanted() const {
    const std::lock_guard lock(m_mutex);
    return m_wanted;
}

void LiveController::know(std::map<std::string, std::string> values) {
    const std::lock_guard lock(m_mutex);
    if (values == m_values) return;
    m_values = std::move(values);
    ++m_revision;
}

void LiveController::follow(const std::stop_token& stop) {
    std::string complaint; // said once, not every two seconds
    while (!stop.stop_requested()) {
        Attached there;
        Result<void> attached = there.attach(m_address);
        const std::string why = attached ? std::string() : attached.error().english();
        if (why != complaint && !why.empty()) std::cerr << why << std::endl;
        complaint = why;
        while (attached && !stop.stop_requested()) {
            const std::vector<std::string> paths = wanted();
            const auto answer = there.ask({{"do", "read"}, {"watch", paths}});
            if (!answer) break;
            std::map<std::string, std::string> values;
            const Json all = answer->value("values", Json::array());
            for (size_t i = 0; i < std::min(paths.size(), all.size()); ++i)
                if (all[i].contains("value")) values[paths[i]] = remote::textAt(all[i], "value");
            know(std::move(values));
            there.wait(kEvery);
        }
        know({}); // what was there is old
        for (auto waited = kEvery; waited < kAgain && !stop.stop_requested(); waited += kEvery)
            std::this_thread::sleep_for(kEvery);
    }
}

} // namespace plc::cli
