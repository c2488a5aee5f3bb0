package org.selectiverenderer.experiment.threshold;

import java.util.Locale;

/** What a participant of the threshold pilot does. */
public enum ThresholdTask {
  /** Says which of two pictures is not like the original: by chance right half of the time. */
  TELL_APART,
  /** Names an object: one of four names, or none. */
  RECOGNISE;

  /** As settings write it. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
