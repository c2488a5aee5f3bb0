/**
 * Charts: a canvas that draws SVG or pixels, colours, measured text, bar and step charts as SVG and
 * PNG files. The packages that have the data decide which charts to draw: {@code polygon} and
 * {@code statistics.report}.
 *
 * <p>In: numbers with their labels. Out: files and SVG; the same input gives the same bytes. Texts
 * are measured with the program's own fonts, so that charts come out the same on machines without
 * fonts or a display. Uses {@code geometry.font}, {@code formats.image} and {@code base.decimal};
 * no AWT, no GL.
 *
 * <p>Charts are drawn by the program's own code, because tests compare SVG files byte by byte with
 * those in the repository: a library's coordinates, element order and number formats change with
 * its version, and measured text with the fonts of the machine. JFreeChart is not used: it needs
 * AWT fonts, which a server may lack, and its SVG companion is under the GPL, which a jar under the
 * MIT licence cannot carry.
 */
@NullMarked
package org.selectiverenderer.chart;

import org.jspecify.annotations.NullMarked;
