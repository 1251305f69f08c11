/* options.h: argp, which also suggests what an unknown long option may have meant, and lists its
 * options for the completion of shells.
 */
#ifndef APP_OPTIONS_H
#define APP_OPTIONS_H

#include <argp.h>

/* argp_parse with three additions: errors are reported in JSON from here on if --json, without a
 * value, is among the options; an unknown long option ends the program with APP_USAGE and the name
 * nearest to it; the single word --list-options prints a line for each option and ends the program:
 *
 *     --name TAB short letter or nothing TAB what it takes or nothing TAB meaning
 *
 * An optional value is in brackets.
 */
void app_options_parse(const struct argp *argp, int argc, char **argv, void *input);

#endif
