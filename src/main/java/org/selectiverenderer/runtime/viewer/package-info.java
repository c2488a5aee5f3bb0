/**
 * The viewer, and what moves it without touching anything.
 *
 * <p>In: poses, recorded paths, Viewpoints to go to. Out: the {@link
 * org.selectiverenderer.runtime.viewer.Viewer}'s pose in the world. A {@link
 * org.selectiverenderer.runtime.viewer.ViewerMotion} moves it frame by frame: a {@link
 * org.selectiverenderer.runtime.viewer.PathMotion}, a {@link
 * org.selectiverenderer.runtime.viewer.ViewpointTransition}, or a walker of {@code runtime.walk}. A
 * {@link org.selectiverenderer.runtime.viewer.Framing} says where all of something is seen. Uses
 * {@code base.csv} and {@code base.problem} for recorded paths, {@code geometry} for boxes; no
 * scene, no window.
 */
@NullMarked
package org.selectiverenderer.runtime.viewer;

import org.jspecify.annotations.NullMarked;
