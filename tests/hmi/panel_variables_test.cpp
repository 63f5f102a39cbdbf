// The Variables tab, drops and completion while a faceplate is drawn: its parameters come first, with the members of
// their types, whether or not the program has a variable of that type.
#include "design_studio.h"
#include "hmi/designer/context/panel_variables.h"
#include "hmi/model/property_literals.h"

#include "editor/kit/inputs/expression_edit.h"

#include <QLineEdit>
#include <QTabWidget>
#include <QTreeWidget>

namespace plc::hmi {
namespace {

class OneVariable final : public kit::VariableProvider {
public:
    std::vector<kit::VariableNode> children(const QString& path) const override {
        if (path.isEmpty())
            return {{QStringLiteral("Main"), QStringLiteral("Main"), {}, {}, kit::Icon::Program, true, true}};
        return {{QStringLiteral("opened"), QStringLiteral("Main.opened"), QStringLiteral("BOOL")}};
    }
    std::vector<kit::VariableNode> search(const QString&, int) const override {
        return children(QStringLiteral("Main"));
    }
};

/// A faceplate in the designer: of a motor, which no program of the machine has, and plain values.
struct FaceplateStudio {
    OneVariable variables;
    Studio studio{
        R"({"id":"a","kind":"lamp","rect":[100,100,60,60]},{"id":"n","kind":"number","rect":[300,100,120,60]})"};

