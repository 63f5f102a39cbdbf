// The view of one element: it reads its bindings, knows when its look changed, paints itself and says what pressing it
// asks for. One subclass per kind, one file per family. Owned by the PanelScene; main thread.
#pragma once
#include "hmi/model/property_key.h"
#include "hmi/texts/catalog.h"
#include "hmi/view/paint/panel_theme.h"
#include "hmi/view/paint/text_box.h"
#include "hmi/view/scene/requests.h"
#include "hmi/view/scene/value_source.h"

#include <QElapsedTimer>
#include <QPainter>

namespace plc::hmi {

class PanelScene;

/// What conditions and motion make of an element at present.
struct Appearance {
    bool visible = true, enabled = true, blinks = false;
    QColor color, textColor; // invalid: the element's own
    double moveX = 0, moveY = 0, rotation = 0;
    bool operator==(const Appearance&) const = default;
};

class ElementView {
public:
    ElementView(const Element& element, PanelScene& scene);
    virtual ~ElementView();
    ElementView(const ElementView&) = delete;
    ElementView& operator=(const ElementView&) = delete;

    const Element& element() const { return m_element; }
    const QRectF& rect() const { return m_rect; }
    const Appearance& appearance() const { return m_appearance; }
    /// Reads properties and asks for bindings; once after construction and after each change of the element.
    void prepare();
    /// Reads the values; true if the look changed.
    bool refresh();
    /// The blink phase turned, or the animation went on; true if that shows.
    bool tick(qint64 frame);
    /// Local coordinates: (0, 0) is the element's upper left corner. The scene has applied motion and rotation.
    void paint(QPainter& painter);
    /// How far the painting may reach beyond the rectangle.
    virtual double overhang() const { return 3; }

    virtual bool isInteractive() const { return false; }
    virtual void press(QPointF) {}
    virtual void move(QPointF) {}
    virtual void release(QPointF, bool /*inside*/) {}
    virtual void wheel(double /*steps*/) {}
    /// The area that reacts, at least 44 px for fingers.
    virtual QRectF touchArea() const;
    bool isPressed() const { return m_pressed; }
    void setPressed(bool pressed);

    /// Every text of the element with its place, in a language; all states of it, not only the present one.
    virtual void collectTexts(const QString& tag, std::vector<TextBox>& out) const;
    /// Reasons of bindings that gave no value.
    QStringList problems() const;
    /// The expressions the element has bound, for tests and the designer.
    QStringList boundExpressions() const;
    virtual int currentPage() const { return -1; }

protected:
    friend class PanelScene;
    /// A place among the element's values.
    struct Slot {
        int index = -1;
        bool isBound() const { return index >= 0; }
    };

    virtual void setUp() = 0;
    /// Values changed; returns whether the look did.
    virtual bool update() { return true; }
    virtual void draw(QPainter& painter) = 0;
    virtual bool advance(qint64 /*frame*/) { return false; }

    Slot bindProperty(PropertyKey<PropertyUse::Text> property);
    Slot bindExpression(const QString& expression);
    /// One row of the property "states": what is shown when the value is that of `value`.
    struct BoundState {
        Slot value;
        QString text;
        QColor color, textColor;
        bool blinks = false;
    };
    std::vector<BoundState> bindStates();
    const Value& value(Slot slot) const;
    ValueFacts facts(Slot slot) const;
    BindingId binding(Slot slot) const;
    QString expression(Slot slot) const;
    /// A number to draw: of the binding, else (in the designer) the sample, else nothing.
    std::optional<double> number(Slot slot, double sample) const;
    bool isTrue(Slot slot, bool sample = false) const;

    const Element& properties() const { return m_element; }
    // Properties by name; one that elements.def does not have does not compile.
    QString text(PropertyKey<PropertyUse::Text> property) const { return m_element.text(property); }
    double num(PropertyKey<PropertyUse::Number> property) const { return m_element.number(property); }
    bool flag(PropertyKey<PropertyUse::Flag> property) const { return m_element.isSet(property); }
    QColor color(PropertyKey<PropertyUse::Color> property) const;
    QColor colorOr(const QString& name, const QColor& fallback) const;
    /// The element's colour unless a condition gives another.
    QColor stateColor(const QColor& own) const { return m_appearance.color.isValid() ? m_appearance.color : own; }
    QColor inkColor(const QColor& own) const { return m_appearance.textColor.isValid() ? m_appearance.textColor : own; }
    const PanelTheme& theme() const;
    PanelScene& scene() const { return m_scene; }
    bool isDesigning() const;
    double width() const { return m_rect.width(); }
    double height() const { return m_rect.height(); }
    QRectF box() const { return {0, 0, m_rect.width(), m_rect.height()}; }
    bool isLit() const; // the bright half of the blink phase

    /// Language of the element: its fixed one or the panel's.
    QString tag() const;
    QLocale locale() const { return localeOf(tag()); }
    QFont font(double pixelSize, bool bold = false, const QString& tag = {}) const;
    /// Figures with units and the like read from left to right in every script.
    QString leftToRight(const QString& words, const QString& forTag = {}) const;
    QString shown(const QString& reference, const QString& tag = {}) const; // text filled with the element's values
    TextBox textBox(const QString& text, const QRectF& rect, double pixelSize, TextAlign align, const char* property,
                    bool bold = false, const QString& tag = {}) const;
    UnitView unit(PropertyKey<PropertyUse::Text> property = "unit", const QString& tag = {}) const;
    QString formatted(double raw, std::string_view format, const UnitView& unit, const QString& tag = {}) const;

    void write(const QString& target, const Value& value, const QString& confirm = {});
    /// The value that was just asked for, until the PLC shows it or half a second has passed; else the PLC's value.
    Value echoed(Slot slot) const { return m_echo ? *m_echo : value(slot); }
    void echo(const Value& value);
    /// The number in the type of the target.
    Value typed(Slot slot, double number) const;
    void repaint();

    bool m_blinking = false;        // set by draw(): something of the element's own blinks
    mutable bool m_isMarked = true; // to be painted; the scene's

private:
    void evaluateAppearance();
    void paintLock(QPainter& painter) const;
    struct Bound {
        BindingId id;
        QString expression;
        Value last;
    };
    struct Rule {
        Slot condition;
        QColor color, textColor;
        bool blink, visible, enabled;
    };
    Element m_element;
    PanelScene& m_scene;
    QRectF m_rect;
    std::vector<Bound> m_bound;
    std::vector<Rule> m_rules;
    Slot m_visible, m_enabled, m_moveX, m_moveY, m_rotate;
    std::vector<std::pair<QString, Slot>> m_textValues;
    Appearance m_appearance;
    std::optional<Value> m_echo;
    qint64 m_echoUntil = -1;
    bool m_pressed = false, m_fresh = true, m_hasProblem = false;
};

/// A value with its colour for limits: the priority's colour beyond low-low or high-high, the warning's beyond low or
/// high.
struct Limits {
    std::optional<double> lowLow, low, high, highHigh;
    static Limits of(const Element& element);
    /// 0 normal, 3 warning, 1 alarm (priorities of PanelTheme::priority).
    int priorityAt(double value) const;
};

/// Makes the view of an element's kind. The scene knows no kinds: whoever makes a scene says what makes its views.
using MakeElementView = std::unique_ptr<ElementView> (*)(const Element& element, PanelScene& scene);

} // namespace plc::hmi
