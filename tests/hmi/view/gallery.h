// A panel with every element kind in a grid, and values for what they are bound to. Shared by the view tests.
#pragma once
#include "hmi/view/element_factory.h"
#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

inline Panel galleryPanel(const QString& theme) {
    Panel panel;
    panel.set("theme", toUtf8(theme));
    double x = 16, y = 16, rowHeight = 0;
    const auto place = [&](Element element) {
        const QSizeF size = element.rect().size();
        if (x + size.width() > 1580) {
            x = 16;
            y += rowHeight + 20;
            rowHeight = 0;
        }
        element.set("rect", rectToJson(QRectF(QPointF(x, y), size)));
        x += size.width() + 20;
        rowHeight = std::max(rowHeight, size.height());
        panel.elements().push_back(std::move(element));
    };
    for (const ElementDescriptor& kind : elementDescriptors()) {
        if (kind.kind == ElementKind::Symbol) {
            for (const std::string_view symbol : kind.property("symbol")->choices()) {
                Element element = Element::make(kind.kind, panel.freeId(kind.key), QRectF(QPointF(), kind.size));
                element.set("symbol", std::string(symbol));
                element.set("label", std::string(symbol));
                place(std::move(element));
            }
            continue;
        }
        place(Element::make(kind.kind, panel.freeId(kind.key), QRectF(QPointF(), kind.size)));
    }
    panel.set("size", Json::array({1600, static_cast<int>(y + rowHeight + 16)}));
    return panel;
}

inline TextCatalog galleryTexts() {
    LanguageSettings settings;
    settings.languages = QStringList{"en", "de", "da", "ar", "zh-CN"};
    TextTable table;
    for (const QString& tag : settings.languages) table.addLanguage(tag);
    return {table, settings};
}

} // namespace plc::hmi
