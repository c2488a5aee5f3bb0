/**
 * The viewer, and motions that move it without collisions.
 *
 * <p>In: poses, recorded paths, Viewpoints to go to. Out: the {@link
 * org.selectiverenderer.runtime.viewer.Viewer}'s pose in the world. A {@link
 * org.selectiverenderer.runtime.viewer.ViewerMotion} moves it frame by frame: a {@link
 * org.selectiverenderer.runtime.viewer.PathMotion}, a {@link
 * org.selectiverenderer.runtime.viewer.ViewpointTransition}, or a walker of {@code runtime.walk}. A
 * {@link org.selectiverenderer.runtime.viewer.CameraFraming} computes a pose from which a whole
 * bounding box is in view. Uses {@code base.csv} and {@code base.problem} for recorded paths,
 * {@code geometry} for boxes; no scene, no window.
 */
@NullMarked
package org.selectiverenderer.runtime.viewer;

import org.jspecify.annotations.NullMarked;
