/**
 * Ray casting, and collisions of the viewer.
 *
 * <p>In: the instance tree. Out: {@link org.selectiverenderer.runtime.collision.RayCaster} for the
 * drawn surfaces, {@link org.selectiverenderer.runtime.collision.CollisionWorld} for the surfaces
 * that stop the viewer, both over one {@link org.selectiverenderer.geometry.bvh.MeshBvh} per mesh;
 * and the {@link org.selectiverenderer.runtime.collision.CollisionResponse} of a sphere among the
 * obstacles near the viewer. Uses {@code runtime.instance}, {@code runtime.nodes.group}, {@code
 * runtime.scene}, {@code geometry.mesh}, {@code geometry.tree} and {@code x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.runtime.collision;

import org.jspecify.annotations.NullMarked;
