#include "hmi/designer/context/arrange.h"

#include "hmi/model/cells.h"
#include "hmi/model/property_literals.h"
#include "hmi/model/walk.h"

#include <QHash>
#include <QRegularExpression>
#include <QSet>

namespace plc::hmi {

QRectF boundsOf(const Panel& panel, const ElementIds& ids) {
    QRectF bounds;
    for (const ElementId& id : ids)
        if (const Element* element = panel.find(id))
            bounds = bounds.isNull() ? element->rect() : bounds.united(element->rect());
    return bounds;
}

namespace {

Edit moved(const Panel& panel, const std::vector<std::pair<ElementId, QPointF>>& offsets) {
    EditList list;
    for (const auto& [id, offset] : offsets)
        if (!offset.isNull()) list.edits.push_back(moveBy(panel, {id}, offset));
    return {list};
}

/// Without those that lie in another selected one: they move with it.
ElementIds outermost(const Panel& panel, const ElementIds& ids) {
    QSet<ElementId> inner;
    for (const ElementId& id : ids)
        for (const ElementId& one : panel.withDescendants(id))
            if (one != id) inner += one;
    ElementIds out;
    for (const ElementId& id : ids)
        if (panel.find(id) && !inner.contains(id)) out.push_back(id);
    return out;
}

bool isFixed(const Panel& panel, const ElementId& id) { return panel.find(id)->isSet("locked"_flag); }

} // namespace

Edit align(const Panel& panel, const ElementIds& selection, Alignment alignment) {
    const ElementIds ids = outermost(panel, selection);
    const QRectF to = ids.size() == 1 ? QRectF(QPointF(), panel.size()) : boundsOf(panel, ids);
    std::vector<std::pair<ElementId, QPointF>> offsets;
    for (const ElementId& id : ids) {
        if (isFixed(panel, id)) continue;
        const QRectF rect = panel.find(id)->rect();
        QPointF offset;
        switch (alignment) {
        case Alignment::Left:
            offset.setX(to.left() - rect.left());
            break;
        case Alignment::CenterX:
            offset.setX(to.center().x() - rect.center().x());
            break;
        case Alignment::Right:
            offset.setX(to.right() - rect.right());
            break;
        case Alignment::Top:
            offset.setY(to.top() - rect.top());
            break;
        case Alignment::CenterY:
            offset.setY(to.center().y() - rect.center().y());
            break;
        case Alignment::Bottom:
            offset.setY(to.bottom() - rect.bottom());
            break;
        }
        offsets.emplace_back(id, offset);
    }
    return moved(panel, offsets);
}

Edit distribute(const Panel& panel, const ElementIds& selection, Direction direction) {
    ElementIds ids = outermost(panel, selection);
    if (ids.size() < 3) return {};
    const bool flat = direction == Direction::Horizontal;
    const auto begin = [&](const ElementId& id) {
        return flat ? panel.find(id)->rect().left() : panel.find(id)->rect().top();
    };
    const auto length = [&](const ElementId& id) {
        return flat ? panel.find(id)->rect().width() : panel.find(id)->rect().height();
    };
    std::stable_sort(ids.begin(), ids.end(),
                     [&](const ElementId& a, const ElementId& b) { return begin(a) < begin(b); });
    double used = 0;
    for (const ElementId& id : ids) used += length(id);
    const double whole = begin(ids.back()) + length(ids.back()) - begin(ids.front()),
                 gap = (whole - used) / static_cast<double>(ids.size() - 1);
    double at = begin(ids.front());
    std::vector<std::pair<ElementId, QPointF>> offsets;
    for (const ElementId& id : ids) {
        const double by = std::round((at - begin(id)) * 1000) / 1000;
        if (!isFixed(panel, id)) offsets.emplace_back(id, flat ? QPointF(by, 0) : QPointF(0, by));
        at += length(id) + gap;
    }
    return moved(panel, offsets);
}

Edit makeSameSize(const Panel& panel, const ElementIds& selection, SameSize what) {
    const ElementIds ids = outermost(panel, selection);
    EditList list;
    if (ids.size() < 2) return {list};
    const QSizeF model = panel.find(ids.front())->rect().size();
    for (const ElementId& id : ids) {
        QRectF rect = panel.find(id)->rect();
        if (what != SameSize::Height) rect.setWidth(model.width());
        if (what != SameSize::Width) rect.setHeight(model.height());
        if (rect != panel.find(id)->rect() && !isFixed(panel, id)) list.edits.push_back(resizeTo(panel, id, rect));
    }
    return {list};
}

Edit reorder(const Panel& panel, const ElementIds& selection, Order order) {
    // What lies in a group moves with it, so that its contents stay above it.
    QSet<ElementId> chosen;
    for (const ElementId& id : selection)
        for (const ElementId& one : panel.withDescendants(id)) chosen += one;
    std::vector<ElementId> now, wanted;
    for (const Element& element : panel.elements()) now.push_back(element.id());
    const auto isChosen = [&](const ElementId& id) { return chosen.contains(id); };
    wanted = now;
    switch (order) {
    case Order::Front:
        std::stable_partition(wanted.begin(), wanted.end(), [&](const ElementId& id) { return !isChosen(id); });
        break;
    case Order::Back:
        std::stable_partition(wanted.begin(), wanted.end(), isChosen);
        break;
    case Order::Forward:
        for (size_t i = wanted.size(); i-- > 1;)
            if (isChosen(wanted[i - 1]) && !isChosen(wanted[i])) std::swap(wanted[i - 1], wanted[i]);
        break;
    case Order::Backward:
        for (size_t i = 1; i < wanted.size(); ++i)
            if (isChosen(wanted[i]) && !isChosen(wanted[i - 1])) std::swap(wanted[i], wanted[i - 1]);
        break;
    }
    EditList list;
    for (size_t i = 0; i < wanted.size(); ++i) {
        if (now[i] == wanted[i]) continue;
        list.edits.push_back({MoveElement{wanted[i], static_cast<int>(i)}});
        now.erase(std::find(now.begin(), now.end(), wanted[i]));
        now.insert(now.begin() + static_cast<long>(i), wanted[i]);
    }
    return {list};
}

Edit makeGroup(const Panel& panel, const ElementIds& selection, ElementId* group) {
    const ElementIds ids = outermost(panel, selection);
    EditList list;
    if (ids.empty()) return {list};
    const ElementId id = panel.freeId("group");
    if (group) *group = id;
    Element frame = Element::make(ElementKind::Group, id, boundsOf(panel, ids));
    const Element* first = panel.find(ids.front());
    if (!first->parent().isEmpty()) frame.set("parent"_field, toUtf8(first->parent()));
    if (first->has("page"_field)) frame.set("page"_field, first->at("page"_field));
    int lowest = static_cast<int>(panel.elements().size());
    for (const ElementId& one : ids) lowest = std::min(lowest, panel.indexOf(one));
    list.edits.push_back({InsertElement{lowest, frame.fields()}});
    for (const ElementId& one : ids) list.edits.push_back(setProperty(panel, one, "parent"_field, toUtf8(id)));
    return {list};
}

namespace {

/// Elements in rows from above, within a row from the left: those belong to one row whose middles are within half a
/// height.
ElementIds asSeen(const Panel& panel, const ElementIds& ids) {
    ElementIds out = ids;
    const auto rect = [&](const ElementId& id) { return panel.find(id)->rect(); };
    std::sort(out.begin(), out.end(),
              [&](const ElementId& a, const ElementId& b) { return rect(a).top() < rect(b).top(); });
    for (auto row = out.begin(); row != out.end();) {
        const double middle = rect(*row).center().y();
        const auto end = std::find_if(row, out.end(), [&](const ElementId& id) { return rect(id).top() > middle; });
        std::sort(row, end, [&](const ElementId& a, const ElementId& b) { return rect(a).left() < rect(b).left(); });
        row = end;
    }
    return out;
}

} // namespace

Edit layOut(const Panel& panel, const ElementIds& selection, const char* layout, ElementId* group) {
    const ElementIds ids = outermost(panel, selection);
    const Element* only = ids.size() == 1 ? panel.find(ids.front()) : nullptr;
    const bool isGroup = only && only->kind() == ElementKind::Group;
    ElementId id = isGroup ? only->id() : ElementId();
    EditList list;
    Panel scratch = panel;
    const auto perform = [&](const Edit& edit) {
        applyTo(scratch, edit);
        list.edits.push_back(edit);
    };
    if (!isGroup) perform(makeGroup(panel, ids, &id));
    if (group) *group = id;
    const ElementIds contents = asSeen(scratch, scratch.childrenOf(id));
    // The frame keeps its contents' size and has room for its margin.
    const double margin = isGroup ? 0 : Element::make(ElementKind::Group, id, {}).number("padding"_number);
    const QRectF rect = scratch.find(id) ? scratch.find(id)->rect() : QRectF();
    perform(setProperty(scratch, id, "rect"_field, rectToJson(rect.adjusted(-margin, -margin, margin, margin))));
    perform(putIntoCells(scratch, contents, id, 0));
    perform(setProperty(scratch, id, "layout"_field, layout));
    if (std::string_view(layout) == "grid" && !contents.empty()) {
        int columns = 1;
        const double first = scratch.find(contents.front())->rect().center().y();
        while (static_cast<size_t>(columns) < contents.size() &&
               scratch.find(contents[static_cast<size_t>(columns)])->rect().top() <= first)
            ++columns;
        perform(setProperty(scratch, id, "columns"_field, columns));
    }
    return {list};
}

Edit dissolveGroups(const Panel& panel, const ElementIds& ids) {
    EditList list;
    for (const ElementId& id : ids) {
        const Element* group = panel.find(id);
        if (!group || group->kind() != ElementKind::Group) continue;
        for (const ElementId& child : panel.childrenOf(id))
            list.edits.push_back(setProperty(panel, child, "parent"_field, toUtf8(group->parent())));
        list.edits.push_back({RemoveElement{id}});
    }
    return {list};
}

Edit setLocked(const Panel& panel, const ElementIds& ids, bool locked) {
    EditList list;
    for (const ElementId& id : ids) list.edits.push_back(setProperty(panel, id, "locked"_field, locked));
    return {list};
}

Json copied(const Panel& panel, const ElementIds& ids) {
    QSet<ElementId> chosen;
    for (const ElementId& id : ids)
        for (const ElementId& one : panel.withDescendants(id)) chosen += one;
    Json out = Json::array();
    for (const Element& element : panel.elements())
        if (chosen.contains(element.id())) out.push_back(element.fields());
    return out;
}

namespace {

/// Inserts copies with new ids. `change` may alter each element before it is inserted.
void insertCopies(Panel& scratch, const Json& elements, QPointF offset, EditList& list, ElementIds* added,
                  const std::function<void(Element&)>& change = {}) {
    QHash<ElementId, ElementId> renamed;
    std::vector<Element> copies;
    for (const Json& fields : elements) {
        if (!fields.is_object()) continue;
        Element element{fields};
        const ElementId old = element.id();
        const std::string_view stem =
            element.descriptor().key.empty() ? std::string_view("element") : element.descriptor().key;
        element.setField("id", toUtf8(scratch.freeId(stem)), 0);
        renamed.insert(old, element.id());
        element.set("rect"_field, rectToJson(element.rect().translated(offset)));
        if (change) change(element);
        scratch.elements().push_back(element);
        copies.push_back(std::move(element));
    }
    for (Element& element : copies) {
        const ElementId parent = element.parent();
        if (renamed.contains(parent))
            element.set("parent"_field, toUtf8(renamed.value(parent)));
        else if (!parent.isEmpty() && !scratch.find(parent))
            element.setField("parent", std::nullopt, 0);
        if (added && !renamed.contains(parent)) added->push_back(element.id());
        *scratch.find(element.id()) = element;
        list.edits.push_back({InsertElement{static_cast<int>(1e9), element.fields()}});
    }
}

} // namespace

QRectF boundsOf(const Json& elements) {
    QRectF bounds;
    for (const Json& fields : elements)
        if (fields.is_object())
            bounds = bounds.isNull() ? Element(fields).rect() : bounds.united(Element(fields).rect());
    return bounds;
}

Edit pasted(const Panel& panel, const Json& elements, std::optional<QPointF> at, ElementIds* added) {
    EditList list;
    if (!elements.is_array()) return {list};
    const QRectF bounds = boundsOf(elements);
    QPointF offset = at ? *at - bounds.topLeft() : QPointF(16, 16);
    // Several pastes at one place would hide each other.
    const auto isTaken = [&](QPointF by) {
        for (const Element& element : panel.elements())
            if (element.rect().topLeft() == bounds.topLeft() + by) return true;
        return false;
    };
    for (int guard = 0; !at && isTaken(offset) && guard < 64; ++guard) offset += QPointF(16, 16);
    Panel scratch = panel;
    insertCopies(scratch, elements, offset, list, added);
    return {list};
}

QString withShiftedIndex(const QString& expression, int shift) {
    static const QRegularExpression index(QStringLiteral("\\[\\s*(-?\\d+)"));
    const QRegularExpressionMatch match = index.match(expression);
    if (!match.hasMatch()) return expression;
    QString out = expression;
    return out.replace(match.capturedStart(1), match.capturedLength(1),
                       QString::number(match.captured(1).toInt() + shift));
}

namespace {

QString withShiftedNumber(const QString& text, int shift) {
    static const QRegularExpression number(QStringLiteral("(\\d+)(?!.*\\d)"));
    const QRegularExpressionMatch match = number.match(text);
    if (!match.hasMatch()) return text;
    QString out = text;
    return out.replace(match.capturedStart(1), match.capturedLength(1),
                       QString::number(match.captured(1).toInt() + shift));
}

} // namespace

Edit duplicatedAsArray(const Panel& panel, const ElementIds& ids, const ArrayLayout& layout, ElementIds* added) {
    EditList list;
    const Json elements = copied(panel, ids);
    const QRectF bounds = boundsOf(panel, ids);
    Panel scratch = panel;
    for (int copy = 1; copy < layout.count; ++copy) {
        const int column = copy % std::max(1, layout.columns), row = copy / std::max(1, layout.columns);
        const QPointF offset(column * (bounds.width() + layout.gap.x()), row * (bounds.height() + layout.gap.y()));
        const int shift = copy * layout.indexStep;
        insertCopies(scratch, elements, offset, list, added, [&](Element& element) {
            Panel single;
            single.elements().push_back(element);
            const Edit change = rewrite(single, [&](const ElementId&, const Found& found) -> std::optional<QString> {
                if (found.type == PropertyType::Text)
                    return found.text.startsWith(u'@') ? found.text : withShiftedNumber(found.text, shift);
                return found.type == PropertyType::TextList ? found.text : withShiftedIndex(found.text, shift);
            });
            applyTo(single, change);
            element = single.elements().front();
            if (const QString name = element.text("name"_text); !name.isEmpty())
                element.set("name"_field, toUtf8(withShiftedNumber(name, shift)));
        });
    }
    return {list};
}

namespace {

Json argumentsAt(const Json& arguments, const ArrayArrangement& arrangement, int index) {
    Json out = arguments.is_object() ? arguments : Json::object();
    for (Json& one : out)
        if (one.is_string()) one = toUtf8(toQString(one).replace(u'#', QString::number(index)));
    out[toUtf8(arrangement.parameter)] = toUtf8(QStringLiteral("%1[%2]").arg(arrangement.array).arg(index));
    return out;
}

} // namespace

Edit arrangedOverArray(const Panel& panel, const ElementId& faceplate, const ArrayArrangement& arrangement,
                       ElementIds* added) {
    EditList list;
    const Element* original = panel.find(faceplate);
    if (!original || original->kind() != ElementKind::Faceplate) return {list};
    const Json arguments = original->at("arguments"_field);
    list.edits.push_back(
        setProperty(panel, faceplate, "arguments"_field, argumentsAt(arguments, arrangement, arrangement.first)));
    const QSizeF size = original->rect().size();
    const Json single = copied(panel, {faceplate});
    Panel scratch = panel;
    for (int index = arrangement.first + 1; index <= arrangement.last; ++index) {
        const int copy = index - arrangement.first, columns = std::max(1, arrangement.columns);
        const QPointF offset((copy % columns) * (size.width() + arrangement.gap.x()),
                             (copy / columns) * (size.height() + arrangement.gap.y()));
        insertCopies(scratch, single, offset, list, added, [&](Element& element) {
            element.set("arguments"_field, argumentsAt(arguments, arrangement, index));
            if (const QString name = element.text("name"_text); !name.isEmpty())
                element.set("name"_field, toUtf8(withShiftedNumber(name, copy)));
        });
    }
    return {list};
}

namespace {

bool isNamePart(QChar c) { return c.isLetterOrNumber() || c == u'_'; }

/// Where the text in quotes that begins at `i` ends.
qsizetype endOfText(const QString& expression, qsizetype i) {
    qsizetype end = i + 1;
    while (end < expression.size() && expression[end] != expression[i]) end += expression[end] == u'$' ? 2 : 1;
    return std::min(end + 1, expression.size());
}

bool hasNameAt(const QString& expression, qsizetype i, const QString& name) {
    return expression.mid(i, name.size()).compare(name, Qt::CaseInsensitive) == 0 &&
           (i + name.size() == expression.size() || !isNamePart(expression[i + name.size()]));
}

/// The path in front of the dot at `dot`: "Plant.valves[2]" of "NOT Plant.valves[2].open".
QString pathBefore(const QString& expression, qsizetype dot) {
    qsizetype begin = dot;
    int depth = 0; // of brackets
    while (begin > 0) {
        const QChar c = expression[begin - 1];
        depth += c == u']' ? 1 : c == u'[' ? -1 : 0;
        if (depth < 0 || (depth == 0 && c != u'[' && !isNamePart(c) && c != u'.' && c != u'^' && c != u'$')) break;
        --begin;
    }
    return expression.mid(begin, dot - begin);
}

/// Texts are left alone; elsewhere `renamedAt` gives what takes the place of the characters from `i` on, and moves `i`
/// behind them; nothing: the character stays.
QString rewritten(const QString& expression, const std::function<std::optional<QString>(qsizetype& i)>& renamedAt) {
    QString out;
    for (qsizetype i = 0; i < expression.size();) {
        const qsizetype begin = i;
        if (expression[i] == u'\'' || expression[i] == u'"') {
            i = endOfText(expression, i);
            out += expression.mid(begin, i - begin);
        } else if (const std::optional<QString> other = renamedAt(i)) {
            out += *other;
        } else {
            out += expression[i++];
        }
    }
    return out;
}

} // namespace

QString withRenamedPath(const QString& expression, const QString& from, const QString& to) {
    return rewritten(expression, [&](qsizetype& i) -> std::optional<QString> {
        const bool begins =
            isNamePart(expression[i]) &&
            (i == 0 || (!isNamePart(expression[i - 1]) && expression[i - 1] != u'.' && expression[i - 1] != u'#'));
        if (!begins || !hasNameAt(expression, i, from)) return {};
        i += from.size();
        return to;
    });
}

QString withRenamedMember(const QString& expression, const QString& from, const QString& to,
                          const std::function<bool(const QString& base)>& isBase) {
    return rewritten(expression, [&](qsizetype& i) -> std::optional<QString> {
        if (expression[i] != u'.' || !hasNameAt(expression, i + 1, from)) return {};
        const QString base = pathBefore(expression, i);
        if (base.isEmpty() || !isBase(base)) return {};
        i += 1 + from.size();
        return u'.' + to;
    });
}

Edit withExpressions(const Panel& panel, const std::function<QString(const QString& expression)>& renamed) {
    return rewrite(panel, [&](const ElementId&, const Found& found) -> std::optional<QString> {
        if (found.type == PropertyType::Text || found.type == PropertyType::TextList) return {};
        return renamed(found.text);
    });
}

Edit renamedKey(const Panel& panel, const QString& from, const QString& to) {
    return rewrite(panel, [&](const ElementId&, const Found& found) -> std::optional<QString> {
        if (found.type == PropertyType::Text && found.text == u'@' + from) return u'@' + to;
        return {};
    });
}

} // namespace plc::hmi
