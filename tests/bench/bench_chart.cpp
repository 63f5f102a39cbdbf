// A chart of 500 steps in the studio's own view: opening it, one edit through keys and the text, scrolling, and a frame
// while it runs. Figures to hold against: under 1 s, under 50 ms, under 16.6 ms a frame.
#include "editor/graph/chart/chart_view.h"
#include "editor/kit/theme.h"
#include "tests/bench/frame_times.h"

#include <QApplication>
#include <QGraphicsItem>
#include <QScrollBar>
#include <QTest>

#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace plc;

namespace {

/// Steps in a row with alternatives, simultaneous branches and actions now and then: about what plants look like.
std::string bigChart(int steps) {
    std::string text = "PROGRAM Main\nVAR\n    go : BOOL;\n    a, b, c : BOOL;\nEND_VAR\n", ways;
    const auto name = [](int i) { return "S" + std::to_string(i); };
    for (int i = 0; i < steps; ++i) {
        text += (i == 0 ? "INITIAL_STEP " : "STEP ") + name(i) + ":\n";
        if (i % 2 == 0) text += "    a(N);\n";
        if (i % 3 == 0) text += "    b(D, T#2s);\n";
        if (i % 7 == 0) text += "    c(S);\n";
        text += "END_STEP\n";
    }
    const auto way = [&](const std::string& from, const std::string& to, const std::string& condition) {
        ways += "TRANSITION FROM " + from + " TO " + to + " := " + condition + "; END_TRANSITION\n";
    };
    for (int i = 0; i + 10 <= steps; i += 10) { // ten steps: a fork of two, a choice of three, the rest in a row
        const std::string next = i + 10 < steps ? name(i + 10) : name(0);
        way(name(i), "(" + name(i + 1) + ", " + name(i + 2) + ")", "go AND " + name(i) + ".T > T#1s");
        way("(" + name(i + 1) + ", " + name(i + 2) + ")", name(i + 3), "NOT go");
        for (int k = 4; k <= 6; ++k) way(name(i + 3), name(i + k), "a AND NOT b");
        for (int k = 4; k <= 6; ++k) way(name(i + k), name(i + 7), "c");
        way(name(i + 7), name(i + 8), "b");
        way(name(i + 8), name(i + 9), name(i + 8) + ".T >= T#500ms");
        way(name(i + 9), next, "go");
    }
    return text + ways + "END_PROGRAM\n";
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    kit::Theme::install(application, kit::ThemeChoice::Light);
    const int steps = argc > 1 ? std::atoi(argv[1]) : 500;
    const std::string text = bigChart(steps);
    std::printf("%d steps, %zu bytes of text\n\n| what | median | worst | goal |\n|---|---|---|---|\n", steps,
                text.size());

    std::vector<double> opens;
    for (int i = 0; i < 5; ++i) {
        opens.push_back(bench::milliseconds([&] {
            editor::ChartView view;
            view.setUnit("Main");
            view.resize(1200, 900);
            view.show();
            view.setText(text);
            QApplication::processEvents();
            view.grab();
        }));
    }
    bench::printRow("open, until the first picture", opens, 1000);

    editor::ChartView view;
    view.setUnit("Main");
    view.resize(1200, 900);
    view.show();
    std::string present = text;
    view.setText(present);
    QApplication::processEvents();
    QObject::connect(&view, &editor::ChartView::editsRequested, &view,
                     [&](const std::vector<diagnostics::TextEdit>& edits) {
                         present = chart::applyEdits(present, edits);
                         view.setText(present);
                     });
    std::vector<double> inserts, deletes;
    for (int i = 0; i < 20; ++i) {
        view.scene().clearSelection();
        view.scene().itemOf(editor::ChartScene::Step, (i * 37) % steps)->setSelected(true);
        inserts.push_back(bench::milliseconds([&] {
            QTest::keyClick(&view.canvas(), Qt::Key_Insert);
            view.grab();
        }));
        deletes.push_back(bench::milliseconds([&] {
            QTest::keyClick(&view.canvas(), Qt::Key_Delete);
            view.grab();
        }));
    }
    bench::printRow("insert a step, until it is drawn", inserts, 50);
    bench::printRow("delete it", deletes, 50);
    std::vector<double> selects;
    for (int i = 0; i < 20; ++i) {
        const auto offset = static_cast<uint32_t>(present.find("STEP S" + std::to_string((i * 53) % steps) + ":"));
        selects.push_back(bench::milliseconds([&] {
            view.showCursor(offset + 6);
            view.grab();
        }));
    }
    bench::printRow("the text's cursor moves, the graph follows", selects, 50);

    for (const double zoom : {1.0, 0.3}) {
        view.canvas().setZoom(zoom);
        QScrollBar* bar = view.canvas().verticalScrollBar();
        bar->setValue(bar->minimum());
        QApplication::processEvents();
        std::vector<double> frames;
        for (int i = 0; i < 120; ++i) {
            frames.push_back(bench::milliseconds([&] {
                bar->setValue(bar->value() + (bar->maximum() - bar->minimum()) / 120);
                view.canvas().viewport()->repaint();
                QApplication::processEvents();
            }));
        }
        bench::printRow(zoom == 1 ? "a frame of scrolling, zoom 100 %" : "a frame of scrolling, zoom 30 %", frames,
                        16.6);
    }
    view.canvas().setZoom(1);
    int frame = 0;
    view.setValues([&](const QString& expression) {
        editor::ChartValue value;
        value.text = "x";
        const int step = expression.startsWith('S') ? expression.mid(1).section('.', 0, 0).toInt() : -1;
        value.isTrue = expression.endsWith(".X") && (step + frame) % 9 == 0;
        value.nanoseconds = frame * 33'000'000LL;
        return value;
    });
    std::vector<double> frames;
    for (frame = 0; frame < 60; ++frame) {
        frames.push_back(bench::milliseconds([&] {
            view.refreshOnline();
            view.canvas().viewport()->repaint();
            QApplication::processEvents();
        }));
    }
    bench::printRow("a frame of a running chart (30 a second)", frames, 33.3);
    return 0;
}
