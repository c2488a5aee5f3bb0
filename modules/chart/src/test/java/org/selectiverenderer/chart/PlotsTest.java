package org.selectiverenderer.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.chart.BarPlot.Group;
import org.selectiverenderer.chart.LinePlot.Curve;
import org.selectiverenderer.chart.LinePlot.Point;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

class PlotsTest {
  private static final Path GOLDEN =
      Path.of("modules/chart/src/test/resources/org/selectiverenderer/chart");

  private static final BarPlot GROUPS =
      new BarPlot(
          "Frames & more",
          "made-up figures; more is better",
          "",
          false,
          List.of("this program", "another", "a third"),
          List.of(
              new Group("hall", Map.of("this program", 61.4, "another", 30.26, "a third", 9.0)),
              new Group("attic", Map.of("this program", 1234.5, "a third", 0.0))));

  private static final BarPlot PARTS =
      new BarPlot(
          "First frame",
          "made-up figures; what the time goes into",
          " ms",
          true,
          List.of("start", "classes", "reading", "triangles", "upload", "drawing", "rest"),
          List.of(
              part("hall", 40, 120, 80, 35, 20.5, 60, 3),
              part("attic", 41, 110, 380, 135, 70, 90, 4)));

  private static final LinePlot CURVES =
      new LinePlot(
          "More sensors",
          "made-up figures",
          "sensors",
          "milliseconds",
          List.of(
              new Curve(
                  "frame", List.of(new Point(1, 0.5), new Point(100, 0.5), new Point(1e5, 0.6))),
              new Curve("update", List.of(new Point(1, 0.02), new Point(1e5, 0.55))),
              new Curve(
                  "load", List.of(new Point(1, 90), new Point(1000, 120), new Point(1e5, 2100)))));

  private static Group part(String label, double... values) {
    List<String> names =
        List.of("start", "classes", "reading", "triangles", "upload", "drawing", "rest");
    Map<String, Double> map = new HashMap<>();
    IntStream.range(0, names.size()).forEach(i -> map.put(names.get(i), values[i]));
    return new Group(label, map);
  }

  static Stream<Plot> plots() {
    String longName = "a very long name ".repeat(20);
    return Stream.of(
        GROUPS,
        PARTS,
        CURVES,
        new BarPlot(
            longName,
            longName,
            " " + "m".repeat(20),
            false,
            List.of(longName, "b"),
            List.of(new Group(longName, Map.of("b", 1e9)))),
        new LinePlot(
            "Steep",
            "",
            "x",
            "y",
            List.of(new Curve("c", List.of(new Point(1, 2), new Point(1e6, 3))))),
        new BarPlot("Nothing", "", "", false, List.of(), List.of()),
        new LinePlot(
            longName,
            longName,
            longName.substring(0, 80),
            "y",
            IntStream.range(0, 7)
                .mapToObj(i -> new Curve(i + longName, List.of(new Point(5, 5))))
                .toList()));
  }

  /** After a change that is meant, {@code -Dplots.update=true} writes the golden files anew. */
  @Test
  void plotsAreTheSameAsEver() throws IOException {
    Map<String, Plot> golden =
        Map.of("groups.svg", GROUPS, "parts.svg", PARTS, "curves.svg", CURVES);
    for (Map.Entry<String, Plot> file : golden.entrySet()) {
      Path path = GOLDEN.resolve(file.getKey());
      if (Boolean.getBoolean("plots.update")) {
        Files.createDirectories(GOLDEN);
        Files.writeString(path, file.getValue().svg());
      }
      assertThat(Files.readString(path).replace("\r\n", "\n"))
          .as(file.getKey())
          .isEqualTo(file.getValue().svg());
    }
  }

  private record Box(String text, double left, double top, double right, double bottom) {
    boolean meets(Box other) {
      return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
  }

