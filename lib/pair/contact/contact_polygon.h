/* contact_polygon.h: what two small convex polygons in one plane have in common. */
#ifndef FMB_PAIR_CONTACT_CONTACT_POLYGON_H
#define FMB_PAIR_CONTACT_CONTACT_POLYGON_H

/* Of two polygons of 64 corners each. */
enum { FMB_POLYGON_MOST = 128 };

/* Corners against the clock; two of a segment, one of a point. */
typedef struct fmb_polygon {
    int n;
    double x[FMB_POLYGON_MOST][2];
} fmb_polygon;

/* The hull of the points of p, in place; what is within `fuzz` of a side is no corner. */
void fmb_polygon_hull(fmb_polygon *p, double fuzz);

/* The common points of two hulls that have some, up to fuzz; at least one corner. */
void fmb_polygon_meet(const fmb_polygon *a, const fmb_polygon *b, double fuzz, fmb_polygon *out);

/* No more than four corners are left: two that are far apart, and the farthest on either side. */
void fmb_polygon_reduce(fmb_polygon *p);

#endif
