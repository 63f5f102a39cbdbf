#include "hmi/web/paint_recorder.h"

#include <QPainter>
#include <QTextOption>

#include <array>
#include <optional>

namespace plc::hmi::web {

namespace {

/// The commands, as client/commands.js knows them.
enum Command : uint8_t {
    SetShift = 1,
    SetTransform,
    SetPen,
    SetBrush,
    SetOpacity,
    SetClip,
    SetCrisp,
    Rect,
    Ellipse,
    Path,
    Polygon,
    Polyline,
    Line,
    DrawPicture,
    Glyphs,
};

enum PaintKind : uint8_t { NoPaint, Solid, Linear, Radial, Conical };

QColor middleOf(const QBrush& brush) {
    if (const QGradient* gradient = brush.gradient(); gradient && !gradient->stops().isEmpty())
        return gradient->stops().at(gradient->stops().size() / 2).second;
    QColor color = brush.color();
    // Patterns are as dark as they are dense.
    if (brush.style() >= Qt::Dense1Pattern && brush.style() <= Qt::Dense7Pattern)
        color.setAlphaF(color.alphaF() * (1.0f - 0.12f * static_cast<float>(brush.style() - Qt::Dense1Pattern)));
    return color;
}

void writeStops(PaintBytes& out, const QGradient& gradient) {
    const QGradientStops stops = gradient.stops();
    out.count(static_cast<uint64_t>(stops.size()));
    for (const auto& [at, color] : stops) {
        out.real(at);
        out.color(color);
    }
}

void writePaint(PaintBytes& out, const QBrush& brush) {
    const QGradient* gradient = brush.gradient();
    if (gradient && gradient->coordinateMode() == QGradient::LogicalMode) {
        const QTransform map = brush.transform();
        const double scale = std::hypot(map.m11(), map.m12());
        if (gradient->type() == QGradient::LinearGradient) {
            const auto* linear = static_cast<const QLinearGradient*>(gradient);
            out.byte(Linear);
            out.point(map.map(linear->start()));
            out.point(map.map(linear->finalStop()));
            return writeStops(out, *gradient);
        }
        if (gradient->type() == QGradient::RadialGradient) {
            const auto* radial = static_cast<const QRadialGradient*>(gradient);
            out.byte(Radial);
            out.point(map.map(radial->center()));
            out.length(radial->radius() * scale);
            out.point(map.map(radial->focalPoint()));
            return writeStops(out, *gradient);
        }
        if (gradient->type() == QGradient::ConicalGradient) {
            const auto* conical = static_cast<const QConicalGradient*>(gradient);
            out.byte(Conical);
            out.point(map.map(conical->center()));
            out.real(conical->angle());
            return writeStops(out, *gradient);
        }
    }
    const QColor color = middleOf(brush);
    if (brush.style() == Qt::NoBrush || color.alpha() == 0) return out.byte(NoPaint);
    out.byte(Solid);
    out.color(color);
}

void writePen(PaintBytes& out, const QPen& pen) {
    if (pen.style() == Qt::NoPen) return out.byte(NoPaint);
    writePaint(out, pen.brush());
    const bool isCosmetic = pen.isCosmetic() || pen.widthF() == 0;
    const int cap = pen.capStyle() == Qt::FlatCap ? 0 : pen.capStyle() == Qt::SquareCap ? 1 : 2;
    const int join = pen.joinStyle() == Qt::BevelJoin ? 1 : pen.joinStyle() == Qt::RoundJoin ? 2 : 0;
    out.byte(static_cast<uint8_t>(cap | join << 2 | (isCosmetic ? 16 : 0)));
    const double width = pen.widthF() == 0 ? 1 : pen.widthF();
    out.length(width);
    if (join == 0) out.length(pen.miterLimit());
    const QList<qreal> dashes = pen.style() == Qt::SolidLine ? QList<qreal>() : pen.dashPattern();
    out.count(static_cast<uint64_t>(dashes.size()));
    for (const qreal dash : dashes) out.length(dash * width);
    if (!dashes.isEmpty()) out.length(pen.dashOffset() * width);
}

} // namespace

class PaintRecorder::Engine final : public QPaintEngine {
public:
    explicit Engine(PaintRecorder& owner) : QPaintEngine(AllFeatures), m_owner(owner) {
        constexpr qsizetype kRoom = 256; // kept while it is emptied and filled
        m_scratch.bytes().reserve(kRoom);
        for (QByteArray& one : m_written) one.reserve(kRoom);
    }
    Type type() const override { return User; }

    bool begin(QPaintDevice*) override {
        forget();
        return true;
    }
    bool end() override { return true; }
    void updateState(const QPaintEngineState& state) override {
        const DirtyFlags flags = state.state();
        if (flags & (DirtyClipPath | DirtyClipRegion | DirtyClipEnabled | DirtyTransform)) m_clipIsKnown = false;
    }

