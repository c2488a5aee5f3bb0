package org.selectiverenderer.openxr;

/**
 * A change of the headset's state.
 *
 * @param text a sentence for people
 */
public record HeadsetEvent(Kind kind, String text) {
  /** The kind of the change. */
  public enum Kind {
    /** A headset was found. */
    FOUND,
    /** The user sees the scene, and the program has the input (FOCUSED). */
    WORN,
    /** A menu of the runtime or another program covers the scene (VISIBLE). */
    COVERED,
    /** The user does not see the scene. */
    AWAY,
    /** The runtime or the session was lost. */
    LOST,
    /** The origin of the reference space was reset. */
    RECENTRED,
    /** The interaction profile of a hand has changed. */
    CONTROLLERS,
    /** The runtime requests that the program ends. */
    LEAVE
  }
}
