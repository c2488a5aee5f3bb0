package org.selectiverenderer.experiment.study;

import java.util.Locale;

/** Where the mouse pointer is while something is shown to a participant. */
public enum PointerPlace {
  /** Kept where each eye has a monitor, as nobody sees it there; else free. */
  AUTO,
  /** In the participant's window, unseen. */
  KEPT,
  /** Wherever the hand takes it. */
  FREE;

  /** As a study file writes it. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }
}
