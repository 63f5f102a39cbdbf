// How a panel takes a screen of other proportions: elements keep their distance to the edges that they are anchored to,
// and what lies in rows and grids gets its cell.
// Pure functions, any thread.
#pragma once
#include "hmi/model/panel.h"

namespace plc::hmi {

/// The panel's size for a screen: as large as designed in one direction, longer in the other, so that it fills the
/// screen at one scale. Its own size where it does not adapt.
QSizeF sizeFor(const Panel& panel, QSizeF screen);
/// The panel with that size: each element placed by its anchors, what is in a group by the group's new
/// rectangle: by its cells if it has any, else by anchors.
Panel laidOut(const Panel& panel, QSizeF size);
/// Whether the panel's elements are placed by their anchors.
bool isAdapting(const Panel& panel);

} // namespace plc::hmi
