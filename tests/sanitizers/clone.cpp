// The thread sanitizer takes every clone() for a fork: in the child it takes back what it counted before. A
// process that QProcess starts shares the memory of its parent until it is another program (CLONE_VM | CLONE_VFORK), so
// that is taken back twice, and from then on no lock of the calling thread is seen: each of them a race that is none.
// Programs with this file call the C library itself. (A child with memory of its own comes from fork().)
#include <sched.h>

#include <cstdarg>
#include <sys/types.h>

extern "C" {

int __clone(int (*run)(void*), void* stack, int flags, void* argument, ...); // of the C library

__attribute__((visibility("default"), no_sanitize("thread"))) int clone(int (*run)(void*), void* stack, int flags,
                                                                        void* argument, ...) noexcept {
    va_list more;
    va_start(more, argument);
    auto* parentThread = va_arg(more, pid_t*);
    void* storage = va_arg(more, void*);
    auto* childThread = va_arg(more, pid_t*);
    va_end(more);
    return __clone(run, stack, flags, argument, parentThread, storage, childThread);
}
}
