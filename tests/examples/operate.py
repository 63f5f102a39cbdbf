#!/usr/bin/env python3
"""Lets a random operator loose on the examples and holds their safety sentences against every scan.

  tests/examples/operate.py build/dev/bin/stepwise projects/examples/motor projects/examples/agv
  tests/examples/operate.py --seed 7 --runs 5 --steps 200 build/dev/bin/stepwise projects/examples/*

The operator's hands are the panel's: each button, switch, box, slider, selector and number of its panels, faceplates
included, pressed for a scan, half a second or long, alone and together, and now and then the power is cut. SAFETY, AFTER
and ONLY_WHEN name what must hold whatever is pressed and whatever fails; CALM what must hold while no fault has been
switched on. Works on a copy; ends with 1 when anything failed.
"""
import argparse
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# What must hold after every scan, whatever is pressed, cut or jammed.
SAFETY = {
    "agv": ["NOT (IO.FwdMotor AND IO.RevMotor)"],
    "alarm_texts": ["Plant.Burnt = 0", "NOT IO.MotorOn OR IO.TemperatureC <= 90.0"],
    "analog": ["NOT Main.SensorFault OR Plant.Boils = 0", "IO.Heating >= 0.0 AND IO.Heating <= 100.0", "Plant.Boils = 0"],
    "bottling": ["Plant.BadOut = 0"],
    "car_park": ["Plant.Crashes = 0", "Main.Cars >= 0 AND Main.Cars <= 24"],
    "car_wash": ["NOT (IO.ArmOut AND IO.ArmBack)"],
    "cascade": ["IO.Valve >= 0.0 AND IO.Valve <= 100.0", "NOT Main.SensorFault OR IO.Valve = 0.0"],
    "command_monitor": ["NOT (IO.OpenDrive AND IO.CloseDrive)", "Plant.Strains = 0", "Main.Agree"],
    "conveyor_sequence": ["IO.S4 OR NOT IO.K1"],
    "depalletiser": ["BeltPlant.Stalls = 0"],
    "district_heating": ["Plant.Frozen = 0"],
    "dosing": ["Dosing.Running OR NOT Dosing.Valve"],
    "gravel": ["IO.ControlLamp OR NOT (IO.ConveyorMotor OR IO.BinValve OR IO.SiloValve)"],
    "filter_watch": ["NOT FilterWatch.Alarm OR FilterWatch.Difference > 10.0 OR FilterWatch.Difference < 4.0", "Plant.Loss >= 0.0"],
    "heater_valve": ["NOT Heater.SensorFault OR NOT Heater.HeaterOn", "Plant.Overheats = 0",
                     "NOT PressureValve.ValveOpen OR PressureValve.PumpAlarm"],
    "hour_meter": ["Main.Counter >= 0", "NOT Main.SensorFault OR Main.meter.q_xErr"],
    "hourly_production": ["HourlyProduction.Total >= HourlyProduction.Produced[7] AND HourlyProduction.Total >= HourlyProduction.Produced[16]"],
    "item_counter": ["Counters.Energy.AmountTotal >= 0.0 AND Counters.Water.AmountTotal >= 0.0"],
    "level_lamps": ["BOOL_TO_INT(IO.Red) + BOOL_TO_INT(IO.Yellow) + BOOL_TO_INT(IO.Green) = SEL(Main.WireBroken, 1, 0)"],
    "loop_tuning": ["IO.Valve >= 0.0 AND IO.Valve <= 100.0", "NOT Main.SensorFault OR IO.Valve = 0.0"],
    "mix_2_brix": ["NOT (IO.TipUp AND IO.TipDown)", "Main.MostApart <= 1"],
    "modbus_tank": ["NOT Main.LineLost OR NOT IO.Pump"],
    "motor": ["NOT IO.K1 OR IO.S2", "IO.L1 = IO.K1",
              "Main.K1Latch = Main.K1SetReset AND Main.K1Latch = Main.K1Steps AND Main.K1Latch = Main.latchIl.Q"
              " AND Main.K1Latch = Main.latchLadder.Q"],
    "operation_mode": ["Plant.Burnt = 0", "NOT (IO.Motor AND Main.operation.q_xErr)"],
    "pid_pt1": ["IO.Drive >= -2000.0 AND IO.Drive <= 2000.0 OR Main.Manual", "Main.Run OR IO.Drive = 0.0"],
    "pt1_filter": ["ABS(Main.SlowFiltered) <= 100.1 AND ABS(Main.FastFiltered) <= 100.1"],
    "pump_energy": ["NOT IO.Pump OR IO.S1", "Plant.HotRuns = 0"],
    "pump_well": ["NOT Plant.Automatic OR Main.bottom.Value OR Main.middle.Value OR NOT (IO.M1 OR IO.M2)",
                  "IO.SwitchOn OR NOT (IO.M1 OR IO.M2)"],
    "pwm": ["NOT (Main.Positive AND Main.Negative)"],
    "rack": ["NOT Main.AxisFault OR NOT (IO.MotorX OR IO.MotorY)"],
    "robot_cnc": ["BOOL_TO_INT(IO.M1_P1) + BOOL_TO_INT(IO.M1_P2) + BOOL_TO_INT(IO.M2_P1) <= 1",
                  "IO.L1 OR NOT (IO.M1_P1 OR IO.M1_P2 OR IO.M2_P1)", "NOT (IO.L1 AND IO.L2)"],
    "robot_packing": ["Plant.Overfilled = 0", "IO.S2 OR NOT (IO.M1 OR IO.M2)"],
    "sensors": ["Main.Level <= 1000"],
    "six_pumps": ["NOT (IO.M[1] AND (IO.Service[1] OR NOT IO.Protection[1]))",
                  "NOT (IO.M[6] AND (IO.Service[6] OR NOT IO.Protection[6]))",
                  "Main.LevelFault OR IO.PT1 >= 100 OR NOT (IO.M[1] OR IO.M[2] OR IO.M[3] OR IO.M[4] OR IO.M[5] OR IO.M[6])"],
    "speed_selector": ["SpeedSelector.Fan = (SpeedSelector.Speed = 50)"],
    "stack": ["Main.Agree AND Main.AgreeDrawn", "Main.Count >= 0 AND Main.Count <= 128"],
    "tank_heating": ["Plant.Overflows = 0", "Plant.HotMixers = 0", "Plant.Boils = 0"],
    "tank_manual": ["NOT IO.V1 OR IO.LS1", "NOT IO.M1 OR IO.LS2"],
    "tank_volume": ["NOT SensorScaling.Error OR SensorScaling.Value = 0.0"],
    "traffic_light": ["Plant.RedRuns = 0", "NOT (IO.Green AND (IO.Red OR IO.Yellow))", "Main.Agree"],
    "valve_matrix": ["PipePlant.Mixed = 0"],
    "valves": ["Plant.Shorts = 0", "NOT Main.Run OR (IO.StopPb AND IO.InterlockOk AND IO.AirOk)"],
    "wave_pump": ["NOT WavePump.SensorFault OR NOT WavePump.K1"],
    "weigh": ["Main.Agree", "Main.Ready OR NOT Main.Valid", "Plant.WrongWeights = 0"],
    "workbook": ["OneShots.WithTrig = OneShots.WithOwnCode AND OneShots.WithTrig = OneShots.WithBlock", "Dozen.Count <= 12 AND Dozen.Own < 12",
                 "Password.Unlocked = (Password.Level > 0)", "LevelSimulate.Level >= 0 AND LevelSimulate.Level <= 4000",
                 "Sorting.Sorted[1] <= Sorting.Sorted[2] AND Sorting.Sorted[5] <= Sorting.Sorted[6] AND Sorting.Sorted[1] = Sorting.Least"],
}
# What follows when a condition has held for so many scans.
AFTER = {
    "filter_watch": [("FilterWatch.Difference > 10.0 OR FilterWatch.Difference < 4.0", 202, "FilterWatch.Alarm")],
    "gravel": [("IO.SiloEmptyLs AND NOT Main.silence.Q", 2, "IO.Siren")],
    "light_tower": [("NOT IO.B1", 2, "NOT IO.Red"), ("NOT IO.B2", 2, "NOT IO.Yellow"), ("IO.B3", 2, "IO.Green"),
                    ("NOT IO.B3", 2, "NOT IO.Green")],
    "weigh": [("Main.Command AND NOT Main.rest.Q", 1002, "Main.NeverAtRest")],
}
# What may change only while a condition holds: an expression, its type, the condition.
ONLY_WHEN = {
    "hourly_production": [("HourlyProduction.Total", "UINT",
                           "HourlyProduction.Hour >= 7 AND HourlyProduction.Hour <= 16 OR HourlyProduction.Total = 0")],
    "item_counter": [("Counters.Items", "UDINT", "Counters.B1 OR Counters.S1")],
    "weigh": [("Main.NetBcd", "WORD", "Main.Valid")],
}
# What must hold too while no fault has been switched on.
CALM = {
    "agv": ["Plant.EndHits = 0"],
    "bottling": ["Plant.Collisions = 0"],
    "car_wash": ["Plant.Scratches = 0", "Plant.ArmHits = 0"],
    "conveyor_sequence": ["Plant.Falls = 0"],
    "district_heating": ["Plant.Scalds = 0"],
    "dosing": ["DosingPlant.Overdoses = 0"],
    "gravel": ["Plant.Spilled = 0.0", "Plant.Overflow = 0.0"],
    "mix_2_brix": ["Plant.WrongBatches = 0", "Plant.Spilled = 0.0"],
    "pump_well": ["Plant.DryRuns = 0 OR NOT Plant.Automatic"],
    "rack": ["Plant.EndHits = 0"],
    "robot_cnc": ["Plant.Wrong = 0 OR Plant.misled"],
    "robot_packing": ["Plant.Spilled = 0", "Plant.WrongBoxes = 0", "Plant.Lifted = 0"],
    "six_pumps": ["Plant.DryRun = 0"],
    "tank_manual": ["Plant.Overflow = 0"],
    "valves": ["Plant.Overflows = 0"],
    "wave_pump": ["WellPlant.DryRun = 0"],
}
# Targets that are no faults though they are boxes of a plant, and what no hand should touch: how the counts are reset.
PLAYED = (r"\.(Automatic|Local|Demonstration|MoreFlow|ClockRuns|MachineRuns|Hand|Runs|Play|WindowOpen|WeakBoiler"
          r"|TapsByItself|Auto|Power)$")
