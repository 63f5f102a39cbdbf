#include "hmi/model/layout.h"

#include "hmi/model/cells.h"
#include "hmi/model/property_literals.h"

#include <QHash>

#include <algorithm>
#include <cmath>

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
    const Span x = placed({rect.x(), rect.width()}, element.text("anchorX"_text), {was.x(), was.width()},
                          {now.x(), now.width()}),
               y = placed({rect.y(), rect.height()}, element.text("anchorY"_text), {was.y(), was.height()},
                          {now.y(), now.height()});
    return {x.begin, y.begin, x.length, y.length};
}

} // namespace

bool isAdapting(const Panel& panel) { return panel.text("adapts"_text) == QStringLiteral("anchors"); }

QSizeF sizeFor(const Panel& panel, QSizeF screen) {
    const QSizeF own = panel.size();
    if (!isAdapting(panel) || screen.width() < 1 || screen.height() < 1) return own;
    const double scale = std::min(screen.width() / own.width(), screen.height() / own.height());
    return {std::max(own.width(), std::floor(screen.width() / scale)),
            std::max(own.height(), std::floor(screen.height() / scale))};
}

namespace {

/// Places elements outer ones first, however they are ordered; a circle of groups ends at the guard.
class Placing {
public:
    Placing(const Panel& panel, QSizeF size) : m_was(QPointF(), panel.size()), m_now(QPointF(), size) {
        for (const Element& element : panel.elements()) m_before.insert(element.id(), &element);
        for (const Element& element : panel.elements())
            if (const Element* outer = outerOf(element); outer && hasCells(*outer))
                m_inCells[outer->id()].push_back(&element);
    }

    QRectF of(const Element& element, int depth = 0) {
        if (const auto known = m_done.constFind(element.id()); known != m_done.constEnd()) return *known;
        const Element* outer = depth < 32 ? outerOf(element) : nullptr;
        if (!outer) return m_done[element.id()] = placed(element, m_was, m_now);
        const QRectF around = of(*outer, depth + 1);
        if (!hasCells(*outer)) return m_done[element.id()] = placed(element, outer->rect(), around);
        const std::vector<const Element*>& contents = m_inCells[outer->id()];
        const std::vector<QRectF> cells = cellsOf(*outer, around, contents);
        for (size_t i = 0; i < cells.size(); ++i) m_done[contents[i]->id()] = cells[i];
        return m_done[element.id()];
    }

private:
    const Element* outerOf(const Element& element) const {
        const Element* outer = m_before.value(element.parent());
        return outer && outer->id() != element.id() ? outer : nullptr;
    }

    QRectF m_was, m_now;
    QHash<ElementId, const Element*> m_before;
    QHash<ElementId, std::vector<const Element*>> m_inCells;
    QHash<ElementId, QRectF> m_done;
};

} // namespace

Panel laidOut(const Panel& panel, QSizeF size) {
    const bool isOther = QSizeF(panel.size()) != size;
    if (!isOther && std::none_of(panel.elements().begin(), panel.elements().end(), hasCells)) return panel;
    Panel out = panel;
    if (isOther) out.set("size"_field, Json::array({static_cast<int>(size.width()), static_cast<int>(size.height())}));
    Placing placing(panel, size);
    for (size_t i = 0; i < panel.elements().size(); ++i) {
        const QRectF rect = placing.of(panel.elements()[i]);
        if (rect != panel.elements()[i].rect()) out.elements()[i].set("rect"_field, rectToJson(rect));
    }
    return out;
}

} // namespace plc::hmi
