/* render.h: report.py, which makes report.html and the figures of report.json. */
#ifndef QUALIFY_RENDER_H
#define QUALIFY_RENDER_H

/* An exit code. Without Python or the script a message says what is missing, and that is no
 * mistake. */
int qualify_render(const char *folder);

#endif
