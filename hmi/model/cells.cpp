#include "hmi/model/cells.h"

#include "hmi/model/layout.h"
#include "hmi/model/property_literals.h"

#include <algorithm>
#include <cmath>

namespace plc::hmi {

namespace {

enum class Flow { Row, Column, Grid };

Flow flowOf(const Element& group, const QRectF& rect) {
    const QString layout = group.text("layout"_text);
    if (layout == QStringLiteral("grid")) return Flow::Grid;
    if (layout == QStringLiteral("either")) return rect.width() >= rect.height() ? Flow::Row : Flow::Column;
    return layout == QStringLiteral("column") ? Flow::Column : Flow::Row;
}

/// What the frame and the title leave.
QRectF inner(const Element& group, const QRectF& rect) {
    const double padding = group.number("padding"_number);
    const double title = group.text("title"_text).isEmpty() ? 0 : group.number("fontSize"_number) * 1.9;
    const QRectF left = rect.adjusted(padding, padding + title, -padding, -padding);
    return {left.topLeft(), QSizeF(std::max(1.0, left.width()), std::max(1.0, left.height()))};
}

struct Stretch {
    double begin = 0, length = 0;
};

/// Whole pixels from edge to edge, so that lines stay sharp and nothing overlaps.
Stretch onPixels(double begin, double length) {
    const double from = std::round(begin);
    return {from, std::max(1.0, std::round(begin + length) - from)};
}

/// Those with a share divide what the others leave; what does not fit is made smaller, never pushed out.
std::vector<Stretch> alongLine(const std::vector<double>& lengths, const std::vector<double>& shares, double from,
                               double room, double gap) {
    double fixed = 0, sum = 0;
    for (size_t i = 0; i < lengths.size(); ++i) {
        sum += shares[i];
        if (shares[i] <= 0) fixed += lengths[i];
    }
    const double free = std::max(1.0, room - gap * static_cast<double>(lengths.size() - 1));
    const double shrink = fixed > free ? free / fixed : 1, rest = std::max(0.0, free - fixed);
    std::vector<Stretch> out;
    for (size_t i = 0; i < lengths.size(); ++i) {
        const double length = shares[i] > 0 ? rest * shares[i] / sum : lengths[i] * shrink;
        out.push_back(onPixels(from, length));
        from += length + gap;
    }
    return out;
}

Stretch across(const QString& how, double length, double from, double room) {
    if (how == QStringLiteral("fill") || length >= room) return onPixels(from, room);
    if (how == QStringLiteral("center")) return onPixels(from + (room - length) / 2, length);
    return onPixels(how == QStringLiteral("end") ? from + room - length : from, length);
}

std::vector<QRectF> inLine(const Element& group, const QRectF& room, const std::vector<const Element*>& contents,
                           bool isRow) {
    std::vector<double> lengths, shares;
    for (const Element* one : contents) {
        lengths.push_back(isRow ? one->rect().width() : one->rect().height());
        shares.push_back(one->number("stretch"_number));
    }
    const std::vector<Stretch> along = alongLine(lengths, shares, isRow ? room.left() : room.top(),
                                                 isRow ? room.width() : room.height(), group.number("gap"_number));
    const QString how = group.text("across"_text);
    std::vector<QRectF> out;
    for (size_t i = 0; i < contents.size(); ++i) {
        const QRectF own = contents[i]->rect();
        const Stretch other = isRow ? across(how, own.height(), room.top(), room.height())
                                    : across(how, own.width(), room.left(), room.width());
        out.push_back(isRow ? QRectF(along[i].begin, other.begin, along[i].length, other.length)
                            : QRectF(other.begin, along[i].begin, other.length, along[i].length));
    }
    return out;
}

int columnsOf(const Element& group, const QRectF& room) {
    if (const int fixed = group.integer("columns"_number); fixed > 0) return fixed;
    const double gap = group.number("gap"_number);
    return std::clamp(static_cast<int>((room.width() + gap) / (group.number("cellWidth"_number) + gap)), 1, 64);
}

std::vector<QRectF> inGrid(const Element& group, const QRectF& room, const std::vector<const Element*>& contents) {
    struct Cell {
        int row, column, span;
    };
    const int columns = columnsOf(group, room);
    const double gap = group.number("gap"_number);
    std::vector<Cell> cells;
    int row = 0, column = 0;
    for (const Element* one : contents) {
        const int span = std::clamp(one->integer("columnSpan"_number), 1, columns);
        if (column + span > columns) {
            ++row;
            column = 0;
        }
        cells.push_back({row, column, span});
        column += span;
    }
    const double width = std::max(1.0, (room.width() - gap * (columns - 1)) / columns),
                 height = std::max(1.0, (room.height() - gap * row) / (row + 1));
    std::vector<QRectF> out;
    for (const Cell& cell : cells) {
        const Stretch x =
            onPixels(room.left() + cell.column * (width + gap), width * cell.span + gap * (cell.span - 1));
        const Stretch y = onPixels(room.top() + cell.row * (height + gap), height);
        out.emplace_back(x.begin, y.begin, x.length, y.length);
    }
    return out;
}

std::vector<const Element*> contentsOfCells(const Panel& panel, const ElementId& group,
                                            const std::vector<ElementId>& without) {
    std::vector<const Element*> out;
    for (const Element& element : panel.elements())
        if (element.parent() == group && element.id() != group &&
            std::find(without.begin(), without.end(), element.id()) == without.end())
            out.push_back(&element);
    return out;
}

} // namespace

bool hasCells(const Element& element) {
    return element.kind() == ElementKind::Group && element.text("layout"_text) != QStringLiteral("free");
}

std::vector<QRectF> cellsOf(const Element& group, const QRectF& rect, const std::vector<const Element*>& contents) {
    if (contents.empty()) return {};
    const QRectF room = inner(group, rect);
    const Flow flow = flowOf(group, rect);
    return flow == Flow::Grid ? inGrid(group, room, contents) : inLine(group, room, contents, flow == Flow::Row);
}

Edit arrangement(const Panel& panel) {
    EditList list;
    if (std::none_of(panel.elements().begin(), panel.elements().end(), hasCells)) return {list};
    const Panel placed = laidOut(panel, panel.size());
    for (size_t i = 0; i < panel.elements().size(); ++i) {
        const QRectF rect = placed.elements()[i].rect();
        if (rect != panel.elements()[i].rect())
            list.edits.push_back(setProperty(panel, panel.elements()[i].id(), "rect", rectToJson(rect)));
    }
    return {list};
}

ElementId groupWithCellsAt(const Panel& panel, QPointF at, const std::vector<ElementId>& without) {
    std::vector<ElementId> inside;
    for (const ElementId& id : without)
        for (const ElementId& one : panel.withDescendants(id)) inside.push_back(one);
    const Element* found = nullptr;
    for (const Element& element : panel.elements()) {
        if (!hasCells(element) || !element.rect().contains(at)) continue;
        if (std::find(inside.begin(), inside.end(), element.id()) != inside.end()) continue;
        const bool isSmaller = !found || element.rect().width() * element.rect().height() <=
                                             found->rect().width() * found->rect().height();
        if (isSmaller) found = &element;
    }
    return found ? found->id() : ElementId();
}

int cellAt(const Panel& panel, const ElementId& group, QPointF at, const std::vector<ElementId>& without) {
    const Element* outer = panel.find(group);
    if (!outer) return 0;
    const std::vector<const Element*> contents = contentsOfCells(panel, group, without);
    const Flow flow = flowOf(*outer, outer->rect());
    const std::vector<QRectF> cells = cellsOf(*outer, outer->rect(), contents);
    for (size_t i = 0; i < cells.size(); ++i) {
        const bool isLeft = at.x() < cells[i].center().x(), isAbove = at.y() < cells[i].center().y();
        const bool isBefore = flow == Flow::Row ? isLeft
                              : flow == Flow::Column
                                  ? isAbove
                                  : at.y() < cells[i].top() || (at.y() < cells[i].bottom() && isLeft);
        if (isBefore) return static_cast<int>(i);
    }
    return static_cast<int>(cells.size());
}

Edit putIntoCells(const Panel& panel, const std::vector<ElementId>& elements, const ElementId& group, int cell) {
    EditList list;
    Panel scratch = panel;
    const auto perform = [&](const Edit& edit) {
        if (edit.isEmpty()) return;
        applyTo(scratch, edit);
        list.edits.push_back(edit);
    };
    const std::vector<const Element*> others = contentsOfCells(panel, group, elements);
    const ElementId before =
        cell >= 0 && static_cast<size_t>(cell) < others.size() ? others[static_cast<size_t>(cell)]->id() : ElementId();
    for (const ElementId& id : elements) {
        perform(setProperty(scratch, id, "parent"_field, toUtf8(group)));
        perform(setProperty(scratch, id, "page"_field, 0));
        const int from = scratch.indexOf(id), last = static_cast<int>(scratch.elements().size()) - 1;
        int to = before.isEmpty() ? last : scratch.indexOf(before);
        if (from < to && !before.isEmpty()) --to; // it is taken out first
        if (from != to) perform({MoveElement{id, to}});
    }
    return {list};
}

} // namespace plc::hmi
