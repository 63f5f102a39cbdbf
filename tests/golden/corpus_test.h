// The listings of the source documents (not part of this project): each compiles and gives what its index says. They
// run when the environment variable STEPWISE_CORPUS names their folder; otherwise one test says that they did not.
#pragma once

namespace plc::golden {

void registerCorpus();

} // namespace plc::golden
