// The application object of a fuzz target that draws; kept to the end of the process.
#pragma once
#include <QApplication>

namespace plc::fuzz {

inline void needApplication() {
    static int count = 1;
    static char name[] = "fuzz";
    static char* words[] = {name, nullptr};
    static QApplication* const application = (qputenv("QT_QPA_PLATFORM", "offscreen"), new QApplication(count, words));
    (void)application;
}

} // namespace plc::fuzz
