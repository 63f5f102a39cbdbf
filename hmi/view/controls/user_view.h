// The view that says who is logged in and lets people in and out. Owned by the scene; main thread.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

class UserFieldView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void press(QPointF at) override;
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override {}
    void draw(QPainter& painter) override;

private:
    TextBox label(const QString& words, const QString& tag) const;
    bool m_isDown = false;
};

} // namespace plc::hmi
