#include "projects/model/project.h"

namespace plc::projects {

driver::BuildInput Project::buildInput() const { return {sources, libraries, false}; }

} // namespace plc::projects
