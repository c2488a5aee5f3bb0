/**
 * Polygon statistics: how many polygons a scene has, object by object and for every set of schemas
 * that the viewer's place can activate (thesis 5.3 and 6.2: Figs 67-72 and 87-90, Tables 3-5).
 *
 * <p>In: a scene file. Out: {@link org.selectiverenderer.polygon.statistics.SceneStatistics}, as
 * text, CSV and JSON, and problems. A polygon is a triangle of what is drawn. Which version of an
 * object a schema shows is decided by {@link org.selectiverenderer.schema.Activation}, as at run
 * time. {@link org.selectiverenderer.polygon.statistics.SceneModel} gives the validator the same
 * counts, boxes and states of files that it has read itself ({@link
 * org.selectiverenderer.polygon.statistics.CountedFile}). Uses {@code x3d} and {@code schema};
 * loads no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.polygon.statistics;

import org.jspecify.annotations.NullMarked;
