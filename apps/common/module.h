/* module.h: modules: code that few runs need and that depends on further libraries is loaded on
 * demand.
 */
#ifndef APP_MODULE_H
#define APP_MODULE_H

/* The table or function with that symbol in the module NAME.so, which is beside the programs where
 * they are built, or where it was installed. Libraries that it loads are visible to others. NULL:
 * there is none; see dlerror. */
void *app_module_symbol(const char *name, const char *symbol);

#endif
