/**
 * What walls and other large flat things hide is not drawn. Without GL, on the processor.
 *
 * <p>In: the cameras of a frame, the meshes in view and where they are, boxes and spheres that are
 * asked about. Out: whether an eye can see anything of them. {@link
 * org.selectiverenderer.runtime.render.occlude.Occlusion} is the way in. Uses {@code
 * runtime.camera}, {@code geometry} and {@code geometry.mesh}.
 *
 * <p><b>Why no pixel changes</b>, whatever the size of the picture and wherever in a pixel it is
 * sampled. What is hidden in a cell of the coarse grid must be behind something that is drawn at
 * every point of the cell:
 *
 * <ul>
 *   <li><i>Something is drawn there.</i> A patch is some triangles of one plane, in one mesh, that
 *       face the eye or are drawn from both sides. Each point that lies within the sum of their
 *       outlines, taken modulo 2, lies within an odd number of them, so within one at least. Edges
 *       cancel only where corners agree to the bit; between such triangles OpenGL leaves no gap.
 *       The rest is the outline: it keeps slits and holes however thin, and where edges meet
 *       corners of other edges, it stays. A cell that an edge of the outline comes near counts as
 *       open, so a covered cell lies wholly inside, with a margin for OpenGL's rounding of corners.
 *   <li><i>It is drawn opaquely.</i> Only shapes that neither blend nor cut out are offered. What
 *       is cut away at the near plane is cut away here too, a little farther on.
 *   <li><i>It is nearer.</i> A cell keeps the farthest point of the plane in it, the margin
 *       included; a box asks with the nearest that it can come in that cell, by its nearest corner
 *       and by the planes of the faces that the eye sees: all of the box is behind those. So what
 *       stands along a wall is hidden from aslant too. What the depth buffer rounds away is added:
 *       see {@code Precision}. What touches a wall from behind is drawn.
 *   <li><i>The occluder itself may be hidden</i>: then what hides it hides what is behind it.
 * </ul>
 *
 * <p>Patches are not joined at the corners of a room: cells on the seam stay open. With the
 * apartment's tour, items that are drawn although another stands before all of them hold a fifth of
 * what is drawn. The tests compare all pixels of random poses in the apartment and among walls with
 * slits.
 */
@NullMarked
package org.selectiverenderer.runtime.render.occlude;

import org.jspecify.annotations.NullMarked;
