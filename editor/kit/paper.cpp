#include "editor/kit/paper.h"

#include "editor/kit/theme.h"

#include <QGraphicsItem>
#include <QGraphicsScene>
#include <QPainter>
#include <QPrinter>

#include <algorithm>
#include <utility>

namespace plc::kit {
namespace {

const ThemeColors* g_paper = nullptr;

constexpr double kScreenDpi = 96;

constexpr double kOverlap = 14; // items claim a little more room than they draw in

/// Where one item follows another from top to bottom, in order.
std::vector<double> cutsOf(const QGraphicsScene& scene) {
    std::vector<std::pair<double, double>> spans; // top, bottom
    for (const QGraphicsItem* item : scene.items()) {
        if (item->parentItem() || !item->isVisible()) continue;
        const QRectF rect = item->sceneBoundingRect();
        spans.emplace_back(rect.top(), rect.bottom());
    }
    std::sort(spans.begin(), spans.end());
    std::vector<double> cuts;
    double reached = 0;
    for (size_t i = 0; i < spans.size(); ++i) {
        const auto& [top, bottom] = spans[i];
        if (i > 0 && top >= reached - kOverlap) cuts.push_back((top + std::max(top, reached)) / 2);
        reached = i > 0 ? std::max(reached, bottom) : bottom;
    }
    return cuts;
}

void drawHead(QPainter& painter, const QRectF& room, const QString& title, size_t page, size_t pages) {
    painter.setPen(colors().muted);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignTop, title);
    painter.drawText(room, Qt::AlignRight | Qt::AlignTop, QStringLiteral("%1 / %2").arg(page).arg(pages));
}

} // namespace

PaperColors::PaperColors() : m_before(std::exchange(g_paper, &lightColors())) {}
PaperColors::~PaperColors() { g_paper = m_before; }
const ThemeColors* PaperColors::current() { return g_paper; }

std::vector<QRectF> pagesOf(const QGraphicsScene& scene, const QRectF& whole, double height) {
    const std::vector<double> cuts = cutsOf(scene);
    std::vector<QRectF> pages;
    for (double top = whole.top(); top < whole.bottom() - 1;) {
        double bottom = top + height;
        if (bottom >= whole.bottom()) {
            bottom = whole.bottom();
        } else {
            const auto behind = std::upper_bound(cuts.begin(), cuts.end(), bottom);
            if (behind != cuts.begin() && *std::prev(behind) > top) bottom = *std::prev(behind);
        }
        pages.emplace_back(whole.left(), top, whole.width(), bottom - top);
        top = bottom;
    }
    return pages;
}

void printScene(QPrinter& printer, QGraphicsScene& scene, const QRectF& whole, const QString& title) {
    printer.setResolution(static_cast<int>(kScreenDpi)); // fonts are in points: at a finer one they would grow twice
    QPainter painter;
    if (whole.isEmpty() || !painter.begin(&printer)) return;
    QFont font = painter.font();
    font.setPointSizeF(8);
    painter.setFont(font);
    const QSizeF paper = printer.pageLayout().paintRectPixels(printer.resolution()).size();
    const double head = painter.fontMetrics().height() * 1.8;
    const double scale = std::min(1.0, paper.width() / whole.width());
    const std::vector<QRectF> pages = pagesOf(scene, whole, (paper.height() - head) / scale);
    for (size_t i = 0; i < pages.size(); ++i) {
        if (i > 0) printer.newPage();
        drawHead(painter, QRectF(QPointF(), paper), title, i + 1, pages.size());
        painter.save();
        const QRectF target(QPointF(0, head), pages[i].size() * scale);
        painter.setClipRect(target);
        scene.render(&painter, target, pages[i]);
        painter.restore();
    }
}

} // namespace plc::kit