    void drawRects(const QRectF* rects, int count) override {
        for (int i = 0; i < count; ++i) command(Rect, true, true, [&](PaintBytes& out) { out.rect(rects[i]); });
    }
    void drawEllipse(const QRectF& rect) override {
        command(Ellipse, true, true, [&](PaintBytes& out) { out.rect(rect); });
    }
    void drawPath(const QPainterPath& path) override {
        command(Path, true, true, [&](PaintBytes& out) { out.path(path); });
    }
    void drawLines(const QLineF* lines, int count) override {
        for (int i = 0; i < count; ++i)
            command(Line, true, false, [&](PaintBytes& out) {
                out.point(lines[i].p1());
                out.point(lines[i].p2() - lines[i].p1());
            });
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        const bool isOpen = mode == PolylineMode;
        command(isOpen ? Polyline : Polygon, true, !isOpen, [&](PaintBytes& out) {
            if (!isOpen) out.byte(mode == WindingMode ? 1 : 0);
            out.count(static_cast<uint64_t>(count));
            QPointF before;
            for (int i = 0; i < count; ++i) {
                const QPointF at(std::round(points[i].x() * 64) / 64, std::round(points[i].y() * 64) / 64);
                out.point(at - before);
                before = at;
            }
        });
    }
    void drawPoints(const QPointF* points, int count) override {
        for (int i = 0; i < count; ++i) {
            const QLineF dot(points[i], points[i] + QPointF(0.01, 0));
            drawLines(&dot, 1);
        }
    }
    void drawPixmap(const QRectF& target, const QPixmap& pixmap, const QRectF& source) override {
        if (!pixmap.isNull()) drawPicture(target, m_owner.m_store.picture(pixmap), source);
    }
    void drawImage(const QRectF& target, const QImage& image, const QRectF& source, Qt::ImageConversionFlags) override {
        if (!image.isNull()) drawPicture(target, m_owner.m_store.picture(image, image.cacheKey()), source);
    }
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        // Widgets draw texts this way; elements hand over glyph runs.
        if (item.text().isEmpty()) return QPaintEngine::drawTextItem(at, item);
        m_owner.addWords(item.text());
        addLine(m_owner, *painter(), item.text(), item.font(), at, item.renderFlags() & QTextItem::RightToLeft);
    }
    void glyphs(const QGlyphRun& run, QPointF at) {
        const QList<quint32> indexes = run.glyphIndexes();
        const QList<QPointF> places = run.positions();
        if (indexes.isEmpty() || indexes.size() != places.size()) return;
        command(Glyphs, true, false, [&](PaintBytes& out) {
            out.count(static_cast<uint64_t>(indexes.size()));
            QPointF before;
            for (qsizetype i = 0; i < indexes.size(); ++i) {
                out.count(m_owner.m_store.glyph(run.rawFont(), indexes[i]));
                const QPointF exact = places[i] + at;
                const QPointF here(std::round(exact.x() * 64) / 64, std::round(exact.y() * 64) / 64);
                out.point(here - before);
                before = here;
            }
        });
    }

private:
    void drawPicture(const QRectF& target, uint32_t id, const QRectF& source) {
        command(DrawPicture, false, false, [&](PaintBytes& out) {
            out.count(id);
            out.rect(target);
            out.rect(source);
        });
    }
    // Written in place: a panel of 1,000 elements is 10,000 commands a frame.
    template <class Write> void command(Command kind, bool usesPen, bool usesBrush, const Write& write) {
        state(usesPen, usesBrush);
        m_scratch.bytes().resize(0);
        m_scratch.byte(kind);
        write(m_scratch);
        add(m_scratch.bytes());
    }
    void add(const QByteArray& bytes) {
        Recording& to = m_owner.m_recording;
        to.bytes.append(bytes);
        to.ends.push_back(static_cast<uint32_t>(to.bytes.size()));
    }
    /// A state is written only when a drawing command needs another one than the last that was written.
    template <class Write> void stateCommand(Command kind, const Write& write) {
        m_scratch.bytes().resize(0);
        m_scratch.byte(kind);
        write(m_scratch);
        QByteArray& known = m_written[kind == SetShift ? SetTransform : kind];
        if (known == m_scratch.bytes()) return;
        known.resize(0);
        known.append(m_scratch.bytes());
        add(known);
    }
    /// The same for values that are cheaper to compare than to write.
    template <class T, class Write>
    void stateOf(std::optional<T>& last, const T& now, Command kind, const Write& write) {
        if (last && *last == now) return;
        last = now;
        stateCommand(kind, [&](PaintBytes& out) { write(out, now); });
    }
    void state(bool usesPen, bool usesBrush) {
        const QPainter& by = *painter();
        clip();
        transform();
        if (usesPen) stateOf(m_pen, by.pen(), SetPen, writePen);
        if (usesBrush) stateOf(m_brush, by.brush(), SetBrush, writePaint);
        stateOf(m_opacity, by.opacity(), SetOpacity,
                [](PaintBytes& out, double opacity) { out.byte(static_cast<uint8_t>(std::lround(opacity * 255))); });
        stateOf(m_isSmooth, by.testRenderHint(QPainter::Antialiasing), SetCrisp,
                [](PaintBytes& out, bool isSmooth) { out.byte(isSmooth ? 0 : 1); });
    }
    QTransform deviceTransform() const {
        const double down = 1.0 / m_owner.m_sharpness;
        return painter()->deviceTransform() * QTransform::fromScale(down, down);
    }
    void transform() {
        const QTransform now = deviceTransform();
        if (m_transform && *m_transform == now) return;
        m_transform = now;
        if (now.type() <= QTransform::TxTranslate)
            return stateCommand(SetShift, [&](PaintBytes& out) { out.point({now.dx(), now.dy()}); });
        stateCommand(SetTransform, [&](PaintBytes& out) {
            for (const double part : {now.m11(), now.m12(), now.m21(), now.m22(), now.dx(), now.dy()}) out.real(part);
        });
    }
    void clip() {
        if (m_clipIsKnown && m_systemClip == systemClip()) return;
        m_clipIsKnown = true;
        m_systemClip = systemClip();
        QPainterPath path;
        bool isClipped = false;
        if (painter()->hasClipping()) {
            path = deviceTransform().map(painter()->clipPath());
            isClipped = true;
        }
        if (!m_systemClip.isEmpty()) {
            QPainterPath system;
            system.addRegion(m_systemClip);
            if (m_owner.m_sharpness != 1)
                system = QTransform::fromScale(1.0 / m_owner.m_sharpness, 1.0 / m_owner.m_sharpness).map(system);
            path = isClipped ? path.intersected(system) : system;
            isClipped = true;
        }
        if (!isClipped && m_written[SetClip].isEmpty()) return;
        stateCommand(SetClip, [&](PaintBytes& out) {
            out.byte(isClipped ? 1 : 0);
            if (isClipped) out.path(path);
        });
    }

