// Every vector of vectors.json, run through the compiled blocks of the Toolbox in virtual time. A vector listed in
// disputed.json (with the sentence of the guide that says so) must fail, so that the list cannot grow old.
#include "tests/library/bench.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace plc::test {
namespace {

using nlohmann::json;

json readJson(const std::string& name) {
    std::ifstream file(plc::sourceDir() + "/tests/library/" + name);
    return json::parse(file);
}

/// A member of an object; an empty one where there is none.
const json& part(const json& object, const char* name) {
    static const json empty = json::object();
    const auto found = object.find(name);
    return found == object.end() ? empty : *found;
}

/// One program with every object of the Toolbox; `choice` says which one a scan calls, by its place in the list.
std::string everyObject(const json& interfaces) {
    std::ostringstream declarations, calls;
    declarations << "VAR\n    choice : INT := -1;\n";
    int index = 0;
    for (const json& object : interfaces) {
        const std::string name = object["name"], kind = object["kind"];
        const int number = index++;
        if (kind == "STRUCT") continue;
        calls << "    " << number << ": ";
        if (kind == "FUNCTION") {
            calls << name << "_result := Toolbox." << name << '(';
            declarations << "    " << name << "_result : " << object["returns"]["type"].get<std::string>() << ";\n";
        } else {
            calls << name << "_block(";
            declarations << "    " << name << "_block : Toolbox." << name << ";\n";
        }
        const bool isFunction = kind == "FUNCTION";
        bool first = true;
        for (const char* group : {"inputs", "inouts"}) {
            if (!isFunction && std::string(group) == "inputs") continue;
            for (const json& pin : object[group]) {
                const std::string pinName = pin["name"], variable = name + "_" + pinName, type = pin["type"];
                const bool isLibraryType = std::string(group) == "inouts";
                declarations << "    " << variable << " : " << (isLibraryType ? "Toolbox." : "") << type << ";\n";
                calls << (first ? "" : ", ") << pinName << " := " << variable;
                first = false;
            }
        }
        calls << ");\n";
    }
    declarations << "END_VAR";
    return declarations.str() + "\nCASE choice OF\n" + calls.str() + "END_CASE\n";
}

class VectorRun {
public:
    VectorRun(const driver::Built& built, const json& interfaces, const json& vector)
        : m_bench(built), m_vector(vector) {
        const std::string block = vector["block"];
        for (size_t i = 0; i < interfaces.size(); ++i) {
            if (interfaces[i]["name"] != block) continue;
            m_object = interfaces[i];
            types::Value choice = m_bench.value("choice");
            choice.data = static_cast<int64_t>(i);
            m_bench.write("choice", choice);
        }
    }

    /// What went wrong, empty when all is as expected.
    std::string run() {
        int scan = 0;
        std::map<std::string, std::vector<bool>> series;
        for (const json& step : m_vector["steps"]) {
            for (const auto& [pin, wanted] : part(step, "set").items())
                m_bench.write(pathOf(pin), fromJson(m_bench.value(pathOf(pin)), wanted));
            for (int i = 0; i < step.value("repeat", 1); ++i, ++scan) {
                m_bench.scan();
                for (const json& aggregate : part(m_vector, "aggregate"))
                    series[aggregate["pin"]].push_back(m_bench.is(pathOf(aggregate["pin"])));
                if (step.contains("expect_each")) compare(step, step["expect_each"], scan);
            }
            if (step.contains("expect")) compare(step, step["expect"], scan - 1);
            for (const auto& [pin, range] : part(step, "expect_range").items()) {
                const double actual = m_bench.real(pathOf(pin));
                if (actual < range[0].get<double>() || actual > range[1].get<double>())
                    fail(scan - 1, pin, range.dump(), std::to_string(actual));
            }
            for (const auto& [pin, bits] : part(step, "expect_bits").items())
                for (const auto& [bit, wanted] : bits.items())
                    if (((m_bench.integer(pathOf(pin)) >> std::stoi(bit)) & 1) != wanted.get<int>())
                        fail(scan - 1, pin + "." + bit, wanted.dump(), "the other");
        }
        for (const json& aggregate : part(m_vector, "aggregate")) checkAggregate(aggregate, series[aggregate["pin"]]);
        return m_failures;
    }

private:
    [[nodiscard]] std::string pathOf(const std::string& pin) const {
        const std::string block = m_object["name"];
        if (m_object["kind"] == "FUNCTION") return pin == block ? block + "_result" : block + "_" + pin;
        for (const json& inOut : m_object["inouts"])
            if (pin.starts_with(inOut["name"].get<std::string>())) return block + "_" + pin;
        return block + "_block." + pin;
    }

