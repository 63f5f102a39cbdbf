// Letters and pictures that drawing commands name by number, each once for all browsers: outlines of glyphs, PNG of
// pixmaps. Owned by the server of panels; main thread.
#pragma once
#include "hmi/web/shared_views.h"

#include <QByteArray>
#include <QGlyphRun>
#include <QHash>
#include <QPixmap>
#include <QRawFont>

#include <vector>

namespace plc::hmi::web {

class PaintStore {
public:
    /// Number of a glyph's outline, in the font's own pixels.
    uint32_t glyph(const QRawFont& font, quint32 index);
    uint32_t picture(const QPixmap& pixmap);
    uint32_t picture(const QImage& image, qint64 cacheKey);

    const QByteArray& glyphPath(uint32_t id) const { return m_glyphs[id]; }
    const QByteArray& picturePng(uint32_t id) const { return m_pictures[id]; }
    size_t glyphCount() const { return m_glyphs.size(); }
    size_t pictureCount() const { return m_pictures.size(); }
    size_t bytes() const { return m_bytes; }
    /// Forgets everything when there is too much of it; browsers must then be given all again.
    bool trim(size_t limit);
    SharedViews& views() { return m_views; }
    /// Changes when everything was forgotten.
    uint32_t edition() const { return m_edition; }

private:
    struct FontGlyphs {
        QRawFont font;
        QHash<quint32, uint32_t> ids;
    };
    FontGlyphs& of(const QRawFont& font);
    std::vector<FontGlyphs> m_fonts;
    size_t m_lastFont = 0;
    std::vector<QByteArray> m_glyphs, m_pictures;
    QHash<qint64, uint32_t> m_pictureIds;      // by cache key
    QHash<QByteArray, uint32_t> m_pictureSame; // by what is in it
    SharedViews m_views;
    size_t m_bytes = 0;
    uint32_t m_edition = 0;
};

} // namespace plc::hmi::web
