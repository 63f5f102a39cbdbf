#include "hmi/view/paint/svg_limits.h"

#include <QHash>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <cmath>

namespace plc::hmi {

namespace {

const QRegularExpression& numbers() {
    static const QRegularExpression pattern(QStringLiteral("[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?"));
    return pattern;
}

/// Shapes in the order of the file; each knows what it lies in and what it repeats.
struct Shape {
    int parent = -1;
    QString repeats;     // id
    int64_t drawn = 0;   // with all that lies in it
    bool isOpen = false; // on the way from the picture's root to here
};

class SvgReader {
public:
    explicit SvgReader(const QByteArray& svg) : m_svg(svg) {}

    Message complaint(const QString& name) {
        const std::string called = toUtf8(name);
        if (!read()) return m_loaded.isEmpty() ? errors::NotAPicture(called) : loads(called);
        if (m_isTooDeep) return errors::PictureTooDeep(called, kDeepestShapes);
        if (m_shapes.size() > static_cast<size_t>(kMostShapes))
            return errors::PictureTooManyShapes(called, kMostShapes);
        if (hasTooManyDashes()) return errors::PictureDashesTooShort(called, kMostDashes);
        const int64_t all = drawnBy(0, 0);
        if (m_isTooDeep) return errors::PictureTooDeep(called, kDeepestShapes);
        return all > kMostShapes ? errors::PictureTooManyShapes(called, kMostShapes) : Message();
    }

private:
    Message loads(const std::string& called) const { return errors::PictureLoadsFile(called, toUtf8(m_loaded)); }

    bool read() {
        QXmlStreamReader xml(m_svg);
        std::vector<int> path;
        while (!xml.atEnd() && m_shapes.size() <= static_cast<size_t>(kMostShapes) && !m_isTooDeep) {
            const QXmlStreamReader::TokenType token = xml.readNext();
            if (token == QXmlStreamReader::EndElement && !path.empty()) path.pop_back();
            if (token != QXmlStreamReader::StartElement) continue;
            m_isTooDeep = path.size() >= static_cast<size_t>(kDeepestShapes);
            const int own = static_cast<int>(m_shapes.size());
            m_shapes.push_back({path.empty() ? -1 : path.back(), {}, 0, false});
            m_inside.push_back({});
            if (!path.empty()) m_inside[static_cast<size_t>(path.back())].push_back(own);
            path.push_back(own);
            if (!take(xml, own)) return false;
        }
        return !m_shapes.empty() &&
               (!xml.hasError() || m_isTooDeep || m_shapes.size() > static_cast<size_t>(kMostShapes));
    }

    bool take(const QXmlStreamReader& xml, int own) {
        if (own == 0 && xml.name() != QStringLiteral("svg")) return false;
        for (const QXmlStreamAttribute& attribute : xml.attributes()) {
            const QString value = attribute.value().toString();
            if (attribute.name() == QStringLiteral("id")) m_byId.insert(value, own);
            if (attribute.name() == QStringLiteral("href")) {
                if (xml.name() == QStringLiteral("image") && !isEmbedded(value)) {
                    m_loaded = value.left(60);
                    return false;
                }
                if (value.startsWith(u'#')) m_shapes[static_cast<size_t>(own)].repeats = value.mid(1);
                continue;
            }
            for (auto it = numbers().globalMatch(value); it.hasNext();)
                m_furthest = std::max(m_furthest, std::abs(it.next().captured().toDouble()));
        }
        return true;
    }

    /// A picture in the picture, and none that is itself drawn from shapes.
    static bool isEmbedded(const QString& reference) {
        if (!reference.startsWith(QStringLiteral("data:"))) return false;
        const QByteArray bytes = QByteArray::fromBase64(reference.mid(reference.indexOf(u',') + 1).left(64).toLatin1());
        return bytes.startsWith("\x89PNG") || bytes.startsWith("\xFF\xD8");
    }

    bool hasTooManyDashes() const {
        static const QRegularExpression dashes(QStringLiteral("stroke-dasharray\\s*[:=]\\s*[\"']?([^\"';}]*)"));
        for (auto it = dashes.globalMatch(QString::fromUtf8(m_svg)); it.hasNext();) {
            double sum = 0;
            const QString lengths = it.next().captured(1);
            bool any = false;
            for (auto each = numbers().globalMatch(lengths); each.hasNext(); any = true)
                sum += std::abs(each.next().captured().toDouble());
            if (any && !(m_furthest <= sum * kMostDashes)) return true;
        }
        return false;
    }

    int64_t drawnBy(int which, int depth) {
        Shape& shape = m_shapes[static_cast<size_t>(which)];
        if (shape.drawn > 0) return shape.drawn;
        if (shape.isOpen || depth > 2 * kDeepestShapes) {
            m_isTooDeep = true;
            return 0;
        }
        shape.isOpen = true;
        int64_t sum = 1;
        for (const int inner : m_inside[static_cast<size_t>(which)]) sum += m_isTooDeep ? 0 : drawnBy(inner, depth + 1);
        if (const auto target = m_byId.constFind(shape.repeats); target != m_byId.constEnd() && !m_isTooDeep)
            sum += drawnBy(*target, depth + 1);
        shape.isOpen = false;
        return shape.drawn = std::min<int64_t>(sum, int64_t(kMostShapes) + 1);
    }

    const QByteArray& m_svg;
    std::vector<Shape> m_shapes;
    std::vector<std::vector<int>> m_inside;
    QHash<QString, int> m_byId;
    QString m_loaded;
    double m_furthest = 1;
    bool m_isTooDeep = false;
};

} // namespace

Message svgComplaint(const QByteArray& svg, const QString& name) { return SvgReader(svg).complaint(name); }

} // namespace plc::hmi
