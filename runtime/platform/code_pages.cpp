#include "runtime/platform/code_pages.h"

#include <iconv.h>

namespace plc::platform {

std::array<char16_t, 128> upperHalfOf(const char* codePage) {
    std::array<char16_t, 128> out{};
    const iconv_t conversion = iconv_open("UTF-16LE", codePage);
    if (conversion == reinterpret_cast<iconv_t>(-1)) return out;
    for (size_t i = 0; i < out.size(); ++i) {
        char byte = static_cast<char>(0x80 + i);
        unsigned char unit[2] = {};
        char *from = &byte, *to = reinterpret_cast<char*>(unit);
        size_t left = 1, room = sizeof unit;
        (void)iconv(conversion, nullptr, nullptr, nullptr, nullptr); // a byte without a character leaves nothing behind
        if (iconv(conversion, &from, &left, &to, &room) != static_cast<size_t>(-1) && room == 0)
            out[i] = static_cast<char16_t>(unit[0] | unit[1] << 8);
    }
    iconv_close(conversion);
    return out;
}

} // namespace plc::platform
