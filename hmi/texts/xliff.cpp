#include "hmi/texts/xliff.h"

#include "hmi/model/errors.h"
#include "hmi/texts/format.h"

#include <QRegularExpression>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>

#include <algorithm>
#include <functional>

namespace plc::hmi {

namespace {

const QString kNamespace12 = QStringLiteral("urn:oasis:names:tc:xliff:document:1.2");
const QString kNamespace20 = QStringLiteral("urn:oasis:names:tc:xliff:document:2.0");

constexpr int kDeepest = 64; // inline elements, groups

/// A text in pieces: plain ones and placeholders "{level:%.1f}".
struct Piece {
    QString text;
    bool isPlaceholder = false;
};

std::vector<Piece> piecesOf(const QString& text) {
    static const QRegularExpression placeholder(QStringLiteral("\\{[^{}]*\\}"));
    std::vector<Piece> out;
    qsizetype from = 0;
    for (auto it = placeholder.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        if (match.capturedStart() > from) out.push_back({text.mid(from, match.capturedStart() - from)});
        out.push_back({match.captured(), true});
        from = match.capturedEnd();
    }
    if (from < text.size() || out.empty()) out.push_back({text.mid(from)});
    return out;
}

/// XML 1.0 has no place for control characters.
QString clean(const QString& text) {
    QString out;
    for (const QChar c : text)
        if (c >= u' ' || c == u'\n' || c == u'\t') out += c;
    return out;
}

QString fileIdOf(const QString& key) {
    QString out;
    for (const QChar c : key) out += c.isLetterOrNumber() || c == u'.' || c == u'-' || c == u'_' ? c : QChar(u'_');
    return out;
}

struct Writer {
    const XliffOptions& options;
    QString bytes{};
    QXmlStreamWriter xml{&bytes};

    bool is20() const { return options.version == XliffVersion::V20; }

    void text(const QString& element, const QString& words, int& number, const std::function<void()>& attributes = {}) {
        xml.writeStartElement(element);
        xml.setAutoFormatting(false); // blanks within count
        if (attributes) attributes();
        for (const Piece& piece : piecesOf(words)) {
            if (!piece.isPlaceholder) {
                xml.writeCharacters(clean(piece.text));
                continue;
            }
            xml.writeStartElement(QStringLiteral("ph"));
            xml.writeAttribute(QStringLiteral("id"), QString::number(number++));
            if (is20()) {
                xml.writeAttribute(QStringLiteral("equiv"), piece.text);
                xml.writeAttribute(QStringLiteral("disp"), piece.text);
            } else {
                xml.writeCharacters(piece.text);
            }
            xml.writeEndElement();
        }
        xml.writeEndElement();
        xml.setAutoFormatting(true);
    }

    void begin() {
        xml.setAutoFormatting(true);
        xml.setAutoFormattingIndent(2);
        xml.writeStartDocument();
        xml.writeStartElement(QStringLiteral("xliff"));
        xml.writeDefaultNamespace(is20() ? kNamespace20 : kNamespace12);
        xml.writeAttribute(QStringLiteral("version"), is20() ? QStringLiteral("2.0") : QStringLiteral("1.2"));
        if (is20()) {
            xml.writeAttribute(QStringLiteral("srcLang"), options.source);
            xml.writeAttribute(QStringLiteral("trgLang"), options.target);
        }
        xml.writeStartElement(QStringLiteral("file"));
        if (is20()) xml.writeAttribute(QStringLiteral("id"), QStringLiteral("texts"));
        xml.writeAttribute(QStringLiteral("original"), options.original);
        if (is20()) return;
        xml.writeAttribute(QStringLiteral("source-language"), options.source);
        xml.writeAttribute(QStringLiteral("target-language"), options.target);
        xml.writeAttribute(QStringLiteral("datatype"), QStringLiteral("plaintext"));
        xml.writeStartElement(QStringLiteral("body"));
    }

    void notes20(const TextTable::Row& row) {
        const QStringList places = options.places.value(row.key);
        if (places.isEmpty() && row.comment.isEmpty()) return;
        xml.writeStartElement(QStringLiteral("notes"));
        const auto note = [&](const char* category, const QString& words) {
            xml.writeStartElement(QStringLiteral("note"));
            xml.writeAttribute(QStringLiteral("category"), QLatin1String(category));
            xml.writeCharacters(clean(words));
            xml.writeEndElement();
        };
        if (!row.comment.isEmpty()) note("comment", row.comment);
        for (const QString& place : places) note("place", place);
        xml.writeEndElement();
    }

