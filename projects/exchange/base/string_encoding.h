// What a STRING of an imported project is: Latin-1 unless its constants have other characters. Function, any thread.
#pragma once
#include "projects/exchange/base/imported.h"

namespace plc::exchange {

/// Unless the import has found it: CODESYS and TwinCAT keep a STRING in the code page of Windows: the first one that
/// has every character, else UTF-8.
void chooseStringEncoding(Imported& imported);

} // namespace plc::exchange
