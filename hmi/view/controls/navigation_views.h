// Views of what leads from panel to panel: the area in which a frame shows the current one, and the navigation bar.
#pragma once
#include "hmi/view/scene/faceplate_view.h"

namespace plc::hmi {

/// The place in a frame where the panel of the moment is drawn.
class PanelAreaView final : public FaceplateView {
public:
    using FaceplateView::FaceplateView;
    QString panelName() const override;
};

/// A key for each of several panels; that of the current one is lit.
class NavigationBarView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void press(QPointF at) override;
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    void draw(QPainter& painter) override;

private:
    struct Entry {
        QString panel, text;
    };
    bool isVertical() const { return height() > width(); }
    QRectF keyArea(size_t index) const;
    std::optional<size_t> keyAt(QPointF at) const;
    TextBox label(size_t index, const QString& tag) const;
    std::vector<Entry> m_entries;
    std::optional<size_t> m_down;
};

} // namespace plc::hmi
