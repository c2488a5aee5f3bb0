/**
 * What is where in a running scene: one instance per path from the root to a node, with its world
 * transformation, whether it is shown, its mesh, surface and lights.
 *
 * <p>X3D is a graph: a node may be USEd in many places. {@link InstanceTree} is the tree of all
 * paths, and each {@link Instance} is one node in one place. Groups keep the transformation of
 * their content, shapes their mesh and surface (shared by all places of a Shape), lights their
 * scope. The tree is built once, with every version of every object in it, and follows changes
 * through node observers: a Switch costs its old and its new child, a Transform what is below it.
 * The sum of the triangles shown is kept along. Drawing, sensors, rays, collisions and counting all
 * read this one tree.
 *
 * <p>A LocalFog, ClipPlane or EnvironmentLight is an {@link
 * org.selectiverenderer.runtime.instance.EffectInstance}; the {@link
 * org.selectiverenderer.runtime.instance.Surroundings} of a shape are those whose scope it is in.
 * How its lines, points and areas are drawn is its {@link
 * org.selectiverenderer.runtime.instance.Stroke}.
 *
 * <p>A {@link Surface} is a shape's look. Most are one material and at most one image; what goes
 * beyond is its {@link SurfaceDetail}, with a {@link TextureUnit} for every texture, whose
 * coordinates are numbered as {@code geometry.tessellate} numbers those of the mesh.
 *
 * <p>What the shaders of an Appearance say is its {@link SurfaceProgram}s, of which whoever draws
 * uses the first that compiles, and tells the shape what has come of each.
 *
 * <p>In: changes of nodes. Out: the tree, kept true at the cost of what changed. Uses {@code
 * runtime.nodes.group}, {@code runtime.nodes.sensor}, {@code runtime.nodes.shader}, {@code
 * runtime.nodes.sound}, {@code runtime.scene}, the films of {@code runtime.movie}, {@code
 * geometry.mesh}, {@code geometry.tessellate}, {@code x3d.catalogue}, {@code x3d.field}, {@code
 * x3d.shader} and {@code base.problem}; no GL.
 */
@NullMarked
package org.selectiverenderer.runtime.instance;

import org.jspecify.annotations.NullMarked;
