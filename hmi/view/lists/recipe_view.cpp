#include "hmi/view/lists/recipe_view.h"

#include "hmi/recipes/recipe_file.h"
#include "hmi/texts/local_number.h"
#include "hmi/view/controls/buttons.h"
#include "hmi/view/scene/panel_scene.h"

#include <algorithm>
#include <cmath>

namespace plc::hmi {

namespace {

/// What the designer shows before there are recipes.
const Recipe& sampleRecipe() {
    static const Recipe sample = [] {
        Recipe out;
        out.name = QStringLiteral("1");
        out.variables = {{QStringLiteral("Main.a"), QStringLiteral("A"), QStringLiteral("°C"), {}, {}, {}},
                         {QStringLiteral("Main.b"), QStringLiteral("B"), QStringLiteral("kg"), {}, {}, {}}};
        out.sets = {
            {QStringLiteral("1"),
             {{QStringLiteral("Main.a"), QStringLiteral("180.0")}, {QStringLiteral("Main.b"), QStringLiteral("2.5")}}}};
        return out;
    }();
    return sample;
}

} // namespace

const Recipe* RecipeTableView::recipe() const {
    const RecipeFile* file = scene().recipes();
    const QString name = text("recipe");
    if (file && !file->recipes().empty()) {
        if (const Recipe* found = file->find(name)) return found;
        if (name.isEmpty()) return &file->recipes().front();
    }
    return isDesigning() ? &sampleRecipe() : nullptr;
}

const RecipeSet* RecipeTableView::set() const {
    const Recipe* all = recipe();
    if (!all || all->sets.empty()) return nullptr;
    const RecipeSet* found = all->find(m_set);
    return found ? found : &all->sets.front();
}

QString RecipeTableView::currentSet() const { return set() ? set()->name : QString(); }

void RecipeTableView::showSet(const QString& name) {
    m_set = name;
    repaint();
}

void RecipeTableView::setUp() {
    m_actual.clear();
    if (const Recipe* all = recipe(); all && !isDesigning())
        for (const RecipeVariable& one : all->variables) m_actual.push_back(bindExpression(one.variable));
}

// ---- places

double RecipeTableView::headHeight() const { return std::max(50.0, num("fontSize") * 3); }
double RecipeTableView::rowHeight() const { return std::max(44.0, num("fontSize") * 2.6); }
int RecipeTableView::visibleRows() const {
    return std::max(1, static_cast<int>((height() - headHeight()) / rowHeight() + 0.05));
}

QRectF RecipeTableView::mirrored(const QRectF& area) const {
    return isRightToLeft(tag()) ? QRectF(width() - area.right(), area.top(), area.width(), area.height()) : area;
}

QRectF RecipeTableView::keyArea(Key key) const {
    const double side = headHeight() - 6, keys = (kKeys - 1) * (side + 4);
    const double names = std::max(40.0, width() - keys - 8);
    if (key == Key::Set) return mirrored({3, 3, names - 4, side});
    return mirrored({3 + names + (static_cast<int>(key) - 1) * (side + 4), 3, side, side});
}

QRectF RecipeTableView::cell(int row, int column) const {
    const double shares[] = {0, 0.46, 0.73, 1};
    return mirrored({width() * shares[column], headHeight() + row * rowHeight(),
                     width() * (shares[column + 1] - shares[column]), rowHeight()});
}

// ---- operation

void RecipeTableView::press(QPointF at) {
    m_pressedAt = at;
    m_pressedTop = m_top;
    m_scrolled = false;
    repaint();
}

void RecipeTableView::move(QPointF at) {
    const double by = m_pressedAt.y() - at.y();
    if (m_pressedAt.y() < headHeight() || std::abs(by) < rowHeight() / 2) return;
    m_scrolled = true;
    scrollTo(m_pressedTop + static_cast<int>(std::lround(by / rowHeight())));
}

void RecipeTableView::wheel(double steps) { scrollTo(m_top - static_cast<int>(std::lround(steps * 2))); }

void RecipeTableView::scrollTo(int top) {
    const int count = recipe() ? static_cast<int>(recipe()->variables.size()) : 0;
    top = std::clamp(top, 0, std::max(0, count - visibleRows()));
    if (top == m_top) return;
    m_top = top;
    repaint();
}

void RecipeTableView::release(QPointF at, bool inside) {
    repaint();
    if (!inside || m_scrolled || !recipe()) return;
    for (int key = 0; key < kKeys; ++key)
        if (keyArea(static_cast<Key>(key)).contains(at) && keyArea(static_cast<Key>(key)).contains(m_pressedAt))
            return pressKey(static_cast<Key>(key));
    const int row = static_cast<int>((at.y() - headHeight()) / rowHeight());
    const size_t index = static_cast<size_t>(m_top + row);
    if (at.y() < headHeight() || row >= visibleRows() || index >= recipe()->variables.size()) return;
    if (!cell(row, 1).contains(at) || !set()) return;
    scene().request(RecipeRequest{element().id(), RecipeRequestKind::Edit, recipe()->name, set()->name,
                                  recipe()->variables[index].variable});
}

void RecipeTableView::pressKey(Key key) {
    const auto ask = [&](RecipeRequestKind kind) {
        scene().request(RecipeRequest{element().id(), kind, recipe()->name, currentSet(), {}});
    };
    switch (key) {
    case Key::Set:
        return ask(RecipeRequestKind::Choose);
    case Key::Write:
        return ask(RecipeRequestKind::Write);
    case Key::Read:
        return ask(RecipeRequestKind::Read);
    case Key::Add:
        return ask(RecipeRequestKind::Add);
    case Key::Remove:
        return ask(RecipeRequestKind::Remove);
    }
}

// ---- painting

void RecipeTableView::drawKeys(QPainter& painter) {
    const QColor ground = theme().color("button"), ink = PanelTheme::inkOn(ground);
    for (int i = 0; i < kKeys; ++i) {
        const Key key = static_cast<Key>(i);
        const QRectF area = keyArea(key), mark = area.adjusted(area.width() * 0.3, area.height() * 0.3,
                                                               -area.width() * 0.3, -area.height() * 0.3);
        const bool isDown = isPressed() && !m_scrolled && area.contains(m_pressedAt);
        drawKey(painter, area, 5, ground, isDown, theme());
        painter.setPen(QPen(ink, 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        const QPointF middle = mark.center();
        const auto arrow = [&](double from, double to) {
            painter.drawLine(QPointF(middle.x(), from), QPointF(middle.x(), to));
            const double wing = to > from ? -mark.height() * 0.35 : mark.height() * 0.35;
            painter.drawPolyline(
                QPolygonF{QPointF(mark.left(), to + wing), QPointF(middle.x(), to), QPointF(mark.right(), to + wing)});
        };
        if (key == Key::Set) {
            drawText(painter,
                     textBox(currentSet(), area.adjusted(10, 0, -26, 0), num("fontSize"), TextAlign::Start, "", true));
            const QPointF tip(isRightToLeft(tag()) ? area.left() + 14 : area.right() - 14, area.center().y() + 3);
            painter.drawPolyline(QPolygonF{tip - QPointF(5, 6), tip, tip - QPointF(-5, 6)});
        } else if (key == Key::Write) { // down into the controller
            arrow(mark.top() - 2, mark.bottom() - 3);
            painter.drawLine(mark.bottomLeft() + QPointF(-2, 2), mark.bottomRight() + QPointF(2, 2));
        } else if (key == Key::Read) { // up from it
            arrow(mark.bottom() - 3, mark.top() - 2);
            painter.drawLine(mark.bottomLeft() + QPointF(-2, 2), mark.bottomRight() + QPointF(2, 2));
        } else {
            painter.drawLine(QPointF(mark.left(), middle.y()), QPointF(mark.right(), middle.y()));
            if (key == Key::Add) painter.drawLine(QPointF(middle.x(), mark.top()), QPointF(middle.x(), mark.bottom()));
        }
    }
}

void RecipeTableView::drawRow(QPainter& painter, int row, size_t index) {
    const RecipeVariable& variable = recipe()->variables[index];
    const double size = num("fontSize");
    const QString unit = variable.unit.isEmpty() ? QString() : QChar(0x00A0) + variable.unit;
    const QRectF line(1, headHeight() + row * rowHeight(), width() - 2, rowHeight());
    painter.setPen(QPen(theme().color("faint"), 1));
    painter.drawLine(line.bottomLeft(), line.bottomRight());
    painter.setPen(theme().color("text"));
    const QString title = variable.title.isEmpty() ? variable.variable : shown(variable.title);
    drawText(painter, textBox(title, cell(row, 0).adjusted(10, 0, -6, 0), size, TextAlign::Start, ""));
    const QString own = set() ? set()->values.value(variable.variable) : QString();
    const QRectF field = cell(row, 1).adjusted(4, 5, -4, -5);
    painter.setPen(QPen(theme().color("line"), 1));
    painter.setBrush(theme().color("inset"));
    painter.drawRoundedRect(field, 4, 4);
    painter.setPen(theme().color("text"));
    drawText(painter, textBox(leftToRight(own.isEmpty() ? QStringLiteral("–") : localNumber(own, locale()) + unit),
                              field.adjusted(6, 0, -6, 0), size, TextAlign::End, ""));
    const Value& actual = index < m_actual.size() ? value(m_actual[index]) : value(Slot{});
    if (actual.isNone()) return;
    const QString format = variable.format.isEmpty() ? QString() : variable.format;
    const QString there =
        format.isEmpty() ? localNumber(actual.toLiteral(), locale()) : formatValue(actual, format, locale());
    painter.setPen(theme().color("muted"));
    drawText(painter,
             textBox(leftToRight(there + unit), cell(row, 2).adjusted(4, 0, -10, 0), size, TextAlign::End, ""));
}

void RecipeTableView::draw(QPainter& painter) {
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(theme().color("inset"));
    painter.drawRect(box().adjusted(0.5, 0.5, -0.5, -0.5));
    painter.fillRect(QRectF(1, 1, width() - 2, headHeight() - 1), theme().color("surface"));
    drawKeys(painter);
    const Recipe* all = recipe();
    if (!all) return;
    painter.save();
    painter.setClipRect(QRectF(0, headHeight(), width(), height() - headHeight()), Qt::IntersectClip);
    for (int row = 0; row <= visibleRows(); ++row)
        if (const size_t index = static_cast<size_t>(m_top + row); index < all->variables.size())
            drawRow(painter, row, index);
    painter.restore();
}

void RecipeTableView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    const Recipe* all = recipe();
    if (!all || isDesigning()) return;
    for (const RecipeVariable& one : all->variables)
        if (!one.title.isEmpty())
            out.push_back(textBox(shown(one.title, forTag), cell(0, 0).adjusted(10, 0, -6, 0), num("fontSize"),
                                  TextAlign::Start, "recipe", false, forTag));
}

} // namespace plc::hmi
