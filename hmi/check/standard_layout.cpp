// What sizes and places say: letters at the viewing distance, fingers, crowding, and what covers what.
#include "hmi/check/standard_parts.h"

#include "hmi/model/errors.h"
#include "hmi/view/element_factory.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plc::hmi {

namespace {

constexpr double kTouchArea = 44; // at least, as ElementView::touchArea has it

int64_t pixels(double length) { return static_cast<int64_t>(std::lround(length)); }

bool isAlways(const QString& expression) { return expression.trimmed().isEmpty(); }

bool hidesByCondition(const Element& element) {
    const Json& rows = element.at("when");
    return rows.is_array() && std::any_of(rows.begin(), rows.end(), [](const Json& row) {
               return row.is_object() && row.contains("visible") && row["visible"] == false;
           });
}

/// How much smaller a placed faceplate is than it was drawn.
double scaleOf(const Element& placed, const Panel& drawn) {
    const QSizeF size = drawn.size();
    if (size.isEmpty()) return 1;
    return std::min(placed.rect().width() / size.width(), placed.rect().height() / size.height());
}

void checkFont(StandardFindings& out, const Element& element) {
    const double smallest = out.input().standard.smallestFont();
    if (!element.descriptor().property("fontSize") || element.number("fontSize") >= smallest) return;
    out.add(StandardRule::TextTooSmall, element.id(), QStringLiteral("fontSize"),
            errors::FontTooSmall(pixels(element.number("fontSize")), pixels(smallest),
                                 pixels(out.input().standard.viewingDistance)),
            setProperty(out.panel(), element.id(), "fontSize", static_cast<int>(smallest)));
}

/// What is drawn in a faceplate shrinks with it.
void checkScaled(StandardFindings& out, const Element& placed, const Panel& drawn) {
    const StandardSettings& standard = out.input().standard;
    const double scale = scaleOf(placed, drawn);
    double font = standard.smallestFont(), target = standard.smallestTarget();
    const double neededFont = font, neededTarget = target;
    for (const Element& inner : drawn.elements()) {
        if (inner.descriptor().property("fontSize")) font = std::min(font, inner.number("fontSize") * scale);
        if (isOperated(inner)) target = std::min(target, std::min(inner.rect().width(), inner.rect().height()) * scale);
    }
    constexpr double Slack = 0.5;
    if (font < neededFont - Slack)
        out.add(StandardRule::TextTooSmall, placed.id(), QStringLiteral("rect"),
                errors::FaceplateShrinksText(pixels(font), pixels(neededFont), pixels(standard.viewingDistance)));
    if (target < neededTarget - Slack)
        out.add(StandardRule::TouchTargetTooSmall, placed.id(), QStringLiteral("rect"),
                errors::FaceplateShrinksTargets(pixels(target), pixels(neededTarget)));
}

/// What reacts to a finger is larger than what is drawn, up to its neighbours.
void checkTargets(StandardFindings& out) {
    const double needed = out.input().standard.smallestTarget();
    std::vector<QRectF> operated;
    for (const Element& element : out.panel().elements())
        if (isOperated(element) && !isSometimesHidden(out.panel(), element)) operated.push_back(element.rect());
    for (const Element& element : out.panel().elements()) {
        if (!isOperated(element)) continue;
        const QRectF rect = element.rect();
        QSizeF size = rect.size();
        const bool isGrid = element.kind() == ElementKind::CellGrid;
        if (isGrid)
            size = {size.width() / std::max(1, element.integer("columns")),
                    size.height() / std::max(1, element.integer("rows"))};
        const double dx = (needed - size.width()) / 2, dy = (needed - size.height()) / 2;
        if (dx <= 0.25 && dy <= 0.25) continue;
        const QRectF finger =
            rect.adjusted(-std::max(0.0, dx), -std::max(0.0, dy), std::max(0.0, dx), std::max(0.0, dy));
        const bool isFree = !isGrid && std::none_of(operated.begin(), operated.end(), [&](const QRectF& other) {
            return other != rect && other.intersects(finger) && !other.intersects(rect);
        });
        if (!isFree)
            out.add(StandardRule::TouchTargetTooSmall, element.id(), QStringLiteral("rect"),
                    errors::TargetTooSmall(pixels(size.width()), pixels(size.height()), pixels(needed)));
    }
}

/// What is looked for and read: drawings are not.
bool isItem(const Element& element) {
    return isOperated(element) || isDisplay(element) || element.kind() == ElementKind::Text;
}

void checkCrowding(StandardFindings& out) {
    constexpr double Room = 3000; // square pixels to each: 200 on a panel of 1024 x 600
    const QSizeF size = out.panel().size();
    const auto all = std::count_if(out.panel().elements().begin(), out.panel().elements().end(), isItem);
    const auto most = static_cast<int64_t>(size.width() * size.height() / Room);
    if (all > std::max<int64_t>(most, 8)) out.add(StandardRule::TooCrowded, {}, {}, errors::PanelCrowded(all, most));
}

// ---- what covers what

/// The part of an element in which it shows something; of a text the letters, not the box around them.
struct Seen {
    const Element* element;
    size_t order; // of drawing
    QRectF rect;
};

QRectF inkOf(const TextBox& box) {
    const QSizeF size = neededSize(box).boundedTo(box.rect.size());
    const bool isRight = (box.align == TextAlign::End) != box.rightToLeft;
    const double left = box.align == TextAlign::Center ? box.rect.center().x() - size.width() / 2
                        : isRight                      ? box.rect.right() - size.width()
                                                       : box.rect.left();
    return {left, box.rect.center().y() - size.height() / 2, size.width(), size.height()};
}

class OverlapChecker {
public:
    explicit OverlapChecker(StandardFindings& out) : m_out(out), m_panel(out.panel()) {}

