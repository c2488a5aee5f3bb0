package org.selectiverenderer.runtime.walk;

/** What the user asks for that is not a motion; whoever owns the world does it. */
public enum NavigationCommand {
  /** Home: back to the bound viewpoint. */
  RESET_VIEWPOINT,
  /** Page Up. */
  PREVIOUS_VIEWPOINT,
  /** Page Down. */
  NEXT_VIEWPOINT,
  /** End: to the last viewpoint. */
  LAST_VIEWPOINT,
  /** F1: frames per second, polygons, areas, schemas. */
  TOGGLE_OVERLAY,
  /** F2: to the next navigation type that the scene allows. */
  NEXT_MODE,
  /** F3: collisions on and off. */
  TOGGLE_COLLISIONS,
  /** F4: where the head looks now is straight ahead. */
  RESET_HEADING,
  /** F5: where all of the scene is seen. */
  VIEW_ALL,
  /** A click: to what is pointed at, where the navigation type is LOOKAT. */
  LOOK_AT,
  /** F11. */
  TOGGLE_FULL_SCREEN,
  /** Escape. */
  LEAVE
}
