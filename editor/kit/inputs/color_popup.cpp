#include "editor/kit/inputs/color_popup.h"

#include "editor/kit/theme.h"

#include <QColorDialog>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>

namespace plc::kit {

namespace {
constexpr int Columns = 10, Side = 22, Margin = 8;
}

const std::vector<QColor>& ColorPopup::swatches() {
    static const std::vector<QColor> all = [] {
        std::vector<QColor> result = lightColors().curves;
        for (const QColor& color : darkColors().curves) result.push_back(color);
        for (int lightness : {225, 170, 110})
            for (int i = 0; i < Columns; ++i) result.push_back(QColor::fromHsl(i * 36, i == 0 ? 180 : 170, lightness));
        for (int i = 0; i < Columns; ++i) {
            const int grey = 255 - i * 255 / (Columns - 1);
            result.emplace_back(grey, grey, grey);
        }
        return result;
    }();
    return all;
}

ColorPopup::ColorPopup(const QColor& current, bool offersNone, QWidget* parent)
    : QFrame(parent, Qt::Popup), m_current(current) {
    setAttribute(Qt::WA_DeleteOnClose);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Colours"));
    const int rows = (static_cast<int>(swatches().size()) + Columns - 1) / Columns;
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(Margin, Margin + rows * Side + 6, Margin, Margin);
    auto* more = new QPushButton(tr("More colours…"), this);
    layout->addWidget(more);
    connect(more, &QPushButton::clicked, this, [this] {
        const QColor color = QColorDialog::getColor(m_current.isValid() ? m_current : Qt::white, parentWidget(), {},
                                                    QColorDialog::ShowAlphaChannel);
        if (color.isValid())
            choose(color);
        else
            close();
    });
    if (offersNone) {
        auto* none = new QPushButton(tr("No colour"), this);
        layout->addWidget(none);
        connect(none, &QPushButton::clicked, this, [this] { choose(QColor()); });
    }
    setFixedWidth(Columns * Side + 2 * Margin);
}

void ColorPopup::openBelow(const QRect& global) {
    adjustSize();
    QPoint at = global.bottomLeft() + QPoint(0, 2);
    if (const QScreen* screen = parentWidget() ? parentWidget()->screen() : nullptr) {
        const QRect free = screen->availableGeometry();
        at.setX(std::clamp(at.x(), free.left(), std::max(free.left(), free.right() - width())));
        if (at.y() + height() > free.bottom()) at.setY(global.top() - height() - 2);
    }
    move(at);
    show();
    setFocus(Qt::PopupFocusReason); // the arrows begin at once
}

QRect ColorPopup::cell(int index) const {
    return QRect(Margin + index % Columns * Side, Margin + index / Columns * Side, Side, Side).adjusted(2, 2, -2, -2);
}

int ColorPopup::cellAt(const QPoint& point) const {
    for (int i = 0; i < static_cast<int>(swatches().size()); ++i)
        if (cell(i).adjusted(-2, -2, 2, 2).contains(point)) return i;
    return -1;
}

void ColorPopup::choose(const QColor& color) {
    emit chosen(color);
    close();
}

void ColorPopup::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), colors().raised);
    painter.setPen(colors().border);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < static_cast<int>(swatches().size()); ++i) {
        const QColor& color = swatches()[static_cast<size_t>(i)];
        const bool current = m_current.isValid() && color.rgba() == m_current.rgba();
        painter.setPen(QPen(i == m_hot || current ? colors().text : colors().border, i == m_hot || current ? 2 : 1));
        painter.setBrush(color);
        painter.drawRoundedRect(QRectF(cell(i)).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    }
}

void ColorPopup::mouseMoveEvent(QMouseEvent* event) {
    if (const int hot = cellAt(event->pos()); hot != m_hot) point(hot);
}

/// As the one that would be chosen; -1: none.
void ColorPopup::point(int index) {
    m_hot = index;
    const QColor color = index >= 0 ? swatches()[static_cast<size_t>(index)] : m_current;
    setAccessibleDescription(color.name());
    update();
    emit hovered(color);
}

void ColorPopup::keyPressEvent(QKeyEvent* event) {
    const int count = static_cast<int>(swatches().size());
    const auto found = std::find_if(swatches().begin(), swatches().end(),
                                    [&](const QColor& each) { return each.rgba() == m_current.rgba(); });
    const int now = m_hot >= 0                                         ? m_hot
                    : m_current.isValid() && found != swatches().end() ? static_cast<int>(found - swatches().begin())
                                                                       : -1;
    const auto go = [&](int by) {
        const int to = now < 0 ? 0 : now + by;
        if (to >= 0 && to < count) return point(to);
        if (by > 0) focusNextChild(); // below the colours are the buttons
    };
    switch (event->key()) {
    case Qt::Key_Left:
        return go(-1);
    case Qt::Key_Right:
        return go(1);
    case Qt::Key_Up:
        return go(-Columns);
    case Qt::Key_Down:
        return go(Columns);
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (now >= 0) choose(swatches()[static_cast<size_t>(now)]);
        return;
    default:
        QFrame::keyPressEvent(event);
    }
}

void ColorPopup::mousePressEvent(QMouseEvent* event) {
    const int hot = cellAt(event->pos());
    if (hot >= 0)
        choose(swatches()[static_cast<size_t>(hot)]);
    else
        QFrame::mousePressEvent(event);
}

void ColorPopup::leaveEvent(QEvent*) {
    m_hot = -1;
    update();
}

} // namespace plc::kit
