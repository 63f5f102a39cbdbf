#include "runtime/compiler/ladder/picture.h"

#include "runtime/base/text.h"
#include "runtime/base/xml_text.h"

#include <array>
#include <cstdio>

namespace plc::ladder {

namespace {

// ---------------------------------------------------------------- characters

enum Side : uint8_t { Up = 1, Down = 2, Left = 4, Right = 8 };

class Characters {
public:
    Characters(int width, int height)
        : m_width(width + 2), m_height(height + 1),
          m_sides(static_cast<size_t>(m_width) * static_cast<size_t>(m_height)), m_glyphs(m_sides.size()) {}

    void draw(const RungPicture& rung) {
        for (const Shape& shape : rung.shapes)
            if (shape.kind != ShapeKind::Text) line(shape, rung.top);
        for (const Shape& shape : rung.shapes)
            if (shape.kind == ShapeKind::Text)
                write(shape.x, rung.top + shape.y, shape.text + (shape.isMarked ? "↺" : ""));
    }

    std::string text() const {
        std::string out;
        for (int y = 0; y < m_height; ++y) {
            std::string row;
            for (int x = 0; x < m_width; ++x) {
                const char32_t glyph = m_glyphs[at(x, y)];
                appendUtf8(row, glyph ? glyph : boxGlyph(m_sides[at(x, y)]));
            }
            const size_t end = row.find_last_not_of(' ');
            out += row.substr(0, end == std::string::npos ? 0 : end + 1) + "\n";
        }
        while (out.ends_with("\n\n")) out.pop_back();
        return out;
    }

private:
    [[nodiscard]] size_t at(int x, int y) const {
        return static_cast<size_t>(y) * static_cast<size_t>(m_width) + static_cast<size_t>(x);
    }
    [[nodiscard]] bool isInside(int x, int y) const { return x >= 0 && y >= 0 && x < m_width && y < m_height; }

    static char32_t boxGlyph(uint8_t sides) {
        static constexpr std::array<char32_t, 16> glyphs = {U' ', U'│', U'│', U'│', U'─', U'┘', U'┐', U'┤',
                                                            U'─', U'└', U'┌', U'├', U'─', U'┴', U'┬', U'┼'};
        return glyphs[sides];
    }

    void join(int x, int y, int sides) {
        if (isInside(x, y)) m_sides[at(x, y)] = static_cast<uint8_t>(m_sides[at(x, y)] | sides);
    }
    void across(int x, int y, int toX) {
        for (int i = x; i <= toX; ++i) join(i, y, (i > x ? Left : 0) | (i < toX ? Right : 0));
    }
    void down(int x, int y, int toY) {
        for (int i = y; i <= toY; ++i) join(x, i, (i > y ? Up : 0) | (i < toY ? Down : 0));
    }
    void write(int x, int y, const std::string& text) {
        for (size_t i = 0; i < text.size(); ++x) {
            const char32_t glyph = decodeUtf8(text, i);
            if (isInside(x, y)) m_glyphs[at(x, y)] = glyph;
        }
    }

    void line(const Shape& s, int top) {
        const int y = top + s.y;
        switch (s.kind) {
        case ShapeKind::Wire:
            return s.h == 0 ? across(s.x, y, s.x + s.w) : down(s.x, y, y + s.h);
        case ShapeKind::Rail:
        case ShapeKind::Nest:
            for (int i = 0; i < s.h; ++i) join(s.x, y + i, Up | Down);
            return;
        case ShapeKind::Contact:
            join(s.x, y, Up | Down);
            join(s.x + s.w, y, Up | Down);
            return write(s.x + 1 + (s.w - 1 - columnsOf(s.text)) / 2, y, s.text);
        case ShapeKind::Coil:
            return write(s.x, y, "(" + s.text + ")");
        case ShapeKind::Box:
            across(s.x, y, s.x + s.w);
            across(s.x, y + s.h, s.x + s.w);
            down(s.x, y, y + s.h);
            return down(s.x + s.w, y, y + s.h);
        case ShapeKind::Circle:
            return write(s.x, y, "○");
        case ShapeKind::Arrow:
            return write(s.x, y, s.text);
        case ShapeKind::Text:
            return;
        }
    }

