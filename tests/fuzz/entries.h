// What the fuzz targets do with their bytes; used by the libFuzzer programs and by the replay of seeds and findings.
#pragma once
#include <string_view>

namespace plc::fuzz {

void lexText(std::string_view bytes);
void parseText(std::string_view bytes);
/// The front end to the checked program: what it says lies in the text, and for some texts is the same when all is
/// read again.
void checkText(std::string_view bytes);
/// Checks, compiles and runs a bounded number of scans; the controller must stay alive whatever the program does.
void runText(std::string_view bytes);
/// The program runs, is exchanged for a mutant of itself (seed from the bytes) and for itself again, state kept.
void changeText(std::string_view bytes);

} // namespace plc::fuzz
