/**
 * Draws an instance tree into the current framebuffer, as one camera sees it.
 *
 * <p>In: an {@link org.selectiverenderer.browser.instance.InstanceTree} and a camera. Out: pixels,
 * by {@link org.selectiverenderer.render.draw.SceneRenderer}, which culls, sorts and draws. The
 * objects on the graphics card are in {@code render.gpu}.
 *
 * <p>A shape is a {@link org.selectiverenderer.render.draw.DrawItem}. What it draws is its {@link
 * org.selectiverenderer.render.draw.SubMesh}: a range of an index buffer, divided into triangle
 * clusters. Either the buffer is its own mesh's, which all shapes with that mesh share, or that of
 * a {@link org.selectiverenderer.render.draw.DrawBatch}: small opaque shapes of equal draw state,
 * near each other, whose vertices lie in one pair of buffers in coordinates around the batch's
 * origin. Plain lit shapes may differ in their diffuse colours, which are then stored in the
 * vertices. Culling and Switches work on items, in a batch too; the visible items of a batch are
 * drawn by one call, since only the index ranges change from one of its shapes to the next. Which
 * shapes share a batch is decided when the tree's structure changes. A shape that moves, or gets
 * another mesh or draw state, leaves its batch for good: its range there is not drawn any more, its
 * own mesh is uploaded in the same frame, the others stay as they are. A shape that a Switch hides
 * stays in its batch.
 *
 * <p>Strokes, hatches, fog and clip planes are a {@link
 * org.selectiverenderer.render.gpu.ShaderEffects}: the effects of a shader program besides colour
 * and light. A shape's stroke and surroundings are part of its draw state; which fog is bound is
 * known only when an eye's view is drawn, so {@link
 * org.selectiverenderer.render.draw.EyeSpaceEffects} decides then. Programs of scenes without such
 * effects contain none of their code, and no uniforms are sent for them.
 *
 * <p>A shape with a custom shader is drawn by a call of its own: {@link
 * org.selectiverenderer.render.draw.CustomShaderCache} compiles and chooses, {@link
 * org.selectiverenderer.render.draw.BuiltInUniforms} has the built-in uniforms by name, {@link
 * org.selectiverenderer.render.draw.CustomShaderBinding} sends them. The next shape binds its own
 * resources anew.
 *
 * <p>GeneratedCubeMapTextures are rendered before the frame is culled, by the same renderer: {@link
 * org.selectiverenderer.render.draw.GeneratedCubeMapRenderer} chooses which ones. Scenes without
 * them pay nothing for it.
 *
 * <p>The upload of new hidden shapes may be deferred ({@link
 * org.selectiverenderer.render.draw.SceneRenderer#follow}): a few are uploaded with each frame, in
 * batches of their own, and any of them in the very frame in which it is shown. Shown shapes that
 * come into a running scene and are too many for one frame follow likewise. The assignment to
 * batches decides how coordinates are rounded: single pixels at edges may differ between a run with
 * deferred uploads and one without.
 *
 * <p>A frame looks at the shapes that the tree's log names, and at those in boxes of its hierarchy
 * that some eye may see: {@link org.selectiverenderer.render.draw.Culler} first takes large ones in
 * view as occluders, then leaves out boxes that are outside of every view or hidden. What no item
 * uses is freed when so much has been made anew that looking at all items is paid for.
 *
 * <p>Of a scene of more than two million triangles only what is seen or near is on the graphics
 * card ({@link org.selectiverenderer.render.draw.UnseenShapes}). Its shapes are in groups of
 * neighbours. When culling finds that a shape without an item may be seen, its group is made ready
 * in that frame, the nearest groups first, as these hide most of the others; then culling goes on
 * with what is ready. So a picture never lacks anything, and of a street of apartments only the one
 * around the viewer is made ready. Near groups follow, a little with each frame, and far ones are
 * given up. {@link org.selectiverenderer.render.draw.SceneRenderer#prepare} makes all ready.
 *
 * <p>{@link org.selectiverenderer.render.draw.DrawItemCache} has the items that there are, {@link
 * org.selectiverenderer.render.draw.DeferredShapes} decides when the others come. A frame spends at
 * most a few milliseconds on what is made ready ahead, as measured in the frames before ({@link
 * org.selectiverenderer.render.draw.UploadBudget}). A mesh of more than 20,000 triangles that is
 * not needed at once is packed on a thread of its own ({@link
 * org.selectiverenderer.render.draw.BackgroundPacker}).
 *
 * <p>Uses {@code render.gpu}, {@code render.glsl}, {@code render.lighting}, {@code render.mesh},
 * {@code render.occlusion}, {@code render.context}, {@code browser.instance}, {@code
 * browser.nodes.shader}, {@code browser.camera}, {@code geometry.bvh}, {@code geometry.mesh},
 * {@code x3d.field}, {@code base.problem} and JOGL.
 */
@NullMarked
package org.selectiverenderer.render.draw;

import org.jspecify.annotations.NullMarked;
