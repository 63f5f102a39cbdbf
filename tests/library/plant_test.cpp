// The plant blocks against the closed-form solutions of the processes they stand for.
#include "tests/library/bench.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plc::test {
namespace {

const std::vector<std::string> plant{"plant"};

TEST(PlantPt1, IsExactWhateverTheCycleTime) {
    for (const auto interval : {1ms, 10ms, 250ms}) {
        Bench bench("VAR f : Plant.PT1; END_VAR", "f(X := 3.0, Gain := 2.0, T1 := T#500ms, Start := 1.0);", plant,
                    interval);
        for (int n = 0; n <= 2000 / interval.count(); ++n) {
            bench.scan();
            ASSERT_NEAR(bench.real("f.Y"), 6.0 - 5.0 * std::exp(-double(n) * double(interval.count()) / 500.0), 1e-5)
                << n;
        }
    }
}

TEST(PlantPt2, SwingsCreepsAndIsCriticalAsTheDampingSays) {
    for (const double damping : {0.2, 0.5, 1.0, 2.5}) {
        Bench bench("VAR f : Plant.PT2; END_VAR",
                    "f(X := 1.0, Gain := 4.0, T := T#200ms, D := " + std::to_string(damping) + ");", plant, 20ms);
        const double w = 5.0;
        for (int n = 0; n <= 150; ++n) {
            bench.scan();
            const double t = n * 0.02;
            double away = 0;
            if (damping < 1) {
                const double wd = w * std::sqrt(1 - damping * damping);
                away = std::exp(-damping * w * t) * (std::cos(wd * t) + damping * w / wd * std::sin(wd * t));
            } else if (damping == 1.0) {
                away = std::exp(-w * t) * (1 + w * t);
            } else {
                const double root = std::sqrt(damping * damping - 1), p1 = -w * (damping - root),
                             p2 = -w * (damping + root);
                away = (p1 * std::exp(p2 * t) - p2 * std::exp(p1 * t)) / (p1 - p2);
            }
            ASSERT_NEAR(bench.real("f.Y"), 4.0 * (1 - away), 1e-4) << damping << " at " << t;
        }
    }
}

TEST(PlantPtN, IsAChainOfEqualLags) {
    for (const int lags : {1, 2, 4, 10}) {
        Bench bench("VAR f : Plant.PTn; END_VAR",
                    "f(X := 1.0, Gain := 2.0, T1 := T#100ms, N := " + std::to_string(lags) + ");", plant, 30ms);
        for (int n = 0; n <= 80; ++n) {
            bench.scan();
            const double x = n * 0.3;
            double sum = 0, term = 1;
            for (int k = 0; k < lags; ++k) {
                sum += term;
                term *= x / (k + 1);
            }
            ASSERT_NEAR(bench.real("f.Y"), 2.0 * (1 - std::exp(-x) * sum), 1e-5) << lags << " lags, scan " << n;
        }
    }
}

TEST(PlantDeadTime, GivesTheInputOfBefore) {
    Bench bench("VAR f : Plant.DeadTime; x : REAL; END_VAR",
                "x := x + 1.0;\nf(X := x, Delay := T#200ms, Start := -5.0);", plant);
    for (int n = 1; n <= 3000; ++n) {
        bench.scan();
        ASSERT_DOUBLE_EQ(bench.real("f.Y"), n <= 20 ? -5.0 : n - 20.0) << n;
    }
}

TEST(PlantDeadTime, CoversLongDelaysWithAThousandSamples) {
    Bench bench("VAR f : Plant.DeadTime; x : REAL; END_VAR", "x := x + 0.01;\nf(X := x, Delay := T#60s);", plant);
    bench.scan(6000);
    EXPECT_DOUBLE_EQ(bench.real("f.Y"), 0.0);
    for (int n = 6001; n <= 20000; ++n) {
        bench.scan();
        ASSERT_NEAR(bench.real("f.Y"), (n - 6000) * 0.01, 0.08) << n;
    }
}

TEST(PlantIntegrator, StaysWithinItsBounds) {
    Bench bench("VAR f : Plant.Integrator; x : REAL := 2.0; END_VAR",
                "f(X := x, Minimum := -1.0, Maximum := 5.0, Start := 1.0);", plant, 100ms);
    bench.scan(11);
    EXPECT_NEAR(bench.real("f.Y"), 3.0, 1e-6);
    bench.scan(20);
    EXPECT_DOUBLE_EQ(bench.real("f.Y"), 5.0);
    EXPECT_TRUE(bench.is("f.AtMaximum"));
    bench.set("x", -1.0);
    bench.scan(10);
    EXPECT_NEAR(bench.real("f.Y"), 4.0, 1e-6);
    bench.scan(100);
    EXPECT_TRUE(bench.is("f.AtMinimum"));
}

TEST(PlantTank, EmptiesAsTorricelliSays) {
    // the root of the level falls in a straight line: sqrt(h) = sqrt(h0) - k t / 2
    Bench bench("VAR f : Plant.Tank; END_VAR",
                "f(Inflow := 0.0, Valve := 1.0, Area := 0.5, Height := 2.0, OutletFlow := 4.0, Start := 2.0);", plant,
                100ms);
    const double k = 4.0 / (1000 * 0.5) / std::sqrt(2.0);
    for (int n = 0; n <= 6000; ++n) {
        bench.scan();
        const double root = std::max(0.0, std::sqrt(2.0) - k * n * 0.1 / 2);
        ASSERT_NEAR(bench.real("f.Level"), root * root, 2e-4) << n;
    }
    EXPECT_TRUE(bench.is("f.Empty"));
}

TEST(PlantTank, SettlesWhereInflowEqualsOutflowAndRunsOver) {
    Bench bench("VAR f : Plant.Tank; q : REAL := 1.0; END_VAR",
                "f(Inflow := q, Valve := 1.0, Area := 0.05, Height := 1.0, OutletFlow := 2.0);", plant, 100ms);
    bench.scan(10000);
    EXPECT_NEAR(bench.real("f.Level"), 0.25, 1e-3);
    EXPECT_NEAR(bench.real("f.Outflow"), 1.0, 2e-3);
    bench.set("q", 5.0);
    bench.scan(1000);
    EXPECT_TRUE(bench.is("f.Full"));
    EXPECT_NEAR(bench.real("f.Overflow"), 3.0, 1e-3);
    EXPECT_NEAR(bench.real("f.Volume"), 50.0, 1e-3);
}

TEST(PlantHeater, WarmsAndCoolsExponentially) {
    Bench bench("VAR f : Plant.Heater; p : REAL := 50.0; END_VAR",
                "f(Power := p, MaxPower := 2000.0, HeatCapacity := 5000.0, Loss := 10.0, Ambient := 20.0);", plant, 1s);
    for (int n = 0; n <= 1000; ++n) {
        bench.scan();
        ASSERT_NEAR(bench.real("f.Temperature"), 120.0 - 100.0 * std::exp(-n / 500.0), 1e-3) << n;
    }
    bench.set("p", 0.0);
    const double before = bench.real("f.Temperature");
    bench.scan(500);
    EXPECT_NEAR(bench.real("f.Temperature"), 20.0 + (before - 20.0) * std::exp(-1.0), 0.01);
}

TEST(PlantMotor, RunsUpWithItsTimeConstantAndIsBraked) {
    Bench bench("VAR f : Plant.Motor; u, load : REAL; END_VAR",
                "f(Drive := u, MaxSpeed := 1500.0, StallTorque := 20.0, Inertia := 0.05, LoadTorque := load);", plant);
    bench.set("load", 5.0);
    bench.scan(10);
    EXPECT_DOUBLE_EQ(bench.real("f.Speed"), 0.0) << "the load does not drive";
    bench.set("u", 20.0);
    bench.scan(10);
    EXPECT_DOUBLE_EQ(bench.real("f.Speed"), 0.0) << "4 Nm do not move 5 Nm";
    bench.set("u", 100.0);
    const double tau = 0.05 * 1500.0 * 2 * M_PI / 60 / 20.0;
    for (int n = 1; n <= 300; ++n) {
        bench.scan();
        ASSERT_NEAR(bench.real("f.Speed"), 1500.0 * 0.75 * (1 - std::exp(-n * 0.01 / tau)), 0.05) << n;
    }
    EXPECT_NEAR(bench.real("f.Torque"), 5.0, 0.01);
    bench.set("u", 0.0);
    bench.scan(1000);
    EXPECT_DOUBLE_EQ(bench.real("f.Speed"), 0.0);
    EXPECT_FALSE(bench.is("f.Turning"));
    bench.set("u", -100.0);
    bench.scan(1000);
    EXPECT_NEAR(bench.real("f.Speed"), -1125.0, 0.1);
}

TEST(PlantValve, TakesItsTravelTime) {
    Bench bench("VAR f : Plant.Valve; o, c, jam : BOOL; END_VAR",
                "f(Open := o, Close := c, TravelTime := T#2s, Jam := jam);", plant, 100ms);
    bench.scan();
    EXPECT_TRUE(bench.is("f.Closed"));
    bench.set("o", 1);
    bench.scan(10);
    EXPECT_NEAR(bench.real("f.Position"), 50.0, 1e-4);
    EXPECT_TRUE(bench.is("f.Moving"));
    bench.set("jam", 1);
    bench.scan(10);
    EXPECT_NEAR(bench.real("f.Position"), 50.0, 1e-4);
    bench.set("jam", 0);
    bench.scan(11);
    EXPECT_TRUE(bench.is("f.Opened"));
    bench.set("c", 1);
    bench.scan(10);
    EXPECT_TRUE(bench.is("f.Opened")) << "both commands leave it";
    bench.set("o", 0);
    bench.scan(21);
    EXPECT_TRUE(bench.is("f.Closed"));
}

TEST(PlantConveyor, CarriesItemsPastTheSensorAndDropsThem) {
    Bench bench("VAR f : Plant.Conveyor; place, stop : BOOL; END_VAR",
                "f(Run := TRUE, Speed := 0.5, Length := 2.0, Place := place, ItemLength := 0.3, SensorAt := 1.0, Stop "
                ":= stop);",
                plant, 100ms);
    bench.set("place", 1);
    bench.scan();
    bench.set("place", 0);
    int covered = 0;
    for (int n = 1; n <= 30; ++n) {
        bench.scan();
        covered += bench.is("f.Sensor");
    }
    EXPECT_NEAR(covered, 7, 1) << "0.3 m at 0.05 m a scan";
    EXPECT_EQ(bench.integer("f.Items"), 1);
    bench.scan(30);
    EXPECT_EQ(bench.integer("f.Items"), 0);
    EXPECT_EQ(bench.integer("f.Dropped"), 1);
    bench.set("stop", 1);
    for (int i = 0; i < 3; ++i) {
        bench.set("place", 1);
        bench.scan();
        bench.set("place", 0);
        bench.scan(20);
    }
    bench.scan(100);
    EXPECT_EQ(bench.integer("f.Items"), 3);
    EXPECT_TRUE(bench.is("f.AtEnd"));
    EXPECT_NEAR(bench.real("f.Positions[1]"), 2.0, 1e-5);
    EXPECT_NEAR(bench.real("f.Positions[2]"), 1.7, 1e-5);
    EXPECT_NEAR(bench.real("f.Positions[3]"), 1.4, 1e-5);
    bench.set("stop", 0);
    bench.scan(60);
    EXPECT_EQ(bench.integer("f.Dropped"), 4);
}

TEST(PlantNoise, HasItsMeanAndDeviationAndRepeats) {
    Bench bench("VAR f, g, h : Plant.Noise; END_VAR",
                "f(X := 10.0, Sigma := 2.0, Seed := 5); g(X := 10.0, Sigma := 2.0, Seed := 5); h(X := 10.0, Sigma := "
                "2.0, Seed := 6);",
                plant);
    double sum = 0, squares = 0;
    int different = 0;
    for (int n = 0; n < 5000; ++n) {
        bench.scan();
        const double y = bench.real("f.Y");
        sum += y;
        squares += (y - 10) * (y - 10);
        EXPECT_DOUBLE_EQ(y, bench.real("g.Y"));
        different += y != bench.real("h.Y");
    }
    EXPECT_NEAR(sum / 5000, 10.0, 0.15);
    EXPECT_NEAR(std::sqrt(squares / 5000), 2.0, 0.15);
    EXPECT_GT(different, 4900);
}

TEST(PlantSensorFault, FailsAsItIsTold) {
    Bench bench("VAR f : Plant.SensorFault; x : REAL := 5.0; kind : Plant.SENSOR_FAULT; END_VAR",
                "f(X := x, Fault := kind, Amount := 2.0, Broken := -20.0);", plant, 100ms);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.Y"), 5.0);
    EXPECT_FALSE(bench.is("f.Faulty"));
    bench.set("kind", 1);
    bench.set("x", 7.0);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.Y"), 5.0);
    EXPECT_TRUE(bench.is("f.Faulty"));
    bench.set("kind", 2);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.Y"), -20.0);
    bench.set("kind", 3);
    bench.scan();
    EXPECT_DOUBLE_EQ(bench.real("f.Y"), 9.0);
    bench.set("kind", 4);
    bench.scan(10);
    EXPECT_NEAR(bench.real("f.Y"), 9.0, 1e-4);
    bench.set("kind", 5);
    int spikes = 0;
    for (int n = 0; n < 2000; ++n) {
        bench.scan();
        spikes += bench.real("f.Y") != 7.0;
    }
    EXPECT_NEAR(spikes, 200, 60);
}

} // namespace
} // namespace plc::test
