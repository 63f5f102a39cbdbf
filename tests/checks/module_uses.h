// The modules and what each of them uses, as the configure step has written it down (module_uses.txt).
#pragma once
#include <map>
#include <set>
#include <string>

/// Module -> the modules it declares to use.
[[nodiscard]] std::map<std::string, std::set<std::string>> declaredUses();
