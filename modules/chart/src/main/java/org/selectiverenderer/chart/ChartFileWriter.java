package org.selectiverenderer.chart;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.base.files.AtomicFileWriter;

/** Writes charts to an SVG or PNG file. */
public final class ChartFileWriter {
  /** The largest height of a picture in pixels; a higher one would take gigabytes. */
  private static final int MAX_HEIGHT = 60_000;

  private enum Kind {
    PNG,
    SVG
  }

  private final Path file;
  private final Kind kind;

  private ChartFileWriter(Path file, Kind kind) {
    this.file = file;
    this.kind = kind;
  }

  /**
   * Returns a writer of a file, which need not exist.
   *
   * @return empty unless its name ends in .png or .svg
   */
  public static Optional<ChartFileWriter> of(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    for (Kind kind : Kind.values()) {
      if (name.endsWith("." + kind.name().toLowerCase(Locale.ROOT))) {
        return Optional.of(new ChartFileWriter(file, kind));
      }
    }
    return Optional.empty();
  }

  /**
   * Draws charts one below the other and writes them; the same charts give the same bytes.
   *
   * @param title title of the drawing, for formats that have one
   * @throws IOException if the file cannot be written, or the charts are too many for one picture
   */
  public void write(String title, List<BarChart> charts) throws IOException {
    check();
    BarChartRenderer page = new BarChartRenderer(charts);
    if (page.height() > MAX_HEIGHT) {
      throw new IOException(file + ": too many charts for one picture; choose some with --scope");
    }
    AtomicFileWriter.write(file, kind == Kind.SVG ? svg(page, title) : png(page));
  }

  /**
   * Draws a step chart and writes it; the same chart gives the same bytes.
   *
   * @throws IOException if the file cannot be written
   */
  public void write(StepChart chart) throws IOException {
    check();
    StepChartRenderer page = new StepChartRenderer(chart);
    if (kind == Kind.SVG) {
      SvgCanvas canvas =
          new SvgCanvas(StepChartRenderer.WIDTH, StepChartRenderer.HEIGHT, chart.title());
      page.draw(canvas);
      AtomicFileWriter.write(file, canvas.finish().getBytes(StandardCharsets.UTF_8));
    } else {
      RasterCanvas canvas = new RasterCanvas(StepChartRenderer.WIDTH, StepChartRenderer.HEIGHT);
      page.draw(canvas);
      AtomicFileWriter.write(file, canvas.png());
    }
  }

  private void check() throws IOException {
    Path folder = file.toAbsolutePath().getParent();
    if (folder != null && !Files.isDirectory(folder)) {
      throw new IOException(file + ": there is no folder " + folder + " to write the chart to");
    }
    if (Files.isDirectory(file)) {
      throw new IOException(file + ": this is a folder; the chart is not written");
    }
  }

  private static byte[] svg(BarChartRenderer page, String title) {
    SvgCanvas canvas = new SvgCanvas(BarChartRenderer.WIDTH, (int) page.height(), title);
    page.draw(canvas);
    return canvas.finish().getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] png(BarChartRenderer page) {
    RasterCanvas canvas = new RasterCanvas(BarChartRenderer.WIDTH, (int) page.height());
    page.draw(canvas);
    return canvas.png();
  }
}
