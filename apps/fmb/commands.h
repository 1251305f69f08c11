/* commands.h: the subcommands of fmb. Each parses its own words (argv[0] is "fmb NAME"), does its
 * work and returns the exit code. */
#ifndef FMB_COMMANDS_H
#define FMB_COMMANDS_H

int cmd_solve(int argc, char **argv);
int cmd_bounds(int argc, char **argv);
int cmd_optimize(int argc, char **argv);
int cmd_project(int argc, char **argv);
int cmd_reduce(int argc, char **argv);
int cmd_vertices(int argc, char **argv);
int cmd_hull(int argc, char **argv);
int cmd_image(int argc, char **argv);
int cmd_sum(int argc, char **argv);
int cmd_check(int argc, char **argv);
int cmd_convert(int argc, char **argv);
int cmd_intersect(int argc, char **argv);
int cmd_mesh(int argc, char **argv);

#endif
