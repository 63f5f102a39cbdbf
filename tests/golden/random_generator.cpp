#include "tests/golden/random_generator.h"

#include <random>

namespace plc::golden {
namespace {

constexpr const char* kIntegers[] = {"SINT",  "INT",   "DINT", "LINT", "USINT", "UINT",
                                     "UDINT", "ULINT", "BYTE", "WORD", "DWORD", "LWORD"};
constexpr const char* kReals[] = {"REAL", "LREAL"};
constexpr const char* kDates[] = {"DATE", "TOD", "DT"};

/// What every program has beside its own statements: blocks that inherit, with methods, properties and an interface.
constexpr const char* kPrelude = R"(
FUNCTION_BLOCK Part
VAR_INPUT
x : INT;
y : REAL;
END_VAR
VAR_OUTPUT
sum : DINT;
out : REAL;
END_VAR
sum := sum + x;
IF y > out THEN out := y; ELSE out := out * 0.5; END_IF
END_FUNCTION_BLOCK
FUNCTION Mixed : INT
VAR_INPUT
p, q : INT;
END_VAR
VAR
k : INT;
END_VAR
FOR k := 1 TO 3 DO Mixed := Mixed + p * k - q; END_FOR
END_FUNCTION
INTERFACE IAdder
METHOD Add : DINT
VAR_INPUT
n : INT;
END_VAR
END_METHOD
END_INTERFACE
FUNCTION_BLOCK Base IMPLEMENTS IAdder
VAR
total : DINT;
held : INT;
END_VAR
METHOD Add : DINT
VAR_INPUT
n : INT;
END_VAR
total := total + n;
Add := total;
END_METHOD
METHOD Share : DINT
VAR_INPUT
n : INT;
END_VAR
Share := total / n;
END_METHOD
PROPERTY Level : INT
GET
Level := held;
END_GET
SET
IF Level > 100 THEN held := 100; ELSE held := Level; END_IF
END_SET
END_PROPERTY
END_FUNCTION_BLOCK
FUNCTION_BLOCK Derived EXTENDS Base
VAR
calls : INT;
END_VAR
METHOD Add : DINT
VAR_INPUT
n : INT;
END_VAR
calls := calls + 1;
Add := SUPER^.Add(n := n) * 2 + calls;
END_METHOD
END_FUNCTION_BLOCK
)";

class Generator {
public:
    Generator(uint32_t seed, bool mayFault) : m_random(seed), m_mayFault(mayFault) {}

    size_t pick(size_t count) { return m_random() % count; }
    bool chance(size_t percent) { return pick(100) < percent; }
    template <size_t N> std::string oneOf(const char* const (&list)[N]) { return list[pick(N)]; }
    std::string anyType() {
        return chance(55)   ? oneOf(kIntegers)
               : chance(40) ? oneOf(kReals)
               : chance(30) ? "BOOL"
               : chance(30) ? oneOf(kDates)
               : chance(50) ? "TIME"
                            : "STRING";
    }
    static bool isReal(const std::string& type) { return type == "REAL" || type == "LREAL"; }

    /// A variable of `type`: v_INT_1 and so on, or an element of a_INT.
    std::string variable(const std::string& type) {
        if (type != "STRING" && chance(25)) return "a_" + type + "[" + index() + "]";
        return "v_" + type + "_" + std::to_string(1 + pick(3));
    }
    std::string index() {
        if (chance(40)) return std::to_string(pick(5));
        if (m_mayFault && chance(4)) return expression("INT", 1);
        return "LIMIT(0, " + expression("INT", 1) + ", 4)";
    }

