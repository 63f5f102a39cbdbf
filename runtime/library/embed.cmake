# Writes the C++ table of the library texts: cmake -DROOT=<st folder> -DOUT=<file.cpp> -P embed.cmake
# One folder is one library; the order is that of the names, so the table is the same on every machine.
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/*.st)
list(SORT files)
set(texts "")
set(rows "")
set(index 0)
foreach(file ${files})
    get_filename_component(library ${file} DIRECTORY)
    get_filename_component(name ${file} NAME)
    file(READ ${ROOT}/${file} text)
    string(APPEND texts "constexpr char text${index}[] = R\"st__(${text})st__\";\n")
    string(APPEND rows "    {\"${library}\", \"${name}\", {text${index}, sizeof text${index} - 1}},\n")
    math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${OUT} "// Generated from runtime/library/st by embed.cmake.
#include \"runtime/library/sources.h\"

namespace plc::library {
namespace {
${texts}
constexpr Source table[] = {
${rows}};
} // namespace

std::span<const Source> sources() { return table; }
} // namespace plc::library
")
