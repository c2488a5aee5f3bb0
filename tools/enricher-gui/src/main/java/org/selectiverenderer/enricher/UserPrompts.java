package org.selectiverenderer.enricher;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.file.ThreeWayMerge;
import org.selectiverenderer.enricher.session.EnricherSession;

/** The questions that the window asks the author; tests answer them without dialogs. */
interface UserPrompts {
  /** What to do with unsaved changes before the document is closed. */
  enum Unsaved {
    SAVE,
    DISCARD,
    CANCEL
  }

  Unsaved unsaved(String name);

  /** What to do with the unsaved changes of a crashed session. */
  enum Left {
    RESTORE,
    DISCARD,
    LATER;

    /** Whether this answer ends the questions for now. */
    boolean settles() {
      return this != DISCARD;
    }
  }

  /**
   * @param sentence which changes are left, and what restoring them does
   */
  Left left(String sentence);

  /**
   * Asks whether to convert a scene that is not XML.
   *
   * @param sentence the encoding of the scene, and the file that would be written
   */
  boolean convert(String sentence);

  /** Asks whether to take the saved text in place of the changed one. */
  boolean revert(String sentence);

  /** Asks whether to overwrite a file. */
  boolean overwrite(String sentence);

  /** What to do about a file that another program has changed. */
  enum OnDisk {
    /** Document and file both stay as they are for now. */
    KEEP,
    /** The document takes the place of the file. */
    OVERWRITE,
    /** The file takes the place of the document. */
    TAKE,
    /** The changes of both are merged. */
    MERGE
  }

  /**
   * @param among the possible answers, beginning with the one that changes nothing
   */
  OnDisk changedOnDisk(String sentence, List<OnDisk> among);

  /**
   * Asks how each conflict between document and file is decided; empty if the author does not
   * merge.
   */
  Optional<List<ThreeWayMerge.Choice>> merge(ThreeWayMerge merge);

  /** The author chooses what to do where a scene is saved to a folder that lacks its files. */
  enum LeftBehind {
    CANCEL,
    /** The files are copied too. */
    TAKE,
    /** The scene is saved alone. */
    LEAVE
  }

  /**
   * @param sentence which files will be missing
   */
  LeftBehind leaveBehind(String sentence);

  /**
   * Asks whether to save a text that is not well-formed XML.
   *
   * @param sentence the fault, and where the last well-formed file stays
   */
  boolean saveFaulty(String sentence);

  /**
   * Asks whether the settings file beside a scene may open what it asks for.
   *
   * @param lines what it asks for beyond its own folder
   */
  boolean trust(String sentence, List<String> lines);

  /**
   * Asks whether to go on without some files.
   *
   * @param lines which files, and why
   */
  boolean without(String sentence, List<String> lines);

  /**
   * Asks whether to replace files that have other content.
   *
   * @param lines which files
   */
  boolean replace(String sentence, List<String> lines);

  /** The model to import; empty if the author cancels. */
  Optional<Path> modelToImport(Path scene);

  Optional<Path> fileToOpen(Optional<Path> near);

  /** The file to save to; empty if the author cancels. */
  Optional<Path> fileToSave(Path near);

  /** Shows the changes that saving will write and asks whether to save. */
  boolean review(EnricherSession session);

  /** Tells the author something in a dialog that has to be confirmed. */
  void tell(String sentence);
}
