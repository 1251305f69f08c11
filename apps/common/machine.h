/* machine.h: what a measurement was made on and with. */
#ifndef APP_MACHINE_H
#define APP_MACHINE_H

typedef struct app_machine {
    char cpu[200];
    const char *compiler, *flags, *commit;
} app_machine;

app_machine app_machine_find(void);

#endif
