package org.selectiverenderer.study.definition;

import java.util.Locale;

/** Where the mouse pointer is confined while a scene is shown to a participant. */
public enum PointerConfinement {
  /** Confined if each eye has a monitor, as nobody could see the pointer there; else free. */
  AUTO,
  /** Confined to the participant's window, and invisible. */
  KEPT,
  /** Not confined. */
  FREE;

  /** Returns the spelling in a study file. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }
}
