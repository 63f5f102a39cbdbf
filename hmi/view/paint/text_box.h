// A text with the place it is drawn into. Elements draw through it, and the check measures the same boxes in every
// language with the real font. Values; main thread (fonts).
#pragma once
#include <QColor>
#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>

namespace plc::hmi {

enum class TextAlign { Start, Center, End };

struct TextBox {
    QString text;
    QRectF rect;
    QFont font;
    TextAlign align = TextAlign::Center;
    bool wraps = false;
    bool rightToLeft = false;
    QString property; // where the text comes from: "text", "states[2].text"
    Qt::Alignment vertical = Qt::AlignVCenter;
};

/// Size that the text needs; of a wrapped one at the box's width.
QSizeF neededSize(const TextBox& box);
bool fits(const TextBox& box);
/// Draws with the painter's pen; what does not fit ends with "…".
void drawText(QPainter& painter, const TextBox& box);
TextAlign textAlign(const QString& name);

} // namespace plc::hmi
