package org.selectiverenderer.polygon;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Counts a scene repeatedly while it is edited: of the files that it inlines, only those that
 * changed since the last count are read again. Prototypes of other files stay as they were when the
 * file that uses them was read, until {@link #forget}.
 *
 * <p>Thread-safe; one thread counts at a time.
 */
public final class IncrementalSceneCounter {
  private volatile GeometryMeasurementCache kept = new GeometryMeasurementCache();

  /**
   * The result of a count. Problems of the scene are not included; the validator reports them.
   *
   * @param states the states of all parts of the scene, grouped by part, each part's state as
   *     loaded first
   * @param model the enrichment of the scene as the validator sees it
   */
  public record CountResult(
      SceneStatistics statistics,
      List<PolygonContributions> states,
      EnrichmentPolygonModel model,
      int filesRead) {
    /** Makes defensive copies, so that the record is immutable. */
    public CountResult {
      states = List.copyOf(states);
    }
  }

  /**
   * Counts the text of a scene.
   *
   * @param file the file where the scene is, or would be: relative urls are resolved against it
   * @param name name of the scene in messages
   * @throws IOException if the text is not a scene, with a message of one line
   */
  public synchronized CountResult count(
      Path file, String name, byte[] text, ContentAccessPolicy access) throws IOException {
    ProblemCollector problems = new ProblemCollector();
    SceneFileLoader.Read read = SceneFileLoader.read(file, name, text, access, kept);
    ScenePolygonCounter counting = new ScenePolygonCounter(read.file(), List.of(), problems);
    return new CountResult(
        counting.count(name),
        counting.shares(),
        EnrichmentPolygonModel.of(read.file()),
        read.filesRead());
  }

  /**
   * Clears the cache, so that the next count reads all files again; does not wait for a count in
   * progress.
   */
  public void forget() {
    kept = new GeometryMeasurementCache();
  }
}
