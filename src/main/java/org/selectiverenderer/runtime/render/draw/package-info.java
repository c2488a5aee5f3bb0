/**
 * Draws an instance tree into the current frame buffer, as one camera sees it.
 *
 * <p>In: an {@link org.selectiverenderer.runtime.instance.InstanceTree} and a camera. Out: pixels,
 * by {@link org.selectiverenderer.runtime.render.draw.SceneRenderer}: what is in the frustum,
 * sorted, with its lights. What lives on the graphics card is {@code runtime.render.gpu}'s.
 *
 * <p>A shape is a {@link org.selectiverenderer.runtime.render.draw.DrawItem}. What it draws is its
 * {@link org.selectiverenderer.runtime.render.draw.MeshPart}: a stretch of an index buffer, cut
 * into clusters. Either the buffer is its own mesh's, which all shapes with that mesh share, or
 * that of a {@link org.selectiverenderer.runtime.render.draw.DrawBatch}: small opaque shapes of one
 * look, near each other, put into one pair of buffers in coordinates around the batch's origin.
 * Plain lit ones may differ in their diffuse colours: then the buffer's vertices have them. Culling
 * and Switches work on items, in a batch too; what is seen of a batch is then drawn by one call,
 * since nothing but the stretches changes from one of its shapes to the next. Which shapes share a
 * batch is decided when the tree's structure changes. A shape that moves, or gets another mesh or
 * look, leaves its batch for good: its stretch there is not drawn any more, its own mesh is
 * uploaded in the same frame, the others stay as they are. A shape that a Switch hides stays in its
 * batch.
 *
 * <p>Lines, hatches, fog and planes that cut are a {@link
 * org.selectiverenderer.runtime.render.gpu.Scenery}: what a program does beside colour and light. A
 * shape's stroke and surroundings are part of its look; which fog is bound is known only when an
 * eye looks, so {@code EyeScenery} decides then. Programs of scenes without any have nothing of it
 * in their texts, and no number is sent for it.
 *
 * <p>A shape with the program of an author is drawn by a call of its own: {@code AuthorPrograms}
 * compiles and chooses, {@code AuthorValues} knows the numbers that browsers give by name, {@code
 * AuthorLook} sends them. What is bound for it, the next shape binds anew.
 *
 * <p>What shapes mirror of the scene is drawn before the frame is culled, by the same renderer:
 * {@code GeneratedCubes} says which, from where and into what. Scenes without any do nothing for
 * it.
 *
 * <p>What is new and not shown may wait ({@link
 * org.selectiverenderer.runtime.render.draw.SceneRenderer#follow}): it is made ready a few shapes
 * with each frame, in batches of its own, and in the very frame in which it is shown. What comes
 * into a running scene shown, but is too much for one frame, follows likewise. How shapes are put
 * into batches decides how their coordinates are rounded: single pixels at edges may differ between
 * a run that waited and one that did not.
 *
 * <p>Uses {@code runtime.render.gpu}, {@code runtime.render.glsl}, {@code runtime.render.light},
 * {@code runtime.render.mesh}, {@code runtime.render.occlude}, {@code runtime.render.context},
 * {@code runtime.instance}, {@code runtime.nodes.shader}, {@code runtime.camera}, {@code
 * geometry.mesh}, {@code x3d.field}, {@code base.problem} and JOGL.
 */
@NullMarked
package org.selectiverenderer.runtime.render.draw;

import org.jspecify.annotations.NullMarked;
