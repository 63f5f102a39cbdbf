// The fields of devices.json as the window names them: which ones a device or channel has, their titles and the words
// to choose from. Pure lookups without state; DevicesView uses them on the GUI thread.
#pragma once

#include "projects/devices/configuration/device.h"

#include <QString>
#include <QStringList>

class QAbstractItemDelegate;
class QObject;

namespace plc::app {

/// Data of the two cells of a row: the field's name in the file; its word in the file where it has a choice of words.
constexpr int kFieldRole = Qt::UserRole, kWordRole = Qt::UserRole + 1;

[[nodiscard]] QStringList fieldsOf(devices::Protocol protocol);
[[nodiscard]] QStringList channelFieldsOf(devices::Protocol protocol);
/// "poll" as "Poll interval".
[[nodiscard]] QString fieldTitle(const QString& field);
/// The words that `field` may have, as the file writes them; none where anything can be typed.
[[nodiscard]] QStringList wordsOf(const QString& field);
/// "holding" of "table" as "Holding register"; a word that is none of the field's as it is.
[[nodiscard]] QString wordTitle(const QString& field, const QString& word);
/// Edits the second cell of a row: a list of titles where the field of the first has words.
[[nodiscard]] QAbstractItemDelegate* newFieldDelegate(QObject* parent);

} // namespace plc::app