    void unit20(const TextTable::Row& row, const QString& source, const QString& target) {
        xml.writeStartElement(QStringLiteral("unit"));
        xml.writeAttribute(QStringLiteral("id"), fileIdOf(row.key));
        xml.writeAttribute(QStringLiteral("name"), row.key);
        notes20(row);
        xml.writeStartElement(QStringLiteral("segment"));
        xml.writeAttribute(QStringLiteral("state"),
                           target.isEmpty() ? QStringLiteral("initial") : QStringLiteral("translated"));
        const auto space = [&] { xml.writeAttribute(QStringLiteral("xml:space"), QStringLiteral("preserve")); };
        int number = 1, again = 1;
        text(QStringLiteral("source"), source, number, space);
        if (!target.isEmpty()) text(QStringLiteral("target"), target, again, space);
        xml.writeEndElement();
        xml.writeEndElement();
    }

    void unit12(const TextTable::Row& row, const QString& source, const QString& target) {
        xml.writeStartElement(QStringLiteral("trans-unit"));
        xml.writeAttribute(QStringLiteral("id"), row.key);
        xml.writeAttribute(QStringLiteral("resname"), row.key);
        xml.writeAttribute(QStringLiteral("xml:space"), QStringLiteral("preserve"));
        int number = 1, again = 1;
        text(QStringLiteral("source"), source, number);
        text(QStringLiteral("target"), target, again, [&] {
            xml.writeAttribute(QStringLiteral("state"),
                               target.isEmpty() ? QStringLiteral("needs-translation") : QStringLiteral("translated"));
        });
        for (const QString& place : options.places.value(row.key)) {
            xml.writeStartElement(QStringLiteral("context-group"));
            xml.writeAttribute(QStringLiteral("purpose"), QStringLiteral("location"));
            xml.writeStartElement(QStringLiteral("context"));
            xml.writeAttribute(QStringLiteral("context-type"), QStringLiteral("x-place"));
            xml.writeCharacters(clean(place));
            xml.writeEndElement();
            xml.writeEndElement();
        }
        if (!row.comment.isEmpty()) xml.writeTextElement(QStringLiteral("note"), clean(row.comment));
        xml.writeEndElement();
    }
};

/// Reads the text of an element with its inline codes; the reader is at its start.
QString inlineText(QXmlStreamReader& xml, const QMap<QString, QString>& data, int depth = 0) {
    QString out;
    if (depth > kDeepest) xml.raiseError(QStringLiteral("too many elements within each other"));
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isCharacters() || xml.isEntityReference()) out += xml.text();
        if (xml.isEndElement()) return out;
        if (!xml.isStartElement()) continue;
        const QString name = xml.name().toString();
        const QXmlStreamAttributes attributes = xml.attributes();
        QString shown = data.value(attributes.value(QLatin1String("dataRef")).toString());
        for (const char* one : {"equiv", "disp", "equiv-text"})
            if (shown.isEmpty()) shown = attributes.value(QLatin1String(one)).toString();
        if (name == QLatin1String("cp")) // a character that XML has no place for
            shown = QChar(static_cast<char16_t>(attributes.value(QLatin1String("hex")).toString().toUInt(nullptr, 16)));
        const QString inner = inlineText(xml, data, depth + 1); // pc, g, mrk: the text within counts
        out += inner.isEmpty() ? shown : inner;
    }
    return out;
}

struct Reader {
    QXmlStreamReader xml;
    XliffFile out{};
    QString place;

    Error error(Message message) const {
        return {std::move(message), (place + u':' + QString::number(xml.lineNumber())).toStdString()};
    }

    static bool isDone(QStringView state) {
        return state != QLatin1String("initial") && state != QLatin1String("new") &&
               !state.startsWith(QLatin1String("needs-translation"));
    }

    void readData(QMap<QString, QString>& data) {
        while (xml.readNextStartElement()) {
            const QString id = xml.attributes().value(QLatin1String("id")).toString();
            data.insert(id, xml.readElementText(QXmlStreamReader::IncludeChildElements));
        }
    }

    void readSegment(XliffUnit& unit, const QMap<QString, QString>& data, bool isSegment) {
        if (isSegment && xml.attributes().hasAttribute(QLatin1String("state")))
            unit.isTranslated &= isDone(xml.attributes().value(QLatin1String("state")));
        QString source, target;
        bool hasTarget = false;
        while (xml.readNextStartElement()) {
            if (xml.name() == QLatin1String("source")) {
                source = inlineText(xml, data);
            } else if (xml.name() == QLatin1String("target")) {
                target = inlineText(xml, data);
                hasTarget = true;
            } else {
                xml.skipCurrentElement();
            }
        }
        unit.source += source;
        unit.target += hasTarget || isSegment ? target : source; // between segments the source stays
    }

    void readUnit20() {
        XliffUnit unit;
        unit.line = static_cast<int>(xml.lineNumber());
        unit.key = xml.attributes().value(QLatin1String("name")).toString();
        if (unit.key.isEmpty()) unit.key = xml.attributes().value(QLatin1String("id")).toString();
        QMap<QString, QString> data;
        while (xml.readNextStartElement()) {
            if (xml.name() == QLatin1String("originalData"))
                readData(data);
            else if (xml.name() == QLatin1String("segment") || xml.name() == QLatin1String("ignorable"))
                readSegment(unit, data, xml.name() == QLatin1String("segment"));
            else
                xml.skipCurrentElement();
        }
        out.units.push_back(std::move(unit));
    }

