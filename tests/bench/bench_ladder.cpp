// A ladder of 1,000 rungs in the studio's own view: opening it, one edit through keys and the text, scrolling, and a
// frame with power flow while it runs. Figures to hold against: under 100 ms, under 16 ms, under 16 ms a frame.
#include "editor/graph/ladder/ladder_view.h"
#include "editor/kit/theme.h"
#include "tests/bench/frame_times.h"

#include <QApplication>
#include <QScrollBar>
#include <QTest>

#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace plc;

namespace {

/// Latches, interlocks, comparisons, timers and moves: about what machines look like.
std::string bigLadder(int rungs) {
    std::string text = "PROGRAM Main\nVAR\n    a, b, c, d : BOOL;\n    i, j : INT;\n    y : ARRAY[0..2000] OF BOOL;\n"
                       "    T : ARRAY[0..2000] OF TON;\nEND_VAR\n";
    for (int i = 0; i < rungs; ++i) {
        const std::string n = std::to_string(i);
        switch (i % 5) {
        case 0:
            text += "// holds itself " + n + "\ny[" + n + "] := (a OR y[" + n + "]) AND NOT b AND (c OR NOT d);\n\n";
            break;
        case 1:
            text += "y[" + n + "] := a AND i > " + n + " OR b AND NOT c;\n\n";
            break;
        case 2:
            text += "y[" + n + "] S= a AND b AND c AND d;\n\n";
            break;
        case 3:
            text += "IF a AND NOT d THEN j := i * " + n + " + 1; END_IF\n\n";
            break;
        default:
            text += "y[" + n + "] := NOT (a AND b);\n\n";
        }
    }
    return text + "END_PROGRAM\n";
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    kit::Theme::install(application, kit::ThemeChoice::Light);
    const int rungs = argc > 1 ? std::atoi(argv[1]) : 1000;
    const std::string text = bigLadder(rungs);
    std::printf("%d rungs, %zu bytes of text\n\n| what | median | worst | goal |\n|---|---|---|---|\n", rungs,
                text.size());

    std::vector<double> opens;
    for (int i = 0; i < 5; ++i)
        opens.push_back(bench::milliseconds([&] {
            editor::LadderView view;
            view.setUnit("Main");
            view.resize(1200, 900);
            view.show();
            view.setText(text);
            QApplication::processEvents();
            view.grab();
        }));
    bench::printRow("open, until the first picture", opens, 100);

    editor::LadderView view;
    view.setUnit("Main");
    view.resize(1200, 900);
    view.show();
    std::string present = text;
    view.setText(present);
    QApplication::processEvents();
    QObject::connect(&view, &editor::LadderView::editsRequested, &view,
                     [&](const std::vector<diagnostics::TextEdit>& edits) {
                         present = diagnostics::applyEdits(present, edits);
                         view.setText(present);
                     });
    std::vector<double> negates;
    for (int i = 0; i < 40; ++i) {
        const ladder::RungId rung(static_cast<size_t>(i * 37 % rungs));
        const auto parts = view.scene().picksOf(rung);
        if (parts.empty() || !view.diagram()[parts.front().node].expr) continue;
        view.scene().select(parts.front());
        negates.push_back(bench::milliseconds([&] {
            QTest::keyClick(&view.canvas(), Qt::Key_N, Qt::ControlModifier);
            view.canvas().viewport()->repaint();
        }));
    }
    bench::printRow("negate a contact, until it is drawn", negates, 16);

    const auto scroll = [&](const char* what) {
        QScrollBar* bar = view.canvas().verticalScrollBar();
        bar->setValue(bar->minimum());
        std::vector<double> frames;
        for (int i = 0; i < 120; ++i)
            frames.push_back(bench::milliseconds([&] {
                bar->setValue(bar->value() + (bar->maximum() - bar->minimum()) / 120);
                view.refreshOnline();
                view.canvas().viewport()->repaint();
                QApplication::processEvents();
            }));
        bench::printRow(what, frames, 16);
    };
    view.canvas().setZoom(1);
    scroll("a frame of scrolling, zoom 100 %");
    int tick = 0;
    view.setValues([&tick](const QString& expression) {
        editor::GraphValue value;
        value.isTrue = (expression.size() + ++tick / 700) % 2 == 0;
        value.text = value.isTrue ? "TRUE" : "FALSE";
        return value;
    });
    scroll("the same with power flow");
    return 0;
}
