/**
 * Polygon statistics: how many polygons a scene has, object by object and for every set of schemas
 * that the viewer's place can activate (thesis 5.3 and 6.2: Figs 67-72 and 87-90, Tables 3-5).
 *
 * <p>The files are read in parallel, Inlines too, and turned into a graph that keeps counts and
 * bounds instead of meshes; no scene runs and no display is needed. Then the areas are found, and
 * which of them share a place, and {@link org.selectiverenderer.schema.Activation} enters these, as
 * the controller does: there is one algorithm, on plain keys. A test holds the counts against those
 * of the instance tree and of simulated walks.
 *
 * <p>{@link org.selectiverenderer.polygon.count.SceneCounter} counts a scene while it is edited: it
 * keeps the inlined files that it has measured, and says what each object has of each state.
 *
 * <p>In: a scene file. Out: {@link org.selectiverenderer.polygon.count.SceneStatistics}, as text,
 * CSV, JSON and bar charts, and problems. {@link org.selectiverenderer.polygon.count.SceneModel}
 * gives the validator the same counts, boxes and states of files that it has read itself ({@link
 * org.selectiverenderer.polygon.count.CountedFile}). Uses {@code chart}, {@code schema}, {@code
 * geometry}, {@code x3d} and {@code base}; loads no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.polygon.count;

import org.jspecify.annotations.NullMarked;
