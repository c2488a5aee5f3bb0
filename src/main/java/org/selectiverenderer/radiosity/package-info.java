/**
 * Radiosity (thesis 2.1.4 and 5.2.1): diffuse inter-reflection in a scene, computed once and stored
 * in pictures or as colours at the vertices.
 *
 * <pre>
 * instance tree -> scene: triangles, reflectance, lamps -> trace: box trees over triangles
 *   -> solve: patches, form factors by rays, iterations
 *   -> atlas: charts on pages -> texel: light at texels -> bake: pictures, tone curve
 *      or mesh: adaptive subdivision -> bake: light at the vertices, tone curve
 *   -> output: X3D files, and pictures beside them
 * </pre>
 *
 * <p>The instance tree of a scene that does not run is read, so that every path is a place with a
 * light of its own, and that tree is written back as files: lit shapes have pictures or colours and
 * no diffuse material, every place of an Inline has a file of its own. Visibility knows versions:
 * one of each object stands for it, any other is lit in its place. Form factors are found once per
 * patch and kept as the patches that rays met; iterations are sums over them. Vertices gather over
 * the facets around them, all with the same directions.
 *
 * <p>The same scene, settings and seed give the same bytes on every machine with any number of
 * processors: every patch and vertex has its own place to write to and takes its points from sets
 * with integer seeds, and only {@code StrictMath} is used beyond square roots.
 *
 * <p>In: a scene's file and {@link org.selectiverenderer.radiosity.RadiositySettings}. Out: {@link
 * org.selectiverenderer.radiosity.bake.LitScene} and, by {@code output}, files; by {@code preview},
 * pictures on the way. Uses {@code runtime} but its renderer, {@code x3d} and {@code base}; the
 * packages within also {@code polygon.model}, {@code schema} and {@code geometry}. Loads no AWT and
 * no GL itself.
 */
@NullMarked
package org.selectiverenderer.radiosity;

import org.jspecify.annotations.NullMarked;
