package org.selectiverenderer.document.versions;

import java.nio.file.Path;

/**
 * A file to be written.
 *
 * @param state what that means for the folder
 * @param byHand whether what is there was made by somebody else, so that it cannot be made again
 */
public record PlannedFile(Path file, byte[] content, State state, boolean byHand) {
  /** What is there before. */
  public enum State {
    NEW,
    CHANGED,
    UNCHANGED
  }
}
