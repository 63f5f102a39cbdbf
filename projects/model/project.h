// A project in memory: what project.json says and which files it has. A value; the storage module reads and writes it.
#pragma once
#include "runtime/compiler/driver/driver.h"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plc::projects {

struct Project {
    std::string folder; // absolute; empty for loose ST files
    std::string name;
    std::vector<std::string> libraries; // lower case: "toolbox"
    std::vector<std::string> defines;   // "Simulation", "Version=2": what conditional pragmas ask for
    image::Addressing addressing = image::Addressing::Bytes; // "byte" or "word": what the number of %MW1 counts
    uint32_t memoryForNew = 0;                               // bytes that __NEW may take; 0: the project has no __NEW
    types::StringCode strings = types::StringCode::Latin1;   // "stringEncoding": what the bytes of a STRING are
    std::string startPanel;                                  // panel file name without ".panel.json"
    std::vector<std::string> languages;                      // BCP 47, ordered; empty = {"en"}
    std::vector<std::string> fallback;                       // chain of languages
    std::string font = "Noto Sans";
    std::string languageVariable;            // path, may be empty
    std::string calendarStart;               // "DT#…", empty = DT#2000-01-01-00:00:00
    nlohmann::ordered_json json;             // the file as read: unknown fields are kept in place
    std::vector<driver::SourceFile> sources; // src/*.st by name; path relative to the folder ("src/main.st")
    std::vector<driver::SourceFile> tests;   // tests/*.st
    std::vector<std::string> panels, traces; // file names
    std::vector<std::string> companions;     // texts of panels, alarms, texts and traces: a variable they name is used
    std::vector<std::pair<std::string, std::string>> encodings; // sources that are not UTF-8: path, encoding
    [[nodiscard]] driver::BuildInput buildInput() const;
};

} // namespace plc::projects
