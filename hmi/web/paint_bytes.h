// Writes the numbers of the drawing commands that a browser gets: small ones take one byte, lengths are in 1/64 pixel.
// client/reader.js reads them. A value, any thread.
#pragma once
#include <QByteArray>
#include <QColor>
#include <QPainterPath>
#include <QPointF>
#include <QRectF>

#include <cmath>
#include <cstring>

namespace plc::hmi::web {

class PaintBytes {
public:
    QByteArray& bytes() { return m_bytes; }
    const QByteArray& bytes() const { return m_bytes; }
    void byte(uint8_t value) { m_bytes.append(static_cast<char>(value)); }
    void count(uint64_t value) {
        for (; value >= 0x80; value >>= 7) byte(static_cast<uint8_t>(value | 0x80));
        byte(static_cast<uint8_t>(value));
    }
    void length(double value) { whole(std::llround(std::isfinite(value) ? std::clamp(value, -1e7, 1e7) * 64 : 0)); }
    void real(double value) {
        const auto narrow = static_cast<float>(value);
        char raw[4];
        std::memcpy(raw, &narrow, 4);
        m_bytes.append(raw, 4);
    }
    void point(QPointF at) {
        length(at.x());
        length(at.y());
    }
    void rect(const QRectF& rect) {
        point(rect.topLeft());
        length(rect.width());
        length(rect.height());
    }
    void color(const QColor& color) {
        const QRgb rgba = color.rgba();
        for (const int part : {qRed(rgba), qGreen(rgba), qBlue(rgba), qAlpha(rgba)}) byte(static_cast<uint8_t>(part));
    }
    void blob(QByteArrayView bytes) {
        count(static_cast<uint64_t>(bytes.size()));
        m_bytes.append(bytes);
    }
    /// Each point as the way from the one before.
    void path(const QPainterPath& path);

private:
    void whole(int64_t value) { count((static_cast<uint64_t>(value) << 1) ^ static_cast<uint64_t>(value >> 63)); }
    QByteArray m_bytes;
};

} // namespace plc::hmi::web
