/* svg.h: drawings as SVG text, which may stand alone or inside a page.

   Lengths are in pixels, y downwards.  Attributes are those of SVG, as `fill="none" stroke="#000"`; the palette below can be
   told apart by colour-blind readers (Okabe, Ito), and what matters differs in shape, too. */
#ifndef VERIFY_SVG_H
#define VERIFY_SVG_H

#include "buffer.h"

#define SVG_BLACK "#000000"
#define SVG_GREY "#999999"
#define SVG_LIGHT "#dddddd"
#define SVG_ORANGE "#e69f00"
#define SVG_SKY "#56b4e9"
#define SVG_GREEN "#009e73"
#define SVG_YELLOW "#f0e442"
#define SVG_BLUE "#0072b2"
#define SVG_VERMILION "#d55e00"
#define SVG_PURPLE "#cc79a7"

typedef enum { SVG_START, SVG_MIDDLE, SVG_END } svg_anchor;
typedef enum { SVG_DISC, SVG_SQUARE, SVG_DIAMOND, SVG_TRIANGLE, SVG_CROSS, SVG_RING } svg_shape;

/* title: for those who cannot see it. */
void svg_begin(buffer *z, double width, double height, const char *title);
void svg_end(buffer *z);

/* What is drawn until svg_end_group has these attributes. */
void svg_group(buffer *z, const char *attributes);
void svg_end_group(buffer *z);

void svg_line(buffer *z, double x1, double y1, double x2, double y2);
void svg_rectangle(buffer *z, double x, double y, double width, double height, const char *attributes);
/* Points one after the other; those that are not finite are left out, and end a line. */
void svg_path_begin(buffer *z);
void svg_path_move(buffer *z, double x, double y);
void svg_path_to(buffer *z, double x, double y);
void svg_path_end(buffer *z, bool closed, const char *attributes);
/* A mark of radius r, in the colour. */
void svg_mark(buffer *z, svg_shape shape, double x, double y, double r, const char *colour);
void svg_text(buffer *z, double x, double y, svg_anchor anchor, const char *text);
/* Upwards, beginning or ending or centred at the point. */
void svg_text_upwards(buffer *z, double x, double y, svg_anchor anchor, const char *text);

/* Text with & < > " escaped, as pages need it, too. */
void svg_escape(buffer *z, const char *text);

#endif
