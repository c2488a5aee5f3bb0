/**
 * The mesh that carries light at its vertices: facets, the vertices that they share, and their
 * adaptive subdivision (thesis Figs 60 and 61).
 *
 * <p>In: the bodies of a scene and light at vertices. Out: {@link
 * org.selectiverenderer.radiosity.mesh.RadiosityMesh}. Uses {@code radiosity.scene}, {@code
 * radiosity.trace}, {@code geometry} and {@code geometry.mesh}.
 */
@NullMarked
package org.selectiverenderer.radiosity.mesh;

import org.jspecify.annotations.NullMarked;
