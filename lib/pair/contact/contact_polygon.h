/* contact_polygon.h: the intersection of two small convex polygons in one plane. */
#ifndef FMB_PAIR_CONTACT_CONTACT_POLYGON_H
#define FMB_PAIR_CONTACT_CONTACT_POLYGON_H

/* The most corners of the intersection of two polygons of 64 corners each. */
enum { FMB_POLYGON_MOST = 128 };

/* Corners, counterclockwise; a segment has two, a point one. */
typedef struct fmb_polygon {
    int n;
    double x[FMB_POLYGON_MOST][2];
} fmb_polygon;

/* Replace the points of p by the corners of their hull, without points within `fuzz` of a side. */
void fmb_polygon_hull(fmb_polygon *p, double fuzz);

/* The common points of two hulls that have some, up to fuzz; at least one corner. */
void fmb_polygon_meet(const fmb_polygon *a, const fmb_polygon *b, double fuzz, fmb_polygon *out);

/* Keep at most four corners: two that are far apart, and the farthest on either side of them. */
void fmb_polygon_reduce(fmb_polygon *p);

#endif
