#include "hmi/model/array_index.h"

namespace plc::hmi {

QString withIndex(QString expression, int index, int row, int column) {
    const auto isWord = [](QChar c) { return c.isLetterOrNumber() || c == u'_'; };
    QString out;
    int depth = 0;
    QChar quote, before;
    for (qsizetype i = 0; i < expression.size(); ++i) {
        const QChar c = expression[i], next = i + 1 < expression.size() ? expression[i + 1] : QChar();
        if (!quote.isNull()) {
            if (c == u'$' && !next.isNull()) { // $' is no end
                out += c;
                out += next;
                ++i;
                continue;
            }
            if (c == quote) quote = QChar();
        } else if (c == u'\'' || c == u'"') {
            quote = c;
        } else if (c == u'[' || c == u']') {
            depth += c == u'[' ? 1 : -1;
        } else if (c == u'#' && depth > 0 && !isWord(before)) {
            const bool isNamed =
                (next == u'r' || next == u'c') && (i + 2 >= expression.size() || !isWord(expression[i + 2]));
            if (isNamed || !isWord(next)) {
                out += QString::number(!isNamed ? index : next == u'r' ? row : column);
                i += isNamed;
                before = u'0';
                continue;
            }
        }
        out += c;
        if (!c.isSpace()) before = c;
    }
    return out;
}

} // namespace plc::hmi
