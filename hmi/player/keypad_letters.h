// The letters of a keypad: the rows of a language's own script, and the letters that Latin rows lack. Pure functions.
#pragma once
#include <QStringList>

namespace plc::hmi {

/// Three rows of at most twelve letters; empty where the language is written in Latin letters or by a method of input
/// (Chinese, Japanese, Korean).
[[nodiscard]] QStringList letterRows(const QString& tag);
/// "äöüß"
[[nodiscard]] QString moreLetters(const QString& tag);

} // namespace plc::hmi
