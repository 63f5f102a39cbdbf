// The messages of a translation file (translations/stepwise_*.ts) and what else the checks read from files. Values, any
// thread.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace plc::checks {

struct Message {
    std::string context, source;
    std::vector<std::string> translations; // one per plural form
    bool isPlural = false, isUnfinished = false, isVanished = false;
};

[[nodiscard]] std::string contentOf(const std::filesystem::path& file);
[[nodiscard]] std::vector<Message> messagesOf(const std::string& language);

} // namespace plc::checks
