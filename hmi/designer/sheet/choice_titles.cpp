#include "hmi/designer/sheet/choice_titles.h"

#include "editor/kit/texts.h"

#include <QCoreApplication>

namespace plc::hmi {

namespace {

struct Title {
    std::string_view property, word; // a property that gives the word another meaning comes first
    const char* title;
};

constexpr Title kChoices[] = {
    {"startEnd", "dot", QT_TRANSLATE_NOOP("HmiChoices", "Dot")},
    {"finishEnd", "dot", QT_TRANSLATE_NOOP("HmiChoices", "Dot")},
    {"icon", "play", QT_TRANSLATE_NOOP("HmiChoices", "Start sign")},
    {"icon", "stop", QT_TRANSLATE_NOOP("HmiChoices", "Stop sign")},
    {"icon", "pause", QT_TRANSLATE_NOOP("HmiChoices", "Pause sign")},
    {"icon", "plus", QT_TRANSLATE_NOOP("HmiChoices", "Plus")},
    {"icon", "minus", QT_TRANSLATE_NOOP("HmiChoices", "Minus")},
    {"icon", "home", QT_TRANSLATE_NOOP("HmiChoices", "House")},
    {"icon", "reset", QT_TRANSLATE_NOOP("HmiChoices", "Circular arrow")},
    {"shows", "time", QT_TRANSLATE_NOOP("HmiChoices", "Time of day")},
    {"sort", "time", QT_TRANSLATE_NOOP("HmiChoices", "By time")},
    {"anchorX", "both", QT_TRANSLATE_NOOP("HmiChoices", "Left and right")},
    {"anchorY", "both", QT_TRANSLATE_NOOP("HmiChoices", "Top and bottom")},
    {"adapts", "scale", QT_TRANSLATE_NOOP("HmiChoices", "Scaling to its size")},
    {"adapts", "anchors", QT_TRANSLATE_NOOP("HmiChoices", "Moving what is anchored")},
    {"layout", "free", QT_TRANSLATE_NOOP("HmiChoices", "Free")},
    {"layout", "row", QT_TRANSLATE_NOOP("HmiChoices", "Row")},
    {"layout", "column", QT_TRANSLATE_NOOP("HmiChoices", "Column")},
    {"layout", "either", QT_TRANSLATE_NOOP("HmiChoices", "Row if wide, column if tall")},
    {"layout", "grid", QT_TRANSLATE_NOOP("HmiChoices", "Grid")},
    {"across", "fill", QT_TRANSLATE_NOOP("HmiChoices", "Filling it")},
    {"", "solid", QT_TRANSLATE_NOOP("HmiChoices", "Solid")},
    {"", "dash", QT_TRANSLATE_NOOP("HmiChoices", "Dashed")},
    {"", "dot", QT_TRANSLATE_NOOP("HmiChoices", "Dotted")},
    {"", "none", QT_TRANSLATE_NOOP("HmiChoices", "None")},
    {"", "start", QT_TRANSLATE_NOOP("HmiChoices", "At the start")},
    {"", "center", QT_TRANSLATE_NOOP("HmiChoices", "Centred")},
    {"", "end", QT_TRANSLATE_NOOP("HmiChoices", "At the end")},
    {"", "light", QT_TRANSLATE_NOOP("HmiChoices", "Light")},
    {"", "dark", QT_TRANSLATE_NOOP("HmiChoices", "Dark")},
    {"", "contrast", QT_TRANSLATE_NOOP("HmiChoices", "High contrast")},
    {"", "arrow", QT_TRANSLATE_NOOP("HmiChoices", "Arrow")},
    {"", "arc", QT_TRANSLATE_NOOP("HmiChoices", "Arc line")},
    {"", "pie", QT_TRANSLATE_NOOP("HmiChoices", "Pie")},
    {"", "chord", QT_TRANSLATE_NOOP("HmiChoices", "Chord")},
    {"", "contain", QT_TRANSLATE_NOOP("HmiChoices", "Show all of it")},
    {"", "cover", QT_TRANSLATE_NOOP("HmiChoices", "Fill the frame")},
    {"", "stretch", QT_TRANSLATE_NOOP("HmiChoices", "Stretch")},
    {"", "right", QT_TRANSLATE_NOOP("HmiChoices", "Right")},
    {"", "left", QT_TRANSLATE_NOOP("HmiChoices", "Left")},
    {"", "up", QT_TRANSLATE_NOOP("HmiChoices", "Up")},
    {"", "down", QT_TRANSLATE_NOOP("HmiChoices", "Down")},
    {"", "momentary", QT_TRANSLATE_NOOP("HmiChoices", "Momentary")},
    {"", "toggle", QT_TRANSLATE_NOOP("HmiChoices", "Toggle")},
    {"", "set", QT_TRANSLATE_NOOP("HmiChoices", "Set to TRUE")},
    {"", "reset", QT_TRANSLATE_NOOP("HmiChoices", "Set to FALSE")},
    {"", "write", QT_TRANSLATE_NOOP("HmiChoices", "Write a value")},
    {"", "panel", QT_TRANSLATE_NOOP("HmiChoices", "Go to a panel")},
    {"", "theme", QT_TRANSLATE_NOOP("HmiChoices", "Change the theme")},
    {"", "language", QT_TRANSLATE_NOOP("HmiChoices", "Change the language")},
    {"", "acknowledge", QT_TRANSLATE_NOOP("HmiChoices", "Acknowledge alarms")},
    {"", "horizontal", QT_TRANSLATE_NOOP("HmiChoices", "Horizontal")},
    {"", "vertical", QT_TRANSLATE_NOOP("HmiChoices", "Vertical")},
    {"", "dateTime", QT_TRANSLATE_NOOP("HmiChoices", "Date and time of day")},
    {"", "date", QT_TRANSLATE_NOOP("HmiChoices", "Date")},
    {"", "week", QT_TRANSLATE_NOOP("HmiChoices", "Calendar week")},
    {"", "round", QT_TRANSLATE_NOOP("HmiChoices", "Round")},
    {"", "square", QT_TRANSLATE_NOOP("HmiChoices", "Square")},
    {"", "pill", QT_TRANSLATE_NOOP("HmiChoices", "Rounded")},
    {"", "dished", QT_TRANSLATE_NOOP("HmiChoices", "Dished ends")},
    {"", "flat", QT_TRANSLATE_NOOP("HmiChoices", "Flat ends")},
    {"", "hopper", QT_TRANSLATE_NOOP("HmiChoices", "Hopper")},
    {"", "open", QT_TRANSLATE_NOOP("HmiChoices", "Open at the top")},
    {"", "select", QT_TRANSLATE_NOOP("HmiChoices", "Select")},
    {"", "present", QT_TRANSLATE_NOOP("HmiChoices", "Present alarms")},
    {"", "history", QT_TRANSLATE_NOOP("HmiChoices", "Alarm history")},
    {"", "priority", QT_TRANSLATE_NOOP("HmiChoices", "By priority")},
    {"", "buttons", QT_TRANSLATE_NOOP("HmiChoices", "Buttons")},
    {"", "menu", QT_TRANSLATE_NOOP("HmiChoices", "Menu")},
    {"", "native", QT_TRANSLATE_NOOP("HmiChoices", "In their own language")},
    {"", "tag", QT_TRANSLATE_NOOP("HmiChoices", "Language tags")},
    {"", "scale", QT_TRANSLATE_NOOP("HmiChoices", "Keep the proportions")},
    {"", "top", QT_TRANSLATE_NOOP("HmiChoices", "Top")},
    {"", "bottom", QT_TRANSLATE_NOOP("HmiChoices", "Bottom")},
    {"", "locked", QT_TRANSLATE_NOOP("HmiChoices", "Locked")},
    {"", "hidden", QT_TRANSLATE_NOOP("HmiChoices", "Hidden")},
    {"", "popup", QT_TRANSLATE_NOOP("HmiChoices", "Open a panel in a window")},
    {"", "close", QT_TRANSLATE_NOOP("HmiChoices", "Close the window")},
    {"", "back", QT_TRANSLATE_NOOP("HmiChoices", "Go back")},
    {"", "home", QT_TRANSLATE_NOOP("HmiChoices", "Go to the start panel")},
    {"", "logOut", QT_TRANSLATE_NOOP("HmiChoices", "Log out")},
    {"", "aside", QT_TRANSLATE_NOOP("HmiChoices", "Shelved alarms")},
};

constexpr Title kSymbols[] = {
    {"", "motor", QT_TRANSLATE_NOOP("HmiChoices", "Motor")},
    {"", "pump", QT_TRANSLATE_NOOP("HmiChoices", "Pump")},
    {"", "valve", QT_TRANSLATE_NOOP("HmiChoices", "Valve")},
    {"", "tank", QT_TRANSLATE_NOOP("HmiChoices", "Tank")},
    {"", "silo", QT_TRANSLATE_NOOP("HmiChoices", "Silo")},
    {"", "conveyor", QT_TRANSLATE_NOOP("HmiChoices", "Conveyor")},
    {"", "mixer", QT_TRANSLATE_NOOP("HmiChoices", "Agitator")},
    {"", "heater", QT_TRANSLATE_NOOP("HmiChoices", "Heater")},
    {"", "fan", QT_TRANSLATE_NOOP("HmiChoices", "Fan")},
    {"", "sensor", QT_TRANSLATE_NOOP("HmiChoices", "Sensor")},
    {"", "lamp", QT_TRANSLATE_NOOP("HmiChoices", "Lamp symbol")}, // beside the element of that name
    {"", "siren", QT_TRANSLATE_NOOP("HmiChoices", "Siren")},
    {"", "truck", QT_TRANSLATE_NOOP("HmiChoices", "Lorry")},
    {"", "vehicle", QT_TRANSLATE_NOOP("HmiChoices", "Vehicle")},
    {"", "robot", QT_TRANSLATE_NOOP("HmiChoices", "Robot")},
    {"", "compressor", QT_TRANSLATE_NOOP("HmiChoices", "Compressor")},
    {"", "exchanger", QT_TRANSLATE_NOOP("HmiChoices", "Heat exchanger")},
    {"", "filter", QT_TRANSLATE_NOOP("HmiChoices", "Filter")},
    {"", "centrifuge", QT_TRANSLATE_NOOP("HmiChoices", "Centrifuge")},
    {"", "controlValve", QT_TRANSLATE_NOOP("HmiChoices", "Control valve")},
    {"", "threeWayValve", QT_TRANSLATE_NOOP("HmiChoices", "Three-way valve")},
    {"", "boiler", QT_TRANSLATE_NOOP("HmiChoices", "Boiler")},
    {"", "coolingTower", QT_TRANSLATE_NOOP("HmiChoices", "Cooling tower")},
    {"", "filler", QT_TRANSLATE_NOOP("HmiChoices", "Filler")},
    {"", "carton", QT_TRANSLATE_NOOP("HmiChoices", "Carton")},
    {"", "pallet", QT_TRANSLATE_NOOP("HmiChoices", "Pallet")},
    {"", "rollers", QT_TRANSLATE_NOOP("HmiChoices", "Roller conveyor")},
    {"", "elevator", QT_TRANSLATE_NOOP("HmiChoices", "Bucket elevator")},
    {"", "screw", QT_TRANSLATE_NOOP("HmiChoices", "Screw conveyor")},
    {"", "turntable", QT_TRANSLATE_NOOP("HmiChoices", "Turntable")},
    {"", "gantry", QT_TRANSLATE_NOOP("HmiChoices", "Gantry")},
    {"", "scara", QT_TRANSLATE_NOOP("HmiChoices", "SCARA robot")},
    {"", "gripper", QT_TRANSLATE_NOOP("HmiChoices", "Gripper")},
    {"", "door", QT_TRANSLATE_NOOP("HmiChoices", "Door")},
    {"", "damper", QT_TRANSLATE_NOOP("HmiChoices", "Damper")},
    {"", "building", QT_TRANSLATE_NOOP("HmiChoices", "Building")},
};

constexpr Title kRoles[] = {
    {"", "background", QT_TRANSLATE_NOOP("HmiChoices", "Background")},
    {"", "surface", QT_TRANSLATE_NOOP("HmiChoices", "Surface")},
    {"", "raised", QT_TRANSLATE_NOOP("HmiChoices", "Raised surface")},
    {"", "inset", QT_TRANSLATE_NOOP("HmiChoices", "Sunken surface")},
    {"", "line", QT_TRANSLATE_NOOP("HmiChoices", "Line colour")},
    {"", "faint", QT_TRANSLATE_NOOP("HmiChoices", "Faint line")},
    {"", "text", QT_TRANSLATE_NOOP("HmiChoices", "Text colour")},
    {"", "muted", QT_TRANSLATE_NOOP("HmiChoices", "Muted text")},
    {"", "button", QT_TRANSLATE_NOOP("HmiChoices", "Button colour")},
    {"", "accent", QT_TRANSLATE_NOOP("HmiChoices", "Accent")},
    {"", "off", QT_TRANSLATE_NOOP("HmiChoices", "Switched off")},
    {"", "running", QT_TRANSLATE_NOOP("HmiChoices", "Running")},
    {"", "liquid", QT_TRANSLATE_NOOP("HmiChoices", "Liquid")},
    {"", "pipe", QT_TRANSLATE_NOOP("HmiChoices", "Pipe colour")},
    {"", "measure", QT_TRANSLATE_NOOP("HmiChoices", "Measured value")},
    {"", "segment", QT_TRANSLATE_NOOP("HmiChoices", "Lit segment")},
    {"", "glass", QT_TRANSLATE_NOOP("HmiChoices", "Display glass")},
    {"", "alarm", QT_TRANSLATE_NOOP("HmiChoices", "Alarm colour")},
    {"", "high", QT_TRANSLATE_NOOP("HmiChoices", "High priority")},
    {"", "warning", QT_TRANSLATE_NOOP("HmiChoices", "Warning")},
    {"", "low", QT_TRANSLATE_NOOP("HmiChoices", "Low priority")},
    {"", "red", QT_TRANSLATE_NOOP("HmiChoices", "Red")},
    {"", "orange", QT_TRANSLATE_NOOP("HmiChoices", "Orange")},
    {"", "yellow", QT_TRANSLATE_NOOP("HmiChoices", "Yellow")},
    {"", "green", QT_TRANSLATE_NOOP("HmiChoices", "Green")},
    {"", "blue", QT_TRANSLATE_NOOP("HmiChoices", "Blue")},
    {"", "white", QT_TRANSLATE_NOOP("HmiChoices", "White")},
    {"", "black", QT_TRANSLATE_NOOP("HmiChoices", "Black")},
    {"", "grey", QT_TRANSLATE_NOOP("HmiChoices", "Grey")},
    {"", "good", QT_TRANSLATE_NOOP("HmiChoices", "Good state")},
    {"", "series1", QT_TRANSLATE_NOOP("HmiChoices", "Curve 1")},
    {"", "series2", QT_TRANSLATE_NOOP("HmiChoices", "Curve 2")},
    {"", "series3", QT_TRANSLATE_NOOP("HmiChoices", "Curve 3")},
    {"", "series4", QT_TRANSLATE_NOOP("HmiChoices", "Curve 4")},
    {"", "series5", QT_TRANSLATE_NOOP("HmiChoices", "Curve 5")},
    {"", "series6", QT_TRANSLATE_NOOP("HmiChoices", "Curve 6")},
    {"", "series7", QT_TRANSLATE_NOOP("HmiChoices", "Curve 7")},
    {"", "series8", QT_TRANSLATE_NOOP("HmiChoices", "Curve 8")},
};

constexpr Title kValueKinds[] = {
    {"", "number", QT_TRANSLATE_NOOP("HmiChoices", "a number")},
    {"", "bool", QT_TRANSLATE_NOOP("HmiChoices", "a BOOL")},
    {"", "text", QT_TRANSLATE_NOOP("HmiChoices", "a text")},
    {"", "array", QT_TRANSLATE_NOOP("HmiChoices", "an array")},
    {"", "any", QT_TRANSLATE_NOOP("HmiChoices", "any type")},
};

template <size_t N> QString titleIn(const Title (&titles)[N], std::string_view property, std::string_view word) {
    for (const Title& each : titles)
        if (each.word == word && (each.property.empty() || each.property == property))
            return QCoreApplication::translate("HmiChoices", each.title);
    return kit::fromView(word);
}

} // namespace

QString choiceTitle(std::string_view property, std::string_view word) { return titleIn(kChoices, property, word); }

QString roleTitle(const QString& role) { return titleIn(kRoles, {}, role.toStdString()); }

QString symbolTitle(const QString& symbol) { return titleIn(kSymbols, {}, symbol.toStdString()); }

QString valueKindTitle(std::string_view kind) { return titleIn(kValueKinds, {}, kind); }

} // namespace plc::hmi
