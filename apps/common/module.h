/* module.h: what few runs need, and what loads libraries of its own, is a module: it is loaded when
 * it is asked for.
 */
#ifndef APP_MODULE_H
#define APP_MODULE_H

/* The table or function of that name in the module NAME.so, which lies beside the programs, as they
 * are built, or where it was installed. What it loads in turn is seen by others. NULL: there is
 * none, as dlerror says. */
void *app_module_symbol(const char *name, const char *symbol);

#endif
