// The style of the studio: Fusion's layout with flat controls, thin scroll bars and an accent line under the open tab.
// Owned by the QApplication once set; GUI thread. Colours come from the theme at the moment of painting.
#pragma once

#include <QProxyStyle>

namespace plc::kit {

/// A property of a tab bar: only the tab in front has a name, the others their picture.
inline constexpr char kNarrowTabs[] = "narrowTabs";

class StudioStyle : public QProxyStyle {
    Q_OBJECT
public:
    StudioStyle();

    void polish(QWidget* widget) override;
    using QProxyStyle::polish;
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override;
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                           const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
    QIcon standardIcon(StandardPixmap pixmap, const QStyleOption* option, const QWidget* widget) const override;

private:
    bool drawButton(const QStyleOption* option, QPainter* painter) const;
    bool drawTab(const QStyleOption* option, QPainter* painter) const;
    bool drawMenuBarItem(const QStyleOption* option, QPainter* painter, const QWidget* widget) const;
    void drawScrollBar(const QStyleOptionComplex* option, QPainter* painter, const QWidget* widget) const;
};

} // namespace plc::kit
