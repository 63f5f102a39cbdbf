// The few texts that the panel itself shows (keypad, state of the controller, refusals), in the operator's language.
// A project overrides any of them by a key `hmi.<name>` in its text table; a language without own words here takes
// those of the next one in its fallback chain, at last English. Pure function.
#pragma once
#include "hmi/texts/catalog.h"

namespace plc::hmi {

enum class SystemText {
    Ok,
    Cancel,
    Yes,
    No,
    Clear,
    Close,
    LogIn,
    LogOut,
    AccessCode,
    WrongAccessCode,
    LogInFirst,
    ConnectionLost,
    Time,
    Alarm,
    NoAlarms,
    AcknowledgeAll,
    All,
    Unacknowledged,
    Acknowledged,
    Returned,
    Gone,         // states of alarms
    UntilRestart, // neither gone nor acknowledged when the controller was started again
    Stopped,
    Paused,
    Fault,
    Past,
    NoController,
    Between, // "between %1 and %2"
    AtLeast,
    AtMost,
    TooLong, // "at most %1 characters"
    BadCharacter,
    NotANumber,
    OutsideLimits,
    IsForced,
    NotRunning,
    InThePast,
    NotWritable,
    Password,
    WrongPassword,
    TooManyTries,
    OnlyFor,
    ConfirmWrite, // "Write %2 to %1?"
    Acknowledge,
    ShowMe,
    ShelveFor,
    ShelvedUntil,
    OutOfService,
    PutBack,
    AlarmsPerHour,
    AlarmFloods,
    StandingAlarms,
    ChatteringAlarms,
    UserName,
    ConfirmRemove, // "Delete %1?"
    ConfirmRead,   // "Replace the values in %1 with those of the controller?"
};

QString systemText(const TextCatalog& texts, SystemText text, const QString& tag);
/// The key that a project may define: "hmi.ok".
QString systemKey(SystemText text);

} // namespace plc::hmi
