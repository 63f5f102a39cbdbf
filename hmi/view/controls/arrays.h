// Views of arrays that are operated: a grid of cells and an editable table.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

class CellGridView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return text("action") != QStringLiteral("none"); }
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    int rows() const { return std::max(1, element().integer("rows")); }
    int columns() const { return std::max(1, element().integer("columns")); }
    QRectF cell(int row, int column) const;
    int stateOf(const Value& value) const;
    TextBox label(const QString& words, const QRectF& area, const QByteArray& place, const QString& tag) const;
    Slot m_value;
    std::vector<BoundState> m_states;
    std::vector<Value> m_cells;
};

class ArrayTableView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void press(QPointF at) override;
    void move(QPointF at) override;
    void release(QPointF at, bool inside) override;
    void wheel(double steps) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    /// What the designer shows before there are columns.
    void drawSample(QPainter& painter);
    struct Column {
        QString title, value, format, unit;
        bool editable;
        double width;
    };
    double headHeight() const;
    double rowHeight() const;
    int visibleRows() const;
    int count() const { return std::max(0, element().integer("count")); }
    QRectF cell(int visibleRow, size_t column) const; // row -1 is the header
    QRectF mirrored(const QRectF& area) const;
    TextBox header(size_t column, const QString& tag) const;
    QString contents(const Value& value, const Column& column) const;
    void scrollTo(int top);
    std::vector<Column> m_columns;
    std::vector<std::vector<Slot>> m_cells; // by visible row, column
    Slot m_selectedTarget;
    int m_top = 0, m_selected = -1;
    QPointF m_pressedAt;
    int m_pressedTop = 0;
    bool m_scrolled = false;
};

} // namespace plc::hmi
