#pragma once

namespace luftpost::app {
/// Runs the command of the command line. Returns the exit code: 0 success, 2 bad input (one line on stderr).
int run(int argc, char** argv);
}  // namespace luftpost::app
