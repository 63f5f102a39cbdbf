// Views of containers: tab and group. What lies in them are elements of their own that name them as parent.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

class TabView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    QRectF touchArea() const override;
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;
    int currentPage() const override { return m_page; }
    /// In the designer the page is chosen by the outline, not by a press.
    void showPage(int page);

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    double headHeight() const;
    QRectF headArea(int page) const;
    TextBox label(int page, const QString& tag) const;
    Slot m_selected;
    QStringList m_titles;
    int m_page = 0;
};

class GroupView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override {}
    bool update() override { return true; }
    void draw(QPainter& painter) override;

private:
    TextBox label(const QString& tag) const;
};

} // namespace plc::hmi
