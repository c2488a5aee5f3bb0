/**
 * The instance tree of a running scene: one instance per path from the root to a node, with its
 * world transformation, visibility, mesh, material and lights.
 *
 * <p>X3D is a graph: a node may be USEd in many places. {@link InstanceTree} is the tree of all
 * paths, and each {@link Instance} is one occurrence of a node. Groups keep the transformation of
 * their content, shapes their mesh and material (shared by all instances of a Shape), lights their
 * scope. Shapes with the same {@link org.selectiverenderer.browser.scene.NodeTemplate}, copies in
 * Inlines of one file, are read once and share the result. The tree is built once, with every
 * version of every object in it, and follows changes through node observers: a Switch costs its old
 * and its new child, a Transform the instances below it. The number of triangles shown is updated
 * at the same time. Drawing, sensors, rays, collisions and counting all read this one tree.
 *
 * <p>A LocalFog, ClipPlane or EnvironmentLight is an {@link
 * org.selectiverenderer.browser.instance.ScopedEffectInstance}; the {@link
 * org.selectiverenderer.browser.instance.ScopedEffects} of a shape are those whose scope it is in.
 * How its lines, points and areas are drawn is its {@link
 * org.selectiverenderer.browser.instance.DrawProperties}.
 *
 * <p>A {@link SurfaceMaterial} is the material of a shape. Most have one material node and at most
 * one image; all further properties are its {@link ExtendedMaterial}, with a {@link TextureUnit}
 * for every texture, whose coordinates are numbered as {@code x3d.tessellate} numbers those of the
 * mesh.
 *
 * <p>The shaders of an Appearance are {@link ShaderProgramSource}s. The renderer uses the first
 * that compiles and reports the result for each.
 *
 * <p>A renderer follows the shapes by {@link ShapeChanges}, a log of those that moved, changed or
 * came to be shown, and finds those in a part of space by {@link ShapeTree}, a hierarchy over all
 * their boxes: neither walks through all shapes.
 *
 * <p>In: changes of nodes. Out: the tree, updated at the cost of what has changed. Uses {@code
 * browser.nodes.group}, {@code browser.nodes.sensor}, {@code browser.nodes.shader}, {@code
 * browser.nodes.sound}, {@code browser.scene}, the movies of {@code browser.movie}, {@code
 * geometry.bvh}, {@code geometry.mesh}, {@code x3d.tessellate}, {@code x3d.catalogue}, {@code
 * x3d.field}, {@code x3d.shader} and {@code base.problem}; no GL.
 */
@NullMarked
package org.selectiverenderer.browser.instance;

import org.jspecify.annotations.NullMarked;
