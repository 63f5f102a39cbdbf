#include "hmi/view/controls/arrays.h"

#include "hmi/model/array_index.h"
#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

// ---- cell grid

void CellGridView::setUp() {
    m_value = bindProperty("value");
    m_states = bindStates();
}

bool CellGridView::update() {
    std::vector<Value> cells = value(m_value).items();
    if (cells.empty() && isDesigning())
        for (int i = 0; i < rows() * columns(); ++i) cells.push_back(Value::ofBool(i % 3 == 0));
    const bool changed = cells != m_cells;
    m_cells = std::move(cells);
    return changed || !m_states.empty();
}

QRectF CellGridView::cell(int row, int column) const {
    const double w = width() / columns(), h = height() / rows();
    return {column * w, row * h, w, h};
}

int CellGridView::stateOf(const Value& held) const {
    for (size_t i = 0; i < m_states.size(); ++i) {
        const Value& other = value(m_states[i].value);
        if (!other.isNone() &&
            (held.kind() == ValueKind::Text ? held.text() == other.text() : held.toNumber() == other.toNumber()))
            return static_cast<int>(i);
    }
    return -1;
}

TextBox CellGridView::label(const QString& words, const QRectF& area, const QByteArray& place,
                            const QString& forTag) const {
    return textBox(words, area.adjusted(3, 1, -3, -1), num("fontSize"), TextAlign::Center, place.constData(), false,
                   forTag);
}

void CellGridView::draw(QPainter& painter) {
    const int first = element().integer("first");
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column < columns(); ++column) {
            const int index = row * columns() + column;
            const QRectF area = cell(row, column).adjusted(1.5, 1.5, -1.5, -1.5);
            const bool known = static_cast<size_t>(index) < m_cells.size();
            const Value held = known ? m_cells[static_cast<size_t>(index)] : Value();
            const int state = known ? stateOf(held) : -1;
            QColor ground =
                known ? (held.toBool() && held.kind() != ValueKind::Text ? color("onColor") : color("offColor"))
                      : theme().color("surface");
            QString words = flag("numbers") ? QString::number(first + index) : QString();
            if (state >= 0) {
                const BoundState& one = m_states[static_cast<size_t>(state)];
                if (one.color.isValid()) ground = one.color;
                if (!one.text.isEmpty()) words = shown(one.text);
                m_blinking = m_blinking || one.blinks;
                if (one.blinks && !isLit()) ground = theme().color("surface");
            }
            ground = stateColor(ground);
            painter.setPen(QPen(theme().color("line"), 1, known ? Qt::SolidLine : Qt::DotLine));
            painter.setBrush(ground);
            painter.drawRoundedRect(area, 3, 3);
            painter.setPen(PanelTheme::inkOn(ground));
            drawText(painter, label(words, area, {}, tag()));
        }
}

void CellGridView::release(QPointF at, bool inside) {
    if (!inside) return;
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column < columns(); ++column) {
            if (!cell(row, column).contains(at)) continue;
            const int first = element().integer("first"), index = row * columns() + column;
            const QString target = text("target");
            if (text("action") == QStringLiteral("select")) return write(target, Value::ofInteger(first + index));
            if (static_cast<size_t>(index) >= m_cells.size()) return;
            return write(withIndex(target, first + index, row + first, column + first),
                         Value::ofBool(!m_cells[static_cast<size_t>(index)].toBool()));
        }
}

void CellGridView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    const QRectF area = cell(0, 0).adjusted(1.5, 1.5, -1.5, -1.5);
    for (size_t i = 0; i < m_states.size(); ++i)
        if (!m_states[i].text.isEmpty())
            out.push_back(label(shown(m_states[i].text, forTag), area,
                                "states[" + QByteArray::number(static_cast<int>(i)) + "].text", forTag));
}

// ---- table

void ArrayTableView::setUp() {
    m_columns.clear();
    m_cells.clear();
    const Json& rows = element().at("columns");
    if (rows.is_array())
        for (const Json& row : rows) {
            if (!row.is_object()) continue;
            const Properties column(descriptorOf(ElementKind::Unknown), row);
            const bool editable = !column.has("editable") || column.isSet("editable");
            m_columns.push_back({column.text("title"), column.text("value"), column.text("format"), column.text("unit"),
                                 editable, column.has("width") ? std::clamp(column.number("width"), 0.05, 100.0) : 1});
        }
    m_selectedTarget = bindProperty("selected");
    const int first = element().integer("first");
    m_top = std::clamp(m_top, 0, std::max(0, count() - visibleRows()));
    for (int row = 0; row < visibleRows() && m_top + row < count(); ++row) {
        m_cells.emplace_back();
        for (const Column& column : m_columns)
            m_cells.back().push_back(bindExpression(withIndex(column.value, first + m_top + row)));
    }
}

