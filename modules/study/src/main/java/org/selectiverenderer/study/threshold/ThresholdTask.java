package org.selectiverenderer.study.threshold;

import java.util.Locale;

/** The task of a participant in a threshold pilot. */
public enum ThresholdTask {
  /**
   * Discrimination: which of two pictures differs from the original (two-alternative forced choice,
   * chance level one half).
   */
  TELL_APART,
  /** Recognition: the name of an object, one of four names, or none. */
  RECOGNISE;

  /** Returns the spelling in the settings. */
  public String spelling() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
