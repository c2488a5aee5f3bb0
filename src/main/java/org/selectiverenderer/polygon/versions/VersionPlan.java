package org.selectiverenderer.polygon.versions;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * What making versions of an object will write. Nothing has been written yet.
 *
 * @param object the DEF name of the object
 * @param versions the original first
 * @param files all files that are written
 * @param scene the changed scene's file, one of them
 * @param edits how the scene's text changes; empty when it already has the Switch
 */
public record VersionPlan(
    String object, List<Version> versions, List<PlannedFile> files, Path scene, List<Edit> edits) {

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

  /**
   * A place in the scene that changes.
   *
   * @param line of its first character, from 1
   * @param before whole lines, to be shown
   * @param from offset of the first character of the text that goes
   * @param to offset behind the last
   * @param replacement what comes in their place
   */
  public record Edit(int line, String before, String after, int from, int to, String replacement) {}

  public VersionPlan {
    versions = List.copyOf(versions);
    files = List.copyOf(files);
    edits = List.copyOf(edits);
  }

  /**
   * Writes all files that change, or none.
   *
   * @return see {@link FileTransaction#commit}
   * @throws IOException if one cannot be written, with one line that names it
   */
  public List<Path> apply(FileActions actions) throws IOException {
    return write(actions, true);
  }

  /** Writes the versions' files, or none, and leaves the scene's file to somebody else. */
  public List<Path> applyVersions(FileActions actions) throws IOException {
    return write(actions, false);
  }

  private List<Path> write(FileActions actions, boolean withScene) throws IOException {
    FileTransaction writing = new FileTransaction(actions);
    for (PlannedFile file : files) {
      boolean wanted = withScene || !file.file().equals(scene);
      if (wanted && file.state() != PlannedFile.State.UNCHANGED) {
        writing.add(file.file(), file.content());
      }
    }
    return writing.commit();
  }
}
