// Text functions on the bytes of the image, for generated code and as the one implementation behind the evaluator:
// STRING is Latin-1 unless the program says otherwise, WSTRING UTF-16; a text lies in `capacity + 1` characters and
// ends at the first 0 or at its capacity. Nothing allocates but the rare call whose result overlaps an operand and has
// over 1,000 characters, and FIND in long texts; none takes longer than its texts are. Pure functions on their
// arguments, any thread.
//
// What is impossible gives ENO FALSE (the functions return 0): a length below 0 or a position before 1 gives ''. A
// position behind the end takes the end: MID gives '', INSERT and REPLACE append, DELETE removes nothing. Lengths
// beyond the end are cut in silence.
#pragma once
#include "runtime/types/type.h"

#include <cstdint>
#include <span>
#include <string_view>

// Names: plc_text_* takes STRING, plc_wtext_* WSTRING. `to` may overlap operands.
#define PLC_TEXT_FUNCTIONS(Prefix, Character)                                                                          \
    uint32_t Prefix##_length(const Character* text, uint32_t capacity);                                                \
    void Prefix##_assign(Character* to, uint32_t toCapacity, const Character* from, uint32_t fromCapacity);            \
    void Prefix##_append(Character* to, uint32_t toCapacity, const Character* from,                                    \
                         uint32_t fromCapacity); /* CONCAT: assign, append… */                                       \
    int32_t Prefix##_compare(const Character* a, uint32_t aCapacity, const Character* b,                               \
                             uint32_t bCapacity); /* -1, 0, 1 */                                                       \
    uint8_t Prefix##_left(Character* to, uint32_t toCapacity, const Character* text, uint32_t capacity,                \
                          int64_t count);                                                                              \
    uint8_t Prefix##_right(Character* to, uint32_t toCapacity, const Character* text, uint32_t capacity,               \
                           int64_t count);                                                                             \
    uint8_t Prefix##_mid(Character* to, uint32_t toCapacity, const Character* text, uint32_t capacity, int64_t length, \
                         int64_t position);                                                                            \
    uint8_t Prefix##_insert(Character* to, uint32_t toCapacity, const Character* a, uint32_t aCapacity,                \
                            const Character* b, uint32_t bCapacity, int64_t position);                                 \
    uint8_t Prefix##_delete(Character* to, uint32_t toCapacity, const Character* text, uint32_t capacity,              \
                            int64_t length, int64_t position);                                                         \
    uint8_t Prefix##_replace(Character* to, uint32_t toCapacity, const Character* a, uint32_t aCapacity,               \
                             const Character* b, uint32_t bCapacity, int64_t length, int64_t position);                \
    uint32_t Prefix##_find(const Character* a, uint32_t aCapacity, const Character* b,                                 \
                           uint32_t bCapacity); /* from 1; 0 = not there */                                            \
    void Prefix##_upper(Character* to, uint32_t toCapacity, const Character* text, uint32_t capacity);                 \
    void Prefix##_lower(Character* to, uint32_t toCapacity, const Character* text, uint32_t capacity);                 \
    void Prefix##_trim(Character* to, uint32_t toCapacity, const Character* text, uint32_t capacity);                  \
    uint8_t Prefix##_is_number(const Character* text, uint32_t capacity);                                              \
    void Prefix##_from_character(Character* to, uint32_t toCapacity, uint32_t code); /* 0 gives '' */                  \
    /* `kind`: TypeKind of the number. Integers, times, dates and BOOL as int64 (ULINT, LWORD: bit pattern). */        \
    void Prefix##_from_integer(Character* to, uint32_t toCapacity, uint32_t kind, int64_t value);                      \
    void Prefix##_from_real(Character* to, uint32_t toCapacity, uint32_t kind, double value);                          \
    int64_t Prefix##_to_integer(const Character* text, uint32_t capacity, uint32_t kind, uint8_t* ok);                 \
    double Prefix##_to_real(const Character* text, uint32_t capacity, uint32_t kind, uint8_t* ok);

extern "C" {
PLC_TEXT_FUNCTIONS(plc_text, char)
PLC_TEXT_FUNCTIONS(plc_wtext, char16_t)
void plc_text_to_wide(char16_t* to, uint32_t toCapacity, const char* from, uint32_t fromCapacity);
uint8_t plc_wtext_to_narrow(char* to, uint32_t toCapacity, const char16_t* from,
                            uint32_t fromCapacity); // 0: a character became '?'
// Of programs whose STRING is not Latin-1; `code`: types::StringCode.
void plc_text_to_wide_by(char16_t* to, uint32_t toCapacity, const char* from, uint32_t fromCapacity, uint32_t code);
uint8_t plc_wtext_to_narrow_by(char* to, uint32_t toCapacity, const char16_t* from, uint32_t fromCapacity,
                               uint32_t code);
uint32_t plc_char_to_wide_by(uint32_t character, uint32_t code);
int32_t plc_wchar_to_narrow_by(uint32_t character, uint32_t code); // -1: STRING does not have it in one byte
void plc_text_upper_by(char* to, uint32_t toCapacity, const char* text, uint32_t capacity, uint32_t code);
void plc_text_lower_by(char* to, uint32_t toCapacity, const char* text, uint32_t capacity, uint32_t code);
}
#undef PLC_TEXT_FUNCTIONS

// Scalar functions that are too long to be emitted in place. `ok` (never null) receives ENO.
extern "C" {
int64_t plc_date_part(int64_t nanoseconds, int64_t which); // 0 year 1 month 2 day 3 day of week
int64_t plc_time_part(int64_t nanoseconds, int64_t which); // 0 hour 1 minute 2 second 3 millisecond
int64_t plc_concat_date(int64_t year, int64_t month, int64_t day, uint8_t* ok);
int64_t plc_concat_tod(int64_t hour, int64_t minute, int64_t second, int64_t millisecond, uint8_t* ok);
int64_t plc_concat_dt(int64_t year, int64_t month, int64_t day, int64_t hour, int64_t minute, int64_t second,
                      int64_t millisecond, uint8_t* ok);
int64_t plc_bcd_to_integer(uint64_t digits, uint32_t kind,
                           uint8_t* ok); // 0 for a digit above 9 or a number beyond `kind`
int64_t plc_integer_to_bcd(int64_t value, uint32_t fromKind, uint32_t toKind, uint8_t* ok);
uint8_t plc_is_valid_bcd(uint64_t digits);
int64_t plc_power_integer(int64_t base, int64_t exponent);         // modulo 2^64; wrap it in the result's type
int64_t plc_multiply_duration(int64_t nanoseconds, double factor); // nearest even, saturating, NaN gives 0
int64_t plc_divide_duration(int64_t nanoseconds, double divisor);
int64_t plc_real_to_time(double value, uint32_t kind); // REAL_TO_TIME, REAL_TO_DT …
}

namespace plc::library {

struct RuntimeSymbol {
    std::string_view name;
    void* address;
};
/// Every function above, for the JIT's symbol table.
[[nodiscard]] std::span<const RuntimeSymbol> runtimeSymbols();

} // namespace plc::library
