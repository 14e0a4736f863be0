// The program: reads the command line, runs one command, turns an Error into exit 2.
#include <malloc.h>

#include "game/app/run.h"

int main(int argc, char** argv) {
    // Buffers of more than 1 MB come and go by mmap. Left alone, glibc raises that bound to 32 MB at the first of them that is
    // freed, and from then on they lie between the small blocks of the heap, which grows. To name the one bound fixes the
    // other too: the end of the heap is given back above 64 MB, not 128 KB, else every frame would ask for it anew.
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
    return luftpost::app::run(argc, argv);
}
