// Which languages there are, and which of a project's is meant for somebody. Functions, any thread.
#pragma once
#include <QLocale>
#include <QStringList>

namespace plc::hmi {

/// A language's code in BCP 47, with script, country and extensions where it has them ("de", "sr-Latn", "pt-BR"), or
/// the pseudo-language. "xx,yy" and "german" are none.
bool isLanguageTag(const QString& tag);
/// The one of `languages` for readers of `reader`: its very tag, else its language, else the first.
QString closestTag(const QStringList& languages, const QLocale& reader);

} // namespace plc::hmi
