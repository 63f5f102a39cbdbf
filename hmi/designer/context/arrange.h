// What the designer does to several elements at once, as edits: align, distribute, size, order, group, copy, array.
// Pure functions over a panel; any thread.
#pragma once
#include "hmi/model/edit.h"

#include <functional>

namespace plc::hmi {

using ElementIds = std::vector<ElementId>;

enum class Alignment { Left, CenterX, Right, Top, CenterY, Bottom };
enum class Direction { Horizontal, Vertical };
enum class SameSize { Width, Height, Both };
enum class Order { Front, Forward, Backward, Back };

QRectF boundsOf(const Panel& panel, const ElementIds& ids);
/// To the bounds of the selection; a single element to the panel.
Edit align(const Panel& panel, const ElementIds& ids, Alignment alignment);
/// Equal gaps between the first and the last.
Edit distribute(const Panel& panel, const ElementIds& ids, Direction direction);
/// As large as the first selected one.
Edit makeSameSize(const Panel& panel, const ElementIds& ids, SameSize what);
Edit reorder(const Panel& panel, const ElementIds& ids, Order order);
/// Puts the elements into a new group; `group` receives its id.
Edit makeGroup(const Panel& panel, const ElementIds& ids, ElementId* group = nullptr);
/// A group that lays the elements out ("row", "column", "grid"), in the order in which they are seen. One group that is
/// selected alone takes the layout itself.
Edit layOut(const Panel& panel, const ElementIds& ids, const char* layout, ElementId* group = nullptr);
Edit dissolveGroups(const Panel& panel, const ElementIds& ids);
Edit setLocked(const Panel& panel, const ElementIds& ids, bool locked);

/// The elements with all that lies in them, as the clipboard holds them.
Json copied(const Panel& panel, const ElementIds& ids);
/// Around copied elements, where they were.
QRectF boundsOf(const Json& elements);
/// New ids; the upper left corner at `at`, or a little beside the original place. `added` receives the outermost ones.
Edit pasted(const Panel& panel, const Json& elements, std::optional<QPointF> at, ElementIds* added = nullptr);

struct ArrayLayout {
    int count = 8;   // copies including the original
    int columns = 1; // copies beside each other before the next row
    QPointF gap{8, 8};
    int indexStep = 1;
};
/// Copies in rows; the first index in each binding (`Motor[1]`) and the last number of each text count up.
Edit duplicatedAsArray(const Panel& panel, const ElementIds& ids, const ArrayLayout& layout,
                       ElementIds* added = nullptr);
/// A faceplate for every element of an array: the one that is there is that of the first index.
struct ArrayArrangement {
    QString array;     // "Plant.Valves"
    QString parameter; // gets "Plant.Valves[3]"
    int first = 1, last = 1;
    int columns = 1;
    QPointF gap{8, 8};
};
/// `#` in the other arguments (the text "V#", the key "@valve.#") is the index.
Edit arrangedOverArray(const Panel& panel, const ElementId& faceplate, const ArrayArrangement& arrangement,
                       ElementIds* added = nullptr);
/// `Motor[1].on` → `Motor[3].on` for a shift of 2.
QString withShiftedIndex(const QString& expression, int shift);

/// Makes other expressions of all bindings of the panel.
Edit withExpressions(const Panel& panel, const std::function<QString(const QString& expression)>& renamed);
/// Renames a variable's path: `Main.start` → `Main.go`, also `main.START.x`, never inside other names or texts.
QString withRenamedPath(const QString& expression, const QString& from, const QString& to);
/// Renames a member behind the paths that `isBase` accepts: `Main.m1.speed` → `Main.m1.velocity`, `$motor.speed` too.
QString withRenamedMember(const QString& expression, const QString& from, const QString& to,
                          const std::function<bool(const QString& base)>& isBase);
/// Renames a key of the text table wherever the panel uses it.
Edit renamedKey(const Panel& panel, const QString& from, const QString& to);

} // namespace plc::hmi
