/**
 * The viewer: where it is, how it walks, what it bumps into, what a ray hits.
 *
 * <p>In: the instance tree, input as intentions ({@link
 * org.selectiverenderer.runtime.navigation.Motion}), recorded paths. Out: the {@link
 * org.selectiverenderer.runtime.navigation.Viewer}'s pose. No windows, no GL.
 *
 * <ul>
 *   <li>Moving: {@link org.selectiverenderer.runtime.navigation.ViewerMotion} is a {@link
 *       org.selectiverenderer.runtime.navigation.Walker}, a {@link
 *       org.selectiverenderer.runtime.navigation.PathMotion} or a {@link
 *       org.selectiverenderer.runtime.navigation.ViewpointTransition}; {@link
 *       org.selectiverenderer.runtime.navigation.Controls} turns keys and mouse into motion.
 *   <li>Finding: {@link org.selectiverenderer.runtime.navigation.RayCaster} for what is drawn,
 *       {@link org.selectiverenderer.runtime.navigation.Colliders} for what is solid, both over one
 *       {@link org.selectiverenderer.runtime.navigation.MeshBvh} per mesh.
 * </ul>
 *
 * <p>Uses {@code x3d} and the runtime's {@code scene}, {@code nodes} and {@code instance}.
 */
@NullMarked
package org.selectiverenderer.runtime.navigation;

import org.jspecify.annotations.NullMarked;
