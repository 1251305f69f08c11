/* samples.c: right and wrong evidence of every kind; see samples.h. */
#include "samples.h"

#define FEASIBLE   "x y\n1 1 <= 4\n-1 0 <= 0\n0 -1 < 0\n1 -1 = 1"
#define CONFLICT   "u y\n1 -1 <= 0\n-1 0 <= -1\n-1 -1 <= -1\n1 2 <= -1"
#define BOX        "x y\n1 1 <= 4\n-1 0 <= 0\n0 -1 <= 0\n2 0 <= 5"
#define OPEN       "x\n1 < 1\n-1 <= 0\n1 <= 5"
#define CONE       "x y\n1 -1 <= 0\n0 -1 < 3"
#define LINE       "x y\n1 -1 = 0\n0 -1 <= 3"
#define POINT      "x y\n1 1 <= 2\n1 -1 <= 0\n-1 0 <= -1\n0 1 < 7"
#define SQUARE     "x y\n1 0 <= 1\n0 1 <= 1\n-1 0 <= 0\n0 -1 <= 0\n1 1 <= 2\n1 1 <= 3\n-1 -1 < 1"
#define FLAT       "x y\n1 1 <= 2\n-1 -1 <= -2\n2 2 <= 4\n1 0 <= 1"
#define EQUALITIES "x y\n1 0 = 1\n0 1 = 1\n1 1 = 2"
#define TRIANGLE   "x y\n1 1 <= 4\n-1 0 <= 0\n0 -1 <= 0"
#define TRIANGLE_ROWS                                                                              \
    "claim implied <= 4\nterm x 1\nterm y 1\nrow 1 1\nend\n"                                       \
    "claim implied <= 0\nterm x -1\nrow 2 1\nend\n"                                                \
    "claim implied <= 0\nterm y -1\nrow 3 1\nend\n"
#define TRIANGLE_CORNERS                                                                           \
    "claim corner\nend\nclaim corner\npoint x 4\nend\nclaim corner\npoint y 4\nend\n"
#define PRISM "x y z\n1 1 1 < 4\n-1 0 0 <= 0\n0 -1 0 <= 0\n1 0 -1 <= 0\n0 0 1 <= 5"
#define PRISM_ROWS                                                                                 \
    "claim implied < 4\nterm x 2\nterm y 1\nrow 1 1\nrow 4 1\nend\n"                               \
    "claim implied <= 0\nterm x -1\nrow 2 1\nend\n"                                                \
    "claim implied <= 0\nterm y -1\nrow 3 1\nend\n"
#define PRISM_FOLLOWS "claim follows <= 5\nterm x 1\nimplied 1 1/2\nimplied 3 1/2\nend\n"
#define PRISM_STEP    "claim whole x y\nstep z 1\nend\n"
#define CONE_RAYS     "claim corner\nray x -1\nend\nclaim corner\nray x 1\nray y 1\nend\n"
#define AT_ORIGIN     "claim feasible\npoint x 0\npoint y 0\nend\n"

