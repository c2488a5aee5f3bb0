package org.selectiverenderer.study.definition;

import java.util.Locale;

/** The movement constraint of a participant while an area is shown. */
public enum MovementConstraint {
  /** No walking: the participant turns at the viewpoint (thesis 6.1.1). */
  TURN,
  /** Walking within the area. */
  WALK,
  /** Walking everywhere. */
  FREE;

  /** Returns the spelling in a study file. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT);
  }
}
