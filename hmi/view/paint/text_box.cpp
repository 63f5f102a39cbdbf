#include "hmi/view/paint/text_box.h"

#include "hmi/view/paint/glyph_sink.h"

#include <QFontMetricsF>
#include <QGlyphRun>
#include <QHash>
#include <QRawFont>
#include <QTextLayout>

namespace plc::hmi {

namespace {

bool isAtRight(const TextBox& box) { return (box.align == TextAlign::End) != box.rightToLeft; }

/// The text cut into the lines that are drawn. Lines stand as far apart as those of the box's own font: fonts that help
/// out with other scripts often have lines much higher than their letters.
struct Lines {
    QStringList texts;
    double width = 0, ink = 0, spacing = 0;

    explicit Lines(const TextBox& box) {
        const QFontMetricsF metrics(box.font);
        for (const QString& paragraph : box.text.split(u'\n')) {
            const double advance = metrics.horizontalAdvance(paragraph);
            if (box.wraps && advance > box.rect.width() + 0.5) {
                wrap(box, paragraph);
            } else {
                texts += paragraph;
                width = std::max(width, advance);
            }
        }
        for (const QString& line : texts)
            if (!line.isEmpty()) ink = std::max(ink, metrics.tightBoundingRect(line).height());
        spacing = std::max(metrics.lineSpacing(), ink);
    }
    /// Only the lines that have room; the last one says that more would follow.
    void keep(const TextBox& box) {
        const qsizetype room = spacing > 0 ? static_cast<qsizetype>((box.rect.height() + 1 - ink) / spacing) + 1 : 1;
        if (texts.size() <= std::max<qsizetype>(1, room)) return;
        texts.resize(std::max<qsizetype>(1, room));
        texts.back() += QChar(0x2026);
    }
    double height() const { return ink + static_cast<double>(texts.size() - 1) * spacing; }

private:
    void wrap(const TextBox& box, const QString& paragraph) {
        QTextLayout layout(paragraph, box.font);
        QTextOption option;
        option.setWrapMode(QTextOption::WordWrap);
        option.setTextDirection(box.rightToLeft ? Qt::RightToLeft : Qt::LeftToRight);
        layout.setTextOption(option);
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(std::max(1.0, box.rect.width() + 0.5));
            texts += paragraph.mid(line.textStart(), line.textLength()).trimmed();
            width = std::max(width, line.naturalTextWidth());
        }
        layout.endLayout();
    }
};

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
    double x = box.rect.left();
    if (box.align == TextAlign::Center)
        x += (box.rect.width() - width) / 2;
    else if (isAtRight(box))
        x = box.rect.right() - width;
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
    if (GlyphSink* sink = GlyphSink::of(painter))
        sink->addGlyphs(painter, run, {});
    else
        painter.drawGlyphRun({}, run);
    return true;
}

} // namespace

void addLine(GlyphSink& sink, const QPainter& painter, const QString& line, const QFont& font, QPointF at,
             bool rightToLeft) {
    QTextLayout layout(line, font);
    QTextOption option(Qt::AlignLeft | Qt::AlignAbsolute);
    option.setTextDirection(rightToLeft ? Qt::RightToLeft : Qt::LeftToRight);
    option.setWrapMode(QTextOption::NoWrap);
    layout.setTextOption(option);
    layout.beginLayout();
    QTextLine shaped = layout.createLine();
    if (shaped.isValid()) shaped.setLineWidth(shaped.naturalTextWidth());
    layout.endLayout();
    if (!shaped.isValid()) return;
    shaped.setPosition({});
    for (const QGlyphRun& run : layout.glyphRuns()) sink.addGlyphs(painter, run, at - QPointF(0, shaped.ascent()));
}

TextAlign textAlign(const QString& name) {
    if (name == QStringLiteral("center")) return TextAlign::Center;
    return name == QStringLiteral("end") ? TextAlign::End : TextAlign::Start;
}

QSizeF neededSize(const TextBox& box) {
    if (box.text.isEmpty()) return {};
    const Lines lines(box);
    return {lines.width, lines.height()};
}

bool fits(const TextBox& box) {
    if (box.text.isEmpty()) return true;
    const QSizeF needed = neededSize(box);
    return needed.width() <= box.rect.width() + 0.5 && needed.height() <= box.rect.height() + 1;
}

void drawText(QPainter& painter, const TextBox& box) {
    if (box.text.isEmpty() || box.rect.width() < 1) return;
    GlyphSink* const sink = GlyphSink::of(painter);
    if (sink) sink->addWords(box.text);
    if (isPlain(box.text) && drawPlain(painter, box)) return;
    painter.setFont(box.font);
    painter.setLayoutDirection(box.rightToLeft ? Qt::RightToLeft : Qt::LeftToRight);
    const QFontMetricsF metrics(box.font);
    Lines lines(box);
    lines.keep(box);
    const double below = static_cast<double>(lines.texts.size() - 1) * lines.spacing;
    double y = box.rect.center().y() + (metrics.ascent() - metrics.descent() - below) / 2;
    if (box.vertical & Qt::AlignTop) y = box.rect.top() + metrics.ascent();
    if (box.vertical & Qt::AlignBottom) y = box.rect.bottom() - metrics.descent() - below;
    for (const QString& line : lines.texts) {
        QString text = line;
        double width = metrics.horizontalAdvance(text);
        if (width > box.rect.width() + 0.5) {
            text = metrics.elidedText(text, Qt::ElideRight, box.rect.width());
            width = metrics.horizontalAdvance(text);
        }
        double x = box.rect.left();
        if (box.align == TextAlign::Center)
            x += (box.rect.width() - width) / 2;
        else if (isAtRight(box))
            x = box.rect.right() - width;
        if (sink)
            addLine(*sink, painter, text, box.font, {x, y}, box.rightToLeft);
        else
            painter.drawText(QPointF(x, y), text);
        y += lines.spacing;
    }
}

} // namespace plc::hmi
