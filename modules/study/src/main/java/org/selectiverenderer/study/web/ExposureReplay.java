package org.selectiverenderer.study.web;

import java.io.IOException;
import java.time.OffsetDateTime;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.headlog.HeadLogMetadata;

/**
 * Finds what was in view in an exposure that ran elsewhere, by showing the scene the same poses and
 * the same choices of its Switches.
 */
@FunctionalInterface
public interface ExposureReplay {
  /**
   * An exposure, or a trial with exposures.
   *
   * @param scene the scene that was shown; empty if the study names none
   * @param viewpoint DEF of the Viewpoint at which it began; empty for the scene's first
   * @param seed of the condition {@code random}
   * @param started when it began
   * @param width of the window in pixels
   * @param height of the window in pixels
   */
  record Exposure(
      Optional<Path> scene,
      String viewpoint,
      Condition condition,
      StudyGroup group,
      long seed,
      OffsetDateTime started,
      int width,
      int height,
      WebExposureLog log) {
    /** Returns what head logs say of the display. */
    public String display() {
      return "browser window of %dx%d".formatted(width, height);
    }
  }

  /**
   * A row of a head log says this of a frame besides the pose.
   *
   * @param object name of the object in the middle of the view; empty for none
   * @param distance to its surface; NaN for none
   * @param version the choice that its Switch shows; -1 for none
   * @param cone names of the objects about the middle
   * @param schemas the active schemas
   */
  record Seen(
      String object, double distance, int version, List<String> cone, List<String> schemas) {
    /** Nothing is known of the frame. */
    public static final Seen UNKNOWN = new Seen("", Double.NaN, -1, List.of(), List.of());

    public Seen {
      cone = List.copyOf(cone);
      schemas = List.copyOf(schemas);
    }
  }

  /**
   * A replay tells the frames of an exposure and the columns of its head log.
   *
   * @param frames one for each frame of the log
   */
  record Replayed(HeadLogMetadata description, List<Seen> frames) {
    public Replayed {
      frames = List.copyOf(frames);
    }
  }

  /**
   * Replays an exposure.
   *
   * @throws IOException if the scene cannot be read, with a sentence
   */
  Replayed of(Study study, Exposure exposure) throws IOException;
}