UNTOUCHED = r"ResetCounts|OverModbus|\.InCnc$"


def panels(project):
    return {path.name[:-len(".panel.json")]: json.loads(path.read_text())
            for path in sorted(project.glob("hmi/*.panel.json"))}


def elements(shown, name, arguments):
    """The elements of a panel with those of its faceplates, their parameters filled in."""
    for element in shown[name]["elements"]:
        text = json.dumps(element)
        for parameter, value in arguments.items():
            text = re.sub(r"\$" + parameter + r"\b", lambda _: json.dumps(str(value))[1:-1], text)
        element = json.loads(text)
        if element["kind"] == "faceplate" and element.get("panel") in shown:
            yield from elements(shown, element["panel"], element.get("arguments", {}))
        else:
            yield element


def number(value, step):
    return str(int(value)) if float(step) == int(step) else f"{value:.3f}"


def hands(project):
    """(target, kind, values) of everything on the panels that can be operated."""
    found = {}
    shown = panels(project)
    plates = {e.get("panel") for p in shown.values() for e in p["elements"] if e["kind"] == "faceplate"}
    for name in shown:
        if name in plates:
            continue
        for e in elements(shown, name, {}):
            target = e.get("target", "")
            if not target or "$" in target or re.search(UNTOUCHED, target):
                continue
            if e["kind"] == "button" and e.get("action") == "write":
                found.setdefault(target, ("value", []))[1].append(e["write"])
            elif e["kind"] == "button" and e.get("action", "press") == "press":
                found[target] = ("button", [])
            elif e["kind"] in ("switch", "checkbox") or e.get("action") == "toggle":
                found[target] = ("switch", [])
            elif e["kind"] == "slider":
                low, high, step = e.get("min", 0), e.get("max", 100), e.get("step", 1)
                found[target] = ("value", [number(low + (high - low) * i / 8.0, step) for i in range(9)])
            elif e["kind"] in ("radio", "rotary") and "options" in e:
                found[target] = ("value", [o["value"] for o in e["options"]])
            elif e["kind"] == "numberEntry":
                low, high = str(e.get("minimum", "0")), str(e.get("maximum", "1"))
                found[target] = ("value", [low, high])
    return found


