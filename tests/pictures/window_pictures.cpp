// Pictures of every window and dialog in every language, and what is cut in them. With STEPWISE_PICTURES=FOLDER a
// picture of each is saved there (docs/pictures/languages.sh); STEPWISE_THEME=light|dark|contrast and
// STEPWISE_WINDOW=1024x700 say of what.
#include "app/settings/translation.h"
#include "editor/kit/theme.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "tests/app/all_windows.h"
#include "tests/support/settle.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSettings>
#include <QTabBar>
#include <QToolButton>

#include <set>

namespace plc::app {
namespace {

constexpr int kTolerance = 2; // of fonts, in pixels

int widthOf(const QWidget& widget, const QString& text) { return widget.fontMetrics().horizontalAdvance(text); }

bool isCut(const QLabel& label) {
    if (label.text().isEmpty() || !label.pixmap(Qt::ReturnByValue).isNull()) return false;
    if (label.wordWrap()) return label.heightForWidth(label.width()) > label.height() + kTolerance;
    return label.sizeHint().width() > label.width() + kTolerance;
}

bool isCut(const QAbstractButton& button) {
    if (button.text().isEmpty()) return false;
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly) return false;
    return button.minimumSizeHint().width() > button.width() + kTolerance;
}

QStringList cutColumnsOf(const QHeaderView& header) {
    QStringList out;
    if (header.orientation() != Qt::Horizontal || !header.model()) return out;
    for (int i = 0; i < header.count(); ++i) {
        const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
        if (!header.isSectionHidden(i) && widthOf(header, text) + 4 > header.sectionSize(i)) out << text;
    }
    return out;
}

/// The texts of a widget that do not fit into it.
QStringList cutTextsOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget))
        return isCut(*label) ? QStringList{label->text()} : QStringList();
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
        return isCut(*button) ? QStringList{button->text()} : QStringList();
    if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
        return widthOf(*group, group->title()) > group->width() ? QStringList{group->title()} : QStringList();
    if (const auto* combo = qobject_cast<const QComboBox*>(&widget); combo && !combo->isEditable())
        return widthOf(*combo, combo->currentText()) + 24 > combo->width() ? QStringList{combo->currentText()}
                                                                           : QStringList();
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
        return widthOf(*line, line->placeholderText()) > line->width() ? QStringList{line->placeholderText()}
                                                                       : QStringList();
    if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) return cutColumnsOf(*header);
    return {};
}

QSize windowSize() {
    const QStringList sides = qEnvironmentVariable("STEPWISE_WINDOW", "1024x700").split('x');
    return {sides.value(0).toInt(), sides.value(1).toInt()};
}

class FitTest : public AllWindowsTest, public ::testing::WithParamInterface<const char*> {
protected:
    void SetUp() override {
        const QString theme = qEnvironmentVariable("STEPWISE_THEME");
        kit::Theme::install(*qApp, theme == "dark"       ? kit::ThemeChoice::Dark
                                   : theme == "contrast" ? kit::ThemeChoice::Contrast
                                                         : kit::ThemeChoice::Light);
        installTranslation(*qApp, GetParam());
        open();
        window->resize(windowSize());
    }
    void TearDown() override {
        AllWindowsTest::TearDown();
        installTranslation(*qApp, "en");
        kit::Theme::install(*qApp, kit::ThemeChoice::Light);
    }
    void keepPicture(QWidget& shown, const QString& name) {
        const QString folder = qEnvironmentVariable("STEPWISE_PICTURES");
        if (folder.isEmpty()) return;
        QString file = name;
        file.replace(QRegularExpression("[^A-Za-z0-9]+"), "_");
        QDir().mkpath(folder);
        EXPECT_TRUE(shown.grab().save(QString("%1/%2_%3.png").arg(folder, GetParam(), file)));
    }
};

TEST_P(FitTest, NoTextIsCut) {
    std::set<QString> cut;
    int seen = 0;
    const QRect screen(QPoint(), windowSize());
    lookAtAll([&](QWidget& shown, const QString& name) {
        settle();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // of values that changed just now
        keepPicture(shown, name);
        if (shown.isWindow() && (shown.width() > screen.width() || shown.height() > screen.height()))
            cut.insert(name + QString(": %1 × %2").arg(shown.width()).arg(shown.height()));
        for (const QWidget* widget : widgetsOf(shown)) {
            if (!widget->isVisible() || !widget->isVisibleTo(&shown) || widget->visibleRegion().isEmpty()) continue;
            ++seen;
            for (const QString& text : cutTextsOf(*widget))
                cut.insert(
                    QString("%1: %2 %3 “%4”").arg(name, widget->metaObject()->className(), widget->objectName(), text));
        }
    });
    for (const QString& each : cut) ADD_FAILURE() << GetParam() << ", " << each.toStdString();
    EXPECT_GT(seen, 2000);
}

INSTANTIATE_TEST_SUITE_P(Languages, FitTest, ::testing::Values("en", "de", "da", "fr", "es", "zh_CN"));

} // namespace
} // namespace plc::app

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QTemporaryDir settings;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    qputenv("STEPWISE_PROJECTS", settings.filePath("projects").toUtf8()); // copies of examples
    QApplication application(argc, argv);
    plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols());
    return RUN_ALL_TESTS();
}
