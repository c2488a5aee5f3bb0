package org.selectiverenderer.runtime.walk;

/** The navigation types of X3D 4.0, 23.4.4. ANY leaves the choice to the user. */
public enum NavigationMode {
  /** On the ground, with gravity and collisions. */
  WALK,
  /** Free of the ground, with collisions. */
  FLY,
  /** About an object. */
  EXAMINE,
  /** Towards what is pointed at; moves as EXAMINE does in between. */
  LOOKAT,
  /** Examines or flies as the user likes; here it moves as FLY. */
  EXPLORE,
  /** The user moves nothing; the scene may. */
  NONE,
  ANY
}
