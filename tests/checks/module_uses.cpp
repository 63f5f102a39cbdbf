#include "tests/checks/module_uses.h"

#include "tests/support/paths.h"

#include <fstream>
#include <sstream>

std::map<std::string, std::set<std::string>> declaredUses() {
    std::map<std::string, std::set<std::string>> uses;
    std::ifstream in(plc::binaryDir() + "/module_uses.txt");
    for (std::string line; std::getline(in, line);) {
        const size_t colon = line.find(':');
        std::istringstream words(line.substr(colon + 1));
        auto& set = uses[line.substr(0, colon)];
        for (std::string word; words >> word;) set.insert(word);
    }
    return uses;
}
