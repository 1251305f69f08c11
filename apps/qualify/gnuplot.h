/* gnuplot.h: gnuplot, if it is there. */
#ifndef QUALIFY_GNUPLOT_H
#define QUALIFY_GNUPLOT_H

typedef enum qualify_drawn {
    QUALIFY_DRAWN = 0,
    QUALIFY_NO_GNUPLOT, /* it is not installed */
    QUALIFY_NOT_DRAWN   /* it cannot be started, or failed; a message said so */
} qualify_drawn;

/* Run that script in that folder. */
qualify_drawn qualify_gnuplot(const char *folder, const char *script);

#endif
