// Every element kind is enumerated: saved, loaded, drawn, bound. A kind that is added to elements.def is tested at
// once.
#include "gallery.h"

#include <QDir>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

QImage drawn(const Element& element, ValueSource* values, bool designing = false) {
    Panel panel;
    panel.set("size", Json::array({900, 600}));
    panel.elements().push_back(element);
    static const TextCatalog texts = galleryTexts();
    PanelScene scene{makeElementView};
    scene.setTexts(&texts);
    scene.setDesigning(designing);
    scene.setValues(values);
    scene.setPanel(panel);
    return scene.picture();
}

QImage empty() {
    Panel panel;
    panel.set("size", Json::array({900, 600}));
    PanelScene scene{makeElementView};
    scene.setPanel(panel);
    return scene.picture();
}

Element made(const ElementDescriptor& kind) {
    return Element::make(kind.kind, QStringLiteral("e1"), QRectF(QPointF(40, 40), kind.size));
}

TEST(EveryKind, IsDrawnWithItsDefaultsInEveryTheme) {
    for (const char* theme : {"light", "dark", "contrast"}) {
        PanelScene scene{makeElementView};
        const TextCatalog texts = galleryTexts();
        scene.setTexts(&texts);
        scene.setDesigning(true);
        scene.setPanel(galleryPanel(QString::fromLatin1(theme)));
        const QImage picture = scene.picture();
        const QRgb ground = scene.theme().color("background").rgb();
        for (const auto& view : scene.views()) {
            const QRect area = view->rect().toRect();
            int painted = 0;
            for (int y = area.top(); y < area.bottom(); ++y)
                for (int x = area.left(); x < area.right(); ++x) painted += picture.pixel(x, y) != ground;
            EXPECT_GT(painted, 40) << theme << ' ' << toUtf8(view->element().id());
        }
        if (qEnvironmentVariableIsSet("STEPWISE_PICTURES"))
            picture.save(qEnvironmentVariable("STEPWISE_PICTURES") +
                         QStringLiteral("/elements_%1.png").arg(QLatin1String(theme)));
    }
}

TEST(EveryKind, IsSavedAndLoadedByteForByteWithEveryPropertySet) {
    for (const ElementDescriptor& kind : elementDescriptors()) {
        Panel panel;
        Element element = made(kind);
        for (const PropertyDescriptor& property : kind.properties) {
            if (property.key == "id" || property.key == "kind" || property.key == "rect") continue;
            Json value = property.fallback;
            switch (property.type) {
            case PropertyType::Bool:
                value = !property.fallback.get<bool>();
                break;
            case PropertyType::Number:
                value = 12.5;
                break;
            case PropertyType::Integer:
                value = 3;
                break;
            case PropertyType::Choice:
            case PropertyType::Symbol:
                value = std::string(property.choices().back());
                break;
            case PropertyType::Records:
                value = Json::array({Json{{std::string(recordFields(property.hint).front().key), "x"}}});
                break;
            case PropertyType::Bindings:
                value = Json{{"a", "Main.a"}};
                break;
            case PropertyType::Points:
                value = Json::array({Json::array({0, 0.25}), Json::array({1, 1})});
                break;
            default:
                value = "Main.x";
                break;
            }
            element.set(property.key, value);
        }
        panel.elements().push_back(element);
        const std::string text = panel.write();
        const Result<Panel> loaded = Panel::parse(text, QStringLiteral("p"));
        ASSERT_TRUE(loaded) << kind.key;
        EXPECT_EQ(loaded->write(), text) << kind.key;
        EXPECT_EQ(loaded->elements().front().kind(), kind.kind);
        EXPECT_EQ(loaded->elements().front().fields(), element.fields());
        PanelScene scene{makeElementView}; // odd values must not harm
        scene.setPanel(*loaded);
        scene.picture();
    }
}

TEST(EveryKind, AsksTheValueSourceForEachOfItsBindings) {
    for (const ElementDescriptor& kind : elementDescriptors()) {
        HeldValues values;
        QStringList expected;
        const PropertyDescriptor* action = kind.property("action");
        for (const std::string_view choice : action ? action->choices() : std::vector<std::string_view>{""}) {
            Element element = made(kind);
            if (action) element.set("action", std::string(choice));
            for (const PropertyDescriptor& property : kind.properties) {
                const std::string name = "Main." + std::string(property.key);
                if (property.type == PropertyType::Expression || property.type == PropertyType::Target) {
                    // The cell target is a pattern that is written, never read.
                    if (!(kind.kind == ElementKind::CellGrid && property.key == "target"))
                        expected += QString::fromStdString(name);
                    element.set(property.key, name);
                }
                if (property.type != PropertyType::Records) continue;
                Json row = Json::object();
                for (const PropertyDescriptor& field : recordFields(property.hint))
                    if (field.type == PropertyType::Expression || field.type == PropertyType::Target) {
                        row[std::string(field.key)] = name + "_" + std::string(field.key);
                        expected += QString::fromStdString(name + "_" + std::string(field.key));
                    }
                element.set(property.key, Json::array({row}));
            }
            Json bindings = Json{{"t", "Main.inText"}};
            element.set("values", bindings);
            drawn(element, &values);
        }
        expected += QStringLiteral("Main.inText");
        for (const QString& one : expected)
            EXPECT_TRUE(values.boundExpressions().contains(one)) << kind.key << ' ' << toUtf8(one);
    }
}