    int m_width, m_height;
    std::vector<uint8_t> m_sides;
    std::vector<char32_t> m_glyphs;
};

// ---------------------------------------------------------------- SVG

std::string number(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.2f", value);
    std::string text = buffer;
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

double middleX(int x) { return (x + 0.5) * kCellWidth; }
double middleY(int y) { return (y + 0.5) * kCellHeight; }

std::string_view classOf(TextRole role) {
    switch (role) {
    case TextRole::Operand:
    case TextRole::Code:
        return "t";
    case TextRole::Title:
    case TextRole::Heading:
        return "t b";
    case TextRole::Pin:
    case TextRole::Order:
    case TextRole::Number:
    case TextRole::Note:
        return "t m";
    case TextRole::Comment:
        return "t m";
    case TextRole::Address:
    case TextRole::Instance:
        return "t i";
    }
    return "t";
}

class Svg {
public:
    explicit Svg(Symbols symbols) : m_symbols(symbols) {}
    void draw(const RungPicture& rung) {
        for (const Shape& shape : rung.shapes) draw(shape, rung.top);
    }
    std::string body;

private:
    void path(const std::string& d, std::string_view kind) {
        body += "<path class=\"" + std::string(kind) + "\" d=\"" + d + "\"/>\n";
    }
    static std::string point(double x, double y) { return number(x) + " " + number(y); }

    void text(double x, double y, std::string_view what, std::string_view kind, std::string_view anchor) {
        if (what.empty()) return;
        body += "<text class=\"" + std::string(kind) + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\"";
        if (anchor != "start") body += " text-anchor=\"" + std::string(anchor) + "\"";
        body += " xml:space=\"preserve\">" + xmlText(what) + "</text>\n";
    }

    /// A lever over a gap: away from the contact, or against it.
    void lever(const Shape& s, double y) {
        const double left = middleX(s.x), right = middleX(s.x + s.w);
        if (s.text == "/")
            return path("M" + point(left, y) + "L" + point(right + 2, y - 8) + "M" + point(right, y) + "V" +
                            number(y - 8),
                        "w k");
        path("M" + point(left, y) + "L" + point(right - 2, y - 9), "w k");
    }

    void rectangle(const Shape& s, double y) {
        const double left = middleX(s.x), right = middleX(s.x + s.w);
        path("M" + point(left - 1, y - 7) + "H" + number(right + 1) + "V" + number(y + 7) + "H" + number(left - 1) +
                 "Z",
             "w k");
        if (s.text == "/") return path("M" + point(left - 1, y + 7) + "L" + point(right + 1, y - 7), "w");
        text((left + right) / 2, y + 4, s.text == " " ? "" : s.text, "t", "middle");
    }

    void bars(const Shape& s, double y) {
        const double left = middleX(s.x), right = middleX(s.x + s.w);
        path("M" + point(left, y - 6) + "V" + number(y + 6) + "M" + point(right, y - 6) + "V" + number(y + 6), "w k");
        if (s.text == "/") return path("M" + point(left + 1, y + 6) + "L" + point(right - 1, y - 6), "w");
        if (s.text != " ") text((left + right) / 2, y + 4, s.text, "t", "middle");
    }

    void draw(const Shape& s, int top) {
        const double x = middleX(s.x), y = middleY(top + s.y);
        switch (s.kind) {
        case ShapeKind::Wire:
            path("M" + point(x, y) +
                     (s.h == 0 ? "H" + number(middleX(s.x + s.w)) : "V" + number(middleY(top + s.y + s.h))),
                 s.isDouble ? "w k" : "w");
            return;
        case ShapeKind::Rail:
            return path("M" + point(x, (top + s.y) * kCellHeight) + "V" + number((top + s.y + s.h) * kCellHeight), "r");
        case ShapeKind::Nest:
            return path("M" + point(x, (top + s.y) * kCellHeight) + "V" + number((top + s.y + s.h + 1) * kCellHeight),
                        "n");
        case ShapeKind::Contact:
            return m_symbols == Symbols::Circuit && (s.text == " " || s.text == "/") ? lever(s, y) : bars(s, y);
        case ShapeKind::Coil: {
            if (m_symbols == Symbols::Circuit) return rectangle(s, y);
            const double right = middleX(s.x + s.w);
            path("M" + point(x + 1, y - 7) + "Q" + point(x - 5, y) + " " + point(x + 1, y + 7) + "M" +
                     point(right - 1, y - 7) + "Q" + point(right + 5, y) + " " + point(right - 1, y + 7),
                 "w k");
            if (s.text == "/") return path("M" + point(x + 4, y + 5) + "L" + point(right - 4, y - 5), "w");
            return text((x + right) / 2, y + 4, s.text == " " ? "" : s.text, "t", "middle");
        }
        case ShapeKind::Box: {
            const double upper = s.node.isValid() ? (top + s.y) * kCellHeight + 1 : y;
            const double lower = s.node.isValid() ? (top + s.y + s.h) * kCellHeight + 5 : middleY(top + s.y + s.h);
            body += "<rect class=\"x\" x=\"" + number(x) + "\" y=\"" + number(upper) + "\" width=\"" +
                    number(s.w * kCellWidth) + "\" height=\"" + number(lower - upper) + "\"/>\n";
            return;
        }
        case ShapeKind::Circle:
            body += "<circle class=\"c\" cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\"3\"/>\n";
            return;
        case ShapeKind::Arrow:
            return text(x, y + 4, s.text, "t", "middle");
        case ShapeKind::Text: {
            const double base = y + 4;
            std::string kind(classOf(s.role));
            if (s.isMarked) kind += " f";
            const std::string what = s.text + (s.isMarked ? "↺" : "");
            if (s.align == Align::Middle) return text((s.x + s.w / 2.0) * kCellWidth, base, what, kind, "middle");
            if (s.align == Align::Right) return text((s.x + s.w) * kCellWidth, base, what, kind, "end");
            return text(s.x * kCellWidth, base, what, kind, "start");
        }
        }
    }

    Symbols m_symbols;
};

constexpr std::string_view kStyle =
    "<style>\n"
    "svg{background:#fff}.t{font:12px 'DejaVu Sans Mono',Consolas,monospace;fill:#1c2733}.b{font-weight:bold}"
    ".m{fill:#5c6b7a}.i{fill:#0b5cad}.f{fill:#8a4b00}\n"
    ".w{fill:none;stroke:#1c2733;stroke-width:1.3}.k{stroke-width:1.9}.r{fill:none;stroke:#1c2733;stroke-width:2.4}"
    ".n{fill:none;stroke:#b9c4cf;stroke-width:2}\n"
    ".x{fill:#f4f7fa;stroke:#1c2733;stroke-width:1.3}.c{fill:#fff;stroke:#1c2733;stroke-width:1.3}\n"
    "@media (prefers-color-scheme:dark){svg{background:#1b2026}.t{fill:#e4e9ee}.m{fill:#9aa7b4}.i{fill:#7db8ff}"
    ".f{fill:#ffc48a}.w,.r{stroke:#e4e9ee}.n{stroke:#46515c}.x{fill:#252c34;stroke:#e4e9ee}"
    ".c{fill:#1b2026;stroke:#e4e9ee}}\n"
    "</style>\n";

} // namespace

std::string asText(const Layout& layout) {
    Characters characters(layout.width, layout.height);
    for (const RungPicture& rung : layout.rungs) characters.draw(rung);
    return characters.text();
}

std::string asSvg(const Layout& layout, std::string_view title, Symbols symbols) {
    Svg svg(symbols);
    for (const RungPicture& rung : layout.rungs) svg.draw(rung);
    const std::string width = number((layout.width + 2) * kCellWidth + 16),
                      height = number((layout.height + 1) * kCellHeight + 16);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"-8 -8 " + width + " " + height + "\">\n<title>" + xmlText(title) + "</title>\n" +
           std::string(kStyle) + svg.body + "</svg>\n";
}

} // namespace plc::ladder
