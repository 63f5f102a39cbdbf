// Views that set a number by dragging: slider and turning knob.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

/// A number between two limits that the finger moves; written at most every 100 ms while moving and once at the end.
class DraggedNumberView : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void wheel(double steps) override;

protected:
    void setUp() override;
    bool update() override;
    double share() const; // 0…1 of what is shown
    double shownNumber() const;
    void drag(double share);
    void finish();
    QString valueText(double raw, const QString& tag) const { return formatted(raw, "format", unit("unit", tag), tag); }

    Slot m_target;
    std::optional<double> m_value, m_dragged;
    bool m_isKnown = false;

private:
    QElapsedTimer m_sinceWrite;
};

class SliderView final : public DraggedNumberView {
public:
    using DraggedNumberView::DraggedNumberView;
    void press(QPointF at) override { drag(shareAt(at)); }
    void move(QPointF at) override { drag(shareAt(at)); }
    void release(QPointF, bool) override { finish(); }
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void draw(QPainter& painter) override;

private:
    bool isVertical() const;
    QRectF track() const;
    double shareAt(QPointF at) const;
    TextBox label(double raw, const QString& tag) const;
};

class KnobView final : public DraggedNumberView {
public:
    using DraggedNumberView::DraggedNumberView;
    void press(QPointF at) override;
    void move(QPointF at) override;
    void release(QPointF, bool) override { finish(); }
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void draw(QPainter& painter) override;

private:
    QPointF center() const { return {width() / 2, height() * 0.46}; }
    double radius() const;
    double shareAt(QPointF at) const;
    TextBox label(double raw, const QString& tag) const;
    double m_lastAngle = 0;
};

} // namespace plc::hmi
