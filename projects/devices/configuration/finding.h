// What is wrong in devices.json, with its place and, in the sentence, the remedy. Made by the reader and the checks. A
// value, any thread.
#pragma once
#include "runtime/base/message.h"

#include <string>

namespace plc::devices {

struct Finding {
    bool isError = true;
    Message message;
    int line = 0;                // of devices.json; 0: the whole file
    std::string device, channel; // empty: none in particular
    /// "devices.json:12: error: Pump, Level: …" in English.
    [[nodiscard]] std::string english(const std::string& file) const;
};

} // namespace plc::devices