bool ArrayTableView::update() {
    if (m_selectedTarget.isBound() && !echoed(m_selectedTarget).isNone())
        m_selected = static_cast<int>(echoed(m_selectedTarget).toInteger()) - element().integer("first");
    return true;
}

double ArrayTableView::headHeight() const { return std::max(24.0, num("fontSize") * 2.1); }

/// Rows that are touched are high enough for a finger.
double ArrayTableView::rowHeight() const {
    const bool isTouched =
        m_selectedTarget.isBound() ||
        std::any_of(m_columns.begin(), m_columns.end(), [](const Column& column) { return column.editable; });
    return isTouched ? std::max(44.0, headHeight()) : headHeight();
}

int ArrayTableView::visibleRows() const {
    return std::max(1, static_cast<int>((height() - headHeight()) / rowHeight()));
}

QRectF ArrayTableView::cell(int visibleRow, size_t column) const {
    const double index = num("fontSize") * 2.6, bar = count() > visibleRows() ? 10 : 0;
    double total = 0, before = 0;
    for (size_t i = 0; i < m_columns.size(); ++i) {
        total += m_columns[i].width;
        if (i < column) before += m_columns[i].width;
    }
    const double room = width() - index - bar;
    return mirrored({index + room * before / total, visibleRow < 0 ? 0 : headHeight() + visibleRow * rowHeight(),
                     room * m_columns[column].width / total, visibleRow < 0 ? headHeight() : rowHeight()});
}

/// Where people read from right to left, the first column is at the right.
QRectF ArrayTableView::mirrored(const QRectF& area) const {
    return isRightToLeft(tag()) ? QRectF(width() - area.right(), area.top(), area.width(), area.height()) : area;
}

TextBox ArrayTableView::header(size_t column, const QString& forTag) const {
    return textBox(shown(m_columns[column].title, forTag), cell(-1, column).adjusted(6, 0, -6, 0), num("fontSize"),
                   TextAlign::Start,
                   ("columns[" + QByteArray::number(static_cast<int>(column)) + "].title").constData(), true, forTag);
}

QString ArrayTableView::contents(const Value& held, const Column& column) const {
    if (held.isNone()) return isDesigning() ? QStringLiteral("0") : QStringLiteral("– –");
    if (!held.isNumber()) return formatValue(held, column.format, locale());
    const UnitView view = scene().texts().settings().unitFor(tag(), column.unit);
    const Value raw = view.factor == 1 && view.offset == 0 ? held : Value::ofReal(view.shown(held.toNumber()));
    const QString words = formatValue(raw, column.format, locale());
    return view.unit.isEmpty() ? words : leftToRight(words + QChar(0x00A0) + view.unit);
}

void ArrayTableView::draw(QPainter& painter) {
    const double row = rowHeight(), head = headHeight();
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(theme().color("inset"));
    painter.drawRect(box());
    painter.fillRect(QRectF(1, 1, width() - 2, head - 1), theme().color("surface"));
    const int first = element().integer("first");
    for (int i = 0; i < static_cast<int>(m_cells.size()) && !m_columns.empty(); ++i) {
        const QRectF line(1, head + i * row, width() - 2, row);
        const bool isSelected = m_top + i == m_selected;
        if (isSelected)
            painter.fillRect(line, theme().color("accent"));
        else if (i % 2)
            painter.fillRect(line, theme().color("surface").lighter(theme().isDark() ? 92 : 103));
        painter.setPen(isSelected ? PanelTheme::inkOn(theme().color("accent")) : theme().color("muted"));
        drawText(painter,
                 textBox(QString::number(first + m_top + i), mirrored({0, line.top(), num("fontSize") * 2.2, row}),
                         num("fontSize") * 0.9, TextAlign::End, ""));
        for (size_t column = 0; column < m_columns.size(); ++column) {
            const Value& held = value(m_cells[static_cast<size_t>(i)][column]);
            painter.setPen(isSelected ? PanelTheme::inkOn(theme().color("accent")) : inkColor(theme().color("text")));
            const TextAlign align = held.isNumber() || held.isNone() ? TextAlign::End : TextAlign::Start;
            drawText(painter, textBox(contents(held, m_columns[column]), cell(i, column).adjusted(6, 0, -6, 0),
                                      num("fontSize"), align, ""));
        }
    }
    for (size_t column = 0; column < m_columns.size(); ++column) {
        painter.setPen(QPen(theme().color("faint"), 1));
        const double x = isRightToLeft(tag()) ? cell(-1, column).right() : cell(-1, column).left();
        painter.drawLine(QPointF(x, 1),
                         QPointF(x, std::min(height() - 1, head + static_cast<double>(m_cells.size()) * row)));
        painter.setPen(theme().color("text"));
        drawText(painter, header(column, tag()));
    }
    painter.setPen(QPen(theme().color("line"), 1));
    painter.drawLine(QPointF(0, head), QPointF(width(), head));
    if (count() > visibleRows()) {
        const double room = height() - head - 4, length = std::max(16.0, room * visibleRows() / count());
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().color("off"));
        painter.drawRoundedRect(
            mirrored(
                {width() - 8, head + 2 + (room - length) * m_top / std::max(1, count() - visibleRows()), 5, length}),
            2.5, 2.5);
    }
    if (m_columns.empty()) drawSample(painter);
}

