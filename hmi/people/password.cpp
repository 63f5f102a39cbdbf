#include "hmi/people/password.h"

#include "hmi/model/errors.h"

#include <crypt.h>

#include <cerrno>
#include <cstring>
#include <memory>

namespace plc::hmi {

namespace {

constexpr int kShortest = 4; // figures on a machine's keypad

/// The work area is large and holds parts of the password: wiped before it goes.
struct WorkArea {
    crypt_data data{};
    ~WorkArea() { explicit_bzero(&data, sizeof data); }
};

QString crypted(const QString& password, const char* setting) {
    const QByteArray phrase = password.toUtf8();
    auto area = std::make_unique<WorkArea>();
    const char* hash = ::crypt_r(phrase.constData(), setting, &area->data);
    return hash && hash[0] != '*' ? QString::fromLatin1(hash) : QString();
}

} // namespace

Result<QString> hashOf(const QString& password) {
    char setting[CRYPT_GENSALT_OUTPUT_SIZE];
    if (!::crypt_gensalt_rn("$y$", 0, nullptr, 0, setting, sizeof setting))
        return Error{errors::PasswordNotHashed(std::string(std::strerror(errno))), {}};
    const QString hash = crypted(password, setting);
    if (hash.isEmpty()) return Error{errors::PasswordNotHashed(std::string(std::strerror(errno))), {}};
    return hash;
}

bool isPassword(const QString& password, const QString& hash) {
    if (!hash.startsWith(u'$') || password.contains(QChar(u'\0'))) return false;
    const QByteArray expected = hash.toLatin1(), found = crypted(password, expected.constData()).toLatin1();
    if (found.size() != expected.size() || found.isEmpty()) return false;
    int difference = 0; // as long for a wrong one as for a right one
    for (qsizetype i = 0; i < found.size(); ++i) difference |= found[i] ^ expected[i];
    return difference == 0;
}

Message weaknessOf(const QString& password, const QString& user) {
    if (password.size() < kShortest) return errors::PasswordTooShort(kShortest);
    if (password.compare(user, Qt::CaseInsensitive) == 0) return errors::PasswordIsName();
    return {};
}

} // namespace plc::hmi
