/**
 * Radiosity (thesis 2.1.4 and 5.2.1): diffuse inter-reflection in a scene, computed once and stored
 * in lightmaps or as colours at the vertices.
 *
 * <pre>
 * instance tree -> scene: triangles, reflectance, lamps -> trace: box trees over triangles
 *   -> solve: patches, form factors by rays, iterations
 *   -> atlas: charts on pages -> texel: light at texels -> bake: pictures, tone curve
 *      or mesh: adaptive subdivision -> bake: light at the vertices, tone curve
 *   -> output: X3D files, and pictures beside them
 * </pre>
 *
 * <p>The instance tree of a scene that does not run is read, so that every path to a shape has
 * light of its own, and that tree is written back as files: lit shapes have lightmaps or vertex
 * colours and no diffuse material, and every instance of an Inline has a file of its own.
 * Visibility knows versions: one version of each object stands for it, and any other is lit in its
 * place. Form factors are found once per patch and kept as the list of patches that its rays met;
 * iterations are sums over them. Vertices gather over the facets around them, all with the same
 * directions.
 *
 * <p>The same scene, settings and seed give the same bytes on every machine with any number of
 * processors: every patch and vertex writes to its own array elements and takes its sample points
 * from sets with integer seeds, and only {@code StrictMath} is used beyond square roots.
 *
 * <p>In: a scene's file and {@link org.selectiverenderer.radiosity.RadiositySettings}. Out: {@link
 * org.selectiverenderer.radiosity.bake.VertexLitScene} and, by {@code output}, files; by {@code
 * preview}, pictures on the way. Uses {@code browser} but its renderer, {@code x3d} and {@code
 * base}; the packages within also {@code models}, {@code schema} and {@code geometry}. Loads no AWT
 * and no GL itself.
 */
@NullMarked
package org.selectiverenderer.radiosity;

import org.jspecify.annotations.NullMarked;
