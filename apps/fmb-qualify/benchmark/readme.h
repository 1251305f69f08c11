/* readme.h: the README of the benchmark's folder. */
#ifndef QUALIFY_README_H
#define QUALIFY_README_H

#include <stdio.h>

/* Writes README.md; `what` is unused. */
void qualify_put_readme(FILE *f, const void *what);

#endif
