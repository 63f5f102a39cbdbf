// One meaning everywhere: each row below is computed by the constant folder, by quick and by optimised code and by the
// expression evaluator, and all four must give the same. Rows are made from the tables of types and standard functions,
// so that nothing is left out.
#include "tests/golden/agreement_test.h"

#include "runtime/compiler/driver/driver.h"
#include "runtime/controller/controller.h"
#include "runtime/library/signatures.h"
#include "runtime/types/conversion.h"

#include <gtest/gtest.h>

#include <random>

namespace plc::golden {
namespace {

struct Operand {
    std::string type, literal; // "INT", "5"
};
struct Row {
    std::string result;
    std::string expression; // $0, $1 … stand for the operands
    std::vector<Operand> operands;
};

bool isQuoted(const Operand& operand) { return operand.literal.starts_with('\'') || operand.literal.starts_with('"'); }
std::string typedLiteral(const Operand& operand) {
    return isQuoted(operand) || operand.literal.find('#') != std::string::npos || operand.type == "BOOL"
               ? operand.literal
               : operand.type + "#" + operand.literal;
}

template <class Name> std::string filledIn(const Row& row, Name name) {
    std::string text;
    for (size_t i = 0; i < row.expression.size(); ++i) {
        if (row.expression[i] == '$')
            text += name(static_cast<size_t>(row.expression[++i] - '0'));
        else
            text += row.expression[i];
    }
    return text;
}

std::string variable(size_t row, size_t operand) { return "o" + std::to_string(row) + "_" + std::to_string(operand); }

std::string programOf(const std::vector<Row>& rows) {
    std::string declarations, statements;
    for (size_t r = 0; r < rows.size(); ++r) {
        for (size_t i = 0; i < rows[r].operands.size(); ++i)
            declarations +=
                variable(r, i) + " : " + rows[r].operands[i].type + " := " + rows[r].operands[i].literal + ";\n";
        const std::string number = std::to_string(r);
        declarations += "v" + number + ", c" + number + " : " + rows[r].result + ";\n";
        statements += "v" + number + " := " + filledIn(rows[r], [&](size_t i) { return variable(r, i); }) + ";\n";
        statements += "c" + number +
                      " := " + filledIn(rows[r], [&](size_t i) { return typedLiteral(rows[r].operands[i]); }) + ";\n";
    }
    return "PROGRAM Main\nVAR\n" + declarations + "END_VAR\n" + statements + "END_PROGRAM\n";
}

std::string valueAt(const image::CompiledProgram& program, std::span<const std::byte> image, const std::string& path) {
    const auto place = program.layout.find(path);
    if (!place) return place.error().english();
    return types::toText(*program.layout.types, types::readValue(*program.layout.types, place->type,
                                                                 image.subspan(place->offset), place->bit));
}

void expectAgreement(const std::vector<Row>& rows) {
    driver::BuildInput input;
    input.files.push_back({"rows.st", programOf(rows)});
    const driver::Built built = driver::build(input);
    ASSERT_EQ(built.failure.english(), "");
    for (const auto& diagnostic : built.checked.analysis->diagnostics)
        if (diagnostic.severity == diagnostics::Severity::Error)
            ADD_FAILURE() << diagnostics::renderText(*built.checked.sources, diagnostic, false);
    ASSERT_TRUE(built.program);
    const auto scanned = [&] {
        controller::Controller controller(built.program);
        controller.start();
        EXPECT_TRUE(controller.scan()) << controller.fault()->message.english();
        return std::vector<std::byte>(controller.image().begin(), controller.image().end());
    };
    const std::vector<std::byte> quick = scanned();
    ASSERT_TRUE(driver::optimise(built));
    const std::vector<std::byte> optimised = scanned();
    for (size_t r = 0; r < rows.size(); ++r) {
        const std::string number = std::to_string(r),
                          shown = filledIn(rows[r], [&](size_t i) {
                              return rows[r].operands[i].type + " " + rows[r].operands[i].literal;
                          });
        const std::string value = valueAt(*built.program, quick, "Main.v" + number);
        EXPECT_EQ(valueAt(*built.program, optimised, "Main.v" + number), value) << "optimised " << shown;
        EXPECT_EQ(valueAt(*built.program, quick, "Main.c" + number), value) << "folded " << shown;
        const auto expression = driver::compileExpression(
            built.checked, filledIn(rows[r], [&](size_t i) { return variable(r, i); }), "Main");
        if (!expression) {
            ADD_FAILURE() << shown << ": " << expression.error().message.english();
            continue;
        }
        const auto outcome = expression->evaluate(quick);
        const auto place = built.program->layout.find("Main.v" + number);
        ASSERT_TRUE(outcome.hasValue()) << shown << ": " << outcome.reason.english();
        EXPECT_EQ(types::toText(expression->types(), types::convert(expression->types(), outcome.value, place->type)),
                  value)
            << "evaluated " << shown;
    }
}

const std::vector<std::string> kTypes{"BOOL",  "BYTE", "WORD",  "DWORD", "LWORD",  "SINT",   "INT",
                                      "DINT",  "LINT", "USINT", "UINT",  "UDINT",  "ULINT",  "REAL",
                                      "LREAL", "TIME", "LTIME", "DATE",  "LDATE",  "TOD",    "LTOD",
                                      "DT",    "LDT",  "CHAR",  "WCHAR", "STRING", "WSTRING"};

std::vector<std::string> samplesOf(const std::string& type) {
    if (type == "BOOL") return {"FALSE", "TRUE"};
    if (type == "REAL") return {"0.0", "0.5", "1.5", "2.5", "-2.5", "1.0E10", "-1.0E30", "16777217.0", "300.7", "0.1"};
    if (type == "LREAL")
        return {"0.0", "0.5", "1.5", "2.5", "-2.5", "1.0E19", "-1.0E300", "9007199254740993.0", "65535.5", "0.1"};
    if (type == "TIME") return {"T#0s", "T#1s500ms", "T#-1500us", "T#50d", "T#1d2h3m4s5ms6us7ns"};
    if (type == "LTIME") return {"LTIME#0s", "LTIME#1us7ns", "LTIME#-3s"};
    if (type == "DATE") return {"D#1970-01-01", "D#2024-02-29", "D#1969-12-31"};
    if (type == "LDATE") return {"LDATE#1970-01-02", "LDATE#2024-02-29"};
    if (type == "TOD") return {"TOD#00:00:00", "TOD#23:59:59.999", "TOD#06:30:00"};
    if (type == "LTOD") return {"LTOD#00:00:01", "LTOD#23:59:59.999999999"};
    if (type == "DT") return {"DT#1970-01-01-00:00:00", "DT#2024-02-29-06:30:15.25", "DT#1969-12-31-23:59:59"};
    if (type == "LDT") return {"LDT#1970-01-01-00:00:01", "LDT#2024-02-29-06:30:15.000000001"};
    if (type == "CHAR") return {"'A'", "'\u00e9'", "'5'"};
    if (type == "WCHAR") return {"\"A\"", "\"\u20ac\""};
    if (type == "STRING")
        return {"''",          "'123'",         "' -5 x'",        "'3.75'",
                "'TRUE'",      "'T#1s'",        "'D#2024-02-29'", "'DT#2024-02-29-06:30:00'",
                "'TOD#06:30'", "'99999999999'", "'abc\u00e9'"};
    if (type == "WSTRING") return {"\"\"", "\"123\"", "\"\u20ac5\"", "\"-1.5e3\"", "\"T#1s\""};
    const types::TypeTable table;
    for (uint32_t k = 0; k <= static_cast<uint32_t>(types::TypeKind::Wchar); ++k) {
        const auto kind = static_cast<types::TypeKind>(k);
        if (types::spelling(kind) != type) continue;
        const auto [low, high] = types::TypeTable::integerRange(kind);
        std::vector<std::string> out{"0", "1", "100", std::to_string(high)};
        if (low != 0) out.insert(out.end(), {std::to_string(low), "-1"});
        return out;
    }
    return {};
}

class AgreementTest : public testing::Test {
public:
    explicit AgreementTest(std::vector<Row> rows) : m_rows(std::move(rows)) {}
    void TestBody() override {
        constexpr size_t kRowsOfOneProgram = 200; // a single body with thousands of statements takes the optimiser long
        for (size_t at = 0; at < m_rows.size(); at += kRowsOfOneProgram) {
            const auto end = std::min(m_rows.size(), at + kRowsOfOneProgram);
            expectAgreement(
                {m_rows.begin() + static_cast<std::ptrdiff_t>(at), m_rows.begin() + static_cast<std::ptrdiff_t>(end)});
        }
    }

private:
    std::vector<Row> m_rows;
};

void add(const std::string& name, std::vector<Row> rows) {
    testing::RegisterTest("Agreement", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [rows = std::move(rows)]() -> testing::Test* { return new AgreementTest(rows); });
}

void addConversions() {
    for (const std::string& from : kTypes) {
        std::vector<Row> rows;
        for (const std::string& to : kTypes)
            for (const std::string& sample : samplesOf(from))
                rows.push_back({to, from + "_TO_" + to + "($0)", {{from, sample}}});
        add("ConversionsFrom" + from, std::move(rows));
    }
}

bool isOneOf(const std::string& type, std::initializer_list<const char*> list) {
    return std::any_of(list.begin(), list.end(), [&](const char* name) { return type == name; });
}
bool isReal(const std::string& type) { return isOneOf(type, {"REAL", "LREAL"}); }
bool isInteger(const std::string& type) {
    return isOneOf(
        type, {"BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT"});
}

void addOperators() {
    for (const std::string& type : kTypes) {
        std::vector<Row> rows;
        const auto samples = samplesOf(type);
        for (const std::string& a : samples) {
            for (const std::string& b : samples) {
                const std::vector<Operand> operands{{type, a}, {type, b}};
                for (const char* op : {"=", "<>", "<", "<=", ">", ">="})
                    rows.push_back({"BOOL", std::string("$0 ") + op + " $1", operands});
                if (isReal(type) || isInteger(type) || isOneOf(type, {"TIME", "LTIME"}))
                    for (const char* op : {"+", "-"}) rows.push_back({type, std::string("$0 ") + op + " $1", operands});
                if (isReal(type) || isInteger(type)) rows.push_back({type, "$0 * $1", operands});
                if (isReal(type) || (isInteger(type) && b != "0")) rows.push_back({type, "$0 / $1", operands});
                if (isInteger(type) && b != "0") rows.push_back({type, "$0 MOD $1", operands});
                if (isInteger(type) || type == "BOOL")
                    for (const char* op : {"AND", "OR", "XOR"})
                        rows.push_back({type, std::string("$0 ") + op + " $1", operands});
                for (const char* function : {"MAX", "MIN"})
                    rows.push_back({type, std::string(function) + "($0, $1)", operands});
                rows.push_back({type, "SEL(TRUE, $0, $1)", operands});
                rows.push_back({type, "MUX(1, $0, $1)", operands});
                rows.push_back({type, "LIMIT($0, $1, $0)", operands});
            }
            if (isReal(type) || isInteger(type) || isOneOf(type, {"TIME", "LTIME"})) {
                rows.push_back({type, "-$0", {{type, a}}});
                rows.push_back({type, "ABS($0)", {{type, a}}});
            }
            if (isInteger(type) || type == "BOOL") rows.push_back({type, "NOT $0", {{type, a}}});
            if (isInteger(type))
                for (const char* function : {"INC($0)", "DEC($0)", "SQR($0)"})
                    rows.push_back({type, function, {{type, a}}});
        }
        add("OperatorsOn" + type, std::move(rows));
    }
}

void addShifts() {
    std::vector<Row> rows;
    for (const std::string& type : kTypes) {
        if (!isInteger(type)) continue;
        for (const char* function : {"SHL", "SHR", "ROL", "ROR"})
            for (const char* count : {"-1", "0", "1", "7", "8", "15", "16", "31", "33", "63", "64", "100"})
                for (const std::string& a : samplesOf(type))
                    rows.push_back({type, std::string(function) + "($0, $1)", {{type, a}, {"INT", count}}});
    }
    add("Shifts", std::move(rows));
}

void addRealFunctions() {
    std::mt19937 random(7);
    std::vector<Row> rows;
    for (const std::string& type : {std::string("REAL"), std::string("LREAL")}) {
        std::vector<std::string> values{"0.0", "1.0", "-1.0", "0.5", "2.5", "-2.5", "100.0"};
        for (int i = 0; i < 40; ++i)
            values.push_back(
                std::to_string(std::uniform_real_distribution<>(i % 2 ? -1.0 : -500.0, i % 2 ? 1.0 : 500.0)(random)));
        for (const std::string& x : values) {
            for (const char* function : {"SQRT", "LN",    "LOG",  "EXP",    "SIN",        "COS",        "TAN",
                                         "ASIN", "ACOS",  "ATAN", "SINH",   "COSH",       "TANH",       "FLOOR",
                                         "CEIL", "ROUND", "FRAC", "LTRUNC", "DEG_TO_RAD", "RAD_TO_DEG", "SQR"})
                rows.push_back({type, std::string(function) + "($0)", {{type, x}}});
            rows.push_back({"DINT", "TRUNC($0)", {{type, x}}});
            rows.push_back({"BOOL", "IS_VALID(LN($0))", {{type, x}}});
            rows.push_back({type, "ATAN2($0, $1)", {{type, x}, {type, values[random() % values.size()]}}});
            rows.push_back({type, "EXPT($0, $1)", {{type, x}, {type, values[random() % values.size()]}}});
            rows.push_back(
                {type, "EXPT($0, $1)", {{type, x}, {"INT", std::to_string(static_cast<int>(random() % 9) - 4)}}});
            rows.push_back({"TIME", "MULTIME($0, $1)", {{"TIME", "T#1s7ms"}, {type, x}}});
            rows.push_back({"TIME", "DIVTIME($0, $1)", {{"TIME", "T#1s7ms"}, {type, x}}});
        }
    }
    add("RealFunctions", std::move(rows));
}

void addPowers() {
    std::vector<Row> rows;
    for (const std::string& type : kTypes) {
        if (!isInteger(type)) continue;
        for (const std::string& base : samplesOf(type))
            for (const char* exponent : {"0", "1", "2", "3", "7", "63"})
                rows.push_back({type, "$0 ** $1", {{type, base}, {type, exponent}}});
    }
    add("Powers", std::move(rows));
}

void addTexts() {
    std::mt19937 random(11);
    for (const bool isWide : {false, true}) {
        std::vector<Row> rows;
        const std::string type = isWide ? "WSTRING" : "STRING", quote = isWide ? "\"" : "'";
        const auto text = [&] {
            std::string out = quote;
            for (auto n = random() % 9; n > 0; --n) out += "abcAB "[random() % 6];
            return Operand{type + (random() % 3 ? "" : "(12)"), out + quote};
        };
        const auto number = [&] { return Operand{"INT", std::to_string(static_cast<int>(random() % 13) - 2)}; };
        for (int i = 0; i < 60; ++i) {
            for (const char* function : {"LEFT", "RIGHT"})
                rows.push_back({type, std::string(function) + "($0, $1)", {text(), number()}});
            for (const char* function : {"MID", "DELETE"})
                rows.push_back({type, std::string(function) + "($0, $1, $2)", {text(), number(), number()}});
            rows.push_back({type, "CONCAT($0, $1)", {text(), text()}});
            rows.push_back({type, "CONCAT($0, $1, $2)", {text(), text(), text()}});
            rows.push_back({type, "INSERT($0, $1, $2)", {text(), text(), number()}});
            rows.push_back({type, "REPLACE($0, $1, $2, $3)", {text(), text(), number(), number()}});
            rows.push_back({"INT", "FIND($0, $1)", {text(), text()}});
            rows.push_back({"INT", "LEN($0)", {text()}});
            rows.push_back({type, "TO_UPPER($0)", {text()}});
            rows.push_back({type, "TO_LOWER($0)", {text()}});
            rows.push_back({type, "TRIM($0)", {text()}});
            rows.push_back({"BOOL", "$0 < $1", {text(), text()}});
            rows.push_back({type + "(5)", "CONCAT($0, $1)", {text(), text()}});
        }
        add(isWide ? "WideTexts" : "Texts", std::move(rows));
    }
}

void addDates() {
    std::vector<Row> rows;
    for (const char* date : {"D#1970-01-01", "D#2000-02-29", "D#1969-12-31", "D#2099-12-31", "D#2024-03-01"}) {
        for (const char* part : {"YEAR_OF", "MONTH_OF", "DAY_OF", "DAY_OF_WEEK"})
            rows.push_back({"INT", std::string(part) + "($0)", {{"DATE", date}}});
        rows.push_back({"DT", "CONCAT_DATE_TOD($0, $1)", {{"DATE", date}, {"TOD", "TOD#06:30:00"}}});
        rows.push_back({"TIME", "$0 - $1", {{"DATE", date}, {"DATE", "D#2000-01-01"}}});
    }
    for (const char* time : {"TOD#00:00:00", "TOD#23:59:59.999", "TOD#06:30:15.5"}) {
        for (const char* part : {"HOUR_OF", "MINUTE_OF", "SECOND_OF", "MILLISECOND_OF"})
            rows.push_back({"INT", std::string(part) + "($0)", {{"TOD", time}}});
        for (const char* span : {"T#1h", "T#-7h", "T#25h"}) {
            rows.push_back({"TOD", "$0 + $1", {{"TOD", time}, {"TIME", span}}});
            rows.push_back({"TOD", "$0 - $1", {{"TOD", time}, {"TIME", span}}});
        }
        rows.push_back({"TIME", "$0 - $1", {{"TOD", time}, {"TOD", "TOD#12:00:00"}}});
    }
    for (const char* at : {"DT#1970-01-01-00:00:00", "DT#2024-02-29-23:59:59", "DT#1969-12-31-23:00:00"}) {
        for (const char* span : {"T#1h", "T#-7h", "T#400d"}) {
            rows.push_back({"DT", "$0 + $1", {{"DT", at}, {"TIME", span}}});
            rows.push_back({"DT", "$0 - $1", {{"DT", at}, {"TIME", span}}});
        }
        rows.push_back({"TIME", "$0 - $1", {{"DT", at}, {"DT", "DT#2000-01-01-00:00:00"}}});
        rows.push_back({"INT", "HOUR_OF($0)", {{"DT", at}}});
    }
    for (const char* year : {"1600", "1970", "2023", "2024", "9999"})
        for (const char* month : {"0", "2", "12"})
            for (const char* day : {"0", "29", "31"})
                rows.push_back({"DATE", "CONCAT_DATE($0, $1, $2)", {{"INT", year}, {"INT", month}, {"INT", day}}});
    for (const char* hour : {"-1", "0", "23", "24"})
        rows.push_back(
            {"TOD", "CONCAT_TOD($0, $1, $2, $3)", {{"INT", hour}, {"INT", "30"}, {"INT", "15"}, {"INT", "250"}}});
    for (const char* factor : {"-3", "0", "7"})
        rows.push_back({"TIME", "$0 * $1", {{"TIME", "T#1s1ms"}, {"INT", factor}}});
    for (const char* divisor : {"-3", "7", "1"})
        rows.push_back({"TIME", "$0 / $1", {{"TIME", "T#1s1ms"}, {"INT", divisor}}});
    add("Dates", std::move(rows));
}

void addCodes() {
    std::vector<Row> rows;
    for (const char* word : {"0", "16#1234", "16#9999", "16#00A0", "16#FFFF"}) {
        for (const char* to : {"INT", "UINT", "SINT", "ULINT"})
            rows.push_back({to, std::string("BCD_TO_") + to + "($0)", {{"WORD", word}}});
        rows.push_back({"BOOL", "IS_VALID_BCD($0)", {{"WORD", word}}});
        rows.push_back({"WORD", "SWAP($0)", {{"WORD", word}}});
        rows.push_back({"WORD", "TO_BIG_ENDIAN($0)", {{"WORD", word}}});
    }
    for (const char* number : {"0", "42", "9999", "10000", "-1"}) {
        rows.push_back({"WORD", "INT_TO_BCD($0)", {{"INT", number}}});
        rows.push_back({"BYTE", "INT_TO_BCD_BYTE($0)", {{"INT", number}}});
    }
    for (const char* real : {"1.0", "-0.1", "3.0E38"}) rows.push_back({"DWORD", "REAL_AS_DWORD($0)", {{"REAL", real}}});
    for (const char* text : {"'12'", "''", "'1x'", "'-1.5e3'", "'A'"}) {
        rows.push_back({"BOOL", "ISNUMBER($0)", {{"STRING", text}}});
        rows.push_back({"BYTE", "F_TOASC($0)", {{"STRING", text}}});
    }
    for (const char* code : {"0", "65", "233"}) rows.push_back({"STRING", "F_TOCHR($0)", {{"INT", code}}});
    add("Codes", std::move(rows));
}

} // namespace

void registerAgreement() {
    addConversions();
    addOperators();
    addShifts();
    addRealFunctions();
    addPowers();
    addTexts();
    addDates();
    addCodes();
}

} // namespace plc::golden