void ArrayTableView::drawSample(QPainter& painter) {
    const double row = rowHeight(), head = headHeight(), index = num("fontSize") * 2.6, wide = (width() - index) / 2;
    for (int column = 0; column < 2; ++column) {
        const double x = index + column * wide;
        painter.setPen(QPen(theme().color("faint"), 1));
        painter.drawLine(QPointF(x, 1), QPointF(x, height() - 1));
        painter.setPen(theme().color("muted"));
        drawText(painter, textBox(column ? QStringLiteral("[#].b") : QStringLiteral("[#].a"),
                                  QRectF(x + 6, 0, wide - 12, head), num("fontSize"), TextAlign::Start, "", true));
        for (int i = 0; i < std::min(visibleRows(), count()); ++i)
            drawText(painter, textBox(QStringLiteral("– –"), QRectF(x + 6, head + i * row, wide - 12, row),
                                      num("fontSize"), TextAlign::End, ""));
    }
    for (int i = 0; i < std::min(visibleRows(), count()); ++i)
        drawText(painter, textBox(QString::number(element().integer("first") + i),
                                  QRectF(0, head + i * row, num("fontSize") * 2.2, row), num("fontSize") * 0.9,
                                  TextAlign::End, ""));
}

void ArrayTableView::press(QPointF at) {
    m_pressedAt = at;
    m_pressedTop = m_top;
    m_scrolled = false;
}

void ArrayTableView::move(QPointF at) {
    const int rows = static_cast<int>((m_pressedAt.y() - at.y()) / rowHeight());
    if (std::abs(at.y() - m_pressedAt.y()) > 10) m_scrolled = true;
    if (m_scrolled) scrollTo(m_pressedTop + rows);
}

void ArrayTableView::wheel(double steps) { scrollTo(m_top - static_cast<int>(steps * 3)); }

void ArrayTableView::scrollTo(int top) {
    top = std::clamp(top, 0, std::max(0, count() - visibleRows()));
    if (top == m_top) return;
    m_top = top;
    prepare();
    refresh();
    repaint();
}

void ArrayTableView::release(QPointF at, bool inside) {
    if (!inside || m_scrolled) return;
    for (int row = 0; row < static_cast<int>(m_cells.size()); ++row) {
        if (at.y() < headHeight() + row * rowHeight() || at.y() >= headHeight() + (row + 1) * rowHeight()) continue;
        const int first = element().integer("first");
        if (m_selected != m_top + row) {
            m_selected = m_top + row;
            if (m_selectedTarget.isBound()) write(expression(m_selectedTarget), Value::ofInteger(first + m_selected));
            repaint();
            // Where rows are chosen, the first touch chooses and the second one edits.
            if (m_selectedTarget.isBound()) return;
        }
        for (size_t column = 0; column < m_columns.size(); ++column) {
            if (!m_columns[column].editable || !cell(row, column).contains(at)) continue;
            const Slot slot = m_cells[static_cast<size_t>(row)][column];
            if (!slot.isBound()) return;
            const ValueFacts known = facts(slot);
            const ValueKind kind = known.kind == ValueKind::None ? value(slot).kind() : known.kind;
            if (kind == ValueKind::Bool) return write(expression(slot), Value::ofBool(!value(slot).toBool()));
            const UnitView view = scene().texts().settings().unitFor(tag(), m_columns[column].unit);
            EntryRequest entry;
            entry.element = element().id();
            entry.target = expression(slot);
            entry.title = shown(m_columns[column].title) + QStringLiteral("  ") + QString::number(first + m_top + row);
            entry.kind = kind == ValueKind::Text ? EntryKind::Text : EntryKind::Number;
            entry.unit = view.unit;
            entry.factor = view.factor;
            entry.offset = view.offset;
            entry.format = m_columns[column].format;
            entry.present = value(slot);
            entry.maxLength = known.textCapacity;
            if (known.minimum) entry.minimum = view.shown(*known.minimum);
            if (known.maximum) entry.maximum = view.shown(*known.maximum);
            entry.valueKind = kind;
            entry.place = cell(row, column).translated(rect().topLeft());
            return scene().request(entry);
        }
        return;
    }
}

void ArrayTableView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    for (size_t column = 0; column < m_columns.size(); ++column)
        if (!m_columns[column].title.isEmpty()) out.push_back(header(column, forTag));
}

} // namespace plc::hmi
