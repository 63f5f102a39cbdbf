// What a chart's drawing is made of: one item for each step, transition and action block, one for all lines, one that
// shows where something that is dragged would go. Items know their part by index and draw it from the scene. Owned by
// the scene; GUI thread.
#pragma once
#include "editor/graph/chart/chart_scene.h"

#include <QGraphicsItem>

namespace plc::editor {

inline constexpr double kStepHeight = 40, kStepLeast = 92, kActionHeight = 24, kTransitionRow = 52, kBarRow = 22,
                        kGap = 36;
inline constexpr double kQualifierLeast = 26, kBarHalf = 15, kActionGap = 18, kIndicatorPad = 12, kCoverageStrip = 3;

[[nodiscard]] const QFont& chartFont();
[[nodiscard]] double widthOf(const QString& text);
[[nodiscard]] QString qualifierOf(const syntax::ActionAssociation& action, std::string_view text);
[[nodiscard]] QString indicatorsOf(const syntax::ActionAssociation& action);
[[nodiscard]] double qualifierWidth(const QString& qualifier);

class ChartItem : public QGraphicsItem {
public:
    ChartItem(ChartScene& scene, ChartScene::ItemKind kind, int index, int sub, const QRectF& rect);
    [[nodiscard]] QRectF boundingRect() const override {
        return m_rect.adjusted(m_kind == ChartScene::Transition ? -40 : -16, -8, 8, 8);
    }
    [[nodiscard]] QPainterPath shape() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    void paintStep(QPainter& painter, bool isSmall) const;
    void paintTransition(QPainter& painter, bool isSmall) const;
    void paintAction(QPainter& painter, bool isSmall) const;
    void paintBreakpoint(QPainter& painter, QPointF at, const QHash<int, bool>& marks) const;

    ChartScene& m_scene;
    ChartScene::ItemKind m_kind;
    int m_index, m_sub;
    QRectF m_rect;
};

/// All lines, bars and arrows in one item: they cannot be picked and are redrawn together.
class ChartLines : public QGraphicsItem {
public:
    struct Stroke {
        QLineF line;
        double width = 1.3;
    };
    struct Arrow {
        QPointF tip;
        QString target;
    };
    /// By height, so that a part of a long chart is drawn without looking at all of it.
    void finish();
    std::vector<Stroke> strokes;
    std::vector<Arrow> arrows;
    bool isFaint = false;

    [[nodiscard]] QRectF boundingRect() const override { return m_bounds; }
    [[nodiscard]] QPainterPath shape() const override { return {}; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override;

private:
    QRectF m_bounds;
    double m_longest = 0;
};

/// Where a drop would go: a bar at a place, or a frame around a part.
class ChartDropHint : public QGraphicsItem {
public:
    ChartDropHint();
    void showAt(const QRectF& rect, const QString& text, bool isAllowed);
    [[nodiscard]] QRectF boundingRect() const override { return m_rect.adjusted(-4, -4, 260, 30); }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override;

private:
    QRectF m_rect;
    QString m_text;
    bool m_isAllowed = true;
};

} // namespace plc::editor
