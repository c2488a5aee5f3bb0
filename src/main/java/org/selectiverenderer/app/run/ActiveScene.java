package org.selectiverenderer.app.run;

import org.selectiverenderer.app.clock.FrameClock;
import org.selectiverenderer.app.walk.UserNavigation;
import org.selectiverenderer.app.walk.Walkthrough;
import org.selectiverenderer.runtime.viewer.ViewerMotion;

/**
 * The state of a run once its scene has been read.
 *
 * @param walking the user's navigation
 * @param motion the viewer's motion including the tracker
 */
record ActiveScene(
    Walkthrough walk, UserNavigation walking, ViewerMotion motion, FrameClock clock) {}