    std::string literal(const std::string& type) {
        if (type == "BOOL") return chance(50) ? "TRUE" : "FALSE";
        if (type == "TIME") return "T#" + std::to_string(pick(5000)) + "ms";
        if (type == "DATE") return "D#20" + std::to_string(10 + pick(30)) + "-02-2" + std::to_string(pick(9));
        if (type == "TOD") return "TOD#" + std::to_string(pick(24)) + ":59:" + std::to_string(10 + pick(50));
        if (type == "DT")
            return "DT#20" + std::to_string(10 + pick(30)) + "-12-31-23:5" + std::to_string(pick(10)) + ":00";
        if (type == "STRING") {
            std::string text = "'";
            for (size_t n = pick(6); n > 0; --n) text += "abc12 "[pick(6)];
            return text + "'";
        }
        if (isReal(type))
            return type + "#" + std::to_string(static_cast<int>(pick(2000)) - 1000) + "." + std::to_string(pick(100));
        const bool isSigned = type == "SINT" || type == "INT" || type == "DINT" || type == "LINT";
        return type + "#" + (isSigned && chance(30) ? "-" : "") + std::to_string(pick(chance(50) ? 8 : 128));
    }

    std::string expression(const std::string& type, int depth) {
        if (depth <= 0) return chance(70) ? variable(type) : literal(type);
        if (type == "BOOL") return truth(depth - 1);
        if (type == "TIME") return duration(depth - 1);
        if (type == "STRING") return text(depth - 1);
        if (type == "DATE" || type == "TOD" || type == "DT") return date(type, depth - 1);
        return isReal(type) ? real(type, depth - 1) : integer(type, depth - 1);
    }

    std::string statement(int depth) {
        const size_t kind = depth <= 0 ? 0 : pick(12);
        if (kind < 5) {
            const std::string type = anyType();
            return variable(type) + " := " + expression(type, 3) + ";\n";
        }
        if (kind < 7)
            return "IF " + expression("BOOL", 2) + " THEN\n" + block(depth - 1) +
                   (chance(50) ? "ELSE\n" + block(depth - 1) : "") + "END_IF\n";
        if (kind == 7) {
            const std::string counter = "i" + std::to_string(m_loops++);
            m_counters += counter + " : INT;\n";
            return "FOR " + counter + " := " + std::to_string(static_cast<int>(pick(4)) - 1) + " TO " +
                   std::to_string(pick(6)) + (chance(30) ? " BY 2" : "") + " DO\n" + block(depth - 1) +
                   (chance(60)
                        ? "a_INT[LIMIT(0, " + counter + ", 4)] := " + expression("INT", 2) + " + " + counter + ";\n"
                        : "") +
                   (chance(20) ? "IF " + expression("BOOL", 1) + " THEN EXIT; END_IF\n" : "") + "END_FOR\n";
        }
        if (kind == 8)
            return "CASE " + expression("INT", 2) + " OF\n0, 2: " + block(depth - 1) + "-5..-1: " + block(depth - 1) +
                   "7..100: " + block(depth - 1) + "ELSE\n" + block(depth - 1) + "END_CASE\n";
        if (kind == 9) return object() + ".Level := " + expression("INT", 2) + ";\n";
        if (kind == 10)
            return "IF " + expression("BOOL", 1) + " THEN adder := base; ELSE adder := derived; END_IF\n" +
                   variable("DINT") + " := adder.Add(" + expression("INT", 2) + ");\n";
        return "f_" + std::to_string(1 + pick(2)) + "(x := " + expression("INT", 2) +
               ", y := " + expression("REAL", 2) + ");\n";
    }
    std::string block(int depth) {
        std::string out;
        for (size_t n = 1 + pick(3); n > 0; --n) out += statement(depth);
        return out;
    }

