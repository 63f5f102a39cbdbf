#include "hmi/view/paint/symbol_art.h"

#include "hmi/model/descriptor.h"

#include <QCache>
#include <QFile>
#include <QHash>
#include <QPainter>
#include <QSvgRenderer>

// Outside the namespace, as the macro asks: a static library's resources are registered by hand.
static void registerSymbols() { Q_INIT_RESOURCE(hmi_symbols); }

namespace plc::hmi {

namespace {

QByteArray artOf(const QString& symbol) {
    [[maybe_unused]] static const bool registered = (registerSymbols(), true);
    static QHash<QString, QByteArray> known;
    auto found = known.find(symbol);
    if (found == known.end()) {
        QFile file(QStringLiteral(":/hmi/symbols/%1.svg").arg(symbol));
        found = known.insert(symbol, file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray());
    }
    return *found;
}

QByteArray filled(const SymbolLook& look) {
    QByteArray svg = artOf(look.symbol);
    const auto put = [&](const char* place, const QByteArray& text) { svg.replace(place, text); };
    put("@body@", look.body.name().toLatin1());
    put("@shade@", look.body.darker(118).name().toLatin1());
    put("@light@", look.body.lighter(112).name().toLatin1());
    put("@line@", look.line.name().toLatin1());
    put("@accent@", look.accent.name().toLatin1());
    put("@ground@", look.ground.name().toLatin1());
    // The sight glass of a vessel is 56 high; the level rises from y = 78.
    const double levelHeight = look.level * 0.56;
    put("@levelY@", QByteArray::number(78 - levelHeight));
    put("@levelH@", QByteArray::number(levelHeight));
    put("@angle@", QByteArray::number(look.frame * 360.0 / kSymbolFrames));
    put("@swing@", QByteArray::number(look.frame < kSymbolFrames / 2 ? look.frame * 5 - 15
                                                                     : (kSymbolFrames - look.frame) * 5 - 15));
    put("@shift@", QByteArray::number(look.frame));
    return svg;
}

} // namespace

QStringList symbolNames() {
    QStringList out;
    for (const std::string_view name : descriptorOf(ElementKind::Symbol).property("symbol")->choices())
        out += QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    return out;
}

bool isMoving(const QString& symbol) {
    const QByteArray art = artOf(symbol);
    return art.contains("@angle@") || art.contains("@shift@") || art.contains("@swing@");
}

bool hasLevel(const QString& symbol) { return artOf(symbol).contains("@levelY@"); }

QPixmap symbolPixmap(const SymbolLook& look, QSize size) {
    static QCache<QString, QPixmap> kept(64 << 20); // bytes
    if (size.isEmpty()) return {};
    size = size.boundedTo(QSize(4096, 4096)); // the painter enlarges it
    const QString key =
        QStringLiteral("%1|%2|%3|%4|%5|%6|%7|%8|%9")
            .arg(look.symbol, look.body.name(), look.line.name(), look.accent.name(), look.ground.name())
            .arg(look.level)
            .arg(look.frame)
            .arg(look.quarter)
            .arg(size.width() * 100000 + size.height());
    if (const QPixmap* found = kept.object(key)) return *found;
    QSvgRenderer renderer(filled(look));
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const double side = std::min(size.width(), size.height());
    painter.translate(size.width() / 2.0, size.height() / 2.0);
    if (look.quarter == 2) painter.scale(-1, 1);
    if (look.quarter == 1) painter.rotate(90);
    if (look.quarter == 3) painter.rotate(-90);
    renderer.render(&painter, QRectF(-side / 2, -side / 2, side, side));
    painter.end();
    kept.insert(key, new QPixmap(pixmap), size.width() * size.height() * 4);
    return pixmap;
}

} // namespace plc::hmi
