// Where the parts of a diagram stand: a grid of columns (one character wide) and lines, computed from the diagram
// alone, so that the same text gives the same drawing on paper, on screen and in characters. Values, any thread.
#pragma once
#include "runtime/compiler/ladder/diagram.h"

namespace plc::ladder {

enum class ShapeKind : uint8_t {
    Wire,    // from (x, y) to (x + w, y + h); one of w, h is 0
    Rail,    // down from (x, y)
    Text,    // w columns from x
    Contact, // two bars at x and x + w, `text` between them
    Coil,    // ( ) at x and x + w, `text` between them
    Box,     // a frame of w × h
    Circle,  // an inverted pin
    Nest,    // beside what a frame repeats or chooses
    Arrow,   // a long rung goes on in the next line
};
enum class TextRole : uint8_t {
    Operand,
    Title, // of a box
    Pin,
    Instance, // of a block
    Order,    // of execution
    Heading,  // title of a network, head of a frame
    Note,     // comment
    Code,     // ST box
    Number,   // of a rung
    Address,  // of a variable
    Comment,  // of a variable
};
enum class Align : uint8_t { Left, Middle, Right };

/// Wires end and bars stand in the middle of a cell; a text fills cells.
struct Shape {
    ShapeKind kind = ShapeKind::Wire;
    NodeId node; // Wire: whose result it carries, none: the rail's; else what the shape belongs to
    int x = 0, y = 0, w = 0, h = 0;
    std::string text{};
    TextRole role = TextRole::Operand;
    Align align = Align::Left;
    bool isDouble = false; // AND_THEN, OR_ELSE
    int pin = -1;          // Text: number of the box's output that is written
    bool isMarked = false; // Text: reads the value of the scan before; Wire: a feedback
};
/// What a click or the keyboard selects.
struct Hit {
    NodeId node;
    int x = 0, y = 0, w = 0, h = 0; // cells
};
struct RungPicture {
    int top = 0;
    int width = 0, height = 0;
    std::vector<Shape> shapes; // y from the rung's top
    std::vector<Hit> hits;     // inner parts after those around them
};
struct Layout {
    int width = 0, height = 0;
    std::vector<RungPicture> rungs; // by RungId
};

/// What stands above a contact or coil.
enum class Naming : uint8_t {
    Symbols,
    Addresses, // in the place of the name, where the variable has one
    Both,
};

struct LayoutOptions {
    int wrapAt = 116;           // columns; a longer rung goes on in the next line
    int leastWidth = 64;        // columns to the right rail
    bool showsNotes = true;     // comments above the rungs
    bool showsComments = false; // of the variables, above their contacts and coils
    Naming naming = Naming::Symbols;
    bool operator==(const LayoutOptions&) const = default;
};

[[nodiscard]] Layout computeLayout(const Diagram& diagram, const LayoutOptions& options = {});

/// Characters, not bytes.
[[nodiscard]] int columnsOf(std::string_view utf8);

} // namespace plc::ladder
