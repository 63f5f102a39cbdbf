// Passwords as they are kept: a salt and a slow hash of it (yescrypt of libxcrypt, which costs memory and time on
// purpose). Functions; any thread, each call takes some tens of milliseconds.
#pragma once
#include "runtime/base/result.h"

#include <QString>

namespace plc::hmi {

/// "$y$…" with a fresh salt; an error where the system has no randomness for one.
Result<QString> hashOf(const QString& password);
bool isPassword(const QString& password, const QString& hash);
/// Why a new password is refused: too short, or the name of its user. Empty: it may be taken.
Message weaknessOf(const QString& password, const QString& user);

} // namespace plc::hmi
