#include "runtime/compiler/driver/dynamic_memory.h"

#include <algorithm>

namespace plc::driver {

/// Stretches of units of eight bytes, each behind one unit with its length: positive when free, negative when taken.
/// The first stretch that is long enough is taken; free ones behind each other are joined on the way.
std::string dynamicMemoryText(uint32_t bytes) {
    const std::string last = std::to_string(std::max<uint32_t>(2, bytes / 8) - 1);
    return "VAR_GLOBAL\n    {attribute 'hide'}\n    __memory : ARRAY[0.." + last +
           "] OF LINT;\nEND_VAR\n"
           "VAR_GLOBAL CONSTANT\n    {attribute 'hide'}\n    __lastUnit : LINT := " +
           last +
           ";\nEND_VAR\n"
           R"(
(** The address of so many bytes, 0 when there is no room. *)
FUNCTION __ALLOCATE : LWORD
VAR_INPUT bytes : LINT; END_VAR
VAR need, place, size, behind : LINT; END_VAR
__ALLOCATE := 0;
need := MAX((bytes + 7) / 8, LINT#1);
IF __memory[0] = 0 THEN __memory[0] := __lastUnit; END_IF
WHILE place < __lastUnit DO
    size := __memory[place];
    IF size = 0 THEN RETURN; END_IF
    IF size > 0 THEN
        behind := place + 1 + size;
        WHILE behind <= __lastUnit DO
            IF __memory[behind] <= 0 THEN EXIT; END_IF
            size := size + 1 + __memory[behind];
            behind := place + 1 + size;
        END_WHILE
        IF size >= need THEN
            IF size > need + 1 THEN
                __memory[place + 1 + need] := size - need - 1;
                size := need;
            END_IF
            __memory[place] := -size;
            FOR behind := place + 1 TO place + size DO __memory[behind] := 0; END_FOR
            __ALLOCATE := TO_LWORD(ADR(__memory[place + 1]));
            RETURN;
        END_IF
        __memory[place] := size;
    END_IF
    place := place + 1 + ABS(size);
END_WHILE
END_FUNCTION

(** Gives the bytes at an address of __ALLOCATE back; FALSE when it is none. *)
FUNCTION __RELEASE : BOOL
VAR_INPUT address : LWORD; END_VAR
VAR wanted, place, size, unit : LINT; END_VAR
__RELEASE := FALSE;
wanted := LWORD_TO_LINT(address) - LWORD_TO_LINT(TO_LWORD(ADR(__memory[0])));
IF wanted < 8 THEN RETURN; END_IF
WHILE place < __lastUnit DO
    size := __memory[place];
    IF size = 0 THEN RETURN; END_IF
    IF (place + 1) * 8 = wanted THEN
        IF size > 0 THEN RETURN; END_IF
        FOR unit := place + 1 TO place - size DO __memory[unit] := 0; END_FOR
        __memory[place] := -size;
        __RELEASE := TRUE;
        RETURN;
    END_IF
    place := place + 1 + ABS(size);
END_WHILE
END_FUNCTION
)";
}

} // namespace plc::driver
