/* commands.h: the studies of fmb-qualify. */
#ifndef QUALIFY_COMMANDS_H
#define QUALIFY_COMMANDS_H

/* argv[0] is "fmb-qualify rules" and the like; an exit code. */
int qualify_rules(int argc, char **argv);

#endif
