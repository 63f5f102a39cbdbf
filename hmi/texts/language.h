// The operator languages of a project and how each writes numbers, dates and units. A value, any thread.
#pragma once
#include "hmi/model/json.h"
#include "hmi/model/value.h"

#include <QLocale>
#include <QMap>
#include <QStringList>

namespace plc::hmi {

/// A language that is made from the first one, longer and accented, to see what a translation will do to a panel.
inline const QString kPseudoTag = QStringLiteral("qps-ploc");

/// How a figure in one unit is shown in another: shown = raw * factor + offset.
struct UnitView {
    QString unit;
    double factor = 1, offset = 0;
    double shown(double raw) const { return raw * factor + offset; }
    double raw(double shown) const { return (shown - offset) / factor; }
};

struct LanguageSettings {
    QStringList languages{QStringLiteral("en")}; // BCP 47 tags in the operator's order
    QStringList fallback;                        // asked in this order when a text is missing
    QString font = QStringLiteral("Noto Sans");
    QString variable;                            // PLC variable that holds the language
    QMap<QString, QMap<QString, QString>> units; // tag → unit → unit shown

    /// Reads the fields `languages`, `fallback`, `font`, `languageVariable`, `units` of project.json.
    static LanguageSettings fromJson(const Json& project);
    /// The tags to ask for a text, in order, without repetition.
    QStringList chain(const QString& tag) const;
    UnitView unitFor(const QString& tag, const QString& unit) const;
    /// Families for the language: the project's font, then the one of the script.
    QStringList fontFamilies(const QString& tag) const;
    /// The tag that a value of the language variable means: a position for numbers, a tag for texts.
    QString tagOf(const Value& value) const;
    Value valueOf(const QString& tag, ValueKind kind) const;
};

QLocale localeOf(const QString& tag);
bool isRightToLeft(const QString& tag);
/// "Deutsch", "dansk", "简体中文".
QString nativeName(const QString& tag);
/// Text of the pseudo-language: accented, 40 % longer, placeholders untouched.
QString pseudoText(const QString& text);

} // namespace plc::hmi
