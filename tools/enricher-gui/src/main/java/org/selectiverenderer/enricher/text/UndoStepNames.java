package org.selectiverenderer.enricher.text;

/**
 * Translates the names of undo steps into the language of the window. The document's edits name
 * their steps in English; the bundle {@code steps} has these names as patterns, and their
 * translations. A name that matches none is shown as it is.
 */
public final class UndoStepNames {
  private final SentencePatterns patterns = new SentencePatterns("steps");

  /** Returns a step's name in the language of the window. */
  public String shown(String name) {
    return patterns.shown(name).orElse(name);
  }
}
