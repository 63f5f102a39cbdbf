// A small window of colours to choose from: the chart colours, a spread of hues and greys, "none", and the full dialog.
// Owned by its Qt parent; GUI thread.
#pragma once

#include <QFrame>

namespace plc::kit {

class ColorPopup : public QFrame {
    Q_OBJECT
public:
    explicit ColorPopup(const QColor& current, bool offersNone, QWidget* parent = nullptr);

    /// Places the window below a rectangle given in global coordinates and shows it.
    void openBelow(const QRect& global);
    static const std::vector<QColor>& swatches();

signals:
    void hovered(const QColor& color);
    void chosen(const QColor& color);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QRect cell(int index) const;
    int cellAt(const QPoint& point) const;
    void choose(const QColor& color);
    void point(int index);

    QColor m_current;
    int m_hot = -1;
};

} // namespace plc::kit
