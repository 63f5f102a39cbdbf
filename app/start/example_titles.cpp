#include "app/start/example_titles.h"

#include <QCoreApplication>

namespace plc::app {

namespace {

struct Card {
    const char* title; // as in projects/examples/*/project.json; a test compares
    const char* summary;
};

constexpr Card kCards[] = {
    {QT_TRANSLATE_NOOP("Examples", "Automated guided vehicle"),
     QT_TRANSLATE_NOOP("Examples",
                       "A vehicle between two limit switches, controlled by two linked sequential function charts")},
    {QT_TRANSLATE_NOOP("Examples", "Alarm texts in five languages"),
     QT_TRANSLATE_NOOP("Examples", "A motor with three alarms that operators read in five languages")},
    {QT_TRANSLATE_NOOP("Examples", "Heated tank with analog blocks"),
     QT_TRANSLATE_NOOP("Examples",
                       "One control loop with a block for each task: filter, monitor, ramp, PID, transfer")},
    {QT_TRANSLATE_NOOP("Examples", "Bottling line"),
     QT_TRANSLATE_NOOP("Examples",
                       "Filler, capper and labeller with buffers between them, controlled as PackML units")},
    {QT_TRANSLATE_NOOP("Examples", "Car park with a robot"),
     QT_TRANSLATE_NOOP("Examples", "A robot parks cars by number plate and retrieves them again")},
    {QT_TRANSLATE_NOOP("Examples", "Car wash with recipes"),
     QT_TRANSLATE_NOOP("Examples", "Five wash programmes, each with a price and a recipe that the owner can edit")},
    {QT_TRANSLATE_NOOP("Examples", "Room heating with supply air"),
     QT_TRANSLATE_NOOP("Examples", "Cascade control: a slow loop for the room, a fast one for the supply air")},
    {QT_TRANSLATE_NOOP("Examples", "Motor valve with command monitor"),
     QT_TRANSLATE_NOOP("Examples", "A motor valve whose travel is monitored; if it takes too long, an alarm sounds")},
    {QT_TRANSLATE_NOOP("Examples", "Conveyor with a sequence"),
     QT_TRANSLATE_NOOP("Examples", "A belt carries an item to the right, waits ten seconds and carries it back")},
    {QT_TRANSLATE_NOOP("Examples", "Depalletiser"),
     QT_TRANSLATE_NOOP("Examples", "Four belts take boxes off pallets; the settings of one can be copied to another")},
    {QT_TRANSLATE_NOOP("Examples", "District-heating substation"),
     QT_TRANSLATE_NOOP("Examples",
                       "Heating and hot water from a district-heating network, with frost protection and summer mode")},
    {QT_TRANSLATE_NOOP("Examples", "Dosing"),
     QT_TRANSLATE_NOOP("Examples", "A valve doses in pulses and pauses until the batch is complete")},
    {QT_TRANSLATE_NOOP("Examples", "Filter"),
     QT_TRANSLATE_NOOP("Examples",
                       "The pressure drop shows how dirty a filter is; an alarm reports when it is out of range")},
    {QT_TRANSLATE_NOOP("Examples", "Gravel plant"),
     QT_TRANSLATE_NOOP("Examples",
                       "Silo, bin, conveyor and truck, controlled by three parallel sequential function charts")},
    {QT_TRANSLATE_NOOP("Examples", "Heater and valve"),
     QT_TRANSLATE_NOOP("Examples",
                       "Two on-off controls: a heater with a set point, and a valve that opens on a pump alarm")},
    {QT_TRANSLATE_NOOP("Examples", "Hour meter with reset and enable"),
     QT_TRANSLATE_NOOP("Examples", "An hour meter that is loaded, enabled and held, giving a sawtooth")},
    {QT_TRANSLATE_NOOP("Examples", "Hourly production"),
     QT_TRANSLATE_NOOP("Examples", "A press makes items; a table counts how many in each hour of the day")},
    {QT_TRANSLATE_NOOP("Examples", "Item counter and meters"),
     QT_TRANSLATE_NOOP("Examples", "Counts items, energy and water; the counts survive a power failure")},
    {QT_TRANSLATE_NOOP("Examples", "Level lamps"),
     QT_TRANSLATE_NOOP("Examples", "A 4 to 20 mA level sensor, three lamps and wire break detection")},
    {QT_TRANSLATE_NOOP("Examples", "Light tower"),
     QT_TRANSLATE_NOOP("Examples", "Three machine signals on three lamps that flash or stay on")},
    {QT_TRANSLATE_NOOP("Examples", "Tuning a control loop"),
     QT_TRANSLATE_NOOP("Examples",
                       "A heat exchanger that oscillates; an experiment and its recording give better settings")},
    {QT_TRANSLATE_NOOP("Examples", "Mixer for two liquids and two bricks"),
     QT_TRANSLATE_NOOP("Examples",
                       "Liquids are weighed while a belt brings two bricks; then the mixer turns and tips")},
    {QT_TRANSLATE_NOOP("Examples", "Motor with latching"),
     QT_TRANSLATE_NOOP("Examples", "Start, stop and a latching contactor, written in five ways that agree")},
    {QT_TRANSLATE_NOOP("Examples", "Operation mode of an agitator"),
     QT_TRANSLATE_NOOP("Examples",
                       "The local control box or the panel: one block decides which of them is in control")},
    {QT_TRANSLATE_NOOP("Examples", "PID loop on a first-order process"),
     QT_TRANSLATE_NOOP("Examples", "The same process with and without a PID controller, side by side in one trace")},
    {QT_TRANSLATE_NOOP("Examples", "First-order filter and two sines"),
     QT_TRANSLATE_NOOP("Examples",
                       "One filter, two sines: the slow one passes, the fast one is attenuated and delayed")},
    {QT_TRANSLATE_NOOP("Examples", "Pump at its most efficient speed"),
     QT_TRANSLATE_NOOP("Examples", "A pump tries its speeds and keeps the one with the least energy per cubic metre")},
    {QT_TRANSLATE_NOOP("Examples", "Two pumps in a well"),
     QT_TRANSLATE_NOOP("Examples", "Two alternating pumps; a float switch is accepted only after two steady seconds")},
    {QT_TRANSLATE_NOOP("Examples", "Pulse width modulation of a sine"),
     QT_TRANSLATE_NOOP("Examples", "A sine becomes pulses for two outputs, as for a motor with two directions")},
    {QT_TRANSLATE_NOOP("Examples", "Storage rack with a robot"),
     QT_TRANSLATE_NOOP("Examples", "A robot counts encoder pulses to store and retrieve loads in twelve locations")},
    {QT_TRANSLATE_NOOP("Examples", "Robot and CNC machine"),
     QT_TRANSLATE_NOOP("Examples", "A robot takes 25 items one by one to a CNC machine and back")},
    {QT_TRANSLATE_NOOP("Examples", "Packing robot with camera inspection"),
     QT_TRANSLATE_NOOP("Examples", "A robot puts three items into each box; a camera checks the result")},
    {QT_TRANSLATE_NOOP("Examples", "Two redundant level sensors"),
     QT_TRANSLATE_NOOP("Examples",
                       "Two sensors are compared; a faulty one is replaced with the healthy one without a jump")},
    {QT_TRANSLATE_NOOP("Examples", "Pumping station with six pumps"),
     QT_TRANSLATE_NOOP("Examples",
                       "Starts and stops six pumps by level and running hours, with the daily inflow of a town")},
    {QT_TRANSLATE_NOOP("Examples", "Motor with selector switch"),
     QT_TRANSLATE_NOOP("Examples", "A rotary switch selects the speed of a motor, a number what a module does")},
    {QT_TRANSLATE_NOOP("Examples", "Stack of integers"),
     QT_TRANSLATE_NOOP("Examples", "Last in, first out: push, pop and reset, in ST and as an instruction list")},
    {QT_TRANSLATE_NOOP("Examples", "Tank over Modbus"),
     QT_TRANSLATE_NOOP("Examples", "A controller and a tank, connected on this computer by real Modbus TCP")},
    {QT_TRANSLATE_NOOP("Examples", "Tank with filling, heating and emptying"),
     QT_TRANSLATE_NOOP(
         "Examples",
         "The same sequence twice: with CASE and as a sequential function chart; either can be in control")},
    {QT_TRANSLATE_NOOP("Examples", "Manually operated tank"),
     QT_TRANSLATE_NOOP("Examples",
                       "Fill, empty and stir with three switches; two level switches prevent operating errors")},
    {QT_TRANSLATE_NOOP("Examples", "Level and volume"),
     QT_TRANSLATE_NOOP("Examples", "A current of 4 to 20 mA becomes a level, and the level becomes a volume")},
    {QT_TRANSLATE_NOOP("Examples", "Traffic light"),
     QT_TRANSLATE_NOOP("Examples", "Red, yellow and green from one seconds counter, written in three ways")},
    {QT_TRANSLATE_NOOP("Examples", "Valve matrix"),
     QT_TRANSLATE_NOOP("Examples",
                       "Five tanks, three pipelines, fifteen valves; two tanks never feed the same pipeline")},
    {QT_TRANSLATE_NOOP("Examples", "Three kinds of valves"),
     QT_TRANSLATE_NOOP("Examples", "A motor valve, a spring-return valve and a control valve, each with its block")},
    {QT_TRANSLATE_NOOP("Examples", "Pump control with waves"),
     QT_TRANSLATE_NOOP("Examples",
                       "A float switch in waves: the pump starts and stops only after five steady seconds")},
    {QT_TRANSLATE_NOOP("Examples", "Truck scale"),
     QT_TRANSLATE_NOOP("Examples", "Four BCD digits become the net weight once the scale has settled")},
    {QT_TRANSLATE_NOOP("Examples", "Workbook"),
     QT_TRANSLATE_NOOP("Examples", "Language samples on four pages, each a separate program with a test")},
};

QString translated(const char* text) { return QCoreApplication::translate("Examples", text); }

} // namespace

QString exampleTitle(const QString& title) { return translated(title.toUtf8().constData()); }

QString exampleSummary(const QString& title) {
    for (const Card& card : kCards)
        if (title == QLatin1String(card.title)) return translated(card.summary);
    return {};
}

} // namespace plc::app
