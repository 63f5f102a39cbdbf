// The studio's own language: loads translations/stepwise_<tag>.qm (built in as resources) before the window is made.
// GUI thread.
#pragma once
#include <QString>
#include <QStringList>

class QApplication;

namespace plc::app {

/// "" = the system's language when there is one for it, else English.
void installTranslation(QApplication& application, const QString& tag);
[[nodiscard]] QStringList translatedLanguages(); // their tags: "en", "de", …
[[nodiscard]] QString ownNameOf(const QString& language);

} // namespace plc::app
