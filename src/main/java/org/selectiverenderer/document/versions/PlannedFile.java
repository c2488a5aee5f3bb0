package org.selectiverenderer.document.versions;

import java.nio.file.Path;

/**
 * A file to be written.
 *
 * @param state what that means for the folder
 */
public record PlannedFile(Path file, byte[] content, State state) {
  /** What is there before. */
  public enum State {
    NEW,
    CHANGED,
    UNCHANGED
  }
}
