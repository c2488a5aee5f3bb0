package org.selectiverenderer.openxr;

/**
 * Something became of the headset.
 *
 * @param text a sentence for people
 */
public record HeadsetNews(Kind kind, String text) {
  /** What. */
  public enum Kind {
    /** There is a headset. */
    FOUND,
    /** The user sees the scene and has its controls. */
    WORN,
    /** Something of the runtime or another program is before the scene. */
    COVERED,
    /** Nobody sees the scene. */
    AWAY,
    /** Runtime or session are gone. */
    LOST,
    /** Somebody has set the middle of the room anew. */
    RECENTRED,
    /** Hands hold something else. */
    CONTROLLERS,
    /** The runtime wants the program to end. */
    LEAVE
  }
}
