// The drawing of one ladder or function block diagram: a cache of the model, one item for each rung, redrawn with each
// text. Nothing here edits. Owned by LadderView; GUI thread.
#pragma once
#include <QGraphicsItem>
#include <QGraphicsScene> // before the standard library's: moc stumbles over <concepts> otherwise
#include <QHash>

#include "editor/graph/ladder/ladder_look.h"
#include "editor/kit/theme.h"
#include "runtime/compiler/ladder/edits.h"
#include "runtime/compiler/ladder/flow.h"

#include <memory>
#include <optional>
#include <vector>

namespace plc::editor {

/// What is selected: a part of a rung, or all of it.
struct LadderPick {
    ladder::RungId rung;
    ladder::NodeId node;
    bool operator==(const LadderPick&) const = default;
};

/// Where a contact comes that is put on a wire.
struct LadderGap {
    ladder::RungId rung;
    ladder::NodeId beside; // none: behind the rung's last contact
    ladder::Place place = ladder::Place::After;
    QRectF at; // on the wire
};

struct LadderProblem {
    QString text;
    bool isError = true;
};

/// What a diagram shows of a running controller, by NodeId.
struct LadderOnline {
    bool isOn = false;
    std::vector<ladder::Power> power;
    bool isExact = false;                 // what was computed there; else the values at the scan's end
    std::vector<QString> values;          // beside an operand at a pin; empty: none
    QHash<uint32_t, QStringList> outputs; // of a box, by the number of its output
    std::vector<bool> leftOut;            // by RungId: not executed in this scan
    std::vector<double> progress;         // of a timer or counter, 0 … 1; below 0: none
    std::vector<bool> forced;
    bool operator==(const LadderOnline&) const = default;
};

class LadderScene;

/// One rung. Draws its shapes from the scene's layout.
class RungItem : public QGraphicsItem {
public:
    RungItem(LadderScene& scene, size_t index) : m_scene(scene), m_index(index) {}
    [[nodiscard]] QRectF boundingRect() const override { return m_bounds; }
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override;
    /// After a new layout; most rungs have kept their size.
    void resized();
    [[nodiscard]] static const QFont& font();

private:
    [[nodiscard]] QRectF bounds() const;
    void paintShape(QPainter& painter, const ladder::Shape& shape) const;
    void paintText(QPainter& painter, const ladder::Shape& shape) const;
    void paintValue(QPainter& painter, const ladder::Shape& shape) const;
    void paintGlyph(QPainter& painter, const ladder::Shape& shape) const;
    void paintBox(QPainter& painter, const ladder::Shape& shape) const;
    void paintSelection(QPainter& painter) const;
    void paintMargin(QPainter& painter) const;
    void paintLever(QPainter& painter, const ladder::Shape& shape, double y) const;
    void paintProblems(QPainter& painter) const;
    [[nodiscard]] QColor inkOf(ladder::NodeId node, bool isWire) const;

    LadderScene& m_scene;
    size_t m_index;
    QRectF m_bounds;
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
    /// [first, last) of the rungs that an area touches.
    [[nodiscard]] std::pair<size_t, size_t> rungsIn(const QRectF& area) const;
    /// What can be selected, rung by rung, in reading order.
    [[nodiscard]] std::vector<LadderPick> picksOf(ladder::RungId rung) const;
    [[nodiscard]] const LadderOnline& online() const { return m_online; }
    [[nodiscard]] QString problemAt(const LadderPick& pick) const;
    [[nodiscard]] size_t problemCount() const {
        return static_cast<size_t>(m_nodeProblems.size() + m_rungProblems.size());
    }
    [[nodiscard]] double cellWidth() const { return m_cellWidth; }
    [[nodiscard]] double cellHeight() const { return m_cellHeight; }
    void setLook(const LadderLook& look);
    void refreshTheme();
    /// The rung that the controller stands at; none.
    void setStanding(ladder::RungId rung);
    [[nodiscard]] ladder::RungId standing() const { return m_standing; }
    void setBookmarks(std::vector<bool> byRung);
    [[nodiscard]] const std::vector<bool>& bookmarks() const { return m_bookmarks; }
    /// The wire at a point, none elsewhere.
    [[nodiscard]] std::optional<LadderGap> gapAt(QPointF point) const;
    /// Where something dragged or inserted would come; none: nothing is marked.
    void markGap(std::optional<LadderGap> gap);
    [[nodiscard]] const kit::ThemeColors& colors() const { return m_colors; }

private:
    friend class RungItem;
    [[nodiscard]] QRectF cells(const ladder::Hit& hit) const;
    [[nodiscard]] double thick(double width) const {
        return m_look.isHighContrast || m_colors.contrast ? width * 1.5 : width;
    }

    const ladder::Diagram* m_diagram = nullptr;
    const ladder::Layout* m_layout = nullptr;
    std::vector<std::unique_ptr<RungItem>> m_items;
    LadderPick m_pick;
    LadderOnline m_online;
    std::vector<int> m_marks;
    QHash<uint32_t, LadderProblem> m_nodeProblems, m_rungProblems;
    std::vector<bool> m_bookmarks; // by RungId
    ladder::RungId m_standing;
    std::optional<LadderGap> m_gap;
    LadderLook m_look;
    kit::ThemeColors m_colors;
    bool m_isFaint = false;
    double m_cellWidth = 7, m_cellHeight = 17;
};

} // namespace plc::editor
