/**
 * Radiosity (thesis 2.1.4 and 5.2.1): diffuse inter-reflection in a scene, computed once and stored
 * as colours at the vertices.
 *
 * <pre>
 * instance tree -> scene: triangles, reflectance, lamps -> trace: box trees over triangles
 *   -> solve: patches, form factors by rays, iterations -> mesh: adaptive subdivision
 *   -> bake: light at the vertices, tone curve -> output: X3D files without lit materials
 * </pre>
 *
 * <p>In: a loaded scene ({@code runtime.instance}) and {@link
 * org.selectiverenderer.radiosity.Settings}. Out: {@link
 * org.selectiverenderer.radiosity.bake.LitScene} and, by {@code output}, files. The same scene,
 * settings and seed give the same bytes on every machine with any number of processors: every patch
 * and vertex has its own place to write to and takes its points from integer-seeded sets, and only
 * {@code StrictMath} is used beyond square roots. Loads no AWT and no GL itself.
 */
@NullMarked
package org.selectiverenderer.radiosity;

import org.jspecify.annotations.NullMarked;
