/**
 * Polygon statistics: how many polygons a scene has, object by object and for every set of schemas
 * that the viewer's place can activate (thesis 5.3 and 6.2: Figs 67-72 and 87-90, Tables 3-5).
 *
 * <p>The files, inlined ones too, are read in parallel and turned into a graph that keeps counts
 * and bounding boxes instead of meshes; no browser runs and no display is needed. Then the
 * overlapping areas are found, and {@link org.selectiverenderer.schema.SchemaActivation} enters
 * them with the same algorithm as the controller. A test compares the counts with those of the
 * instance tree in a running browser and of simulated walks.
 *
 * <p>{@link org.selectiverenderer.polygon.IncrementalSceneCounter} counts a scene while it is
 * edited: it caches the inlined files that it has measured, and returns the contribution of each
 * object to each state.
 *
 * <p>Beside polygons, {@link org.selectiverenderer.polygon.RenderingCost} has the draw calls and
 * the bytes of textures of a state; of pictures only the sizes are read.
 *
 * <p>In: a scene file. Out: {@link org.selectiverenderer.polygon.SceneStatistics}, as text, CSV,
 * JSON and bar charts, and problems. {@link org.selectiverenderer.polygon.EnrichmentPolygonModel}
 * gives the validator the same counts, boxes and states for files that the validator has read
 * itself ({@link org.selectiverenderer.polygon.FilePolygonMeasurement}). Uses {@code chart}, {@code
 * schema}, {@code geometry}, {@code x3d} and {@code base}; loads no AWT and no GL.
 */
@NullMarked
package org.selectiverenderer.polygon;

import org.jspecify.annotations.NullMarked;
