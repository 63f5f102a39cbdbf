// The messages of a translation file (translations/stepwise_*.ts) and what else the checks read from files. Values, any
// thread.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace plc::checks {

/// The languages that have every text of the studio; English has the plurals only.
inline constexpr std::array<const char*, 5> kTranslated{"de", "da", "fr", "es", "zh_CN"};

struct Message {
    std::string context, source;
    std::vector<std::string> translations; // one per plural form
    bool isPlural = false, isUnfinished = false, isVanished = false;
};

[[nodiscard]] std::string contentOf(const std::filesystem::path& file);
[[nodiscard]] std::vector<Message> messagesOf(const std::string& language);

} // namespace plc::checks
