/**
 * Ray casting, and collisions of the viewer.
 *
 * <p>In: the instance tree. Out: {@link org.selectiverenderer.browser.collision.RayCaster} for the
 * drawn surfaces, {@link org.selectiverenderer.browser.collision.CollisionWorld} for the surfaces
 * that stop the viewer, both over one {@link org.selectiverenderer.geometry.bvh.MeshBvh} per mesh;
 * and the {@link org.selectiverenderer.browser.collision.CollisionResponse} of a sphere among the
 * obstacles near the viewer. What moved since the last ray or step is found in the tree's log of
 * changes. Uses {@code browser.instance}, {@code browser.nodes.group}, {@code browser.scene},
 * {@code geometry.mesh}, {@code geometry.bvh} and {@code x3d.catalogue}.
 */
@NullMarked
package org.selectiverenderer.browser.collision;

import org.jspecify.annotations.NullMarked;
