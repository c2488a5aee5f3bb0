package org.selectiverenderer.app.run;

import org.selectiverenderer.app.clock.FrameClock;
import org.selectiverenderer.app.walk.Walking;
import org.selectiverenderer.app.walk.Walkthrough;
import org.selectiverenderer.runtime.viewer.ViewerMotion;

/**
 * What a run has once its scene is read.
 *
 * @param walking the user's
 * @param motion what moves the viewer in the end
 */
record LiveScene(Walkthrough walk, Walking walking, ViewerMotion motion, FrameClock clock) {}
