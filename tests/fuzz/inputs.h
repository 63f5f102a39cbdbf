// What is done with each file that comes from outside besides ST: read, used and written again. Nothing it holds may
// crash, hang or be lost on the way. Used by the libFuzzer program fuzz_inputs and by tests/loaders. Needs a
// QApplication; main thread.
#pragma once
#include <string>

namespace plc::fuzz {

void readPanel(const std::string& bytes);
void readTexts(const std::string& bytes);
void readAlarms(const std::string& bytes);
void readTraceSetup(const std::string& bytes);
void readProjectFile(const std::string& bytes);
void readRecording(const std::string& bytes);
void readRetainFile(const std::string& bytes);
void readRecipes(const std::string& bytes);
void readPeople(const std::string& bytes);
void readTranslations(const std::string& bytes);
void readDevices(const std::string& bytes);
void readForeignTrace(const std::string& bytes);
/// The next byte says whose: PLCopen XML, TwinCAT, an export of CODESYS 2.3.
void readForeignProject(const std::string& bytes);

struct Input {
    const char* name;
    void (*read)(const std::string&);
};
inline constexpr Input kInputs[] = {
    {"panel", readPanel},
    {"texts", readTexts},
    {"alarms", readAlarms},
    {"trace", readTraceSetup},
    {"project", readProjectFile},
    {"recording", readRecording},
    {"retain", readRetainFile},
    {"recipes", readRecipes},
    {"people", readPeople},
    {"xliff", readTranslations},
    {"devices", readDevices},
    {"table", readForeignTrace},
    {"foreign", readForeignProject},
};

} // namespace plc::fuzz
