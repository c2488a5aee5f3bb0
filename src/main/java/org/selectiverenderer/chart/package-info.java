/**
 * What charts are drawn with: a canvas, its SVG form, colours and measured text. The charts
 * themselves live where their figures are: {@code app.chart}, {@code statistics.report}.
 *
 * <p>Texts are measured with the program's own fonts of {@code x3d.geometry.text}, so that charts
 * come out the same on machines without fonts or a display. Uses {@code x3d.geometry.text}; no AWT,
 * no GL.
 */
@NullMarked
package org.selectiverenderer.chart;

import org.jspecify.annotations.NullMarked;
