/**
 * Occlusion culling: what walls and other large flat things hide is not drawn. It runs on the
 * processor, without GL.
 *
 * <p>In: the cameras of a frame, the meshes in view and their places, and queries about boxes and
 * spheres. Out: whether an eye can see anything of them. The entry point is {@link
 * org.selectiverenderer.render.occlusion.OcclusionCuller}. Uses {@code browser.camera}, {@code
 * geometry} and {@code geometry.mesh}.
 *
 * <p><b>Why no pixel changes</b>, whatever the size of the picture and wherever in a pixel it is
 * sampled. What is hidden in a cell of the coarse depth buffer must be behind something that is
 * drawn at every point of the cell:
 *
 * <ul>
 *   <li><i>Something is drawn there.</i> An occluder polygon stands for triangles of one plane, in
 *       one mesh, that face the eye or are drawn from both sides. Each point that lies within the
 *       sum of their outlines, taken modulo 2, lies within an odd number of them, so within one at
 *       least. Edges cancel only where corners agree to the bit; between such triangles OpenGL
 *       leaves no gap. The rest is the outline: it keeps slits and holes however thin, and where
 *       edges meet corners of other edges, it stays. A cell that an edge of the outline comes near
 *       counts as open, so a covered cell lies wholly inside, with a margin for OpenGL's rounding
 *       of corners.
 *   <li><i>It is drawn opaquely.</i> Only shapes without blending and alpha test are offered. What
 *       is clipped at the near plane is clipped here too, a little farther away.
 *   <li><i>It is nearer.</i> A cell stores the farthest point of the plane within it, the margin
 *       included; it is compared with the nearest point that the queried box can have in that cell,
 *       which its nearest corner and the planes of the faces that the eye sees bound: all of the
 *       box is behind those. So an object along a wall is hidden even at grazing angles. The
 *       rounding of the depth buffer is added: see {@link
 *       org.selectiverenderer.render.occlusion.RasterErrorBounds}. An object that touches a wall
 *       from behind is drawn.
 *   <li><i>The occluder itself may be hidden</i>: then what hides it hides what is behind it.
 * </ul>
 *
 * <p>Occluder polygons are not joined at the corners of a room: cells on the seam stay open. On the
 * apartment's tour, items that are drawn although another one hides them completely make up a fifth
 * of what is drawn. The tests compare all pixels of random poses in the apartment and among walls
 * with slits.
 */
@NullMarked
package org.selectiverenderer.render.occlusion;

import org.jspecify.annotations.NullMarked;
