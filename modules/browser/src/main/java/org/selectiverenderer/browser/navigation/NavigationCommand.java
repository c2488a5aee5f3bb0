package org.selectiverenderer.browser.navigation;

/** A command of the user that is not a motion; the owner of the world executes it. */
public enum NavigationCommand {
  /** Home: back to the bound viewpoint. */
  RESET_VIEWPOINT,
  /** Page Up. */
  PREVIOUS_VIEWPOINT,
  /** Page Down. */
  NEXT_VIEWPOINT,
  /** End: to the last viewpoint. */
  LAST_VIEWPOINT,
  /** F1: shows or hides frames per second, polygons, areas and schemas. */
  TOGGLE_OVERLAY,
  /** F2: to the next navigation type that the scene allows. */
  NEXT_MODE,
  /** F3: collisions on and off. */
  TOGGLE_COLLISIONS,
  /** F4: makes the present head direction the forward direction. */
  RESET_HEADING,
  /** F5: moves the viewer to where the whole scene is in view. */
  VIEW_ALL,
  /** Click: moves the viewer to the shape under the pointer, if the navigation type is LOOKAT. */
  LOOK_AT,
  /** F11. */
  TOGGLE_FULL_SCREEN,
  /** Escape. */
  LEAVE
}
