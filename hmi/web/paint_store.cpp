#include "hmi/web/paint_store.h"

#include "hmi/web/paint_bytes.h"

#include <QBuffer>
#include <QCryptographicHash>

namespace plc::hmi::web {

PaintStore::FontGlyphs& PaintStore::of(const QRawFont& font) {
    if (m_lastFont < m_fonts.size() && m_fonts[m_lastFont].font == font) return m_fonts[m_lastFont];
    for (m_lastFont = 0; m_lastFont < m_fonts.size(); ++m_lastFont)
        if (m_fonts[m_lastFont].font == font) return m_fonts[m_lastFont];
    m_fonts.push_back({font, {}});
    return m_fonts.back();
}

uint32_t PaintStore::glyph(const QRawFont& font, quint32 index) {
    FontGlyphs& known = of(font);
    if (const auto found = known.ids.constFind(index); found != known.ids.constEnd()) return *found;
    QPainterPath outline = font.pathForGlyph(index);
    outline.setFillRule(Qt::WindingFill);
    PaintBytes out;
    out.path(outline);
    const auto id = static_cast<uint32_t>(m_glyphs.size());
    m_bytes += static_cast<size_t>(out.bytes().size());
    m_glyphs.push_back(out.bytes());
    known.ids.insert(index, id);
    return id;
}

uint32_t PaintStore::picture(const QPixmap& pixmap) {
    if (const auto found = m_pictureIds.constFind(pixmap.cacheKey()); found != m_pictureIds.constEnd()) return *found;
    return picture(pixmap.toImage(), pixmap.cacheKey());
}

uint32_t PaintStore::picture(const QImage& image, qint64 cacheKey) {
    if (const auto found = m_pictureIds.constFind(cacheKey); found != m_pictureIds.constEnd()) return *found;
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG", 60);
    const QByteArray print = QCryptographicHash::hash(png, QCryptographicHash::Sha256);
    const auto next = static_cast<uint32_t>(m_pictures.size());
    const uint32_t id = m_pictureSame.value(print, next);
    if (id == next) {
        m_bytes += static_cast<size_t>(png.size());
        m_pictures.push_back(png);
        m_pictureSame.insert(print, id);
    }
    m_pictureIds.insert(cacheKey, id);
    return id;
}

bool PaintStore::trim(size_t limit) {
    if (m_bytes <= limit && m_pictureIds.size() < 100'000) return false;
    m_fonts.clear();
    m_glyphs.clear();
    m_pictures.clear();
    m_pictureIds.clear();
    m_pictureSame.clear();
    m_views.clear(); // they name letters by their numbers
    m_bytes = 0;
    ++m_edition;
    return true;
}

} // namespace plc::hmi::web
