// Panels in memory and on disk: byte-stable files, edits with inverse, unknown things kept.
#include "hmi/model/document.h"
#include "hmi/model/walk.h"

#include <QSet>
#include <gtest/gtest.h>
#include <random>

namespace plc::hmi {
namespace {

const char* const kFile = R"({
  "version": 1,
  "author": "plant",
  "title": "@main.title",
  "size": [800, 480],
  "elements": [
    {
      "id": "button1",
      "kind": "button",
      "rect": [16, 16, 128, 56],
      "future": {"deep": [1, 2.5, "x"]},
      "when": [{"if": "Main.fault", "color": "alarm", "other": 7}],
      "text": "@main.start",
      "target": "Main.start"
    },
    {
      "id": "dial",
      "kind": "hologram",
      "rect": [200, 16, 64, 64],
      "beams": 12
    },
    {
      "id": "group1",
      "kind": "group",
      "rect": [8, 200, 300, 100]
    },
    {
      "id": "lamp1",
      "kind": "lamp",
      "parent": "group1",
      "rect": [16, 210, 56, 56],
      "value": "Main.running"
    }
  ],
  "notes": {"a": 1}
}
)";

Panel parsed(const std::string& text) {
    Result<Panel> panel = Panel::parse(text, QStringLiteral("p"));
    EXPECT_TRUE(panel) << (panel ? "" : panel.error().english());
    return panel ? *panel : Panel();
}

TEST(Panel, ANumberIsWithinItsRangeWhateverTheFileSays) {
    const auto fontSize = [](const char* written) {
        const Result<Panel> panel =
            Panel::parse(std::string(R"({"elements": [{"id": "a", "kind": "trend", "fontSize": )") + written + "}]}",
                         QStringLiteral("main"));
        return panel ? panel->elements()[0].number("fontSize") : -1;
    };
    const double usual = fontSize("null");
    EXPECT_GE(usual, 6);
    EXPECT_EQ(fontSize("14"), 14);
    EXPECT_EQ(fontSize("0"), 6);
    EXPECT_EQ(fontSize("1e300"), 200);
    for (const char* other : {"{}", "[]", R"("14")", "true"}) EXPECT_EQ(fontSize(other), usual) << other;
}

TEST(Panel, AnOptionOfAnotherTypeIsAsIfItWereMissing) {
    const auto isShown = [](const char* written) {
        const Result<Panel> panel =
            Panel::parse(std::string(R"({"elements": [{"id": "a", "kind": "trend", "legend": )") + written + "}]}",
                         QStringLiteral("main"));
        return panel && panel->elements()[0].isSet("legend");
    };
    EXPECT_FALSE(isShown("false"));
    for (const char* other : {"true", "{}", "1", R"("false")"}) EXPECT_TRUE(isShown(other)) << other;
}

TEST(PanelFile, LoadingAndSavingChangesNoByteAndKeepsWhatItDoesNotKnow) { EXPECT_EQ(parsed(kFile).write(), kFile); }

TEST(PanelFile, WritesWholeNumbersWithoutFractionAndKnownFieldsInOrder) {
    const std::string text =
        parsed(R"({"elements":[{"kind":"lamp","rect":[1.0,2.50,3,4e0],"id":"a","extra":1}],"title":"x"})").write();
    EXPECT_EQ(text, "{\n  \"title\": \"x\",\n  \"elements\": [\n    {\n      \"id\": \"a\",\n      \"extra\": 1,\n     "
                    " \"kind\": \"lamp\",\n"
                    "      \"rect\": [1, 2.5, 3, 4]\n    }\n  ]\n}\n");
    EXPECT_EQ(parsed(text).write(), text);
}

TEST(PanelFile, RefusesWhatIsNoPanelWithAReason) {
    for (const auto& [text, word] :
         {std::pair{"{\n\n  broken", "JSON"}, std::pair{"[]", "object"}, std::pair{R"({"version": 2})", "newer"},
          std::pair{R"({"elements": {}})", "list"}, std::pair{R"({"elements": [1]})", "Element 1"},
          std::pair{R"({"elements": [{"id":"a"},{"id":"a"}]})", "\"a\""}}) {
        const Result<Panel> panel = Panel::parse(text, QStringLiteral("p.panel.json"));
        ASSERT_FALSE(panel) << text;
        EXPECT_NE(panel.error().message.english().find(word), std::string::npos) << panel.error().message.english();
    }
    EXPECT_EQ(Panel::parse("{\n\n  broken", QStringLiteral("p")).error().place, "p:3");
}

TEST(ElementTable, GivesEveryKindATitleASizeAndItsOwnKey) {
    QSet<QString> keys;
    for (const ElementDescriptor& one : elementDescriptors()) {
        const QString key = QString::fromUtf8(one.key.data(), static_cast<qsizetype>(one.key.size()));
        EXPECT_FALSE(keys.contains(key));
        keys += key;
        EXPECT_EQ(kindOf(one.key), one.kind);
        EXPECT_GT(one.size.width(), 0);
        EXPECT_GT(one.properties.size(), descriptorOf(ElementKind::Unknown).properties.size() - 1) << one.key;
        QSet<QString> names;
        for (const PropertyDescriptor& property : one.properties) {
            EXPECT_FALSE(names.contains(QString::fromStdString(std::string(property.key))))
                << one.key << '.' << property.key;
            names += QString::fromStdString(std::string(property.key));
            if (property.type == PropertyType::Records) {
                EXPECT_FALSE(recordFields(property.hint).empty()) << property.key;
            }
            if (property.type == PropertyType::Choice) {
                EXPECT_GT(property.choices().size(), 1u) << property.key;
            }
        }
    }
    EXPECT_GE(keys.size(), 43);
}

