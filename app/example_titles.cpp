#include "app/example_titles.h"

#include <QCoreApplication>

namespace plc::app {

namespace {

// As in projects/examples/*/project.json, for lupdate; a test compares.
[[maybe_unused]] constexpr const char* kTitles[] = {
    QT_TRANSLATE_NOOP("Examples", "Automatic guided vehicle"),
    QT_TRANSLATE_NOOP("Examples", "Alarm texts in five languages"),
    QT_TRANSLATE_NOOP("Examples", "Heated tank with analog blocks"),
    QT_TRANSLATE_NOOP("Examples", "Bottling line"),
    QT_TRANSLATE_NOOP("Examples", "Car park with a robot"),
    QT_TRANSLATE_NOOP("Examples", "Car wash with recipes"),
    QT_TRANSLATE_NOOP("Examples", "Room heated by supply air"),
    QT_TRANSLATE_NOOP("Examples", "Motor valve with command monitor"),
    QT_TRANSLATE_NOOP("Examples", "Conveyor with a sequence"),
    QT_TRANSLATE_NOOP("Examples", "Depalletiser"),
    QT_TRANSLATE_NOOP("Examples", "District-heating substation"),
    QT_TRANSLATE_NOOP("Examples", "Dosing"),
    QT_TRANSLATE_NOOP("Examples", "Filter"),
    QT_TRANSLATE_NOOP("Examples", "Gravel plant"),
    QT_TRANSLATE_NOOP("Examples", "Heater and valve"),
    QT_TRANSLATE_NOOP("Examples", "Hour meter with reset and enable"),
    QT_TRANSLATE_NOOP("Examples", "Items per hour"),
    QT_TRANSLATE_NOOP("Examples", "Items and meters"),
    QT_TRANSLATE_NOOP("Examples", "Level lamps"),
    QT_TRANSLATE_NOOP("Examples", "Light tower"),
    QT_TRANSLATE_NOOP("Examples", "Tuning a control loop"),
    QT_TRANSLATE_NOOP("Examples", "Mixer for two liquids and two bricks"),
    QT_TRANSLATE_NOOP("Examples", "Motor with self-holding"),
    QT_TRANSLATE_NOOP("Examples", "Operation mode of an agitator"),
    QT_TRANSLATE_NOOP("Examples", "PID loop on a first-order process"),
    QT_TRANSLATE_NOOP("Examples", "First-order filter and two sines a decade apart"),
    QT_TRANSLATE_NOOP("Examples", "Pump that looks for its cheapest speed"),
    QT_TRANSLATE_NOOP("Examples", "Two pumps in a well"),
    QT_TRANSLATE_NOOP("Examples", "Pulse width modulation of a sine"),
    QT_TRANSLATE_NOOP("Examples", "Rack with a robot"),
    QT_TRANSLATE_NOOP("Examples", "Robot and CNC machine"),
    QT_TRANSLATE_NOOP("Examples", "Robot that packs boxes"),
    QT_TRANSLATE_NOOP("Examples", "Two level sensors that watch each other"),
    QT_TRANSLATE_NOOP("Examples", "Pumping station with six pumps"),
    QT_TRANSLATE_NOOP("Examples", "Motor with selector"),
    QT_TRANSLATE_NOOP("Examples", "Stack of integers"),
    QT_TRANSLATE_NOOP("Examples", "Tank over Modbus"),
    QT_TRANSLATE_NOOP("Examples", "Tank that is filled, heated and emptied"),
    QT_TRANSLATE_NOOP("Examples", "Tank, operated by hand"),
    QT_TRANSLATE_NOOP("Examples", "Level and volume"),
    QT_TRANSLATE_NOOP("Examples", "Traffic light"),
    QT_TRANSLATE_NOOP("Examples", "Valve matrix"),
    QT_TRANSLATE_NOOP("Examples", "Three kinds of valves"),
    QT_TRANSLATE_NOOP("Examples", "Pump in waves"),
    QT_TRANSLATE_NOOP("Examples", "Truck scale"),
    QT_TRANSLATE_NOOP("Examples", "Workbook"),
};

} // namespace

QString exampleTitle(const QString& title) {
    return QCoreApplication::translate("Examples", title.toUtf8().constData());
}

} // namespace plc::app