    PaintRecorder& m_owner;
    PaintBytes m_scratch;
    std::array<QByteArray, 16> m_written; // state commands, by kind
    std::optional<QPen> m_pen;            // what the last of them was made of
    std::optional<QBrush> m_brush;
    std::optional<QTransform> m_transform;
    std::optional<double> m_opacity;
    std::optional<bool> m_isSmooth;
    bool m_clipIsKnown = false;
    QRegion m_systemClip;

public:
    /// The next command begins a piece that must make sense alone.
    void forget() {
        for (QByteArray& one : m_written) one.resize(0);
        m_pen.reset();
        m_brush.reset();
        m_transform.reset();
        m_opacity.reset();
        m_isSmooth.reset();
        m_clipIsKnown = false;
    }
};

PaintRecorder::PaintRecorder(PaintStore& store, QSize size, int sharpness)
    : m_store(store), m_size(size), m_sharpness(sharpness), m_engine(std::make_unique<Engine>(*this)) {}

PaintRecorder::~PaintRecorder() = default;

QPaintEngine* PaintRecorder::paintEngine() const { return m_engine.get(); }

void PaintRecorder::addGlyphs(const QPainter&, const QGlyphRun& run, QPointF at) { m_engine->glyphs(run, at); }

void PaintRecorder::addWords(const QString& words) {
    if (!m_recording.words.isEmpty()) m_recording.words += u' ';
    m_recording.words += words;
}

Recording PaintRecorder::take() {
    m_engine->forget();
    return std::exchange(m_recording, {});
}

int PaintRecorder::metric(PaintDeviceMetric metric) const {
    switch (metric) {
    case PdmWidth:
        return m_size.width() * m_sharpness;
    case PdmHeight:
        return m_size.height() * m_sharpness;
    case PdmWidthMM:
        return m_size.width() * 254 / 960;
    case PdmHeightMM:
        return m_size.height() * 254 / 960;
    case PdmNumColors:
        return 0x7fffffff;
    case PdmDepth:
        return 32;
    case PdmDpiX:
    case PdmDpiY:
    case PdmPhysicalDpiX:
    case PdmPhysicalDpiY:
        return 96;
    case PdmDevicePixelRatio:
        return m_sharpness;
    case PdmDevicePixelRatioScaled:
        return static_cast<int>(m_sharpness * devicePixelRatioFScale());
    default:
        return QPaintDevice::metric(metric);
    }
}

} // namespace plc::hmi::web