TEST(EveryKind, LooksDifferentWhenItsValueChanges) {
    for (const ElementDescriptor& kind : elementDescriptors()) {
        const char* property = nullptr;
        for (const char* candidate : {"value", "target", "state", "level", "flow", "x"})
            if (!property && kind.property(candidate)) property = candidate;
        if (!property || kind.kind == ElementKind::Button) continue;
        HeldValues values;
        Element element = made(kind);
        element.set(property, "Main.v");
        if (kind.property("y")) element.set("y", "Main.v");
        if (kind.kind == ElementKind::LightTower) element.set("lights", Json::array({Json{{"value", "Main.v"}}}));
        if (kind.kind == ElementKind::DateTime)
            values.set(QStringLiteral("Main.v"), Value::ofInstant(ValueKind::DateTime, 0));
        const std::string_view hint = kind.property(property)->hint;
        const auto valueOf = [&](int step) {
            if (hint == "array")
                return Value::ofArray({Value::ofInteger(10), Value::ofInteger(step * 40), Value::ofInteger(70)});
            if (kind.kind == ElementKind::DateTime) return Value::ofInstant(ValueKind::DateTime, step * 3600000000000);
            if (hint == "bool") return Value::ofBool(step == 1);
            if (kind.kind == ElementKind::TextEntry)
                return Value::ofText(step ? QStringLiteral("abc") : QStringLiteral("xyz"));
            if (kind.kind == ElementKind::MaskedEntry) return Value::ofInteger(step ? 1 : 1234);
            return Value::ofInteger(step ? 2 : 0);
        };
        values.set(QStringLiteral("Main.v"), valueOf(0));
        const QImage before = drawn(element, &values);
        values.set(QStringLiteral("Main.v"), valueOf(1));
        EXPECT_NE(before, drawn(element, &values)) << kind.key;
    }
}

TEST(EveryKind, ShowsWhenABindingHasNoValue) {
    for (const ElementDescriptor& kind : elementDescriptors()) {
        HeldValues values;
        values.set(QStringLiteral("Main.here"), Value::ofBool(true));
        Element element = made(kind);
        element.set("visible", "Main.here");
        const QImage before = drawn(element, &values);
        element.set("visible", "Main.gone");
        EXPECT_NE(before, drawn(element, &values)) << kind.key; // the mark in the corner
    }
}

TEST(Appearance, TheFirstTrueConditionDecides) {
    HeldValues values;
    Element element = made(descriptorOf(ElementKind::Rectangle));
    element.set(
        "when",
        Json::parse(R"([{"if":"A","color":"#ff0000"},{"if":"B","color":"#00ff00"},{"if":"C","visible":false}])"));
    const auto colorAt = [&](bool a, bool b, bool c) {
        values.set(QStringLiteral("A"), Value::ofBool(a));
        values.set(QStringLiteral("B"), Value::ofBool(b));
        values.set(QStringLiteral("C"), Value::ofBool(c));
        return drawn(element, &values).pixelColor(100, 80).name().toStdString();
    };
    EXPECT_EQ(colorAt(true, true, true), "#ff0000");
    EXPECT_EQ(colorAt(false, true, true), "#00ff00");
    EXPECT_EQ(colorAt(false, false, true), empty().pixelColor(100, 80).name().toStdString());
    EXPECT_EQ(colorAt(false, false, false),
              PanelTheme::of(PanelThemeKind::Light).color("surface").name().toStdString());
}

TEST(Appearance, MovesAndRotatesByExpressionAndRepaintsBothPlaces) {
    HeldValues values;
    values.set(QStringLiteral("X"), Value::ofInteger(0));
    Element element = made(descriptorOf(ElementKind::Rectangle));
    element.set("moveX", "X");
    Panel panel;
    panel.elements().push_back(element);
    PanelScene scene{makeElementView};
    scene.setValues(&values);
    scene.setPanel(panel);
    scene.picture();
    values.set(QStringLiteral("X"), Value::ofInteger(300));
    const QRegion dirty = scene.refresh(40);
    EXPECT_TRUE(dirty.contains(QPoint(60, 60)));
    EXPECT_TRUE(dirty.contains(QPoint(380, 60)));
    EXPECT_FALSE(dirty.contains(QPoint(280, 60)));
    EXPECT_TRUE(scene.refresh(80).isEmpty());
}

TEST(Containers, ATabShowsOnlyTheElementsOfItsPage) {
    Panel panel;
    panel.elements().push_back(Element::make(ElementKind::Tab, QStringLiteral("tab1"), QRectF(0, 0, 400, 300)));
    for (int page = 0; page < 2; ++page) {
        Element lamp = Element::make(ElementKind::Lamp, QStringLiteral("lamp%1").arg(page), QRectF(50, 100, 50, 50));
        lamp.set("parent", "tab1");
        lamp.set("page", page);
        panel.elements().push_back(lamp);
    }
    PanelScene scene{makeElementView};
    scene.setPanel(panel);
    scene.refresh(0);
    EXPECT_TRUE(scene.isShown(*scene.view(QStringLiteral("lamp0"))));
    EXPECT_FALSE(scene.isShown(*scene.view(QStringLiteral("lamp1"))));
    scene.press(QPointF(250, 10));
    scene.release(QPointF(250, 10));
    scene.refresh(40);
    EXPECT_FALSE(scene.isShown(*scene.view(QStringLiteral("lamp0"))));
    EXPECT_TRUE(scene.isShown(*scene.view(QStringLiteral("lamp1"))));
}

} // namespace
} // namespace plc::hmi
