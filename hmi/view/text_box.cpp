#include "hmi/view/text_box.h"

#include <QFontMetricsF>
#include <QGlyphRun>
#include <QHash>
#include <QRawFont>

namespace plc::hmi {

namespace {

int flagsOf(const TextBox& box) {
    int flags = static_cast<int>(box.vertical) | Qt::AlignAbsolute;
    const bool atRight = (box.align == TextAlign::End) != box.rightToLeft;
    if (box.align == TextAlign::Center) flags |= Qt::AlignHCenter;
    else flags |= atRight ? Qt::AlignRight : Qt::AlignLeft;
    if (box.wraps) flags |= Qt::TextWordWrap;
    return flags;
}

/// Figures and plain Latin letters need no shaping: their glyphs are looked up once per font. A panel of a thousand
/// changing numbers would else spend most of its time in text layout.
struct PlainGlyphs {
    QRawFont font;
    std::array<quint32, 128> glyph{};
    std::array<double, 128> advance{};
    double ascent = 0, descent = 0;
    bool isUsable = false;

    explicit PlainGlyphs(const QFont& from) {
        font = QRawFont::fromFont(from);
        if (!font.isValid()) return;
        for (char16_t c = 32; c < 127; ++c) {
            const QList<quint32> indexes = font.glyphIndexesForString(QString(QChar(c)));
            if (indexes.size() != 1 || indexes[0] == 0) return;
            glyph[c] = indexes[0];
            advance[c] = font.advancesForGlyphIndexes(indexes).value(0).x();
        }
        ascent = font.ascent();
        descent = font.descent();
        isUsable = true;
    }
};

const PlainGlyphs* plainGlyphs(const QFont& font) {
    static QHash<QString, PlainGlyphs> known;
    thread_local QFont lastFont;
    thread_local const PlainGlyphs* last = nullptr;
    if (last && lastFont == font) return last->isUsable ? last : nullptr;
    const QString key = font.toString();
    auto found = known.find(key);
    if (found == known.end()) {
        if (known.size() > 64) known.clear(), last = nullptr;
        found = known.insert(key, PlainGlyphs(font));
    }
    lastFont = font;
    last = &*found;
    return last->isUsable ? last : nullptr;
}

bool isPlain(const QString& text) {
    if (text.size() > 48) return false;
    for (const QChar c : text)
        if (c < u' ' || c > u'~') return false;
    return true;
}

bool drawPlain(QPainter& painter, const TextBox& box) {
    const PlainGlyphs* glyphs = plainGlyphs(box.font);
    if (!glyphs) return false;
    double width = 0;
    for (const QChar c : box.text) width += glyphs->advance[c.unicode()];
    if (width > box.rect.width() + 0.5) return false;
    const bool atRight = (box.align == TextAlign::End) != box.rightToLeft;
    double x = box.rect.left();
    if (box.align == TextAlign::Center) x += (box.rect.width() - width) / 2;
    else if (atRight) x = box.rect.right() - width;
    double y = box.rect.center().y() + (glyphs->ascent - glyphs->descent) / 2;
    if (box.vertical & Qt::AlignTop) y = box.rect.top() + glyphs->ascent;
    if (box.vertical & Qt::AlignBottom) y = box.rect.bottom() - glyphs->descent;
    QList<quint32> indexes(box.text.size());
    QList<QPointF> places(box.text.size());
    for (qsizetype i = 0; i < box.text.size(); ++i) {
        const char16_t c = box.text[i].unicode();
        indexes[i] = glyphs->glyph[c];
        places[i] = {x, y};
        x += glyphs->advance[c];
    }
    QGlyphRun run;
    run.setRawFont(glyphs->font);
    run.setGlyphIndexes(indexes);
    run.setPositions(places);
    painter.drawGlyphRun({}, run);
    return true;
}

} // namespace

TextAlign textAlign(const QString& name) {
    if (name == QStringLiteral("center")) return TextAlign::Center;
    return name == QStringLiteral("end") ? TextAlign::End : TextAlign::Start;
}

QSizeF neededSize(const TextBox& box) {
    const QFontMetricsF metrics(box.font);
    // Fonts of some scripts have lines much higher than their letters: one line needs what its ink needs.
    const double ink = box.text.isEmpty() ? 0 : metrics.tightBoundingRect(box.text).height();
    if (!box.wraps) {
        const QStringList lines = box.text.split(u'\n');
        QSizeF size(0, ink);
        for (const QString& line : lines) size.setWidth(std::max(size.width(), metrics.horizontalAdvance(line)));
        if (lines.size() > 1) size.setHeight(static_cast<double>(lines.size()) * metrics.lineSpacing());
        return size;
    }
    QSizeF size = metrics.boundingRect(QRectF(0, 0, box.rect.width(), 1e6), Qt::TextWordWrap | Qt::AlignLeft, box.text).size();
    if (size.height() < metrics.lineSpacing() * 1.5) size.setHeight(ink);
    return size;
}

bool fits(const TextBox& box) {
    if (box.text.isEmpty()) return true;
    const QSizeF needed = neededSize(box);
    return needed.width() <= box.rect.width() + 0.5 && needed.height() <= box.rect.height() + 1;
}

void drawText(QPainter& painter, const TextBox& box) {
    if (box.text.isEmpty() || box.rect.width() < 1) return;
    if (isPlain(box.text) && drawPlain(painter, box)) return;
    painter.setFont(box.font);
    QString text = box.text;
    if (!box.wraps && !text.contains(u'\n')) {
        const QFontMetricsF metrics(box.font);
        if (metrics.horizontalAdvance(text) > box.rect.width() + 0.5) text = metrics.elidedText(text, Qt::ElideRight, box.rect.width());
    }
    if (box.wraps) {
        // A word that is wider than its line would lose both its ends.
        const QFontMetricsF metrics(box.font);
        for (const QString& word : text.split(u' ', Qt::SkipEmptyParts))
            if (metrics.horizontalAdvance(word) > box.rect.width() + 0.5) text.replace(word, metrics.elidedText(word, Qt::ElideRight, box.rect.width()));
    }
    painter.setLayoutDirection(box.rightToLeft ? Qt::RightToLeft : Qt::LeftToRight);
    painter.drawText(box.rect, flagsOf(box), text);
}

} // namespace plc::hmi
