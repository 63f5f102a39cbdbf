// Views of what is pressed: button, switch, check box.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

enum class ButtonAction {
    Momentary,
    Toggle,
    Set,
    Reset,
    Write,
    Panel,
    Language,
    Acknowledge,
    PopUp,
    Close,
    Back,
    Home,
    LogOut,
    Theme
};
enum class ButtonIcon { None, Play, Stop, Pause, Up, Down, Left, Right, Plus, Minus, Home, Reset };

class ButtonView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void press(QPointF at) override;
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    TextBox label(const QString& tag) const;
    double iconSide() const;
    void perform();
    ButtonAction m_action = ButtonAction::Momentary;
    ButtonIcon m_icon = ButtonIcon::None;
    Slot m_target, m_lit, m_write;
    bool m_isLit = false, m_isDown = false;
    QString m_shown;
};

class SwitchView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    QRectF track() const;
    TextBox label(bool on, const QString& tag) const;
    bool hasLabel() const;
    Slot m_target;
    bool m_on = false;
};

class CheckBoxView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override;
    bool update() override;
    void draw(QPainter& painter) override;

private:
    double side() const;
    TextBox label(const QString& tag) const;
    Slot m_target;
    bool m_on = false;
};

/// A raised key: ground, edge and a lower edge that goes when it is pressed.
void drawKey(QPainter& painter, const QRectF& rect, double radius, const QColor& ground, bool isDown,
             const PanelTheme& theme);

} // namespace plc::hmi
