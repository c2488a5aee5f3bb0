/**
 * What a ray hits and what the viewer bumps into.
 *
 * <p>In: the instance tree. Out: {@link org.selectiverenderer.runtime.collide.RayCaster} for what
 * is drawn, {@link org.selectiverenderer.runtime.collide.Colliders} for what is solid, both over
 * one {@link org.selectiverenderer.geometry.tree.MeshTree} per mesh; and the barriers that
 * triangles near the viewer are to it. Uses {@code runtime.instance}, {@code runtime.nodes.group},
 * {@code runtime.scene}, {@code geometry.mesh}, {@code geometry.tree} and {@code x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.runtime.collide;

import org.jspecify.annotations.NullMarked;
