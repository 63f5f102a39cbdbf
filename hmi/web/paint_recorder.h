// A paint device that writes down what is painted as drawing commands for a browser's canvas. One piece per element;
// two recordings of an element differ in the commands that changed. Owned by a PanelStream; main thread.
#pragma once
#include "hmi/view/paint/glyph_sink.h"
#include "hmi/web/paint_bytes.h"
#include "hmi/web/paint_store.h"
#include "hmi/web/shared_views.h"

#include <QPaintDevice>
#include <QPaintEngine>

#include <memory>

namespace plc::hmi::web {

class PaintRecorder final : public QPaintDevice, public GlyphSink {
public:
    PaintRecorder(PaintStore& store, QSize size, int sharpness = 1);
    ~PaintRecorder() override;

    QPaintEngine* paintEngine() const override;
    void addGlyphs(const QPainter& painter, const QGlyphRun& run, QPointF at) override;
    void addWords(const QString& words) override;
    /// What was painted since the last call.
    Recording take();
    void setSize(QSize size) { m_size = size; }
    /// Pixels of symbols per pixel of the panel: browsers that show it enlarged get sharper ones.
    void setSharpness(int sharpness) { m_sharpness = sharpness; }

protected:
    int metric(PaintDeviceMetric metric) const override;

private:
    class Engine;
    PaintStore& m_store;
    QSize m_size;
    int m_sharpness;
    Recording m_recording;
    std::unique_ptr<Engine> m_engine;
};

} // namespace plc::hmi::web
