// A small machine that is built and runs, with an operator side, for the player's and the designer's tests.
#pragma once
#include "hmi/player/panel_commands.h"
#include "hmi/player/panel_player.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/support/patience.h"

#include <QTest>
#include <gtest/gtest.h>

namespace plc::hmi {

inline const char* const kMachine = R"(
TYPE Mode : (Idle, Hand, Auto); END_TYPE
VAR_GLOBAL
    Language : INT;
    Tag : STRING(10) := 'en';
END_VAR
PROGRAM Main
VAR
    start, stop, running, overload, flash, forced : BOOL;
    presses : INT;
    level : REAL := 12.5;
    small : SINT;
    count : DINT;
    operation : Mode;
    name : STRING(5);
    wait : TIME := T#1s;
    numbers : ARRAY[1..3] OF INT := [1, 2, 3];
    edge : R_TRIG;
    divisor : INT := 1;
    quotient : INT;
END_VAR
edge(CLK := start);
IF edge.Q THEN presses := presses + 1; END_IF;
running := (running OR start) AND NOT stop;
count := count + 1;
quotient := 100 / divisor;
flash := count = 50; // one scan
END_PROGRAM
CONFIGURATION C
RESOURCE R ON PLC
    TASK T(INTERVAL := T#10ms, PRIORITY := 1);
    PROGRAM Main WITH T : Main;
END_RESOURCE
END_CONFIGURATION
)";

inline driver::Built builtMachine() {
    jit::setRuntimeSymbols(controller::runtimeSymbols()); // for faults
    driver::BuildInput input;
    input.files.push_back({"main.st", kMachine});
    driver::Built built = driver::build(input);
    std::string messages = built.failure.english();
    if (built.checked.analysis)
        for (const auto& one : built.checked.analysis->diagnostics)
            messages += diagnostics::renderText(*built.checked.sources, one, false) + "\n";
    EXPECT_TRUE(built.program) << messages;
    return built;
}

inline PanelProject machineProject() {
    PanelProject project;
    LanguageSettings settings;
    settings.languages = QStringList{"en", "da", "ar"};
    settings.variable = QStringLiteral("Language");
    project.texts =
        TextCatalog(*TextTable::parse("key,comment,en,da,ar\nstart,,Start,Start,بدء\nover,,Overload at "
                                      "{n:%d},Overbelastet ved {n:%d},حمل زائد {n:%d}\nflash,,Flash,Blink,ومضة\n",
                                      QString()),
                    settings);
    project.alarms = *AlarmFile::parse(
        R"({"alarms":[{"id":"over","condition":"Main.overload","text":"@over","values":{"n":"Main.count"}},{"id":"flash","condition":"Main.flash","text":"@flash","priority":3}]})",
        QString());
    project.hasAlarms = true;
    return project;
}

inline Panel panelOf(const std::string& elements) {
    Result<Panel> panel = Panel::parse("{\"size\": [640, 400], \"elements\": [" + elements + "]}", QStringLiteral("p"));
    EXPECT_TRUE(panel) << (panel ? "" : panel.error().english());
    return panel ? *panel : Panel();
}

/// Lets windows and the scan go on until something is so; at most a minute.
template <class Condition> bool waitFor(PanelPlayer& player, Condition condition) {
    return QTest::qWaitFor(
        [&] {
            player.frame();
            return condition();
        },
        kPatience);
}

} // namespace plc::hmi
