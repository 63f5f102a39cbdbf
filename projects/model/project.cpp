#include "projects/model/project.h"

namespace plc::projects {

driver::BuildInput Project::buildInput() const {
    driver::BuildInput input{sources, libraries, false, companions, defines};
    input.addressing = addressing;
    input.memoryForNew = memoryForNew;
    input.strings = strings;
    for (const driver::SourceFile& test : tests) input.companions.push_back(test.text);
    return input;
}

} // namespace plc::projects
