// Pictures of the style, the icons and the small widgets, to be looked at (STEPWISE_PICTURES names the folder); and
// that each theme paints them without leaving anything in the colours of the other one.
#include "editor/kit/command_palette.h"
#include "editor/kit/icons.h"
#include "editor/kit/inputs/expression_edit.h"
#include "editor/kit/inputs/property_grid.h"
#include "editor/kit/theme.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QGridLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenuBar>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTextEdit>
#include <QToolBar>
#include <QTreeWidget>

#include <gtest/gtest.h>

using namespace plc::kit;

namespace {

void keep(const QImage& image, const QString& name) {
    const QString folder = qEnvironmentVariable("STEPWISE_PICTURES");
    if (!folder.isEmpty()) image.save(folder + '/' + name + ".png");
}

QWidget* controls() {
    auto* page = new QWidget;
    auto* grid = new QGridLayout(page);
    auto* ok = new QPushButton("Apply");
    ok->setDefault(true);
    auto* off = new QPushButton("Disabled");
    off->setEnabled(false);
    grid->addWidget(ok, 0, 0);
    grid->addWidget(new QPushButton(icon(Icon::Build), "Build"), 0, 1);
    grid->addWidget(off, 0, 2);
    auto* checked = new QCheckBox("Checked");
    checked->setChecked(true);
    auto* partly = new QCheckBox("Partly");
    partly->setTristate(true);
    partly->setCheckState(Qt::PartiallyChecked);
    grid->addWidget(checked, 1, 0);
    grid->addWidget(new QCheckBox("Open"), 1, 1);
    grid->addWidget(partly, 1, 2);
    auto* radio = new QRadioButton("One");
    radio->setChecked(true);
    grid->addWidget(radio, 2, 0);
    grid->addWidget(new QRadioButton("Two"), 2, 1);
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setValue(40);
    grid->addWidget(slider, 2, 2);
    auto* combo = new QComboBox;
    combo->addItems({"Rising edge", "Falling edge"});
    grid->addWidget(combo, 3, 0);
    auto* spin = new QSpinBox;
    spin->setSuffix(" ms");
    grid->addWidget(spin, 3, 1);
    auto* line = new QLineEdit("Main.pid.q_rOut");
    grid->addWidget(line, 3, 2);
    auto* bad = new ExpressionEdit;
    bad->setText("Main.nothing");
    bad->setCheck([](const QString&) { return QString("unknown"); });
    grid->addWidget(bad, 4, 0);
    auto* progress = new QProgressBar;
    progress->setValue(60);
    grid->addWidget(progress, 4, 1, 1, 2);
    auto* box = new QGroupBox("Group");
    auto* inBox = new QGridLayout(box);
    inBox->addWidget(new QLabel("Inside a group"));
    grid->addWidget(box, 5, 0, 1, 3);
    grid->setRowStretch(6, 1);
    return page;
}

void fillWindow(QMainWindow& window) {
    QMenu* file = window.menuBar()->addMenu("&File");
    file->addAction(icon(Icon::Save), "Save all")->setShortcut(QKeySequence("Ctrl+S"));
    window.menuBar()->addMenu("&Edit");
    window.menuBar()->addMenu("&View");
    QToolBar* bar = window.addToolBar("Run");
    for (Icon which : {Icon::Run, Icon::Pause, Icon::Stop, Icon::Step, Icon::Reset})
        bar->addAction(icon(which), iconWord(which).toString());
    bar->addSeparator();
    for (Icon which : {Icon::Breakpoint, Icon::Watch, Icon::Force, Icon::Trace})
        bar->addAction(icon(which), iconWord(which).toString());
    bar->actions()[1]->setCheckable(true);
    bar->actions()[1]->setChecked(true);
    bar->actions()[3]->setEnabled(false);
    auto* tabs = new QTabWidget;
    tabs->setDocumentMode(true);
    tabs->setTabsClosable(true);
    tabs->addTab(controls(), icon(Icon::Pou), "Controls");
    tabs->addTab(new QTextEdit, icon(Icon::Panel), "operator.panel");
    window.setCentralWidget(tabs);
    auto* tree = new QTreeWidget;
    tree->setHeaderHidden(true);
    auto* project = new QTreeWidgetItem(tree, {"gravel"});
    project->setIcon(0, icon(Icon::Project));
    for (auto [which, name] : {std::pair{Icon::Program, "Main"},
                               {Icon::Block, "Motor"},
                               {Icon::Function, "Scale"},
                               {Icon::Type, "Phase"},
                               {Icon::Globals, "IO"},
                               {Icon::Task, "Fast"}}) {
        auto* item = new QTreeWidgetItem(project, {name});
        item->setIcon(0, icon(which));
    }
    project->setExpanded(true);
    tree->setCurrentItem(project->child(1));
    auto* left = new QDockWidget("Project");
    left->setWidget(tree);
    window.addDockWidget(Qt::LeftDockWidgetArea, left);
    auto* table = new QTableWidget(12, 3);
    table->setHorizontalHeaderLabels({"Name", "Value", "Type"});
    for (int r = 0; r < 12; ++r) {
        table->setItem(r, 0, new QTableWidgetItem(QString("var%1").arg(r)));
        table->setItem(r, 1, new QTableWidgetItem(QString::number(r * 1.5)));
        table->setItem(r, 2, new QTableWidgetItem("REAL"));
    }
    table->setAlternatingRowColors(true);
    table->verticalHeader()->hide();
    table->selectRow(2);
    auto* bottom = new QDockWidget("Watch");
    bottom->setWidget(table);
    window.addDockWidget(Qt::BottomDockWidgetArea, bottom);
    auto* grid = new PropertyGrid;
    std::vector<PropertyDescriptor> d(5);
    d[0] = {.id = "x", .group = "Geometry", .label = "X", .kind = PropertyKind::Integer, .suffix = " px"};
    d[1] = {.id = "name", .group = "General", .label = "Name", .kind = PropertyKind::Text};
    d[2] = {.id = "on", .group = "General", .label = "Visible", .kind = PropertyKind::Bool};
    d[3] = {.id = "fill", .group = "General", .label = "Fill", .kind = PropertyKind::Color};
    d[4] = {.id = "records", .group = "General", .label = "States", .kind = PropertyKind::Action};
    grid->setDescriptors(std::move(d));
    grid->setValues({{"x", 120}, {"name", "Pump"}, {"on", true}, {"fill", QColor("#d9480f")}, {"records", "3 states"}});
    auto* right = new QDockWidget("Properties");
    right->setWidget(grid);
    window.addDockWidget(Qt::RightDockWidgetArea, right);
    window.statusBar()->showMessage("Running  ·  scan 1.2 ms  ·  load 12 %");
}

} // namespace

