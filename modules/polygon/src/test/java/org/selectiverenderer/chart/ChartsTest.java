package org.selectiverenderer.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.polygon.SceneStatistics;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;
import org.selectiverenderer.polygon.SceneStatisticsCharts;

class ChartsTest {
  private static final SceneStatistics OFFICE = office("Switch_TrashCan", 291489);

  @TempDir Path folder;

  private static SceneStatistics office(String name, long high) {
    return new SceneStatistics(
        "scenes/a & b.x3d",
        high,
        List.of(
            new ObjectCount(name, Optional.of("Office"), List.of(1064L, 93L), 0),
            new ObjectCount("Switch_Plant", Optional.of("Office"), List.of(10L, 20L, 5L), 0),
            new ObjectCount("Switch_Empty", Optional.of("Office"), List.of(0L, 0L), 0)),
        List.of(
            new ScopeCount(
                "Office",
                high,
                List.of(
                    new StateCount(List.of("OfficeSchema"), high / 4, 25),
                    new StateCount(List.of("DeskSchema"), high / 3, 33.3),
                    new StateCount(List.of("DeskSchema", "BookcaseSchema"), high / 2, 50)))));
  }

  private static void write(Path file, SceneStatistics statistics) throws IOException {
    ChartFileWriter.of(file)
        .orElseThrow()
        .write("Polygons of a & b.x3d", SceneStatisticsCharts.of(statistics));
  }

  /** A text or a bar on the page; texts are as wide as their letters and as high as an em. */
  private record Box(String what, double left, double top, double right, double bottom) {
    boolean meets(Box other) {
      return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
  }

  private static final class Recorder implements ChartCanvas {
    final List<Box> texts = new ArrayList<>();
    final List<Box> bars = new ArrayList<>();

    @Override
    public void rectangle(double x, double y, double width, double height, ChartColour colour) {
      switch (colour) {
        case BLUE, ORANGE, VERMILION, GREY -> bars.add(new Box("bar", x, y, x + width, y + height));
        default -> {}
      }
    }

    @Override
    public void text(String text, double x, double y, SizedFont lettering, ChartColour colour) {
      double size = lettering.size();
      texts.add(new Box(text, x, y - 0.8 * size, x + lettering.width(text), y + 0.2 * size));
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {0, 1, 7, 999, 291489, 1234567890123L})
  void noTextMeetsAnotherOrABarOrTheEdge(long polygons) {
    String longName = "Switch_" + "VeryLongName".repeat(12);
    BarChartRenderer page =
        new BarChartRenderer(SceneStatisticsCharts.of(office(longName, polygons)));
    Recorder recorder = new Recorder();

    page.draw(recorder);

    for (Box text : recorder.texts) {
      assertThat(text.left).as(text.what).isGreaterThanOrEqualTo(0);
      assertThat(text.right).as(text.what).isLessThanOrEqualTo(BarChartRenderer.WIDTH);
      assertThat(text.bottom).as(text.what).isLessThan(page.height());
      assertThat(recorder.texts).filteredOn(other -> other != text && other.meets(text)).isEmpty();
      assertThat(recorder.bars).filteredOn(bar -> bar.meets(text)).isEmpty();
    }
  }

  @Test
  void barsAreLabelledWithObjectsAndStates() {
    Recorder recorder = new Recorder();

    new BarChartRenderer(SceneStatisticsCharts.of(OFFICE)).draw(recorder);

    assertThat(recorder.texts)
        .extracting(Box::what)
        .contains(
            "TrashCan",
            "8.7 %  (93 of 1,064)",
            "Plant, v2",
            "200.0 %  (20 of 10)",
            "Plant, v3",
            "no polygons in the original",
            "all objects high",
            "291,489  (100.0 %)",
            "DeskSchema and BookcaseSchema");
  }

  @Test
  void svgIsWellFormedAndTheSameEveryTime() throws Exception {
    Path file = folder.resolve("chart.svg");
    write(file, office("Switch_<&>\"\u0001\ud83d", 10));
    byte[] first = Files.readAllBytes(file);
    write(file, office("Switch_<&>\"\u0001\ud83d", 10));

    assertThat(Files.readAllBytes(file)).isEqualTo(first);
    var svg =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new ByteArrayInputStream(first))
            .getDocumentElement();
    assertThat(svg.getAttribute("width")).isEqualTo("1200");
    assertThat(svg.getElementsByTagName("title").item(0).getTextContent())
        .isEqualTo("Polygons of a & b.x3d");
    assertThat(svg.getTextContent()).contains("<&>\"", "OfficeSchema");
  }

  @Test
  void pngShowsBarsAndLetters() throws IOException {
    Path file = folder.resolve("chart.PNG");

    write(file, OFFICE);

    BufferedImage image = ImageIO.read(file.toFile());
    assertThat(image.getWidth()).isEqualTo(1200);
    int[] pixels =
        image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    assertThat(share(pixels, ChartColour.PAPER)).isBetween(0.7, 0.95);
    assertThat(share(pixels, ChartColour.INK)).as("letters").isBetween(0.0005, 0.02);
    for (ChartColour bar :
        List.of(ChartColour.BLUE, ChartColour.ORANGE, ChartColour.VERMILION, ChartColour.GREY)) {
      assertThat(share(pixels, bar)).as(bar.name()).isGreaterThan(0.005);
    }
  }

  private static double share(int[] pixels, ChartColour colour) {
    return IntStream.of(pixels).filter(rgb -> (rgb & 0xffffff) == colour.rgb()).count()
        / (double) pixels.length;
  }

  @Test
  void otherEndingsAreNoChartFiles() {
    assertThat(ChartFileWriter.of(Path.of("chart.jpg"))).isEmpty();
    assertThat(ChartFileWriter.of(Path.of("svg"))).isEmpty();
  }

  @Test
  void aFolderThatIsNotThereIsNamed() {
    Path file = folder.resolve("missing").resolve("chart.svg");

    assertThatThrownBy(() -> write(file, OFFICE))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("there is no folder " + file.getParent());
  }

  @Test
  void tooManyBarsAreLeftOutAndSaid() {
    List<ObjectCount> objects =
        IntStream.range(0, 300)
            .mapToObj(i -> new ObjectCount("S" + i, Optional.of("Hall"), List.of(9L, 1L), 0))
            .toList();
    SceneStatistics hall =
        new SceneStatistics("hall.x3d", 9, objects, List.of(new ScopeCount("Hall", 9, List.of())));

    BarChart chart = SceneStatisticsCharts.of(hall).get(0);

    assertThat(chart.bars()).hasSize(200);
    assertThat(chart.subtitle()).endsWith("100 more are left out");
  }
}
