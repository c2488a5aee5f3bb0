package org.selectiverenderer.app.chart;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.chart.SvgCanvas;
import org.selectiverenderer.polygon.statistics.SceneStatistics;

/** A file that charts are to be drawn into. */
public final class ChartFile {
  /** Pixels; more would take gigabytes. */
  private static final int MAX_HEIGHT = 60_000;

  private enum Kind {
    PNG,
    SVG
  }

  private final Path file;
  private final Kind kind;

  private ChartFile(Path file, Kind kind) {
    this.file = file;
    this.kind = kind;
  }

  /**
   * A file that need not exist.
   *
   * @return empty unless its name ends in .png or .svg
   */
  public static Optional<ChartFile> of(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    for (Kind kind : Kind.values()) {
      if (name.endsWith("." + kind.name().toLowerCase(Locale.ROOT))) {
        return Optional.of(new ChartFile(file, kind));
      }
    }
    return Optional.empty();
  }

  /**
   * Draws the charts of a scene's polygons and writes them, the same bytes every time.
   *
   * @throws IOException if the file cannot be written, or the charts are too many for one picture
   */
  public void write(SceneStatistics statistics) throws IOException {
    Path folder = file.toAbsolutePath().getParent();
    if (folder != null && !Files.isDirectory(folder)) {
      throw new IOException(file + ": there is no folder " + folder + " to write the chart to");
    }
    if (Files.isDirectory(file)) {
      throw new IOException(file + ": this is a folder; the chart is not written");
    }
    ChartPage page = new ChartPage(StatisticsCharts.of(statistics));
    if (page.height() > MAX_HEIGHT) {
      throw new IOException(file + ": too many charts for one picture; choose some with --scope");
    }
    Files.write(file, kind == Kind.SVG ? svg(page, statistics) : png(page));
  }

  private static byte[] svg(ChartPage page, SceneStatistics statistics) {
    SvgCanvas canvas =
        new SvgCanvas(
            ChartPage.WIDTH,
            (int) page.height(),
            "Polygons of " + Path.of(statistics.scene()).getFileName());
    page.draw(canvas);
    return canvas.finish().getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] png(ChartPage page) throws IOException {
    PixelCanvas canvas = new PixelCanvas(ChartPage.WIDTH, (int) page.height());
    page.draw(canvas);
    return canvas.png();
  }
}
