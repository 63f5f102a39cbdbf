// The few texts that the panel itself shows (keypad, state of the controller, refusals), in the operator's language.
// A project overrides any of them by a key `hmi.<name>` in its text table. Pure function.
#pragma once
#include "hmi/texts/catalog.h"

namespace plc::hmi {

enum class SystemText {
    Ok, Cancel, Yes, No, Clear, Close,
    Time, Alarm, NoAlarms, AcknowledgeAll,
    Stopped, Paused, Fault, Past, NoController,
    Between,        // "between %1 and %2"
    AtLeast, AtMost,
    NotANumber, OutsideLimits, IsForced, NotRunning, InThePast, NotWritable,
};

QString systemText(const TextCatalog& texts, SystemText text, const QString& tag);
/// The key that a project may define: "hmi.ok".
QString systemKey(SystemText text);

} // namespace plc::hmi
