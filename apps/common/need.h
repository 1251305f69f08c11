/* need.h: memory that a command cannot do without. */
#ifndef APP_NEED_H
#define APP_NEED_H

/* A pointer that must not be NULL: else says so and exits with APP_INTERNAL. */
void *app_need(void *p);
/* From here on the same where GMP gets no memory for a number: by itself it would abort. */
void app_need_limbs(void);

#endif
