/* svg.c: elements and numbers as text. */
#include "svg.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void svg_escape(buffer *z, const char *text)
{
    for (; *text; text++) {
        const char *entity = *text == '&' ? "&amp;" : *text == '<' ? "&lt;" : *text == '>' ? "&gt;" : *text == '"' ? "&quot;" : NULL;
        if (entity)
            buffer_append(z, entity, strlen(entity));
        else
            buffer_append(z, text, 1);
    }
}

/* Two places behind the point, no zeros at the end. */
static void number(buffer *z, double v)
{
    char text[64];
    int length = snprintf(text, sizeof text, "%.2f", fabs(v) < 1e7 ? v : copysign(1e7, v));
    while (text[length - 1] == '0')
        length--;
    if (text[length - 1] == '.')
        length--;
    buffer_append(z, text, (size_t)length);
}

static void attribute(buffer *z, const char *name, double v)
{
    buffer_print(z, " %s=\"", name);
    number(z, v);
    buffer_print(z, "\"");
}

void svg_begin(buffer *z, double width, double height, const char *title)
{
    buffer_print(z, "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"");
    attribute(z, "width", width);
    attribute(z, "height", height);
    buffer_print(z, " viewBox=\"0 0 %.0f %.0f\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"12\">\n<title>", width, height);
    svg_escape(z, title);
    buffer_print(z, "</title>\n");
    svg_rectangle(z, 0, 0, width, height, "fill=\"#ffffff\"");
}

void svg_end(buffer *z)
{
    buffer_print(z, "</svg>\n");
}

void svg_group(buffer *z, const char *attributes)
{
    buffer_print(z, "<g %s>\n", attributes);
}

void svg_end_group(buffer *z)
{
    buffer_print(z, "</g>\n");
}

void svg_line(buffer *z, double x1, double y1, double x2, double y2)
{
    buffer_print(z, "<line");
    attribute(z, "x1", x1);
    attribute(z, "y1", y1);
    attribute(z, "x2", x2);
    attribute(z, "y2", y2);
    buffer_print(z, "/>\n");
}

void svg_rectangle(buffer *z, double x, double y, double width, double height, const char *attributes)
{
    buffer_print(z, "<rect");
    attribute(z, "x", x);
    attribute(z, "y", y);
    attribute(z, "width", width);
    attribute(z, "height", height);
    buffer_print(z, " %s/>\n", attributes);
}

/* ---- paths ---- */

void svg_path_begin(buffer *z)
{
    buffer_print(z, "<path d=\"");
}

static void path_step(buffer *z, char letter, double x, double y)
{
    buffer_append(z, &letter, 1);
    number(z, x);
    buffer_append(z, " ", 1);
    number(z, y);
}

void svg_path_move(buffer *z, double x, double y)
{
    if (isfinite(x) && isfinite(y))
        path_step(z, 'M', x, y);
}

/* The first point of a path begins it. */
void svg_path_to(buffer *z, double x, double y)
{
    bool first = z->length > 0 && z->bytes[z->length - 1] == '"';
    if (isfinite(x) && isfinite(y))
        path_step(z, first ? 'M' : 'L', x, y);
}

void svg_path_end(buffer *z, bool closed, const char *attributes)
{
    buffer_print(z, "%s\" %s/>\n", closed ? "Z" : "", attributes);
}

/* ---- marks ---- */

static void polygon(buffer *z, double x, double y, double r, const double corner[][2], int corners, const char *colour)
{
    svg_path_begin(z);
    for (int i = 0; i < corners; i++)
        svg_path_to(z, x + r * corner[i][0], y + r * corner[i][1]);
    buffer_print(z, "Z\" fill=\"%s\"/>\n", colour);
}

void svg_mark(buffer *z, svg_shape shape, double x, double y, double r, const char *colour)
{
    static const double square[][2] = {{-.9, -.9}, {.9, -.9}, {.9, .9}, {-.9, .9}};
    static const double diamond[][2] = {{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}};
    static const double triangle[][2] = {{0, -1.2}, {1.1, .8}, {-1.1, .8}};
    if (!isfinite(x) || !isfinite(y))
        return;
    switch (shape) {
    case SVG_SQUARE:
        polygon(z, x, y, r, square, 4, colour);
        return;
    case SVG_DIAMOND:
        polygon(z, x, y, r, diamond, 4, colour);
        return;
    case SVG_TRIANGLE:
        polygon(z, x, y, r, triangle, 3, colour);
        return;
    case SVG_CROSS:
        svg_path_begin(z);
        svg_path_move(z, x - r, y - r);
        svg_path_to(z, x + r, y + r);
        svg_path_move(z, x - r, y + r);
        svg_path_to(z, x + r, y - r);
        buffer_print(z, "\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\"/>\n", colour);
        return;
    default:
        buffer_print(z, "<circle");
        attribute(z, "cx", x);
        attribute(z, "cy", y);
        attribute(z, "r", r);
        if (shape == SVG_RING)
            buffer_print(z, " fill=\"#ffffff\" stroke=\"%s\" stroke-width=\"1.4\"/>\n", colour);
        else
            buffer_print(z, " fill=\"%s\"/>\n", colour);
    }
}

/* ---- text ---- */

static void text_element(buffer *z, double x, double y, svg_anchor anchor, bool upwards, const char *text)
{
    static const char *const anchors[] = {"start", "middle", "end"};
    buffer_print(z, "<text");
    attribute(z, "x", x);
    attribute(z, "y", y);
    buffer_print(z, " text-anchor=\"%s\"", anchors[anchor]);
    if (upwards)
        buffer_print(z, " transform=\"rotate(-90 %.2f %.2f)\"", x, y);
    buffer_print(z, ">");
    svg_escape(z, text);
    buffer_print(z, "</text>\n");
}

void svg_text(buffer *z, double x, double y, svg_anchor anchor, const char *text)
{
    text_element(z, x, y, anchor, false, text);
}

void svg_text_upwards(buffer *z, double x, double y, svg_anchor anchor, const char *text)
{
    text_element(z, x, y, anchor, true, text);
}
