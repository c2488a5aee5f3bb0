package org.selectiverenderer.browser.viewer;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.csv.TimeSeriesReader;
import org.selectiverenderer.formats.csv.TimeSeriesSpec;

/**
 * Reads a {@link CameraPath} from CSV: a header {@code t,x,y,z} or {@code t,x,y,z,yaw,pitch,roll}
 * in any order, then one row per time; seconds, metres, degrees. Other columns are ignored. See
 * {@link TimeSeriesReader}.
 *
 * <p>A path with errors is not played: the errors are reported, each with its location.
 */
public final class CameraPathReader {
  private static final TimeSeriesSpec FORM =
      new TimeSeriesSpec(
          "the path",
          "the path is not played",
          List.of("t", "x", "y", "z"),
          List.of("yaw", "pitch", "roll"),
          true,
          false,
          false);

  private CameraPathReader() {}

  /**
   * Reads a file.
   *
   * @return the path; empty if it has errors, which are then in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<CameraPath> read(Path path, ProblemCollector problems) throws IOException {
    return TimeSeriesReader.read(FORM, path, problems).map(CameraPath::new);
  }

  /**
   * Reads a text.
   *
   * @param file the file's name, for messages
   */
  public static Optional<CameraPath> parse(String file, String text, ProblemCollector problems) {
    return TimeSeriesReader.parse(FORM, file, text, problems).map(CameraPath::new);
  }
}
