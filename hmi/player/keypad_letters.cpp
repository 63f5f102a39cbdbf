#include "hmi/player/keypad_letters.h"

namespace plc::hmi {

namespace {

struct Letters {
    const char* languages; // "|ru|bg|"
    const char* rows[3];
};

// As the keyboards of the countries have them.
constexpr Letters kScripts[] = {
    {"|ar|fa|ur|", {"ضصثقفغعهخحجد", "شسيبلاتنمكطذ", "ئءؤرلاىةوزظآ"}},
    {"|he|yi|", {"קראטוןםפ", "שדגכעיחלךף", "זסבהנמצתץ"}},
    {"|ru|bg|", {"йцукенгшщзхъ", "фывапролджэё", "ячсмитьбю"}},
    {"|uk|", {"йцукенгшщзхї", "фівапролджєґ", "ячсмитьбю"}},
    {"|el|", {"ςερτυθιοπ", "ασδφγηξκλ", "ζχψωβνμάέ"}},
    {"|th|", {"ๆไำพะัีรนยบล", "ฟหกดเ้่าสวงช", "ผปแอิืทมใฝ"}},
    {"|hi|mr|ne|", {"ौैाीूबहगदजड", "ोे्िुपरकतचट", "मनवलसयञधभष"}},
};

QString languageOf(const QString& tag) { return tag.section(u'-', 0, 0).toLower(); }

} // namespace

QStringList letterRows(const QString& tag) {
    for (const Letters& script : kScripts)
        if (QLatin1String(script.languages).contains(QString(u'|' + languageOf(tag) + u'|')))
            return {QString::fromUtf8(script.rows[0]), QString::fromUtf8(script.rows[1]),
                    QString::fromUtf8(script.rows[2])};
    return {};
}

QString moreLetters(const QString& tag) {
    const struct {
        const char *language, *letters;
    } rows[] = {{"de", "äöüß"},   {"da", "æøå"},        {"nb", "æøå"},       {"sv", "åäö"},
                {"fi", "åäö"},    {"fr", "éèêàâçùûîô"}, {"es", "ñáéíóúü"},   {"pt", "ãõáéíóúâêç"},
                {"it", "àèéìòù"}, {"nl", "éëïóö"},      {"pl", "ąćęłńóśźż"}, {"cs", "áčďéěíňóřšťúůýž"},
                {"tr", "çğıöşü"}};
    for (const auto& row : rows)
        if (languageOf(tag) == QLatin1String(row.language)) return QString::fromUtf8(row.letters);
    return {};
}

} // namespace plc::hmi