    [[nodiscard]] types::Value fromJson(types::Value like, const json& wanted) const {
        const types::TypeTable& types = *m_bench.built().program->layout.types;
        if (wanted.is_array()) {
            auto& elements = std::get<std::vector<types::Value>>(like.data);
            for (size_t i = 0; i < elements.size(); ++i)
                elements[i].data = i < wanted.size() ? wanted[i].get<int64_t>() : int64_t{0};
            return like;
        }
        if (std::holds_alternative<std::string>(like.data)) {
            like.data = wanted.get<std::string>();
            return like;
        }
        if (wanted.is_boolean())
            like.data = static_cast<int64_t>(wanted.get<bool>());
        else if (wanted.is_string() && std::holds_alternative<double>(like.data))
            like.data = wanted == "INF" ? HUGE_VAL : -HUGE_VAL;
        else if (wanted.is_string())
            like = types::parseValue(types, like.type, wanted.get<std::string>()).value();
        else if (std::holds_alternative<double>(like.data))
            like.data = static_cast<double>(static_cast<float>(wanted.get<double>()));
        else if (types[like.type].kind == types::TypeKind::Time)
            like.data = wanted.get<int64_t>() * 1'000'000;
        else
            like.data = wanted.is_number_float() ? static_cast<int64_t>(wanted.get<double>()) : wanted.get<int64_t>();
        return like;
    }

    void compare(const json& step, const json& expected, int scan) {
        for (const auto& [pin, wanted] : expected.items()) {
            const types::Value actual = m_bench.value(pathOf(pin));
            const types::Value target = fromJson(actual, wanted);
            bool same = actual == target;
            if (const auto* number = std::get_if<double>(&actual.data); number && wanted.is_number()) {
                const double goal = wanted.get<double>();
                same = std::abs(*number - goal) <= step.value("tol", 1e-4 * std::max(1.0, std::abs(goal)));
            } else if (step.contains("tol") && std::holds_alternative<int64_t>(actual.data) && wanted.is_number()) {
                const bool isTime = (*m_bench.built().program->layout.types)[actual.type].kind == types::TypeKind::Time;
                same = std::abs(static_cast<double>(actual.integer() - target.integer())) <=
                       step["tol"].get<double>() * (isTime ? 1e6 : 1);
            }
            if (!same) fail(scan, pin, wanted.dump(), types::toText(*m_bench.built().program->layout.types, actual));
        }
    }

    void checkAggregate(const json& aggregate, const std::vector<bool>& series) {
        const size_t from = aggregate.value("from_scan", size_t{0}),
                     to = std::min(aggregate.value("to_scan", series.size() - 1), series.size() - 1);
        int count = 0, run = 0, longest = 0;
        for (size_t i = from; i <= to; ++i) {
            count += series[i];
            run = series[i] ? run + 1 : 0;
            longest = std::max(longest, run);
        }
        if (aggregate.contains("count_true") &&
            (count < aggregate["count_true"][0].get<int>() || count > aggregate["count_true"][1].get<int>()))
            fail(static_cast<int>(to), aggregate["pin"], aggregate["count_true"].dump() + " times TRUE",
                 std::to_string(count));
        if (aggregate.contains("max_run_true") && longest > aggregate["max_run_true"].get<int>())
            fail(static_cast<int>(to), aggregate["pin"], "runs up to " + aggregate["max_run_true"].dump(),
                 std::to_string(longest));
    }

    void fail(int scan, const std::string& pin, const std::string& wanted, const std::string& actual) {
        m_failures += "scan " + std::to_string(scan) + ": " + pin + " should be " + wanted + ", is " + actual + "\n";
    }

    Bench m_bench;
    json m_vector, m_object;
    std::string m_failures;
};

/// The task interval of a vector: its steps all have the same one.
int intervalOf(const json& vector) {
    int interval = 0;
    for (const json& step : vector["steps"]) {
        const int own = step.value("dt_ms", 0);
        if (interval == 0) interval = own;
        if (own != interval) throw std::runtime_error(vector["id"].get<std::string>() + " mixes intervals");
    }
    return interval == 0 ? 10 : interval;
}

TEST(ToolboxVectors, GiveWhatTheyExpect) {
    const json interfaces = readJson("interfaces.json"), vectors = readJson("vectors.json");
    std::map<std::string, std::string> disputed;
    for (const json& each : readJson("disputed.json")) disputed[each["id"]] = each["sentence"];
    std::map<int, driver::Built> builds;
    const std::string objects = everyObject(interfaces);
    const size_t split = objects.find("END_VAR") + 7;
    int done = 0;
    for (const json& vector : vectors) {
        const int interval = intervalOf(vector);
        if (!builds.contains(interval))
            builds[interval] = buildText(
                programText(objects.substr(0, split), objects.substr(split), std::chrono::milliseconds(interval)),
                {"toolbox"});
        const std::string id = vector["id"];
        const std::string failures = VectorRun(builds[interval], interfaces, vector).run();
        if (disputed.contains(id))
            EXPECT_NE(failures, "") << id << " is disputed (" << disputed[id] << ") but passes";
        else
            EXPECT_EQ(failures, "") << id << ' ' << vector.value("assumes", "");
        ++done;
    }
    EXPECT_EQ(done, 359);
}

} // namespace
} // namespace plc::test
