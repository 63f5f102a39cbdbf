// The drawing of one ladder or function block diagram: a cache of the model, one item for each rung, redrawn with each
// text. Nothing here edits. Owned by LadderView; GUI thread.
#pragma once
#include <QGraphicsItem>
#include <QGraphicsScene> // before the standard library's: moc stumbles over <concepts> otherwise
#include <QHash>

#include "runtime/compiler/ladder/flow.h"
#include "runtime/compiler/ladder/layout.h"

#include <memory>
#include <vector>

namespace plc::editor {

/// What is selected: a part of a rung, or all of it.
struct LadderPick {
    ladder::RungId rung;
    ladder::NodeId node;
    bool operator==(const LadderPick&) const = default;
};

struct LadderProblem {
    QString text;
    bool isError = true;
};

/// What a diagram shows of a running controller, by NodeId.
struct LadderOnline {
    bool isOn = false;
    std::vector<ladder::Power> power;
    std::vector<QString> values;  // beside a pin or a box; empty: none
    std::vector<double> progress; // of a timer or counter, 0 … 1; below 0: none
    std::vector<bool> forced;
    bool operator==(const LadderOnline&) const = default;
};

class LadderScene;

/// One rung. Draws its shapes from the scene's layout.
class RungItem : public QGraphicsItem {
public:
    RungItem(LadderScene& scene, size_t index) : m_scene(scene), m_index(index) {}
    [[nodiscard]] QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override;
    void resized() { prepareGeometryChange(); }

private:
    void paintShape(QPainter& painter, const ladder::Shape& shape) const;
    void paintText(QPainter& painter, const ladder::Shape& shape) const;
    void paintGlyph(QPainter& painter, const ladder::Shape& shape) const;
    void paintBox(QPainter& painter, const ladder::Shape& shape) const;
    void paintSelection(QPainter& painter) const;
    void paintProblems(QPainter& painter) const;
    [[nodiscard]] QColor inkOf(ladder::NodeId node, bool isWire) const;

    LadderScene& m_scene;
    size_t m_index;
};

class LadderScene : public QGraphicsScene {
    Q_OBJECT
public:
    explicit LadderScene(QObject* parent = nullptr);

    /// Diagram and layout must outlive the next call.
    void show(const ladder::Diagram& diagram, const ladder::Layout& layout);
    void forget();
    void setFaint(bool faint);
    void setOnline(LadderOnline online);
    void setMarks(std::vector<int> marks); // by RungId: 0 none, 1 breakpoint, -1 disabled
    void setProblems(QHash<uint32_t, LadderProblem> byNode, QHash<uint32_t, LadderProblem> byRung);
    void select(LadderPick pick);

    [[nodiscard]] const LadderPick& picked() const { return m_pick; }
    [[nodiscard]] LadderPick pickAt(QPointF point) const;
    [[nodiscard]] QRectF rectOf(const LadderPick& pick) const;
    /// What can be selected, rung by rung, in reading order.
    [[nodiscard]] std::vector<LadderPick> picksOf(ladder::RungId rung) const;
    [[nodiscard]] const LadderOnline& online() const { return m_online; }
    [[nodiscard]] QString problemAt(const LadderPick& pick) const;
    [[nodiscard]] size_t problemCount() const {
        return static_cast<size_t>(m_nodeProblems.size() + m_rungProblems.size());
    }
    [[nodiscard]] double cellWidth() const { return m_cellWidth; }
    [[nodiscard]] double cellHeight() const { return m_cellHeight; }
    void refreshTheme() { update(); }

private:
    friend class RungItem;
    [[nodiscard]] QRectF cells(const ladder::Hit& hit) const;

    const ladder::Diagram* m_diagram = nullptr;
    const ladder::Layout* m_layout = nullptr;
    std::vector<std::unique_ptr<RungItem>> m_items;
    LadderPick m_pick;
    LadderOnline m_online;
    std::vector<int> m_marks;
    QHash<uint32_t, LadderProblem> m_nodeProblems, m_rungProblems;
    bool m_isFaint = false;
    double m_cellWidth = 7, m_cellHeight = 17;
};

} // namespace plc::editor
