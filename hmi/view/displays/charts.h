// Views that draw charts: bars of an array, a curve over x with an operating point, a trend over time.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

class ChartView : public ElementView {
public:
    using ElementView::ElementView;

protected:
    struct Axis {
        double from = 0, to = 1;
        double share(double value) const { return to == from ? 0 : (value - from) / (to - from); }
    };
    void drawGround(QPainter& painter, const QRectF& plot) const;
    void drawVerticalAxis(QPainter& painter, const QRectF& plot, const Axis& axis, const QString& format) const;
    void drawHorizontalAxis(QPainter& painter, const QRectF& plot, const Axis& axis, const QString& format,
                            const QString& unitOfLast = {}) const;
    TextBox titleBox(std::string_view property, const QRectF& area, TextAlign align, const QString& tag) const;
    double fontSize() const { return num("fontSize"); }
};

class BarChartView final : public ChartView {
public:
    using ChartView::ChartView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    QRectF plot() const;
    QString barText(size_t index, const QString& tag) const;
    TextBox label(size_t index, size_t count, const QString& tag) const;
    Slot m_value;
    Limits m_limits;
    std::vector<double> m_bars;
};

class XyChartView final : public ChartView {
public:
    using ChartView::ChartView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    QRectF plot() const;
    TextBox xTitle(const QString& tag) const;
    TextBox yTitle(const QString& tag) const;
    Slot m_x, m_y, m_pointX, m_pointY;
    std::vector<QPointF> m_curve;
    std::optional<QPointF> m_point;
};

class TrendChartView final : public ChartView {
public:
    using ChartView::ChartView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;
    bool advance(qint64 milliseconds) override;

private:
    QColor standardColor(const Properties& series, int index) const;
    QString shownUnit() const;
    struct Series {
        Slot value;
        QString title;
        QColor color;
        bool holds;
        std::vector<CurvePiece> pieces;
    };
    QRectF plot() const;
    void read();
    TextBox legend(size_t series, const QString& tag) const;
    std::vector<Series> m_series;
    qint64 m_nextRead = 0;
    quint64 m_revision = 0;
};

} // namespace plc::hmi