TEST(Gallery, StyleInBothThemes) {
    for (ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
        Theme::current().setChoice(choice);
        QMainWindow window;
        fillWindow(window);
        window.resize(1000, 640);
        window.show();
        for (int i = 0; i < 3; ++i) QApplication::processEvents();
        const QImage image = window.grab().toImage();
        keep(image, choice == ThemeChoice::Dark ? "style_dark" : "style_light");
        // Most of a window in one theme is as dark, or as light, as the theme says.
        int wrong = 0, all = 0;
        for (int y = 0; y < image.height(); y += 3)
            for (int x = 0; x < image.width(); x += 3) {
                const int lightness = image.pixelColor(x, y).lightness();
                ++all;
                wrong += choice == ThemeChoice::Dark ? lightness > 120 : lightness < 120;
            }
        EXPECT_LT(wrong, all / 12);
        CommandPalette palette(&window);
        palette.open("s");
        for (int i = 0; i < 3; ++i) QApplication::processEvents();
        keep(window.grab().toImage(), choice == ThemeChoice::Dark ? "palette_dark" : "palette_light");
    }
    Theme::current().setChoice(ThemeChoice::Light);
}

TEST(Gallery, IconsSheet) {
    for (ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
        Theme::current().setChoice(choice);
        constexpr int Columns = 15, Cell = 64;
        const int rows = (static_cast<int>(allIcons().size()) + Columns - 1) / Columns;
        QImage image(Columns * Cell, rows * Cell, QImage::Format_ARGB32_Premultiplied);
        image.fill(colors().window);
        QPainter painter(&image);
        for (size_t i = 0; i < allIcons().size(); ++i)
            paintIcon(&painter,
                      QRectF(static_cast<double>(i % Columns) * Cell + 12, static_cast<double>(i / Columns) * Cell + 12,
                             40, 40),
                      allIcons()[i]);
        painter.end();
        keep(image, choice == ThemeChoice::Dark ? "icons_dark" : "icons_light");
        EXPECT_EQ(image.width(), Columns * Cell);
    }
    Theme::current().setChoice(ThemeChoice::Light);
}
