// Which of the studio's translation files speaks a language: "de-AT" is "de", "zh-Hans-SG" is "zh_CN". Values, any
// thread.
#pragma once
#include <QString>

namespace plc::kit {

/// The tag of translations/stepwise_<tag>.ts for a language tag or a locale's name; Chinese is written in two scripts,
/// of which one is translated.
[[nodiscard]] QString translationTag(const QString& language);

} // namespace plc::kit
