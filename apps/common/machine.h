/* machine.h: the hardware and software of a measurement, as a paper would cite them. Sources:
 * Linux's /proc/cpuinfo, /etc/os-release, uname(2), sysconf(3), getloadavg(3). "unknown" or 0 if
 * these give no value. */
#ifndef APP_MACHINE_H
#define APP_MACHINE_H

#include <stdint.h>

typedef struct app_machine {
    char cpu[200], os[200], kernel[200];
    long cores;      /* that may be used */
    uint64_t memory; /* [bytes] */
    double load;     /* average of the last minute, now */
    const char *compiler, *flags, *commit;
} app_machine;

app_machine app_machine_find(void);

#endif
