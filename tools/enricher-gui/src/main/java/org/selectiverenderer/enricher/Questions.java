package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.Optional;
import org.selectiverenderer.enricher.session.EnricherSession;

/** What the author is asked. */
interface Questions {
  /** What is to become of unsaved changes. */
  enum Unsaved {
    SAVE,
    DISCARD,
    CANCEL
  }

  Unsaved unsaved(String name);

  /** What is to become of changes that an earlier session has left. */
  enum Left {
    RESTORE,
    DISCARD,
    LATER;

    /** Whether nothing more is to be asked now. */
    boolean settles() {
      return this != DISCARD;
    }
  }

  /**
   * @param sentence what is left, and what restoring does
   */
  Left left(String sentence);

  /**
   * Whether to convert a scene that cannot be edited as it is.
   *
   * @param sentence what it is, and what would be made of it
   */
  boolean convert(String sentence);

  /** Whether to overwrite what another program has written. */
  boolean overwrite(String sentence);

  /** Whether to take the file of the disk in place of the document. */
  boolean reload(String sentence);

  /**
   * Whether to save where the scene will miss files.
   *
   * @param sentence which
   */
  boolean leaveBehind(String sentence);

  /**
   * Whether to save a text that is not well formed.
   *
   * @param sentence what is wrong, and what becomes of the last good copy
   */
  boolean saveFaulty(String sentence);

  Optional<Path> fileToOpen(Optional<Path> near);

  /** The file to save to, as the author names it. */
  Optional<Path> fileToSave(Path near);

  /** Whether the changes are as the author wants them, having seen them. */
  boolean review(EnricherSession session);

  /** Says a sentence that must not be missed. */
  void tell(String sentence);
}
