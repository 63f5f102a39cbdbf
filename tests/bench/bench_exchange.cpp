// A TwinCAT tree of the wanted size (60,000 lines if nothing is said): read, turned into a project, checked.
#include "projects/exchange/base/assemble.h"
#include "projects/exchange/import.h"
#include "tests/bench/program_generator.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

const char* elementOf(plc::exchange::PieceKind kind) {
    if (kind == plc::exchange::PieceKind::Type) return "DUT";
    return kind == plc::exchange::PieceKind::Globals ? "GVL" : "POU";
}

/// One unit of the generated text as TwinCAT stores it.
void writeUnit(const fs::path& folder, const std::string& unit, int number) {
    const plc::exchange::PieceKind kind = plc::exchange::kindOfDeclaration(unit);
    const std::string element = elementOf(kind);
    std::string declaration = unit, body;
    if (element == "POU") {
        const size_t vars = unit.rfind("END_VAR\n");
        const size_t split = vars == std::string::npos ? unit.find('\n') + 1 : vars + 8;
        declaration = unit.substr(0, split);
        body = unit.substr(split, unit.rfind("END_") - split);
    }
    std::string name = plc::exchange::nameInDeclaration(unit);
    if (name.empty()) name = "List" + std::to_string(number);
    const std::string ending = element == "POU" ? ".TcPOU" : element == "DUT" ? ".TcDUT" : ".TcGVL";
    std::ofstream(folder / (name + "_" + std::to_string(number) + ending))
        << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<TcPlcObject Version=\"1.1.0.1\"><" << element << " Name=\""
        << name << "\"><Declaration><![CDATA[" << declaration << "]]></Declaration><Implementation><ST><![CDATA["
        << body << "]]></ST></Implementation></" << element << "></TcPlcObject>\n";
}

void writeTree(const fs::path& folder, const std::string& text) {
    std::istringstream in(text);
    std::string unit;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        unit += line + "\n";
        const bool ends = line.starts_with("END_PROGRAM") || line.starts_with("END_FUNCTION") ||
                          line.starts_with("END_TYPE") ||
                          (line.starts_with("END_VAR") &&
                           plc::exchange::kindOfDeclaration(unit) == plc::exchange::PieceKind::Globals);
        if (!ends) continue;
        const fs::path inner = folder / ("Part" + std::to_string(number / 50));
        fs::create_directories(inner);
        writeUnit(inner, unit, number++);
        unit.clear();
    }
}

} // namespace

int main(int argc, char** argv) {
    const size_t lines = argc > 1 ? static_cast<size_t>(std::atol(argv[1])) : 60'000;
    const fs::path folder = fs::temp_directory_path() / ("bench-exchange-" + std::to_string(::getpid()));
    writeTree(folder, plc::bench::generateProgram(lines));
    const auto begin = std::chrono::steady_clock::now();
    const auto imported = plc::exchange::importFrom(folder.string());
    if (!imported) {
        std::fprintf(stderr, "%s\n", imported.error().english().c_str());
        return 1;
    }
    const double read = secondsSince(begin);
    const plc::driver::Checked checked = plc::driver::check(plc::exchange::toProject(*imported).buildInput());
    const double all = secondsSince(begin);
    size_t count = 0;
    for (const auto& file : imported->files)
        count += static_cast<size_t>(std::count(file.text.begin(), file.text.end(), '\n'));
    std::printf("| files | lines | import | import and check | errors |\n|---|---|---|---|---|\n| %zu | %zu | %.2f s | "
                "%.2f s | %s |\n",
                imported->files.size(), count, read, all, checked.analysis->hasErrors ? "yes" : "none");
    fs::remove_all(folder);
    return 0;
}
