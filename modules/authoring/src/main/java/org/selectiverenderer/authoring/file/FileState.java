package org.selectiverenderer.authoring.file;

/** The state of a file compared to when it was opened or saved last. */
public enum FileState {
  SAME,
  /** Another program has written it. */
  CHANGED,
  GONE
}