def watched(name):
    """What follows after a while and what changes only sometimes: variables, the start, each scan."""
    after, only = AFTER.get(name, []), ONLY_WHEN.get(name, [])
    variables = [f"    held{n} : DINT;" for n in range(len(after))]
    variables += [f"    old{n} : {kind};" for n, (_, kind, _) in enumerate(only)]
    start = [f"held{n} := 0;" for n in range(len(after))] + [f"old{n} := {value};" for n, (value, _, _) in enumerate(only)]
    scan = []
    for n, (condition, scans, then) in enumerate(after):
        scan += [f"held{n} := SEL({condition}, 0, held{n} + 1);", f"ASSERT held{n} <= {scans} OR ({then});"]
    for n, (value, _, when) in enumerate(only):
        scan += [f"ASSERT {value} = old{n} OR ({when});", f"old{n} := {value};"]
    return variables, start, scan


def scenario(rng, found, faults, steps, safety, title, name):
    """One TEST: random hands, each followed by a stretch of scans with every sentence asserted in each."""
    variables, start, scan = watched(name)
    lines = [f"TEST '{title}'", "VAR", "    i : INT;", *variables, "END_VAR", "RUN 2 SCANS;", *start]
    isOn = {}
    targets = [t for t in sorted(found) if faults or not is_fault(t, found[t])]

    def run(scans):
        lines.append(f"FOR i := 1 TO {scans} DO")
        lines.append("    RUN 1 SCANS;")
        lines.extend(f"    ASSERT {sentence};" for sentence in safety)
        lines.extend(f"    {line}" for line in scan)
        lines.append("END_FOR")

    def press(target, value):
        isOn[target] = value
        lines.append(f"{target} := {'TRUE' if value else 'FALSE'};")

    for _ in range(steps):
        if rng.random() < 0.02:
            lines.append("POWER_OFF T#1s;")
            lines.append("RUN 1 SCANS;")
            lines.extend(start)
        for target in rng.sample(targets, min(len(targets), rng.choice([1, 1, 1, 2]))):
            kind, values = found[target]
            if kind == "value":
                lines.append(f"{target} := {rng.choice(values)};")
            elif kind == "button" and rng.random() < 0.7:
                press(target, True)
                run(rng.choice([1, 1, 10]))
                press(target, False)
            else:
                press(target, not isOn.get(target, False))
        if rng.random() < 0.1:
            for target, value in sorted(isOn.items()):
                if value:
                    press(target, False)
        run(rng.choice([1, 3, 20, 100, 400, 1500]))
    lines.append("END_TEST\n")
    return "\n".join(lines)


