/**
 * Bar charts as SVG and PNG files, 1200 pixels wide: those of Figs 68, 70, 72 (an object's
 * versions) and 87, 88, 90 (polygons per activated schema).
 *
 * <p>In: {@link org.selectiverenderer.polygon.statistics.SceneStatistics}. Out: files. Drawn with
 * {@code chart}; texts are drawn into PNG files with the program's own fonts of {@code
 * x3d.geometry.text}, so that charts come out the same on machines without fonts or a display. Uses
 * {@code chart}, {@code polygon.statistics} and {@code x3d}; of AWT only the PNG encoder, no GL.
 */
@NullMarked
package org.selectiverenderer.app.chart;

import org.jspecify.annotations.NullMarked;
