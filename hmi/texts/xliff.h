// Texts for translators' tools: XLIFF 2.0 and 1.2, out of the text table and back into it. Placeholders are inline
// codes, so that a tool keeps them; notes say where a text is used. Pure functions, any thread.
#pragma once
#include "hmi/texts/text_table.h"

#include <QMap>

namespace plc::hmi {

enum class XliffVersion { V12, V20 };

struct XliffOptions {
    XliffVersion version = XliffVersion::V20;
    QString source, target;              // language tags
    QString original;                    // "hmi/texts.csv"
    QMap<QString, QStringList> places{}; // by key: "main: button1.text"
    bool onlyMissing = false;            // texts without a translation
};
/// One unit per key that has a text in the source language.
std::string writeXliff(const TextTable& table, const XliffOptions& options);

struct XliffUnit {
    QString key, source, target;
    bool isTranslated = true; // by its state
    int line = 0;
};
struct XliffFile {
    XliffVersion version = XliffVersion::V20;
    QString source, target;
    std::vector<XliffUnit> units;
};
Result<XliffFile> readXliff(const std::string& bytes, const QString& place);

/// What became of a file that was read into the table.
struct XliffReport {
    int taken = 0, same = 0, empty = 0;
    std::vector<Error> remarks; // unknown keys, sources that are other texts now, placeholders that differ
};
/// Only translations with the placeholders of their source are taken.
XliffReport takeXliff(TextTable& table, const XliffFile& file, const QString& place);

} // namespace plc::hmi