    /// The declarations and statements of a PROGRAM; `watched`: variables and the expressions that they are given last.
    std::string program(const std::string& name, std::vector<std::pair<std::string, std::string>>& watched) {
        std::string body;
        for (int i = 0; i < 12; ++i) body += statement(3);
        std::string watches;
        for (int i = 0; i < (m_mayFault ? 12 : 20); ++i) {
            const std::string type = anyType(), variable = "w" + std::to_string(i);
            const std::string expr = expression(type, 4);
            watched.emplace_back(variable, expr);
            watches += variable + " : " + type + ";\n";
            body += variable + " := " + expr + ";\n";
        }
        std::string declarations;
        const auto declare = [&](const std::string& type) {
            for (int i = 1; i <= 3; ++i)
                declarations += "v_" + type + "_" + std::to_string(i) + " : " +
                                (type == "STRING" ? "STRING(12)" : type) + " := " + literal(type) + ";\n";
            if (type != "STRING")
                declarations += "a_" + type + " : ARRAY[0..4] OF " + type + " := [" + literal(type) + ", " +
                                literal(type) + ", " + literal(type) + "];\n";
        };
        for (const char* type : kIntegers) declare(type);
        for (const char* type : {"REAL", "LREAL", "BOOL", "TIME", "STRING", "DATE", "TOD", "DT"}) declare(type);
        return "PROGRAM " + name + "\nVAR\n" + declarations + m_counters + watches +
               "f_1, f_2 : Part;\nbase : Base;\nderived : Derived;\nadder : IAdder;\nEND_VAR\n" + body +
               "END_PROGRAM\n";
    }

private:
    std::string object() { return chance(50) ? "base" : "derived"; }
    std::string date(const std::string& type, int depth) {
        const auto self = [&] { return "(" + expression(type, depth) + ")"; };
        switch (pick(6)) {
        case 0:
            return (chance(50) ? "MIN(" : "MAX(") + self() + ", " + self() + ")";
        case 1:
            return "SEL(" + expression("BOOL", depth) + ", " + self() + ", " + self() + ")";
        case 2:
            return "DINT_TO_" + type + "(" + expression("DINT", depth) + ")";
        case 3:
            return type == "DT" ? "CONCAT_DATE_TOD(" + expression("DATE", depth) + ", " + expression("TOD", depth) + ")"
                                : "DT_TO_" + type + "(" + expression("DT", depth) + ")";
        default:
            if (type == "DATE") return "DT_TO_DATE(" + expression("DT", depth) + ")";
            return self() + (chance(50) ? " + (" : " - (") + expression("TIME", depth) + ")";
        }
    }
    std::string truth(int depth) {
        switch (pick(6)) {
        case 0:
            return "(" + expression("BOOL", depth) + (chance(50) ? " AND " : " OR ") + expression("BOOL", depth) + ")";
        case 1:
            return "NOT (" + expression("BOOL", depth) + ")";
        case 2:
            return "(" + expression("BOOL", depth) + " XOR " + expression("BOOL", depth) + ")";
        case 3:
            return variable("BOOL");
        default: {
            const std::string type = anyType();
            constexpr const char* kCompare[] = {"=", "<>", "<", "<=", ">", ">="};
            return "((" + expression(type, depth) + ") " + oneOf(kCompare) + " (" + expression(type, depth) + "))";
        }
        }
    }
    std::string integer(const std::string& type, int depth) {
        const auto self = [&] { return "(" + expression(type, depth) + ")"; };
        switch (pick(15)) {
        case 0:
            return self() + " + " + self();
        case 1:
            return self() + " - " + self();
        case 2:
            return self() + " * " + self();
        case 3:
            return self() + (chance(50) ? " / " : " MOD ") +
                   (m_mayFault && chance(10) ? self() : "(" + self() + " OR " + type + "#1)");
        case 4:
            return self() + (chance(50) ? " AND " : " XOR ") + self();
        case 5:
            return (chance(50) ? "SHL(" : "SHR(") + self() + ", " + expression("INT", 1) + ")";
        case 6:
            return (chance(50) ? "MIN(" : "MAX(") + self() + ", " + self() + ")";
        case 7:
            return "SEL(" + expression("BOOL", depth) + ", " + self() + ", " + self() + ")";
        case 8:
            return "LIMIT(" + self() + ", " + self() + ", " + self() + ")";
        case 9:
        case 10: {
            const std::string from = oneOf(kIntegers);
            return from + "_TO_" + type + "(" + expression(from, depth) + ")";
        }
        case 11: {
            const std::string from = chance(70) ? oneOf(kReals) : chance(50) ? "TIME" : "BOOL";
            return from + "_TO_" + type + "(" + expression(from, depth) + ")";
        }
        case 12:
            return "STRING_TO_" + type + "(" + expression("STRING", depth) + ")";
        case 13:
            if (type == "DINT" && m_mayFault && chance(20))
                return object() + ".Share(" + expression("INT", depth) + ")";
            if (type == "DINT") return object() + ".Add(n := " + expression("INT", depth) + ")";
            if (type == "INT" && chance(40)) return object() + ".Level";
            return type == "INT" ? "Mixed(" + expression("INT", depth) + ", " + expression("INT", depth) + ")"
                                 : "NOT " + self();
        default:
            return (chance(50) ? "ABS(" : "MUX(" + expression("INT", 1) + ", " + self() + ", ") + self() + ")";
        }
    }
    std::string real(const std::string& type, int depth) {
        const auto self = [&] { return "(" + expression(type, depth) + ")"; };
        switch (pick(10)) {
        case 0:
            return self() + " + " + self();
        case 1:
            return self() + " - " + self();
        case 2:
            return self() + " * " + self();
        case 3:
            return self() + " / " + self();
        case 4:
            return "SQRT(" + self() + ")";
        case 5:
            return "SIN(" + self() + ")";
        case 6:
            return "MAX(" + self() + ", " + self() + ")";
        case 7: {
            const std::string from = chance(70) ? oneOf(kIntegers) : type == "REAL" ? "LREAL" : "REAL";
            return from + "_TO_" + type + "(" + expression(from, depth) + ")";
        }
        case 8:
            return "SEL(" + expression("BOOL", depth) + ", " + self() + ", " + self() + ")";
        default:
            return "-" + self();
        }
    }
    std::string duration(int depth) {
        switch (pick(6)) {
        case 5: {
            const std::string type = oneOf(kDates);
            return "(" + expression(type, depth) + ") - (" + expression(type, depth) + ")";
        }
        case 0:
            return "(" + expression("TIME", depth) + ") + (" + expression("TIME", depth) + ")";
        case 1:
            return "(" + expression("TIME", depth) + ") - (" + expression("TIME", depth) + ")";
        case 2:
            return "(" + expression("TIME", depth) + ") * (" + expression("INT", depth) + ")";
        case 3:
            return "DINT_TO_TIME(" + expression("DINT", depth) + ")";
        default:
            return "MIN(" + expression("TIME", depth) + ", " + expression("TIME", depth) + ")";
        }
    }
    std::string text(int depth) {
        switch (pick(6)) {
        case 0:
            return "CONCAT(" + expression("STRING", depth) + ", " + expression("STRING", depth) + ")";
        case 1:
            return "LEFT(" + expression("STRING", depth) + ", " + expression("INT", 1) + ")";
        case 2:
            return "MID(" + expression("STRING", depth) + ", " + expression("INT", 1) + ", " + expression("INT", 1) +
                   ")";
        case 3:
            return "INT_TO_STRING(" + expression("INT", depth) + ")";
        case 4:
            return "REPLACE(" + expression("STRING", depth) + ", " + expression("STRING", depth) + ", 1, 2)";
        default:
            return "SEL(" + expression("BOOL", depth) + ", " + expression("STRING", depth) + ", " +
                   expression("STRING", depth) + ")";
        }
    }

    std::mt19937 m_random;
    bool m_mayFault;
    std::string m_counters;
    int m_loops = 0;
};

} // namespace

std::string randomPrelude() { return kPrelude; }

RandomProgram randomProgram(uint32_t seed, Faults faults, const std::string& name) {
    RandomProgram made{seed, name, {}, {}};
    made.text = Generator(seed, faults == Faults::Possible).program(name, made.watched);
    return made;
}

} // namespace plc::golden
