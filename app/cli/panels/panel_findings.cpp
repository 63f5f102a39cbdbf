#include "app/cli/panels/panel_findings.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

namespace plc::cli {

bool hasPanels(const projects::Project& project) {
    if (project.folder.empty()) return false;
    std::error_code ignored;
    const std::filesystem::path folder = std::filesystem::path(project.folder) / "hmi";
    return !project.panels.empty() || std::filesystem::exists(folder / "texts.csv", ignored) ||
           std::filesystem::exists(folder / "alarms.json", ignored) ||
           std::filesystem::exists(folder / "recipes.json", ignored);
}

void printFindings(const std::vector<hmi::Finding>& findings, std::ostream& out) {
    std::vector<const hmi::Finding*> order;
    for (const hmi::Finding& one : findings) order.push_back(&one);
    std::stable_sort(order.begin(), order.end(),
                     [](const hmi::Finding* a, const hmi::Finding* b) { return a->isError > b->isError; });
    for (const hmi::Finding* one : order) out << one->text().toStdString() << "\n";
}

std::string renderJson(const hmi::Finding& finding) {
    nlohmann::ordered_json object;
    object["file"] = finding.file.toStdString();
    if (finding.line > 0) object["line"] = finding.line;
    if (!finding.element.isEmpty()) object["element"] = finding.element.toStdString();
    if (!finding.property.isEmpty()) object["property"] = finding.property.toStdString();
    if (!finding.language.isEmpty()) object["language"] = finding.language.toStdString();
    object["code"] = finding.code().toStdString();
    object["severity"] = finding.isError ? "error" : "warning";
    object["message"] = finding.message.english();
    if (!finding.why.isEmpty()) object["why"] = finding.why.english();
    if (!finding.fix.isEmpty()) object["fixable"] = true;
    return object.dump();
}

} // namespace plc::cli
