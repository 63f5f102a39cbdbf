// The view of a recipe: its sets to choose from, their values beside those of the controller, keys to write and to
// read. Owned by the scene; main thread.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

struct Recipe;
struct RecipeSet;

class RecipeTableView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void press(QPointF at) override;
    void move(QPointF at) override;
    void release(QPointF at, bool inside) override;
    void wheel(double steps) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;
    /// The set that is shown; the first one where that is gone.
    QString currentSet() const;
    void showSet(const QString& name);

protected:
    void setUp() override;
    void draw(QPainter& painter) override;

private:
    enum class Key { Set, Write, Read, Add, Remove };
    static constexpr int kKeys = 5;
    const Recipe* recipe() const;
    const RecipeSet* set() const;
    double headHeight() const;
    double rowHeight() const;
    int visibleRows() const;
    QRectF keyArea(Key key) const;
    QRectF cell(int visibleRow, int column) const; // 0 name, 1 the set's value, 2 the controller's
    QRectF mirrored(const QRectF& area) const;
    void scrollTo(int top);
    void drawKeys(QPainter& painter);
    void drawRow(QPainter& painter, int visibleRow, size_t variable);
    void pressKey(Key key);
    std::vector<Slot> m_actual;
    QString m_set;
    int m_top = 0, m_pressedTop = 0;
    QPointF m_pressedAt;
    bool m_scrolled = false;
};

} // namespace plc::hmi