    void readUnit12() {
        XliffUnit unit;
        unit.line = static_cast<int>(xml.lineNumber());
        unit.key = xml.attributes().value(QLatin1String("resname")).toString();
        if (unit.key.isEmpty()) unit.key = xml.attributes().value(QLatin1String("id")).toString();
        while (xml.readNextStartElement()) {
            if (xml.name() == QLatin1String("source")) {
                unit.source = inlineText(xml, {});
            } else if (xml.name() == QLatin1String("target")) {
                unit.isTranslated = isDone(xml.attributes().value(QLatin1String("state")));
                unit.target = inlineText(xml, {});
            } else {
                xml.skipCurrentElement();
            }
        }
        out.units.push_back(std::move(unit));
    }

    /// Files, groups and bodies, however deep.
    void readContents(int depth) {
        while (xml.readNextStartElement()) {
            const auto name = xml.name();
            if (name == QLatin1String("unit")) {
                readUnit20();
            } else if (name == QLatin1String("trans-unit")) {
                readUnit12();
            } else if (depth < kDeepest && (name == QLatin1String("file") || name == QLatin1String("body") ||
                                            name == QLatin1String("group"))) {
                if (out.source.isEmpty())
                    out.source = xml.attributes().value(QLatin1String("source-language")).toString();
                if (out.target.isEmpty())
                    out.target = xml.attributes().value(QLatin1String("target-language")).toString();
                readContents(depth + 1);
            } else {
                xml.skipCurrentElement();
            }
        }
    }

    Result<XliffFile> read() {
        if (!xml.readNextStartElement() || xml.name() != QLatin1String("xliff")) return error(errors::NotXliff());
        const QString version = xml.attributes().value(QLatin1String("version")).toString();
        if (!version.startsWith(QLatin1String("1.")) && !version.startsWith(QLatin1String("2.")))
            return error(errors::XliffVersionUnknown(toUtf8(version)));
        out.version = version.startsWith(u'1') ? XliffVersion::V12 : XliffVersion::V20;
        out.source = xml.attributes().value(QLatin1String("srcLang")).toString();
        out.target = xml.attributes().value(QLatin1String("trgLang")).toString();
        readContents(0);
        if (xml.hasError()) return error(errors::XmlWrong(toUtf8(xml.errorString())));
        if (out.target.isEmpty()) return error(errors::XliffWithoutTarget());
        return out;
    }
};

QStringList placeholdersOf(const QString& text) {
    QStringList out;
    for (const Piece& piece : piecesOf(text))
        if (piece.isPlaceholder)
            out += piece.text.mid(1).section(u':', 0, 0).chopped(piece.text.contains(u':') ? 0 : 1);
    out.sort();
    return out;
}

} // namespace

std::string writeXliff(const TextTable& table, const XliffOptions& options) {
    Writer writer{options};
    writer.begin();
    for (const TextTable::Row& row : table.rows()) {
        const QString source = table.text(row.key, options.source), target = table.text(row.key, options.target);
        if (source.isEmpty() || (options.onlyMissing && !target.isEmpty())) continue;
        if (writer.is20())
            writer.unit20(row, source, target);
        else
            writer.unit12(row, source, target);
    }
    writer.xml.writeEndDocument();
    return toUtf8(writer.bytes);
}

Result<XliffFile> readXliff(const std::string& bytes, const QString& place) {
    Reader reader{QXmlStreamReader(QByteArray::fromStdString(bytes)), {}, place};
    return reader.read();
}

XliffReport takeXliff(TextTable& table, const XliffFile& file, const QString& place) {
    XliffReport report;
    const auto remark = [&](const XliffUnit& unit, Message message) {
        report.remarks.push_back({std::move(message), (place + u':' + QString::number(unit.line)).toStdString()});
    };
    for (const XliffUnit& unit : file.units) {
        const std::string key = toUtf8(unit.key);
        if (!table.contains(unit.key)) {
            remark(unit, errors::KeyMissing(key));
            continue;
        }
        if (unit.target.isEmpty() || !unit.isTranslated) {
            ++report.empty;
            continue;
        }
        const QString source = table.text(unit.key, file.source);
        if (!source.isEmpty() && clean(source) != unit.source)
            remark(unit, errors::SourceTextChanged(key, toUtf8(file.source)));
        // Of the text as it is here: a tool may have lost them in its copy of the source, too.
        if (placeholdersOf(unit.target) != placeholdersOf(source.isEmpty() ? unit.source : source)) {
            remark(unit, errors::TranslationPlaceholders(key));
            continue;
        }
        if (table.text(unit.key, file.target) == unit.target) {
            ++report.same;
            continue;
        }
        if (table.columnOf(file.target) < 0) table.addLanguage(file.target);
        table.setText(unit.key, file.target, unit.target);
        ++report.taken;
    }
    return report;
}

} // namespace plc::hmi
