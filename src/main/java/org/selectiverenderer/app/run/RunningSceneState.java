package org.selectiverenderer.app.run;

import org.selectiverenderer.app.clock.FrameClock;
import org.selectiverenderer.browser.viewer.ViewerMotion;
import org.selectiverenderer.walkthrough.NavigationController;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * The state of a run once its scene has been read.
 *
 * @param walking the user's navigation
 * @param motion the viewer's motion including the tracker
 */
record RunningSceneState(
    Walkthrough walk, NavigationController walking, ViewerMotion motion, FrameClock clock) {}
