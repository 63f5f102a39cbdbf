// Drawings on paper: the light colours while something is printed, and a scene cut into pages between its items.
// GUI thread; nothing here is owned by anyone for longer than one print.
#pragma once

#include <QRectF>
#include <QString>

#include <vector>

class QGraphicsScene;
class QPrinter;

namespace plc::kit {

struct ThemeColors;

/// While one lives, kit::colors() are those of the light theme: ink on white, whatever the studio looks like. Scenes
/// that keep colours take them again after it was made, and once more when it is gone.
class PaperColors {
public:
    PaperColors();
    ~PaperColors();
    PaperColors(const PaperColors&) = delete;
    PaperColors& operator=(const PaperColors&) = delete;
    /// Null when nothing is printed.
    [[nodiscard]] static const ThemeColors* current();

private:
    const ThemeColors* m_before;
};

/// Parts of `whole` from top to bottom, each at most `height` high (scene units, > 0), cut where no item is in the way;
/// an item that is higher than a page is cut through.
[[nodiscard]] std::vector<QRectF> pagesOf(const QGraphicsScene& scene, const QRectF& whole, double height);

/// As large as on the screen or, where the paper is too narrow, as wide as the paper. Each page has the title and its
/// number at the top.
void printScene(QPrinter& printer, QGraphicsScene& scene, const QRectF& whole, const QString& title);

} // namespace plc::kit
