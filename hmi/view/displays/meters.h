// Views of a number on a scale: bar, tank level, gauge; and of signals: light tower, float switch.
#pragma once
#include "hmi/view/scene/element_view.h"

#include <QPainterPath>

namespace plc::hmi {

/// What the meters share: value, scale and limits.
class MeterView : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    /// How far the value moves the drawing, in pixels: below a third of one nothing is repainted.
    virtual double travel() const { return std::max(width(), height()); }
    virtual TextBox valueBox(const QString& words, const QString& tag) const = 0;
    double shareOf(double raw) const;
    QColor valueColor(const QColor& normal) const;
    QString valueText(double raw, const QString& tag) const { return formatted(raw, "format", unit("unit", tag), tag); }
    QString shownValue() const { return m_words; }
    /// Round steps of the scale: about `count` between minimum and maximum, in the unit shown.
    std::vector<double> steps(int count) const;

    Slot m_value;
    Limits m_limits;
    std::optional<double> m_now;
    int m_priority = 0;
    QString m_words;
};

class BarView final : public MeterView {
public:
    using MeterView::MeterView;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;
    TextBox valueBox(const QString& words, const QString& tag) const override;

private:
    QRectF track() const;
    bool isVertical() const { return text("orientation") == QStringLiteral("vertical"); }
    QPointF at(double share, double across) const;
    Slot m_setPoint;
    std::optional<double> m_aim;
};

class TankLevelView final : public MeterView {
public:
    using MeterView::MeterView;

protected:
    void draw(QPainter& painter) override;
    TextBox valueBox(const QString& words, const QString& tag) const override;

private:
    QPainterPath vessel() const;
};

class GaugeView final : public MeterView {
public:
    using MeterView::MeterView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void draw(QPainter& painter) override;
    TextBox valueBox(const QString& words, const QString& tag) const override;

private:
    QPointF center() const;
    double radius() const;
    TextBox label(const QString& tag) const;
};

class LightTowerView final : public ElementView {
public:
    using ElementView::ElementView;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    struct Light {
        QColor color;
        Slot value, blink;
        bool on = false, blinks = false;
    };
    std::vector<Light> m_lights;
    Slot m_siren;
    bool m_sounds = false;
};

class FloatSwitchView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    TextBox label(const QString& tag) const;
    Slot m_value;
    bool m_raised = false;
    QString m_shown;
};

} // namespace plc::hmi