  @ParameterizedTest
  @MethodSource("plots")
  void noTextMeetsAnotherOrTheEdge(Plot plot) throws Exception {
    Element svg =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new ByteArrayInputStream(plot.svg().getBytes(StandardCharsets.UTF_8)))
            .getDocumentElement();
    double height = Double.parseDouble(svg.getAttribute("height"));
    List<Box> boxes = new ArrayList<>();
    NodeList texts = svg.getElementsByTagName("text");
    for (int i = 0; i < texts.getLength(); i++) {
      Element text = (Element) texts.item(i);
      double size = number(text, "font-size");
      double x = number(text, "x");
      double y = number(text, "y");
      boxes.add(
          new Box(
              text.getTextContent(),
              x,
              y - 0.8 * size,
              x + number(text, "textLength"),
              y + 0.2 * size));
    }
    for (Box box : boxes) {
      assertThat(box.left).as(box.text).isGreaterThanOrEqualTo(0);
      assertThat(box.right).as(box.text).isLessThanOrEqualTo(PlotHeader.WIDTH);
      assertThat(box.bottom).as(box.text).isLessThanOrEqualTo(height);
      assertThat(boxes)
          .as(box.text)
          .filteredOn(other -> other != box && other.meets(box))
          .isEmpty();
    }
  }

  private static double number(Element element, String attribute) {
    return Double.parseDouble(element.getAttribute(attribute));
  }

  @Test
  void partsAddUpAndWhatWasNotMeasuredIsSaid() {
    assertThat(PARTS.svg()).contains(">359 ms<", ">830 ms<");
    assertThat(GROUPS.svg())
        .containsOnlyOnce(">not measured<")
        .contains(">1,235<", ">30.3<", ">0<");
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "12345.6, '12,346'",
    "99.96, 100",
    "99.94, 99.9",
    "12.25, 12.2",
    "1.234, 1.23",
    "0.01234, 0.0123",
    "1000, '1,000'",
    "0.1, 0.1"
  })
  void numbersHaveThreeDigitsThatCount(double value, String text) {
    assertThat(PlotNumberFormat.of(value)).isEqualTo(text);
  }

  @Test
  void aLogarithmicAxisCoversWholePowersOfTen() {
    LogAxis wide = new LogAxis(DoubleStream.of(0.5, 1, 2000), 100);
    assertThat(wide.marks()).containsExactly(0.1, 1.0, 10.0, 100.0, 1000.0, 10000.0);
    assertThat(wide.at(0.1)).isEqualTo(0);
    assertThat(wide.at(10_000)).isEqualTo(100);
    LogAxis single = new LogAxis(DoubleStream.of(10), 100);
    assertThat(single.marks()).containsExactly(10.0, 20.0, 50.0, 100.0);
    assertThat(single.at(10)).isEqualTo(0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-1, Double.NaN, Double.POSITIVE_INFINITY})
  void whatHasNoLengthIsNoBar(double value) {
    assertThatThrownBy(
            () ->
                new BarPlot(
                    "", "", "", false, List.of("a"), List.of(new Group("g", Map.of("a", value)))))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void seriesAreTold() {
    List<String> eight = IntStream.range(0, 8).mapToObj(i -> "s" + i).toList();
    assertThatThrownBy(() -> new BarPlot("", "", "", false, eight, List.of()))
        .hasMessageContaining("8 series");
    assertThatThrownBy(() -> new BarPlot("", "", "", false, List.of("a", "a"), List.of()))
        .hasMessageContaining("one name");
    assertThatThrownBy(
            () ->
                new BarPlot(
                    "", "", "", false, List.of("a"), List.of(new Group("g", Map.of("b", 1.0)))))
        .hasMessageContaining("no series");
  }

  @Test
  void aCurveGoesToTheRightThroughWhatHasALogarithm() {
    for (List<Point> points :
        List.of(
            List.of(new Point(0, 1)),
            List.of(new Point(1, 0)),
            List.of(new Point(2, 1), new Point(1, 1)),
            List.<Point>of())) {
      assertThatThrownBy(() -> new LinePlot("", "", "", "", List.of(new Curve("c", points))))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessageContaining("c ");
    }
  }
}