const proof_sample proof_samples[] = {
    /* feasible */
    {"point", FEASIBLE, "claim feasible\npoint x 2\npoint y 1\nend\n", NULL, FMB_FEASIBLE},
    {"fractions", FEASIBLE, "claim feasible\npoint y 3/2\npoint x 5/2\nend\n", NULL, FMB_FEASIBLE},
    {"point outside", FEASIBLE, "claim feasible\npoint x 4\npoint y 3\nend\n", "violates row 1", 0},
    {"point on a strict row", FEASIBLE, "claim feasible\npoint x 1\npoint y 0\nend\n",
     "violates row 3", 0},
    {"point off an equality", FEASIBLE, "claim feasible\npoint x 1\npoint y 1\nend\n",
     "violates row 4", 0},
    {"second claim wrong", FEASIBLE,
     "claim feasible\npoint x 2\npoint y 1\nend\nclaim feasible\npoint x 2\npoint y 2\nend\n",
     "violates row 4", 0},

    /* infeasible */
    {"conflict", CONFLICT, "claim infeasible\nrow 1 2\nrow 2 3\nrow 4 1\nend\n", NULL,
     FMB_INFEASIBLE},
    {"conflict in fractions", CONFLICT,
     "claim infeasible\nrow 4 1/3\nrow 2 1\nrow 1 2/3\nrow 3 0\nend\n", NULL, FMB_INFEASIBLE},
    {"strict conflict", "x\n1 < 0\n-1 <= 0", "claim infeasible\nrow 1 2\nrow 2 2\nend\n", NULL,
     FMB_INFEASIBLE},
    {"equality backwards", "x\n2 = 2\n1 <= 0", "claim infeasible\nrow 1 -1\nrow 2 2\nend\n", NULL,
     FMB_INFEASIBLE},
    {"false row", "x\n1 <= 0\n0 <= -1", "claim infeasible\nrow 2 1/9\nend\n", NULL, FMB_INFEASIBLE},
    {"wrong multiplier", CONFLICT, "claim infeasible\nrow 1 2\nrow 2 2\nrow 4 1\nend\n",
     "coefficient of u is wrong", 0},
    {"missing multiplier", CONFLICT, "claim infeasible\nrow 1 2\nrow 2 2\nend\n",
     "coefficient of y is wrong", 0},
    {"negative multiplier", "x\n1 <= 3\n1 <= 5", "claim infeasible\nrow 1 1\nrow 2 -1\nend\n",
     "multiplier of row 2 is negative", 0},
    {"all negative", CONFLICT, "claim infeasible\nrow 1 -2\nrow 2 -3\nrow 4 -1\nend\n",
     "multiplier of row 1 is negative", 0},
    {"0 <= 0", "x\n1 <= 0\n-1 <= 0", "claim infeasible\nrow 1 1\nrow 2 1\nend\n", "not strict", 0},
    {"strict row unused", "x\n1 < 5\n1 <= 0\n-1 <= 0", "claim infeasible\nrow 2 1\nrow 3 1\nend\n",
     "not strict", 0},
    {"nothing", CONFLICT, "claim infeasible\nend\n", "not strict", 0},
    {"0 <= 1", "x\n1 <= 1\n-1 < 0", "claim infeasible\nrow 1 1\nrow 2 1\nend\n",
     "right side is too large", 0},

    /* bound */
    {"upper end", BOX, "claim bound upper x <= 5/2\nrow 4 1/2\npoint x 5/2\npoint y 0\nend\n", NULL,
     FMB_FEASIBLE},
    {"lower end", BOX, "claim bound lower y >= 0\nrow 3 1\npoint x 1\npoint y 0\nend\n", NULL,
     FMB_FEASIBLE},
    {"end from two rows", BOX,
     "claim bound upper y <= 4\nrow 1 1\nrow 2 1\npoint x 0\npoint y 4\nend\n", NULL, FMB_FEASIBLE},
    {"end by an equality", LINE,
     "claim bound lower x >= -3\nrow 1 -1\nrow 2 1\npoint x -3\npoint y -3\nend\n", NULL,
     FMB_FEASIBLE},
    {"bound too small", BOX, "claim bound upper x <= 2\nrow 4 1/2\npoint x 2\npoint y 0\nend\n",
     "right side is too large", 0},
    {"bound too large", BOX, "claim bound upper x <= 3\nrow 4 1/2\npoint x 3\npoint y 0\nend\n",
     "violates row 4", 0},
    {"point elsewhere", BOX, "claim bound upper x <= 5/2\nrow 4 1/2\npoint x 2\npoint y 0\nend\n",
     "not at the bound", 0},
    {"point outside at the bound", BOX,
     "claim bound upper x <= 5/2\nrow 4 1/2\npoint x 5/2\npoint y 2\nend\n", "violates row 1", 0},
    {"side confused", BOX, "claim bound lower x >= 5/2\nrow 4 1/2\npoint x 5/2\npoint y 0\nend\n",
     "coefficient of x is wrong", 0},
    {"variable confused", BOX,
     "claim bound upper y <= 5/2\nrow 4 1/2\npoint x 0\npoint y 5/2\nend\n",
     "coefficient of x is wrong", 0},
    {"multiplier of a bound negative", BOX,
     "claim bound lower x >= 5/2\nrow 4 -1/2\npoint x 5/2\npoint y 0\nend\n",
     "multiplier of row 4 is negative", 0},
    {"open end", OPEN,
     "claim bound upper x < 1\nrow 1 1\npoint x 1\nend\nclaim feasible\npoint x 0\nend\n", NULL,
     FMB_FEASIBLE},
    {"open end without a solution", OPEN, "claim bound upper x < 1\nrow 1 1\npoint x 1\nend\n",
     "no claim shows that the system is feasible", 0},
    {"open end with a wrong solution", OPEN,
     "claim feasible\npoint x 1\nend\nclaim bound upper x < 1\nrow 1 1\npoint x 1\nend\n",
     "violates row 1", 0},
    {"open end claimed attained", OPEN,
     "claim feasible\npoint x 0\nend\nclaim bound upper x <= 1\nrow 1 1\npoint x 1\nend\n",
     "violates row 1", 0},
    {"attained end claimed open", OPEN,
     "claim feasible\npoint x 0\nend\nclaim bound lower x > 0\nrow 2 1\npoint x 0\nend\n",
     "not strict", 0},
    {"open end too large", OPEN,
     "claim feasible\npoint x 0\nend\nclaim bound upper x < 5\nrow 3 1\npoint x 5\nend\n",
     "not strict", 0},
    {"open end not near", OPEN,
     "claim feasible\npoint x 0\nend\nclaim bound upper x < 2\nrow 1 1\npoint x 2\nend\n",
     "violates row 1", 0},

    /* bound of a form */
    {"form", BOX,
     "claim bound upper <= 13/2\nterm x 2\nterm y 1\nrow 1 1\nrow 4 1/2\npoint x 5/2\npoint y "
     "3/2\nend\n",
     NULL, FMB_FEASIBLE},
    {"form downwards", BOX,
     "claim bound lower >= -4\nterm x 1\nterm y -1\nrow 1 1\nrow 2 2\npoint y 4\nend\n", NULL,
     FMB_FEASIBLE},
    {"form 0", BOX, "claim bound upper <= 0\nend\n", NULL, FMB_FEASIBLE},
    {"form not attained", OPEN,
     "claim bound upper < 2\nterm x 2\nrow 1 2\npoint x 1\nend\nclaim feasible\nend\n", NULL,
     FMB_FEASIBLE},
    {"form not attained, no solution", OPEN,
     "claim bound upper < 2\nterm x 2\nrow 1 2\npoint x 1\nend\n",
     "no claim shows that the system is feasible", 0},
    {"form too small", BOX,
     "claim bound upper <= 6\nterm x 2\nterm y 1\nrow 1 1\nrow 4 1/2\npoint x 5/2\npoint y "
     "1\nend\n",
     "right side is too large", 0},
    {"form of others", BOX,
     "claim bound upper <= 13/2\nterm x 2\nterm y 2\nrow 1 1\nrow 4 1/2\npoint x 5/2\npoint y "
     "3/4\nend\n",
     "coefficient of y is wrong", 0},
    {"form with its point elsewhere", BOX,
     "claim bound upper <= 13/2\nterm x 2\nterm y 1\nrow 1 1\nrow 4 1/2\npoint x 2\npoint y "
     "2\nend\n",
     "not at the bound", 0},

    /* unbounded */
    {"ray", CONE, AT_ORIGIN "claim unbounded upper x\nray x 1\nray y 1\nend\n", NULL, FMB_FEASIBLE},
    {"ray downwards", CONE, AT_ORIGIN "claim unbounded lower x\nray x -1/7\nray y 0\nend\n", NULL,
     FMB_FEASIBLE},
    {"ray along an equality", LINE, AT_ORIGIN "claim unbounded upper x\nray x 2\nray y 2\nend\n",
     NULL, FMB_FEASIBLE},
    {"ray without a solution", CONE, "claim unbounded upper x\nray x 1\nray y 1\nend\n",
     "no claim shows that the system is feasible", 0},
    {"ray leaves", CONE, AT_ORIGIN "claim unbounded upper x\nray x 2\nray y 1\nend\n",
     "ray violates row 1", 0},
    {"ray leaves an equality", LINE, AT_ORIGIN "claim unbounded upper y\nray x 1\nray y 2\nend\n",
     "ray violates row 1", 0},
    {"ray stands still", CONE, AT_ORIGIN "claim unbounded upper x\nray x 0\nray y 1\nend\n",
     "does not go that way", 0},
    {"ray to the other side", CONE, AT_ORIGIN "claim unbounded lower x\nray x 1\nray y 1\nend\n",
     "does not go that way", 0},

    {"ray of a form", CONE,
     AT_ORIGIN "claim unbounded upper\nterm x 2\nterm y -1\nray x 1\nray y 1\nend\n", NULL,
     FMB_FEASIBLE},
    {"ray of a form downwards", CONE,
     AT_ORIGIN "claim unbounded lower\nterm x 1\nterm y -1\nray y 3\nend\n", NULL, FMB_FEASIBLE},
    {"ray along which the form stands still", CONE,
     AT_ORIGIN "claim unbounded lower\nterm x 1\nterm y -1\nray x 1\nray y 1\nend\n",
     "does not go that way", 0},
    {"ray of the form 0", CONE, AT_ORIGIN "claim unbounded upper\nray x 1\nray y 1\nend\n",
     "does not go that way", 0},

    /* implied */
    {"implied", POINT, "claim implied <= 1\nterm x 1\nrow 1 1/2\nrow 2 1/2\nend\n", NULL, 0},
    {"implied with slack", POINT, "claim implied <= 2\nterm x 1\nrow 1 1/2\nrow 2 1/2\nend\n", NULL,
     0},
    {"implied strictly", POINT, "claim implied < 8\nterm y 1\nrow 4 1\nend\n", NULL, 0},
    {"implied strictly by slack", POINT, "claim implied < 2\nterm x 1\nrow 1 1/2\nrow 2 1/2\nend\n",
     NULL, 0},
    {"implied equality", POINT,
     "claim implied = 1\nterm x 1\nrow 1 1/2\nrow 2 1/2\nreverse 3 1\nend\n", NULL, 0},
    {"implied nothing", POINT, "claim implied <= 0\nend\n", NULL, 0},
    {"implied too much", POINT, "claim implied <= 1/2\nterm x 1\nrow 1 1/2\nrow 2 1/2\nend\n",
     "right side is too large", 0},
    {"implied not strictly", POINT, "claim implied < 1\nterm x 1\nrow 1 1/2\nrow 2 1/2\nend\n",
     "not strict", 0},
    {"implied other term", POINT, "claim implied <= 1\nterm y 1\nrow 1 1/2\nrow 2 1/2\nend\n",
     "coefficient of x is wrong", 0},
    {"implied equality one way", POINT, "claim implied = 1\nterm x 1\nrow 1 1/2\nrow 2 1/2\nend\n",
     "coefficient of x is wrong", 0},
    {"implied equality other way", POINT, "claim implied = 1\nterm x 1\nreverse 3 1\nend\n",
     "coefficient of x is wrong", 0},
    {"implied equality with slack", POINT,
     "claim implied = 2\nterm x 1\nrow 1 1/2\nrow 2 1/2\nreverse 3 1\nend\n",
     "right side is too large", 0},

    /* redundant, irredundant */
    {"square", SQUARE,
     "claim redundant 5\nrow 1 1\nrow 2 1\nend\nclaim redundant 6\nrow 1 1\nrow 2 1\nend\n"
     "claim redundant 7\nrow 3 1\nrow 4 1\nend\n"
     "claim irredundant 1\npoint x 2\npoint y 0\nend\nclaim irredundant 2\npoint x 0\npoint y "
     "7\nend\n"
     "claim irredundant 3\npoint x -1\npoint y 1\nend\n"
     "claim irredundant 4\npoint x 1\npoint y -1/2\nend\n",
     NULL, 0},
    {"both go", SQUARE,
     "claim redundant 5\nrow 1 1\nrow 2 1\nend\nclaim redundant 6\nrow 5 1\nend\n",
     "row 5 was removed", 0},
    {"by itself", SQUARE, "claim redundant 5\nrow 5 1\nend\n", "row 5 was removed", 0},
    {"by one that stays", SQUARE, "claim redundant 6\nrow 5 1\nend\n", NULL, 0},
    {"not redundant", SQUARE, "claim redundant 5\nrow 1 1\nend\n", "coefficient of y is wrong", 0},
    {"tighter than the rest", SQUARE, "claim redundant 5\nrow 6 1\nend\n",
     "right side is too large", 0},
    {"redundant by a negative multiplier", SQUARE, "claim redundant 5\nrow 4 -1\nrow 1 1\nend\n",
     "multiplier of row 4 is negative", 0},
    {"strict row redundant", "x\n1 < 1\n2 < 2", "claim redundant 1\nrow 2 1/2\nend\n", NULL, 0},
    {"closed row redundant", "x\n1 < 1\n1 <= 1", "claim redundant 2\nrow 1 1\nend\n", NULL, 0},
    {"strict row not redundant", "x\n1 < 1\n1 <= 1", "claim redundant 1\nrow 2 1\nend\n",
     "not strict", 0},
    {"strict row irredundant", "x\n1 < 1\n1 <= 1", "claim irredundant 1\npoint x 1\nend\n", NULL,
     0},
    {"point outside another row", SQUARE, "claim irredundant 1\npoint x 3\npoint y 0\nend\n",
     "violates row 5", 0},
    {"point inside", SQUARE, "claim irredundant 1\npoint x 1\npoint y 1\nend\n", "satisfies row 1",
     0},

    /* equality */
    {"flat", FLAT,
     "claim equality 1\nrow 2 1\nend\nclaim redundant 2\nrow 1 -1\nend\n"
     "claim redundant 3\nrow 1 2\nend\nclaim irredundant 1\npoint x 0\npoint y 0\nend\n"
     "claim irredundant 4\npoint x 3\npoint y -1\nend\n",
     NULL, 0},
    {"equality of an equality", EQUALITIES, "claim equality 3\nrow 3 -1\nend\n", NULL, 0},
    {"no equality", FLAT, "claim equality 4\nrow 2 1\nend\n", "coefficient of y is wrong", 0},
    {"equality by itself", FLAT, "claim equality 1\nrow 1 -1\nend\n",
     "multiplier of row 1 is negative", 0},
    {"equality by an equality", FLAT,
     "claim equality 1\nrow 2 1\nend\nclaim equality 3\nrow 1 -2\nend\n", NULL, 0},
    {"equality by a later equality", FLAT,
     "claim equality 3\nrow 1 -2\nend\nclaim equality 1\nrow 2 1\nend\n",
     "multiplier of row 1 is negative", 0},
    {"equalities in a circle", FLAT,
     "claim equality 1\nrow 3 -1/2\nend\nclaim equality 3\nrow 1 -2\nend\n",
     "multiplier of row 3 is negative", 0},
    {"bound by a claimed equality", FLAT,
     "claim equality 1\nrow 2 1\nend\nclaim implied <= -2\nterm x -1\nterm y -1\nrow 1 -1\nend\n",
     "multiplier of row 1 is negative", 0},
    {"equality not reached", "x\n1 <= 1\n-1 <= 0", "claim equality 1\nrow 2 1\nend\n",
     "right side is too large", 0},
    {"equality of a strict row", "x\n1 < 0\n-1 <= 0", "claim equality 1\nrow 2 1\nend\n",
     "row 1 is strict", 0},
    {"negative without the equality", FLAT, "claim redundant 2\nrow 1 -1\nend\n",
     "multiplier of row 1 is negative", 0},
    {"point off an equality that stays", FLAT,
     "claim equality 1\nrow 2 1\nend\nclaim redundant 2\nrow 1 -1\nend\n"
     "claim irredundant 4\npoint x 3\npoint y -2\nend\n",
     "violates row 1", 0},
    {"redundant equality", EQUALITIES,
     "claim redundant 3\nrow 1 1\nrow 2 1\nreverse 1 -1\nreverse 2 -1\nend\n", NULL, 0},
    {"redundant equality one way", EQUALITIES, "claim redundant 3\nrow 1 1\nrow 2 1\nend\n",
     "coefficient of x is wrong", 0},
    {"equality redundant by inequalities", "x\n1 = 1\n1 <= 1\n-1 <= -1",
     "claim redundant 1\nrow 2 1\nreverse 3 1\nend\n", NULL, 0},
    {"reverse by a row that goes later", "x\n1 = 1\n1 <= 1\n-1 <= -1\n-2 <= -2",
     "claim redundant 1\nrow 2 1\nreverse 3 1\nend\nclaim redundant 3\nrow 4 1/2\nend\n", NULL, 0},
    {"reverse by a row that is gone", "x\n1 = 1\n1 <= 1\n-1 <= -1\n-2 <= -2",
     "claim redundant 3\nrow 4 1/2\nend\nclaim redundant 1\nrow 2 1\nreverse 3 1\nend\n",
     "row 3 was removed", 0},
    {"one after another", SQUARE,
     "claim redundant 6\nrow 5 1\nend\nclaim redundant 5\nrow 1 1\nrow 2 1\nend\n", NULL, 0},
    {"in a circle", "x\n1 <= 1\n1 <= 1",
     "claim redundant 1\nrow 2 1\nend\nclaim redundant 2\nrow 1 1\nend\n", "row 1 was removed", 0},
    {"gone twice", SQUARE, "claim redundant 6\nrow 5 1\nend\nclaim redundant 6\nrow 5 1\nend\n",
     NULL, 0},
    {"negative by an equality that goes later", FLAT,
     "claim equality 1\nrow 2 1\nend\nclaim redundant 2\nrow 1 -1\nend\n"
     "claim redundant 1\nrow 3 1/2\nend\n",
     "multiplier of row 1 is negative", 0},

    /* corner, whole */
    {"corners of a triangle", TRIANGLE, TRIANGLE_ROWS TRIANGLE_CORNERS "claim whole x y\nend\n",
     NULL, 0},
    {"order of kept variables", TRIANGLE, "claim whole y x\nend\n" TRIANGLE_CORNERS TRIANGLE_ROWS,
     NULL, 0},
    {"a row more", TRIANGLE,
     TRIANGLE_ROWS TRIANGLE_CORNERS
     "claim implied <= 5\nterm x 1\nrow 1 1\nrow 3 1\nend\nclaim whole x y\nend\n",
     NULL, 0},
    {"a point more", TRIANGLE,
     TRIANGLE_ROWS TRIANGLE_CORNERS "claim corner\npoint x 1\nend\nclaim whole x y\nend\n", NULL,
     0},
    {"one variable", TRIANGLE,
     "claim implied <= 4\nterm x 1\nrow 1 1\nrow 3 1\nend\nclaim implied <= 0\nterm x -1\nrow 2 1\n"
     "end\nclaim corner\nend\nclaim corner\npoint x 4\nend\nclaim whole x\nend\n",
     NULL, 0},
    {"no variable", TRIANGLE, "claim corner\npoint x 1\nend\nclaim whole\nend\n", NULL, 0},
    {"a row is missing", TRIANGLE,
     TRIANGLE_CORNERS "claim implied <= 4\nterm x 1\nterm y 1\nrow 1 1\nend\n"
                      "claim implied <= 0\nterm x -1\nrow 2 1\nend\nclaim whole x y\nend\n",
     "do not span", 0},
    {"a corner is missing", TRIANGLE,
     TRIANGLE_ROWS "claim corner\nend\nclaim corner\npoint x 4\nend\nclaim whole x y\nend\n",
     "do not span", 0},
    {"a corner twice", TRIANGLE,
     TRIANGLE_ROWS TRIANGLE_CORNERS "claim corner\nend\nclaim whole x y\nend\n", "do not span", 0},
    {"a corner off its place", TRIANGLE,
     TRIANGLE_ROWS "claim corner\nend\nclaim corner\npoint x 3\nend\n"
                   "claim corner\npoint y 4\nend\nclaim whole x y\nend\n",
     "do not span", 0},
    {"a corner outside", TRIANGLE,
     TRIANGLE_ROWS TRIANGLE_CORNERS "claim corner\npoint x 5\nend\nclaim whole x y\nend\n",
     "violates row 1", 0},
    {"no corner", TRIANGLE, TRIANGLE_ROWS "claim whole x y\nend\n", "do not span", 0},
    {"a row that is too tight", TRIANGLE,
     "claim whole x y\nend\n" TRIANGLE_CORNERS TRIANGLE_ROWS
     "claim implied <= 3\nterm x 1\nterm y 1\nrow 1 1\nend\n",
     "leans on claims", 0},
    {"a point and a ray at once", TRIANGLE, "claim corner\npoint x 1\nray x 0\nray y 1\nend\n",
     "both a point and a ray", 0},
    {"a direction that leaves", TRIANGLE, "claim corner\nray x 1\nend\n", "violates row 1", 0},
    {"a cone", CONE,
     "claim implied <= 0\nterm x 1\nterm y -1\nrow 1 1\nend\nclaim implied < 3\nterm y -1\n"
     "row 2 1\nend\nclaim corner\npoint x -3\npoint y -3\nend\n" CONE_RAYS "claim whole x y\nend\n",
     NULL, 0},
    {"a cone without one ray", CONE,
     "claim implied <= 0\nterm x 1\nterm y -1\nrow 1 1\nend\nclaim implied < 3\nterm y -1\n"
     "row 2 1\nend\nclaim corner\npoint x -3\npoint y -3\nend\nclaim corner\nray x -1\nend\n"
     "claim whole x y\nend\n",
     "do not span", 0},
    {"a cone that is said to be closed", CONE,
     "claim implied <= 0\nterm x 1\nterm y -1\nrow 1 1\nend\nclaim implied <= 3\nterm y -1\n"
     "row 2 1\nend\nclaim corner\npoint x -3\npoint y -3\nend\n" CONE_RAYS "claim whole x y\nend\n",
     "no corners show", 0},
    {"all of the plane", "x y z\n1 1 1 <= 1",
     "claim corner\nend\nclaim corner\nray x 1\nray z -1\nend\nclaim corner\nray x -1\nend\n"
     "claim corner\nray y 1\nray z -1\nend\nclaim corner\nray y -1\nend\nclaim whole x y\nend\n",
     NULL, 0},
    {"a line one way", "x y z\n1 1 1 <= 1",
     "claim corner\nend\nclaim corner\nray x 1\nray z -1\nend\nclaim corner\nray x -1\nend\n"
     "claim corner\nray y 1\nray z -1\nend\nclaim whole x y\nend\n",
     "do not span", 0},
    {"a point", EQUALITIES,
     "claim implied = 1\nterm x 1\nrow 1 1\nreverse 1 -1\nend\nclaim corner\npoint x 1\npoint y 1\n"
     "end\nclaim whole x\nend\n",
     NULL, 0},
    {"a segment by an equation", LINE,
     "claim implied = 0\nterm x 1\nterm y -1\nrow 1 1\nreverse 1 -1\nend\nclaim implied <= 3\n"
     "term y -1\nrow 2 1\nend\nclaim corner\npoint x -3\npoint y -3\nend\nclaim corner\nray x 1\n"
     "ray y 1\nend\nclaim whole x y\nend\n",
     NULL, 0},
    {"equation not named", LINE,
     "claim implied <= 3\nterm y -1\nrow 2 1\nend\nclaim corner\npoint x -3\npoint y -3\nend\n"
     "claim corner\nray x 1\nray y 1\nend\nclaim whole x y\nend\n",
     "do not span", 0},
    {"an edge that strict rows leave",
     "x y z\n1 0 0 <= 1\n-1 0 0 <= 0\n0 1 0 < 1\n0 -1 0 <= 0\n0 0 1 <= 1",
     "claim implied <= 1\nterm x 1\nrow 1 1\nend\nclaim implied <= 0\nterm x -1\nrow 2 1\nend\n"
     "claim corner\nend\nclaim corner\npoint x 1\npoint y 1\nend\nclaim whole x\nend\n",
     "no corners show", 0},
    {"the same with a point inside",
     "x y z\n1 0 0 <= 1\n-1 0 0 <= 0\n0 1 0 < 1\n0 -1 0 <= 0\n0 0 1 <= 1",
     "claim implied <= 1\nterm x 1\nrow 1 1\nend\nclaim implied <= 0\nterm x -1\nrow 2 1\nend\n"
     "claim corner\nend\nclaim corner\npoint x 1\nend\nclaim whole x\nend\n",
     NULL, 0},

    /* whole by steps, follows */
    {"a step", PRISM, PRISM_ROWS PRISM_FOLLOWS PRISM_STEP, NULL, 0},
    {"a strict sum", PRISM,
     PRISM_ROWS "claim follows < 2\nterm x 1\nimplied 1 1/2\nimplied 3 1/2\nend\n" PRISM_STEP, NULL,
     0},
    {"two steps", TRIANGLE, "claim whole\nstep y 2\nstep x 1\nend\n", NULL, 0},
    {"by an equality", EQUALITIES,
     "claim implied = 1\nterm x 1\nrow 1 1\nreverse 1 -1\nend\nclaim whole x\nstep y 1\nend\n",
     NULL, 0},
    {"a sum that nobody says", PRISM, PRISM_ROWS PRISM_STEP, "no claim implies some", 0},
    {"a row not as strict", PRISM,
     "claim implied <= 4\nterm x 2\nterm y 1\nrow 1 1\nrow 4 1\nend\n"
     "claim implied <= 0\nterm x -1\nrow 2 1\nend\nclaim implied <= 0\nterm y -1\nrow 3 1\n"
     "end\n" PRISM_FOLLOWS PRISM_STEP,
     "no claim implies some", 0},
    {"a step of what is kept", PRISM,
     PRISM_ROWS PRISM_FOLLOWS "claim whole x y\nstep z 1\nstep y 2\nend\n", "that is kept", 0},
    {"a step too few", PRISM, PRISM_ROWS PRISM_FOLLOWS "claim whole x\nstep z 1\nend\n",
     "variables are not eliminated", 0},
    {"a claim about what goes", PRISM,
     PRISM_ROWS "claim implied <= 5\nterm z 1\nrow 5 1\nend\nclaim implied <= 0\nterm x 1\n"
                "term z -1\nrow 4 1\nend\nclaim follows <= 5\nterm x 1\nimplied 4 1\nimplied 5 "
                "1\nend\n" PRISM_STEP,
     "no claim implies some", 0},
    {"follows from too little", PRISM,
     PRISM_ROWS "claim follows <= 1\nterm x 1\nimplied 1 1/2\nimplied 3 1/2\nend\n", "too large",
     0},
    {"follows, but not strictly", PRISM,
     PRISM_ROWS "claim follows < 0\nterm x -1\nimplied 2 1\nend\n", "too large", 0},
    {"follows from another form", PRISM,
     PRISM_ROWS "claim follows <= 5\nterm x 1\nimplied 1 1/2\nend\n", "coefficient is wrong", 0},
    {"follows from less than nothing", PRISM,
     PRISM_ROWS "claim follows <= 5\nterm x 1\nimplied 2 -1\nend\n", "is negative", 0},
    {"follows as an equation", PRISM, PRISM_ROWS "claim follows = 0\nterm x -1\nimplied 2 1\nend\n",
     "no inequality", 0},
    {"follows from a claim of another kind", PRISM,
     PRISM_ROWS PRISM_FOLLOWS "claim follows <= 5\nterm x 1\nimplied 4 1\nend\n", "not 'implied'",
     0},

    {"no claim", BOX, "# nothing\n", "there is no claim", 0},
};

const size_t proof_samples_count = sizeof proof_samples / sizeof *proof_samples;
