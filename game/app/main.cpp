// The program: reads the command line, runs one command, turns an Error into exit 2.
#include "game/app/run.h"

int main(int argc, char** argv) { return luftpost::app::run(argc, argv); }
