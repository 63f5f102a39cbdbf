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

/// The lines of a row that is none.
struct BadLines {
    int first = 0, last = 0;
};

Result<CsvTable> parse(const std::string& bytes, const QString& place, BadLines& bad) {
    int rowLine = 1;
    const auto fail = [&](int first, int line, Message message) {
        bad = {first, line};
        return Error{std::move(message), (place + u':' + QString::number(line)).toStdString()};
    };
    std::string_view text = bytes;
    if (text.starts_with(kBom)) text.remove_prefix(kBom.size());
    int number = 1;
    for (size_t from = 0; from < text.size(); ++number) {
        const size_t end = std::min(text.find('\n', from), text.size());
        if (!isUtf8(text.substr(from, end - from))) return fail(number, number, errors::LineNotUtf8());
        from = end + 1;
    }
    CsvTable table;
    table.separator = separatorOf(text);
    std::string field;
    QStringList row;
    bool quoted = false, wasQuoted = false, any = false;
    int line = 1, quoteLine = 1;
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
            return fail(rowLine, line, errors::TextAfterQuote());
        } else {
            field += c;
        }
    }
    if (quoted) return fail(quoteLine, quoteLine, errors::QuoteNotClosed());
    if (any) endRow();
    return table;
}

/// Takes the lines out, an empty one stays for each, so that the numbers of the others hold.
void takeOut(std::string& bytes, const BadLines& bad, const Error& error, std::vector<CsvTable::Damage>& into) {
    size_t begin = 0;
    for (int line = 1; line < bad.first && begin != std::string::npos; ++line) begin = bytes.find('\n', begin) + 1;
    for (int line = bad.first; line <= bad.last && begin < bytes.size(); ++line) {
        const size_t end = std::min(bytes.find('\n', begin), bytes.size());
        std::string taken = bytes.substr(begin, end - begin);
        if (taken.ends_with('\r')) taken.pop_back();
        bytes.erase(begin, end - begin);
        into.push_back({line, std::move(taken), error});
        ++begin;
    }
}

} // namespace

Result<CsvTable> parseCsv(const std::string& bytes, const QString& place) {
    BadLines bad;
    return parse(bytes, place, bad);
}

Result<CsvTable> parseDamagedCsv(const std::string& bytes, const QString& place) {
    constexpr size_t kMost = 200; // each costs a reading of the file
    std::string rest = bytes;
    std::vector<CsvTable::Damage> damaged;
    for (;;) {
        BadLines bad;
        Result<CsvTable> table = parse(rest, place, bad);
        if (!table && (bad.first <= 1 || damaged.size() > kMost)) return table; // without its header it is no table
        if (!table) {
            takeOut(rest, bad, table.error(), damaged);
            continue;
        }
        std::sort(damaged.begin(), damaged.end(),
                  [](const CsvTable::Damage& a, const CsvTable::Damage& b) { return a.line < b.line; });
        table->damaged = std::move(damaged);
        return table;
    }
}

std::string writeCsvRow(const QStringList& row) {
    std::string out;
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
    return out + "\r\n";
}

std::string writeCsv(const std::vector<QStringList>& rows) {
    std::string out(kBom);
    for (const QStringList& row : rows) out += writeCsvRow(row);
    return out;
}

} // namespace plc::hmi
