#include "app/serve/gate.h"

#include "hmi/people/log_in.h"

#include <QCryptographicHash>

namespace plc::serve {

LogIn byAccessCode(QByteArray code) {
    const auto print = [](const QByteArray& text) {
        return QCryptographicHash::hash(text, QCryptographicHash::Sha256);
    };
    return [wanted = print(code), print](const QString&, const QString& secret) -> std::optional<QString> {
        const QByteArray given = print(secret.toUtf8());
        int difference = 0;
        for (qsizetype i = 0; i < wanted.size(); ++i) difference |= wanted[i] ^ given[i];
        if (difference != 0) return {};
        return QStringLiteral("operator");
    };
}

LogIn byPeople(const hmi::PeopleFile& people) {
    return [&people](const QString& name, const QString& secret) -> std::optional<QString> {
        hmi::LogIn door(people); // wrong ones are counted by the gate, by where they come from
        if (door.logIn(name, secret, std::chrono::steady_clock::now()) != hmi::LogIn::Answer::Good) return {};
        return door.user();
    };
}

Gate::Outcome Gate::ask(const QString& address, const QString& name, const QString& secret, qint64 now) {
    constexpr qint64 kWindow = 60'000;
    constexpr size_t kTries = 10;
    constexpr qsizetype kAddresses = 4096;
    if (m_failures.size() > kAddresses) // forgets whoever has been quiet
        m_failures.removeIf(
            [&](const auto& entry) { return entry.value().empty() || now - entry.value().back() > kWindow; });
    std::deque<qint64>& failures = m_failures[address];
    while (!failures.empty() && now - failures.front() > kWindow) failures.pop_front();
    if (failures.size() >= kTries) {
        ++m_refusals;
        return {Answer::TooOften, {}};
    }
    if (const std::optional<QString> known = m_logIn(name, secret)) return {Answer::Open, *known};
    failures.push_back(now);
    ++m_refusals;
    return {Answer::Wrong, {}};
}

} // namespace plc::serve