    void run() {
        measureTexts();
        std::vector<Seen> all;
        for (size_t order = 0; order < m_panel.elements().size(); ++order) {
            const Element& element = m_panel.elements()[order];
            if (!isSeen(element)) continue;
            const bool isText = element.kind() == ElementKind::Text;
            const QRectF rect = isText ? m_ink.value(element.id()) : element.rect();
            if (!rect.isEmpty()) all.push_back({&element, order, rect});
        }
        std::stable_sort(all.begin(), all.end(),
                         [](const Seen& a, const Seen& b) { return a.rect.left() < b.rect.left(); });
        for (size_t i = 0; i < all.size(); ++i)
            for (size_t k = i + 1; k < all.size() && all[k].rect.left() < all[i].rect.right(); ++k)
                if (covers(all[i], all[k])) {
                    report(all[i], all[k]);
                    break; // the first says enough
                }
    }

private:
    static constexpr double kUnseen = 2;

    /// Where the letters are in any of the languages.
    void measureTexts() {
        PanelScene scene{makeElementView};
        scene.setMeasuring(true);
        scene.setTexts(&m_out.input().texts);
        scene.setFaceplates(m_out.input().panelLookup());
        scene.setThemes(m_out.input().themes);
        scene.setPanel(m_panel);
        for (const QString& tag : m_out.input().texts.settings().languages) {
            scene.setLanguage(tag);
            scene.refresh(0);
            for (const auto& view : scene.views()) {
                if (scene.isInner(*view) || view->element().kind() != ElementKind::Text) continue;
                std::vector<TextBox> boxes;
                view->collectTexts(tag, boxes);
                for (const TextBox& box : boxes)
                    m_ink[view->element().id()] |= inkOf(box).translated(view->element().rect().topLeft());
            }
        }
    }

    /// Upright, at its place at all times, and no drawing.
    bool isSeen(const Element& element) const {
        const bool isShown = element.kind() == ElementKind::Text || element.kind() == ElementKind::NumericDisplay ||
                             element.kind() == ElementKind::MultiState || isOperated(element);
        return isShown && !isSometimesHidden(m_panel, element) && element.number("angle") == 0 &&
               isAlways(element.text("moveX")) && isAlways(element.text("moveY")) && isAlways(element.text("rotate"));
    }

    bool covers(const Seen& a, const Seen& b) const {
        const QRectF both = a.rect & b.rect;
        if (both.width() <= kUnseen || both.height() <= kUnseen) return false;
        return areTogether(*a.element, *b.element);
    }

    /// Not on different pages of the same tab.
    bool areTogether(const Element& a, const Element& b) const {
        for (const Element* one = &a; one; one = around(*one))
            for (const Element* other = &b; other; other = around(*other)) {
                const bool isSameTab = !one->parent().isEmpty() && one->parent() == other->parent();
                if (isSameTab && one->integer("page") != other->integer("page")) return false;
                if (one->parent() == one->id() || other->parent() == other->id()) return true; // reported elsewhere
            }
        return true;
    }

    const Element* around(const Element& element) const {
        return element.parent().isEmpty() ? nullptr : m_panel.find(element.parent());
    }

    void report(const Seen& a, const Seen& b) {
        const bool isFirstBelow = a.order < b.order;
        const Seen &below = isFirstBelow ? a : b, &above = isFirstBelow ? b : a;
        m_out.add(StandardRule::ElementsOverlap, below.element->id(), QStringLiteral("rect"),
                  errors::CoveredBy(toUtf8(above.element->caption())));
    }

    StandardFindings& m_out;
    const Panel& m_panel;
    QHash<ElementId, QRectF> m_ink;
};

} // namespace

bool isFaceplate(const Panel& panel) { return !parametersOf(panel).empty(); }

bool isSometimesHidden(const Panel& panel, const Element& element) {
    const Element* at = &element;
    for (size_t depth = 0; at && depth <= 32; ++depth) {
        if (!at->text("visible").isEmpty() || hidesByCondition(*at)) return true;
        at = at->parent().isEmpty() ? nullptr : panel.find(at->parent());
    }
    return false;
}

void checkSizes(StandardFindings& out) {
    for (const Element& element : out.panel().elements()) {
        checkFont(out, element);
        if (element.kind() != ElementKind::Faceplate) continue;
        if (const Panel* drawn = out.input().panelLookup()(element.text("panel"))) checkScaled(out, element, *drawn);
    }
    checkTargets(out);
    checkCrowding(out);
}

void checkOverlaps(StandardFindings& out) {
    if (out.isChecked(StandardRule::ElementsOverlap)) OverlapChecker(out).run();
}

} // namespace plc::hmi
