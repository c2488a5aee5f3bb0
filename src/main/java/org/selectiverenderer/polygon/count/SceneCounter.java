package org.selectiverenderer.polygon.count;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.x3d.files.ContentAccess;

/**
 * Counts a scene again and again while it is edited: of what it inlines only files are read that
 * have changed since the count before. Prototypes of other files are taken as they were when the
 * file that uses them was read, until {@link #forget}.
 *
 * <p>Safe for use by several threads; one counts at a time.
 */
public final class SceneCounter {
  private volatile KeptFiles kept = new KeptFiles();

  /**
   * What a scene comes to. What is wrong with it is for its checks to say.
   *
   * @param states of all parts of the scene, those of one part together, as loaded first
   * @param model as the validator sees the scene
   */
  public record Counted(
      SceneStatistics statistics, List<StateShares> states, SceneModel model, int filesRead) {
    /** Keeps copies, so that it stays as it is. */
    public Counted {
      states = List.copyOf(states);
    }
  }

  /**
   * Counts the text of a scene.
   *
   * @param file where it is, or would be: its urls start from there
   * @param name for messages
   * @throws IOException if there is no scene in it, with a message of one line
   */
  public synchronized Counted count(Path file, String name, byte[] text, ContentAccess access)
      throws IOException {
    Problems problems = new Problems();
    SceneFiles.Read read = SceneFiles.read(file, name, text, access, kept);
    PolygonStatistics counting = new PolygonStatistics(read.file(), List.of(), problems);
    return new Counted(
        counting.count(name), counting.shares(), SceneModel.of(read.file()), read.filesRead());
  }

  /** Reads all files anew next time; waits for no count that is under way. */
  public void forget() {
    kept = new KeptFiles();
  }
}
