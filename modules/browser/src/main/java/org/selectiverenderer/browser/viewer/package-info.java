/**
 * The viewer, and motions that move it without collisions.
 *
 * <p>In: poses, recorded paths, Viewpoints to go to. Out: the {@link
 * org.selectiverenderer.browser.viewer.Viewer}'s pose in the world. A {@link
 * org.selectiverenderer.browser.viewer.ViewerMotion} moves it frame by frame: a {@link
 * org.selectiverenderer.browser.viewer.PathMotion}, a {@link
 * org.selectiverenderer.browser.viewer.ViewpointTransition}, or a walker of {@code
 * browser.navigation}. A {@link org.selectiverenderer.browser.viewer.CameraFraming} computes a pose
 * from which a whole bounding box is in view. Uses {@code formats.csv} and {@code base.problem} for
 * recorded paths, {@code geometry} for boxes; no scene, no window.
 */
@NullMarked
package org.selectiverenderer.browser.viewer;

import org.jspecify.annotations.NullMarked;
