/* need.h: memory that a command cannot do without. */
#ifndef APP_NEED_H
#define APP_NEED_H

/* Returns p; if it is NULL, exits with APP_INTERNAL after a message. */
void *app_need(void *p);
/* From here on do the same when GMP gets no memory for a number, instead of aborting. */
void app_need_limbs(void);

#endif
