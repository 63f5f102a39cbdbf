// The studio's own language: loads translations/stepwise_<tag>.qm (built in as resources) before the window is made.
// GUI thread.
#pragma once
#include <QString>
#include <QStringList>

class QApplication;

namespace plc::app {

/// "" = the system's language when there is one for it, else English.
void installTranslation(QApplication& application, const QString& tag);
[[nodiscard]] QStringList translatedLanguages(); // "en", "de", "da", "fr", "es", "zh_CN"

} // namespace plc::app
