package org.selectiverenderer.browser.navigation;

/** The navigation types of X3D 4.0, 23.4.4. ANY leaves the choice to the user. */
public enum NavigationMode {
  /** Moves on the ground, with gravity and collisions. */
  WALK,
  /** Moves freely, with collisions. */
  FLY,
  /** Orbits about an object. */
  EXAMINE,
  /** Moves to the shape that is clicked; otherwise orbits like EXAMINE. */
  LOOKAT,
  /** Leaves the choice between EXAMINE and FLY to the browser, which moves as FLY. */
  EXPLORE,
  /** The user cannot move; the scene may move the viewer. */
  NONE,
  ANY
}