def an_hour(safety):
    """One TEST: nobody comes for an hour, the power is cut for a second, and nobody comes for another."""
    lines = ["TEST 'an hour without a hand, a power cut, and an hour more'", "VAR", "    i : INT;", "END_VAR", "FOR i := 1 TO 720 DO"]
    lines.append("    IF i = 360 THEN")
    lines.append("        POWER_OFF T#1s;")
    lines.append("    END_IF")
    lines.append("    RUN T#10s;")
    lines.extend(f"    ASSERT {sentence};" for sentence in safety)
    lines.extend(["END_FOR", "END_TEST", ""])
    return "\n".join(lines)


def is_fault(target, hand):
    return hand[0] == "switch" and re.match(r"(\w*Plant|Station)\.", target) and not re.search(PLAYED, target)


def operate(options, project):
    rng = random.Random(f"{options.seed} {project.name}")
    found = hands(project)
    safety, calm = SAFETY.get(project.name, []), CALM.get(project.name, [])
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / project.name
        shutil.copytree(project, copy)
        for path in copy.glob("tests/*"):
            path.unlink()
        text = an_hour(safety + calm)
        for run in range(options.runs):
            faults = run % 2 == 1
            title = f"run {run}, seed {options.seed}, {'with' if faults else 'without'} faults"
            text += scenario(rng, found, faults, options.steps, safety + ([] if faults else calm), title, project.name) + "\n"
        (copy / "tests").mkdir(exist_ok=True)
        (copy / "tests" / "operator.st").write_text(text)
        result = subprocess.run([os.path.abspath(options.stepwise), "test", str(copy)], capture_output=True, text=True,
                                cwd=folder, timeout=options.seconds)
        if result.returncode and options.keep:
            shutil.copy(copy / "tests" / "operator.st", Path(options.keep) / f"{project.name}.st")
    verdict = "as it should be" if result.returncode == 0 else "FAILED"
    watches = len(AFTER.get(project.name, [])) + len(ONLY_WHEN.get(project.name, []))
    print(f"{project.name:20} {len(found):3} hands, {len(safety) + watches:2} + {len(calm):2} sentences, {options.runs} runs: {verdict}",
          flush=True)
    if result.returncode:
        print("\n".join((result.stdout + result.stderr).splitlines()[:options.lines]), flush=True)
    return result.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stepwise")
    parser.add_argument("projects", nargs="+", type=Path)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1_000_000))
    parser.add_argument("--runs", type=int, default=4, help="half of them with faults")
    parser.add_argument("--steps", type=int, default=60, help="presses of a run")
    parser.add_argument("--seconds", type=float, default=300.0)
    parser.add_argument("--lines", type=int, default=12, help="of the report of what failed")
    parser.add_argument("--keep", default="", help="folder for the scenarios that failed")
    options = parser.parse_args()
    os.nice(10)
    print(f"seed {options.seed}", flush=True)
    results = [operate(options, project) for project in options.projects if (project / "src").is_dir()]
    sys.exit(0 if all(results) else 1)


main()