TEST(PanelEdit, TwoHundredRandomEditsUndoneGiveTheFirstFileByteForByte) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        const auto pick = [&](size_t count) { return static_cast<size_t>(random() % count); };
        PanelDocument document(parsed(kFile));
        for (int step = 0; step < 200; ++step) {
            const Panel& panel = document.panel();
            const auto& elements = panel.elements();
            const ElementId some = elements.empty() ? ElementId() : elements[pick(elements.size())].id();
            switch (pick(7)) {
            case 0: {
                const ElementDescriptor& kind = elementDescriptors()[pick(elementDescriptors().size())];
                const Element element = Element::make(kind.kind, panel.freeId(kind.key),
                                                      QRectF(QPointF(double(pick(700)), double(pick(400))), kind.size));
                document.perform(QStringLiteral("insert"),
                                 {InsertElement{static_cast<int>(pick(elements.size() + 1)), element.fields()}});
                break;
            }
            case 1:
                if (elements.size() > 2) document.perform(QStringLiteral("remove"), removeElements(panel, {some}));
                break;
            case 2:
                document.perform(QStringLiteral("move"), moveBy(panel, {some}, QPointF(double(pick(40)), 3)),
                                 pick(2) ? 5 : 0);
                break;
            case 3:
                if (!some.isEmpty())
                    document.perform(QStringLiteral("order"),
                                     {MoveElement{some, static_cast<int>(pick(elements.size()))}});
                break;
            case 4:
                if (const Element* element = panel.find(some)) {
                    const PropertyDescriptor& property =
                        element->descriptor().properties[pick(element->descriptor().properties.size() - 2) + 2];
                    const Json values[] = {property.fallback, Json("text"), Json(double(pick(100)) / 8), Json(true),
                                           Json::array({1, 2.0})};
                    document.perform(QStringLiteral("set"), setProperty(panel, some, property.key, values[pick(5)]));
                    if (pick(8) == 0)
                        document.perform(QStringLiteral("unknown"), {SetField{some, "future", Json(int(pick(9))), {}}});
                }
                break;
            case 5:
                document.perform(QStringLiteral("resize"),
                                 resizeTo(panel, some, QRectF(0, 0, 10 + double(pick(300)), 10 + double(pick(300)))));
                break;
            case 6:
                document.perform(QStringLiteral("panel"), setProperty(panel, {}, "theme", pick(2) ? "dark" : "light"));
                break;
            }
        }
        const std::string last = document.panel().write();
        EXPECT_EQ(parsed(last).write(), last) << "seed " << seed;
        while (document.undoStack().canUndo()) document.undoStack().undo();
        ASSERT_EQ(document.panel().write(), kFile) << "seed " << seed;
        while (document.undoStack().canRedo()) document.undoStack().redo();
        ASSERT_EQ(document.panel().write(), last) << "seed " << seed;
    }
}

TEST(PanelEdit, ADragOfManyStepsIsOneUndoStep) {
    PanelDocument document(parsed(kFile));
    const int gesture = document.newGesture();
    for (int i = 0; i < 10; ++i)
        document.perform(QStringLiteral("drag"), moveBy(document.panel(), {QStringLiteral("group1")}, QPointF(5, 1)),
                         gesture);
    EXPECT_EQ(document.panel().find(QStringLiteral("lamp1"))->rect().x(), 66);
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_EQ(document.panel().write(), kFile);
}

TEST(PanelEdit, RemovingAGroupRemovesWhatLiesInIt) {
    PanelDocument document(parsed(kFile));
    document.perform(QStringLiteral("remove"), removeElements(document.panel(), {QStringLiteral("group1")}));
    EXPECT_EQ(document.panel().elements().size(), 2u);
    document.undoStack().undo();
    EXPECT_EQ(document.panel().write(), kFile);
}

TEST(PanelWalk, FindsEveryBindingAndTextAlsoInRecords) {
    const Panel panel = parsed(kFile);
    QStringList bindings, texts;
    for (const Element& element : panel.elements()) {
        forEachBinding(element, [&](const Found& found) { bindings += found.place() + u'=' + found.text; });
        forEachText(element, [&](const Found& found) { texts += found.text; });
    }
    EXPECT_EQ(bindings.join(u' ').toStdString(), "when[0].if=Main.fault target=Main.start value=Main.running");
    EXPECT_EQ(texts.join(u' ').toStdString(), "@main.start");
    Panel changed = panel;
    const Edit edit = rewrite(panel, [](const ElementId&, const Found& found) -> std::optional<QString> {
        return found.text.startsWith(QStringLiteral("Main."))
                   ? std::optional(QStringLiteral("Plant.") + found.text.mid(5))
                   : std::nullopt;
    });
    const Edit inverse = applyTo(changed, edit);
    EXPECT_EQ(toQString(changed.find(QStringLiteral("button1"))->at("when")[0]["if"]).toStdString(), "Plant.fault");
    applyTo(changed, inverse);
    EXPECT_EQ(changed.write(), kFile);
}

} // namespace
} // namespace plc::hmi
