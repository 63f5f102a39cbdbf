// The view of a placed faceplate: the frame in which the scene draws the views of its contents. Owned by the scene;
// main thread.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

class FaceplateView : public ElementView {
public:
    using ElementView::ElementView;
    /// From the faceplate's panel to this element's own coordinates.
    const QTransform& contents() const { return m_contents; }
    /// The panel that is placed, or null.
    const Panel* panel() const;
    virtual QString panelName() const { return text("panel"); }

protected:
    void setUp() override;
    void draw(QPainter& painter) override;

private:
    QTransform m_contents;
    QSizeF m_size;
    QColor m_ground;
};

} // namespace plc::hmi
