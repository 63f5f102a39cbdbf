// What a test run found, as lines of the log. GUI thread.
#pragma once
#include "projects/testing/test_run.h"

namespace plc::editor {
class EventLog;
}

namespace plc::app {

void logTests(editor::EventLog& log, const testing::Report& report);

} // namespace plc::app
