package org.selectiverenderer.experiment.study;

import java.util.Locale;

/** Where a participant may go while an area is shown. */
public enum Stay {
  /** Nowhere: the view turns where the viewpoint is (thesis 6.1.1). */
  TURN,
  /** About the area. */
  WALK,
  /** Everywhere. */
  FREE;

  /** As a study file writes it. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }
}