    FaceplateStudio() {
        driver::BuildInput input;
        input.files.push_back({"main.st", std::string(kMachine) + R"(
            TYPE Wheel : STRUCT rpm : REAL; blocked : BOOL; END_STRUCT END_TYPE
            (* turns a wheel *)
            FUNCTION_BLOCK Motor
            VAR_INPUT run : BOOL; (* by the operator *) END_VAR
            VAR_OUTPUT wheel : Wheel; END_VAR
            END_FUNCTION_BLOCK)"});
        studio.context->setChecked(driver::check(input));
        EXPECT_FALSE(studio.context->checked().analysis->hasErrors);
        studio.context->setVariables([this]() -> const kit::VariableProvider& { return variables; });
        studio.designer = std::make_unique<PanelDesigner>(*studio.context, QStringLiteral("main"));
        studio.designer->resize(1400, 900);
        studio.designer->show();
        settle();
        studio.designer->canvas().setZoom(1);
        setParameters(R"json([{"name":"motor","type":"motor"},{"name":"title","type":"text"},
                              {"name":"limit","type":"REAL"},{"name":"on","type":"BOOL"},
                              {"name":"label","type":"STRING(12)"},{"name":"it"}])json");
        studio.designer->findChild<QTabWidget*>()->setCurrentWidget(&picker());
    }
    void setParameters(const char* rows) {
        PanelDocument& document = studio.designer->document();
        document.perform({}, hmi::setProperty(document.panel(), ElementId(), "parameters", Json::parse(rows)));
    }
    kit::VariablePicker& picker() { return *studio.designer->findChild<kit::VariablePicker*>(); }
    QTreeWidget& tree() {
        for (QTreeWidget* one : picker().findChildren<QTreeWidget*>())
            if (one->rootIsDecorated()) return *one;
        throw std::logic_error("no tree");
    }
    QStringList roots() {
        QStringList out;
        for (int i = 0; i < tree().topLevelItemCount(); ++i) out += tree().topLevelItem(i)->text(0);
        return out;
    }
    /// What a drag of that row carries.
    QMimeData* dragged(const char* path) {
        EXPECT_TRUE(picker().selectPath(QString::fromLatin1(path))) << path;
        return tree().model()->mimeData({tree().currentIndex()});
    }
};

TEST(PanelVariables, TheParametersComeFirstAndFollowTheirList) {
    FaceplateStudio f;
    EXPECT_EQ(f.roots(), (QStringList{"$motor", "$limit", "$on", "$label", "$it", "Main"}));
    const QTreeWidgetItem& motor = *f.tree().topLevelItem(0);
    EXPECT_EQ(motor.text(1), "motor");
    EXPECT_EQ(motor.text(2), "turns a wheel");
    f.tree().topLevelItem(0)->setExpanded(true);
    QStringList members;
    for (int i = 0; i < motor.childCount(); ++i) members += motor.child(i)->text(0) + u' ' + motor.child(i)->text(2);
    EXPECT_EQ(members, (QStringList{"run by the operator", "wheel "}));
    f.setParameters(R"([{"name":"wheel","type":"Wheel"}])");
    EXPECT_EQ(f.roots(), (QStringList{"$wheel", "Main"}));
    f.studio.designer->action(QStringLiteral("undo"))->trigger();
    EXPECT_EQ(f.roots().front(), "$motor");
    f.picker().setFilter(QStringLiteral("rpm")); // found by a member's name
    QTest::keyClick(f.picker().findChild<QLineEdit*>(), Qt::Key_Return);
    EXPECT_EQ(f.studio.last().text("value"), "$motor.wheel.rpm");
}

TEST(PanelVariables, AParameterDraggedOntoThePanelBecomesTheElementThatFitsItsType) {
    const struct {
        const char* path;
        Qt::KeyboardModifiers keys;
        ElementKind kind;
        const char* property;
    } rows[] = {
        {"$on", Qt::NoModifier, ElementKind::Lamp, "value"},
        {"$on", Qt::ShiftModifier, ElementKind::Switch, "target"},
        {"$limit", Qt::ShiftModifier, ElementKind::NumericEntry, "target"},
        {"$label", Qt::ShiftModifier, ElementKind::TextEntry, "target"},
        {"$motor.run", Qt::NoModifier, ElementKind::Lamp, "value"},
        {"$motor.wheel.rpm", Qt::ShiftModifier, ElementKind::NumericEntry, "target"},
        {"$it", Qt::NoModifier, ElementKind::NumericDisplay, "value"},
    };
    FaceplateStudio f;
    double y = 180;
    for (const auto& row : rows) {
        f.studio.drop(f.dragged(row.path), 500, y += 30, row.keys);
        EXPECT_EQ(f.studio.last().kind(), row.kind) << row.path;
        EXPECT_EQ(f.studio.last().text(row.property).toStdString(), row.path);
        EXPECT_FALSE(f.studio.last().text("name").contains(u'$')) << "a name is no binding";
    }
}

TEST(PanelVariables, AParameterDraggedOntoAnElementBindsWhatItsTypeFits) {
    FaceplateStudio f;
    f.studio.drop(f.dragged("$motor.wheel.blocked"), 130, 130);
    EXPECT_EQ(f.studio.panel().find("a")->text("value"), "$motor.wheel.blocked");
    EXPECT_EQ(f.studio.panel().elements().size(), 2u);
    f.studio.drop(f.dragged("$limit"), 130, 130); // a REAL on a lamp
    EXPECT_EQ(f.studio.panel().find("a")->text("value"), "$motor.wheel.blocked");
    EXPECT_EQ(f.studio.panel().elements().size(), 3u);

    f.studio.designer->selection().set({"n"});
    auto* grid = f.studio.designer->sheet().findChild<kit::PropertyGrid*>();
    ASSERT_TRUE(grid && grid->row("value"));
    grid->scrollToItem(grid->row("value"));
    const QPoint row = grid->visualItemRect(grid->row("value")).center();
    std::unique_ptr<QMimeData> mime(f.dragged("$motor.wheel.rpm"));
    QDragEnterEvent enter(row, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(grid->viewport(), &enter);
    QDragMoveEvent move(row, Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(grid->viewport(), &move);
    QDropEvent drop(QPointF(row), Qt::CopyAction, mime.get(), Qt::LeftButton, {});
    QApplication::sendEvent(grid->viewport(), &drop);
    EXPECT_EQ(f.studio.panel().find("n")->text("value"), "$motor.wheel.rpm");
}

TEST(PanelVariables, ABlockParameterBecomesAFaceplateThatTakesItButNeverThePanelItself) {
    FaceplateStudio f;
    QString said;
    QObject::connect(&f.studio.designer->canvas(), &DesignCanvas::refused, [&](const QString& why) { said = why; });
    f.setParameters(R"([{"name":"motor","type":"Motor"}])");
    f.studio.drop(f.dragged("$motor"), 500, 300);
    EXPECT_EQ(f.studio.panel().elements().size(), 2u);
    EXPECT_TRUE(said.contains("$motor") && said.contains("Motor")) << said.toStdString();
    auto inner = Panel::parse(R"({"size":[80,60],"parameters":[{"name":"m","type":"Motor"}],"elements":[]})",
                              QStringLiteral("inner"));
    ASSERT_TRUE(inner);
    f.studio.project.panels.push_back({QStringLiteral("inner"), *inner});
    f.studio.drop(f.dragged("$motor"), 500, 300);
    ASSERT_EQ(f.studio.last().kind(), ElementKind::Faceplate);
    EXPECT_EQ(f.studio.last().text("panel"), "inner");
    EXPECT_EQ(f.studio.last().at("arguments"), Json({{"m", "$motor"}}));
}

TEST(PanelVariables, BindingFieldsCompleteParametersAndTheirMembers) {
    FaceplateStudio f;
    f.studio.context->setCompletions([](const QString&, int) {
        return std::vector<kit::Completion>{{QStringLiteral("ofTheProject"), {}, kit::Icon::Variable, 0}};
    });
    const PanelVariables variables(*f.studio.context, f.studio.designer->document());
    const auto offered = [&](const char* text) {
        QStringList out;
        const QString line = QString::fromLatin1(text);
        for (const kit::Completion& one : variables.complete(line, static_cast<int>(line.size()))) out += one.text;
        return out;
    };
    EXPECT_EQ(offered("$"), (QStringList{"$motor", "$limit", "$on", "$label", "$it"}));
    EXPECT_EQ(offered("1 > $lim"), QStringList{"$limit"});
    EXPECT_EQ(offered("$motor.wheel.r"), QStringList{"rpm"});
    EXPECT_EQ(offered("Ma"), QStringList{"ofTheProject"});
    EXPECT_EQ(offered("").front(), "$motor");
    EXPECT_EQ(offered("").back(), "ofTheProject");

    // With keys, in the property sheet.
    f.studio.designer->selection().set({"n"});
    auto* grid = f.studio.designer->sheet().findChild<kit::PropertyGrid*>();
    grid->editProperty(QStringLiteral("value"));
    auto* line = grid->findChild<kit::ExpressionEdit*>();
    ASSERT_TRUE(line);
    QTest::keyClicks(line, QStringLiteral("$motor.whe"));
    ASSERT_TRUE(line->isCompletionShown());
    QTest::keyClick(line, Qt::Key_Return);
    QTest::keyClicks(line, QStringLiteral(".rp"));
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_EQ(line->text(), "$motor.wheel.rpm");
    line->setText(QStringLiteral("$motor.run"));
    EXPECT_TRUE(line->complaint().isEmpty());
    line->setText(QStringLiteral("$motor"));
    EXPECT_FALSE(line->complaint().isEmpty()) << "a block has no single value";
}

} // namespace
} // namespace plc::hmi
