// A screen for tests that open a window where there is no display.
#pragma once
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace luftpost::test {
/// Xvfb on the first free number; DISPLAY names it as long as this lives.
class VirtualScreen {
public:
    VirtualScreen() {
        int channel[2];
        if (pipe(channel) != 0) return;
        child_ = fork();
        if (child_ == 0) {
            prctl(PR_SET_PDEATHSIG, SIGKILL);  // never outlives the test
            close(channel[0]);
            for (int stream : {STDOUT_FILENO, STDERR_FILENO}) dup2(open("/dev/null", O_WRONLY), stream);
            std::string const number = fmt::format("{}", channel[1]);
            execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
                   static_cast<char*>(nullptr));
            _exit(127);
        }
        close(channel[1]);
        std::string number;
        for (char letter = 0; read(channel[0], &letter, 1) == 1 && letter != '\n';) number += letter;
        close(channel[0]);
        if (number.empty()) return;
        setenv("DISPLAY", (":" + number).c_str(), 1);
        ready_ = true;
    }
    ~VirtualScreen() {
        if (child_ <= 0) return;
        kill(child_, SIGTERM);
        waitpid(child_, nullptr, 0);
        if (ready_) unsetenv("DISPLAY");
    }
    VirtualScreen(VirtualScreen const&) = delete;
    VirtualScreen& operator=(VirtualScreen const&) = delete;
    bool ready() const { return ready_; }

private:
    pid_t child_ = -1;
    bool ready_ = false;
};
}  // namespace luftpost::test
