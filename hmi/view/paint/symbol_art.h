// Our own machine symbols: SVG texts with places for colours, level and movement, drawn once per look and kept.
// Main thread.
#pragma once
#include <QColor>
#include <QPixmap>
#include <QStringList>

namespace plc::hmi {

struct SymbolLook {
    QString symbol;
    QColor body, line, accent, ground;
    int level = 0;   // percent, for vessels
    int frame = 0;   // 0 … kSymbolFrames - 1 of the movement
    int quarter = 0; // 0 right, 1 down, 2 left (mirrored), 3 up
    bool operator==(const SymbolLook&) const = default;
};

inline constexpr int kSymbolFrames = 12;

QStringList symbolNames();
/// Whether the symbol has parts that move when it runs.
bool isMoving(const QString& symbol);
bool hasLevel(const QString& symbol);
/// The picture at this size in device pixels; from the store if this look was drawn before.
QPixmap symbolPixmap(const SymbolLook& look, QSize size);

} // namespace plc::hmi
