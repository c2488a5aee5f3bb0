package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Optional;
import org.selectiverenderer.study.definition.Study;

/**
 * The room on the disk with a study's folder.
 *
 * @param free free bytes
 */
public record DiskRoom(long free) {
  /**
   * Free bytes below which a session may end too early: an hour at 120 frames a second writes 95
   * MB, as docs/experiment.md measures.
   */
  public static final long LEAST = 200L << 20;

  /**
   * Measures the room.
   *
   * @throws IOException if the disk does not tell
   */
  public static DiskRoom of(Study study) throws IOException {
    return new DiskRoom(Files.getFileStore(study.folder()).getUsableSpace());
  }

  /** Returns a sentence if there is too little room for a session. */
  public Optional<String> warning() {
    return free >= LEAST
        ? Optional.empty()
        : Optional.of(
            "the disk with the study's folder has %d MB left; make room before a session"
                .formatted(free >> 20));
  }
}
