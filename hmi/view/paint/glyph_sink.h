// A paint device that takes texts as glyph runs instead of pixels (the browser's): runs keep the widths that the check
// of sizes has proved. Asked for by drawText() of text_box.h; main thread.
#pragma once
#include <QGlyphRun>
#include <QPainter>
#include <QString>

namespace plc::hmi {

class GlyphSink {
public:
    virtual ~GlyphSink() = default;
    /// Drawn with the painter's pen; `at` is added to the run's positions.
    virtual void addGlyphs(const QPainter& painter, const QGlyphRun& run, QPointF at) = 0;
    /// What a person reads there, for screen readers.
    virtual void addWords(const QString& words) = 0;

    /// That of the painter's device; null: an ordinary device.
    static GlyphSink* of(const QPainter& painter) { return dynamic_cast<GlyphSink*>(painter.device()); }
};

/// Shapes one line as QPainter would; `at` is the left end of its base line.
void addLine(GlyphSink& sink, const QPainter& painter, const QString& line, const QFont& font, QPointF at,
             bool rightToLeft);

} // namespace plc::hmi
