#include "hmi/texts/csv.h"

#include "hmi/model/errors.h"

#include <QStringDecoder>
#include <algorithm>
#include <string_view>

namespace plc::hmi {

namespace {

constexpr std::string_view kBom = "\xEF\xBB\xBF";

/// The separator of a file is the one that stands most often in its first line outside quotes.
char separatorOf(std::string_view text) {
    int commas = 0, semicolons = 0, tabs = 0;
    bool quoted = false;
    for (const char c : text) {
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '\n' || c == '\r') break;
        commas += c == ',';
        semicolons += c == ';';
        tabs += c == '\t';
    }
    if (tabs > commas && tabs > semicolons) return '\t';
    return semicolons > commas ? ';' : ',';
}

bool isUtf8(std::string_view line) {
    QStringDecoder decoder(QStringDecoder::Utf8, QStringConverter::Flag::Stateless);
    const QString text = decoder.decode(QByteArrayView(line.data(), static_cast<qsizetype>(line.size())));
    Q_UNUSED(text)
    return !decoder.hasError();
}

} // namespace

Result<CsvTable> parseCsv(const std::string& bytes, const QString& place) {
    const auto fail = [&](int line, Message message) {
        return Error{std::move(message), (place + u':' + QString::number(line)).toStdString()};
    };
    std::string_view text = bytes;
    if (text.starts_with(kBom)) text.remove_prefix(kBom.size());
    int number = 1;
    for (size_t from = 0; from < text.size(); ++number) {
        const size_t end = std::min(text.find('\n', from), text.size());
        if (!isUtf8(text.substr(from, end - from))) return fail(number, errors::LineNotUtf8());
        from = end + 1;
    }
    CsvTable table;
    table.separator = separatorOf(text);
    std::string field;
    QStringList row;
    bool quoted = false, wasQuoted = false, any = false;
    int line = 1, rowLine = 1, quoteLine = 1;
    const auto endField = [&] {
        QStringDecoder decoder(QStringDecoder::Utf8,
                               QStringConverter::Flag::ConvertInitialBom); // fromUtf8 would take a mark off each field
        row += QString(decoder.decode(QByteArrayView(field.data(), static_cast<qsizetype>(field.size()))));
        field.clear();
        wasQuoted = false;
    };
    const auto endRow = [&] {
        endField();
        if (row.size() > 1 || !row.front().isEmpty()) {
            table.rows.push_back(row);
            table.lines.push_back(rowLine);
        }
        row.clear();
        any = false;
    };
    for (size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            if (c == '\n') ++line;
            if (c != '"')
                field += c;
            else if (i + 1 < text.size() && text[i + 1] == '"')
                field += text[++i];
            else
                quoted = false;
            continue;
        }
        if (!any) rowLine = line;
        any = true;
        if (c == table.separator) {
            endField();
        } else if (c == '\n' || c == '\r') {
            if (c == '\r' && i + 1 < text.size() && text[i + 1] == '\n') ++i;
            endRow();
            ++line;
        } else if (c == '"' && field.empty() && !wasQuoted) {
            quoted = wasQuoted = true;
            quoteLine = line;
        } else if (wasQuoted) {
            return fail(line, errors::TextAfterQuote());
        } else {
            field += c;
        }
    }
    if (quoted) return fail(quoteLine, errors::QuoteNotClosed());
    if (any) endRow();
    return table;
}

std::string writeCsv(const std::vector<QStringList>& rows) {
    std::string out(kBom);
    for (const QStringList& row : rows) {
        bool first = true;
        for (const QString& field : row) {
            if (!first) out += ',';
            first = false;
            const bool needsQuotes = field.contains(u',') || field.contains(u'"') || field.contains(u'\n') ||
                                     field.contains(u'\r') || (row.size() == 1 && field.isEmpty());
            QString text = field;
            if (needsQuotes) text = u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"';
            out += text.toStdString();
        }
        out += "\r\n";
    }
    return out;
}

} // namespace plc::hmi
