// Blocks signals that end the program during the object's lifetime: in this thread. On Windows, where console events run in a thread of their own, in
// the process.
#pragma once

#if defined(_WIN32)
#include "baker/windows_text.h"
#include <atomic>
#else
#include <signal.h>
#endif

namespace lr::baker {

#if defined(_WIN32)

class SignalsHeld {
public:
    SignalsHeld() {
        ++held();
        SetConsoleCtrlHandler(&wait, TRUE);
    }
    ~SignalsHeld() {
        SetConsoleCtrlHandler(&wait, FALSE);
        --held();
    }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

private:
    static std::atomic<int>& held() {
        static constinit std::atomic<int> count = 0;
        return count;
    }
    static BOOL WINAPI wait(DWORD) {
        while (held() > 0) Sleep(1);
        return FALSE; // the next handler ends the program
    }
};

#else

class SignalsHeld {
public:
    SignalsHeld() {
        sigset_t set;
        sigemptyset(&set);
        for (const int s : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) sigaddset(&set, s);
        pthread_sigmask(SIG_BLOCK, &set, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

private:
    sigset_t before_;
};

#endif
} // namespace lr::baker
