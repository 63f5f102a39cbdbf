// Every word of panel files that the designer offers has a title of its own, which is translated.
#include "hmi/designer/sheet/choice_titles.h"

#include "editor/kit/texts.h"
#include "hmi/model/descriptor.h"
#include "hmi/view/paint/panel_theme.h"
#include "hmi/view/paint/symbol_art.h"

#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

TEST(ChoiceTitles, EveryChoiceOfEveryElementHasOne) {
    int seen = 0;
    for (const ElementDescriptor& kind : elementDescriptors())
        for (const PropertyDescriptor& property : kind.properties) {
            if (property.type == PropertyType::Expression || property.type == PropertyType::Target) {
                EXPECT_TRUE(property.hint.empty() || valueKindTitle(property.hint) != kit::fromView(property.hint))
                    << property.hint;
            }
            if (property.type != PropertyType::Choice) continue;
            for (const std::string_view choice : property.choices()) {
                EXPECT_NE(choiceTitle(property.key, choice), kit::fromView(choice)) << property.key << ": " << choice;
                ++seen;
            }
        }
    EXPECT_GT(seen, 60);
    for (const QString& symbol : symbolNames()) EXPECT_NE(symbolTitle(symbol), symbol) << symbol.toStdString();
    for (const QString& role : PanelTheme::roles()) EXPECT_NE(roleTitle(role), role) << role.toStdString();
}

TEST(ChoiceTitles, AWordCanMeanDifferentThings) {
    EXPECT_EQ(choiceTitle("action", "reset"), "Set to FALSE");
    EXPECT_EQ(choiceTitle("icon", "reset"), "Circular arrow");
    EXPECT_EQ(choiceTitle("lineStyle", "dot"), "Dotted");
    EXPECT_EQ(choiceTitle("startEnd", "dot"), "Dot");
    EXPECT_EQ(choiceTitle("shape", "unknown"), "unknown") << "of a newer version: as it is in the file";
}

} // namespace
} // namespace plc::hmi
