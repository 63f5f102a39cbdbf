// What a row of the watch keeps in its first column beside the text, by role of the item. For the sources of WatchView,
// which owns the rows; GUI thread.
#pragma once
#include <Qt>

#include <cstdint>

namespace plc::editor {

inline constexpr int kExpressionRole = Qt::UserRole;
inline constexpr int kUnfoldedRole = Qt::UserRole + 1; // the version of the program whose parts the row has, from 1
inline constexpr int kFromRole = Qt::UserRole + 2;     // a stretch of a long array: its first element, from 0
inline constexpr int kFormatRole = Qt::UserRole + 3;   // the row's own number format
inline constexpr uint64_t kStretch = 1000;

} // namespace plc::editor
