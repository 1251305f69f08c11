/* readme.h: what the folder of the benchmark says of itself. */
#ifndef QUALIFY_README_H
#define QUALIFY_README_H

#include <stdio.h>

/* README.md; what is not used. */
void qualify_put_readme(FILE *f, const void *what);

#endif
