#include "hmi/model/layout.h"

#include <QHash>

#include <cmath>
#include <functional>

namespace plc::hmi {

namespace {

/// Where the stretch from `begin` to `end` goes when its surroundings grow from `was` to `now`.
struct Span {
    double begin = 0, length = 0;
};

Span placed(Span own, const QString& anchor, Span was, Span now) {
    const double before = own.begin - was.begin, more = now.length - was.length;
    if (anchor == QStringLiteral("right") || anchor == QStringLiteral("bottom"))
        return {now.begin + before + more, own.length};
    if (anchor == QStringLiteral("both")) return {now.begin + before, std::max(1.0, own.length + more)};
    if (anchor == QStringLiteral("center")) return {now.begin + before + more / 2, own.length};
    return {now.begin + before, own.length};
}

QRectF placed(const Element& element, const QRectF& was, const QRectF& now) {
    const QRectF rect = element.rect();
    const Span x = placed({rect.x(), rect.width()}, element.text("anchorX"), {was.x(), was.width()},
                          {now.x(), now.width()}),
               y = placed({rect.y(), rect.height()}, element.text("anchorY"), {was.y(), was.height()},
                          {now.y(), now.height()});
    return {x.begin, y.begin, x.length, y.length};
}

} // namespace

bool isAdapting(const Panel& panel) { return panel.text("adapts") == QStringLiteral("anchors"); }

QSizeF sizeFor(const Panel& panel, QSizeF screen) {
    const QSizeF own = panel.size();
    if (!isAdapting(panel) || screen.width() < 1 || screen.height() < 1) return own;
    const double scale = std::min(screen.width() / own.width(), screen.height() / own.height());
    return {std::max(own.width(), std::floor(screen.width() / scale)),
            std::max(own.height(), std::floor(screen.height() / scale))};
}

Panel laidOut(const Panel& panel, QSizeF size) {
    const QRectF was(QPointF(), panel.size()), now(QPointF(), size);
    if (was == now) return panel;
    Panel out = panel;
    out.set("size", Json::array({static_cast<int>(size.width()), static_cast<int>(size.height())}));
    QHash<ElementId, const Element*> before;
    for (const Element& element : panel.elements()) before.insert(element.id(), &element);
    QHash<ElementId, QRectF> done;
    // Outer ones first, however they are ordered; a circle of groups ends at the guard.
    const std::function<QRectF(const Element&, int)> placeOf = [&](const Element& element, int depth) -> QRectF {
        if (const auto known = done.constFind(element.id()); known != done.constEnd()) return *known;
        const Element* outer = before.value(element.parent());
        QRectF rect = outer && outer != &element && depth < 32
                          ? placed(element, outer->rect(), placeOf(*outer, depth + 1))
                          : placed(element, was, now);
        done.insert(element.id(), rect);
        return rect;
    };
    for (Element& element : out.elements()) element.set("rect", rectToJson(placeOf(*before.value(element.id()), 0)));
    return out;
}

} // namespace plc::hmi
