/* Dies of a signal while it receives: its own fault, or a signal that is sent to it. */
#include "process.h"

#include <sys/resource.h>

int main(int count, char **arguments)
{
    struct rlimit no_core = { 0, 0 };
    int number = count > 1 ? atoi(arguments[1]) : 0, is_fault = count > 2, port = serve(SEND, "1.5");
    volatile int zero = 0, *volatile nowhere = NULL;

    alarm(120);
    setrlimit(RLIMIT_CORE, &no_core);
    /* The parent process may have set the signal to be ignored. */
    signal(number, SIG_DFL);
    CHECK(BRConnectTo("127.0.0.1", port) != NULL);
    if (is_fault && number == SIGSEGV)
        *nowhere = 1;
    else if (is_fault)
        zero = 100 / zero;
    raise(number);
    return zero;
}
