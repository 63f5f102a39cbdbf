// Who may operate: who knows the access code, or the users of the panels with their passwords. Guesses are slowed down
// for each address. Owned by the server; main thread.
#pragma once
#include "hmi/people/people_file.h"

#include <QByteArray>
#include <QHash>
#include <QString>

#include <deque>
#include <functional>
#include <optional>

namespace plc::serve {

/// The name to show and to record for who gave that secret, or nothing.
using LogIn = std::function<std::optional<QString>(const QString& name, const QString& secret)>;
/// Everybody who knows the code is "operator"; compared in the same time whatever is wrong.
[[nodiscard]] LogIn byAccessCode(QByteArray code);
/// The users of the project's panels; they must outlive it.
[[nodiscard]] LogIn byPeople(const hmi::PeopleFile& people);

class Gate {
public:
    explicit Gate(LogIn logIn) : m_logIn(std::move(logIn)) {}
    enum class Answer { Open, Wrong, TooOften };
    struct Outcome {
        Answer answer = Answer::Wrong;
        QString name;
    };
    /// `now` in ms of any epoch.
    Outcome ask(const QString& address, const QString& name, const QString& secret, qint64 now);
    uint64_t refusals() const { return m_refusals; }

private:
    LogIn m_logIn;
    QHash<QString, std::deque<qint64>> m_failures; // times, by address
    uint64_t m_refusals = 0;
};

} // namespace plc::serve
