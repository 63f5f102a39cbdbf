// Which language a table of texts gets as its next: chosen from those that there are, by their own names, or typed as
// a tag. Functions; GUI thread.
#pragma once
#include <QStringList>

class QWidget;

namespace plc::hmi {

/// "Deutsch (de)", "简体中文 (zh-CN)"…: every language that is known, by name.
[[nodiscard]] QStringList languagesToChoose();
/// The tag of what was chosen or typed: "Deutsch (de)", "german", "DE" → "de"; "" where it is no language.
[[nodiscard]] QString languageTagOf(const QString& typed);
/// Asks for one that is not `taken`, until it is one; "" when that is cancelled.
[[nodiscard]] QString askForLanguage(const QStringList& taken, QWidget* parent);

} // namespace plc::hmi
