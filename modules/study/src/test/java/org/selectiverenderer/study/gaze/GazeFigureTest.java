package org.selectiverenderer.study.gaze;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.chart.LinePlot;
import org.selectiverenderer.chart.LinePlot.Curve;
import org.selectiverenderer.chart.LinePlot.Point;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.study.gaze.ConsistencyEstimator.RatingLookup;

/**
 * The figure of docs/gaze.md: how far estimates are from the preferences of simulated viewers, by
 * the number of participants. {@code mvn test -Dtest=GazeFigureTest -Dplots.update=true} simulates
 * and draws it anew.
 */
class GazeFigureTest {
  private static final Path FIGURES = Path.of("docs", "figures", "gaze", "error.csv");
  private static final Path PICTURE = Path.of("docs", "pictures", "gaze-error.svg");
  private static final int[] PEOPLE = {1, 2, 4, 8, 16, 32, 64};
  private static final int ROOMS = 6;
  private static final int CHECKED_PEOPLE = 4;
  private static final int OBJECTS = 24;
  private static final double STRENGTH = 0.6;
  private static final RatingLookup NO_RATINGS = (object, area) -> OptionalDouble.empty();

  /** Squared errors of the estimates of some rooms. */
  private static final class Errors {
    double naive;
    double gaze;
    double rated;
    int count;
    int decided;
    int wrong;
  }

  @BeforeAll
  static void simulateAndUpdate() throws IOException {
    if (Boolean.getBoolean("plots.update")) {
      Files.createDirectories(FIGURES.getParent());
      Files.writeString(FIGURES, figures(simulate(PEOPLE.length)));
      Files.writeString(PICTURE, plot(Files.readAllLines(FIGURES)));
    }
  }

  @Test
  void theCommittedPictureIsDrawnFromTheCommittedFigures() throws IOException {
    assertThat(Files.readString(PICTURE).replace("\r\n", "\n"))
        .isEqualTo(plot(Files.readAllLines(FIGURES)));
  }

  @Test
  void theCommittedFiguresAreThoseOfTheProgram() throws IOException {
    List<String> committed = Files.readAllLines(FIGURES);
    List<String> now = figures(simulate(CHECKED_PEOPLE)).lines().toList();
    assertThat(committed).startsWith(now.toArray(String[]::new));
  }

  private static Map<Integer, Errors> simulate(int sizes) {
    Map<Integer, Errors> all = new LinkedHashMap<>();
    for (int room = 0; room < ROOMS; room++) {
      double[] attention = RecoveryTest.attention(STRENGTH, room);
      double[] rated = RecoveryTest.attention(STRENGTH, 100 + room);
      GazeSimulator simulator =
          new GazeSimulator(
              "room.x3d", List.of("OfficeSchema"), GazeSimulator.along(attention, room));
      // Raters agree with the viewers about two objects of three.
      RatingLookup ratings =
          (object, area) -> {
            int at = RecoveryTest.index(object);
            double of = at % 3 == 0 ? rated[at] : attention[at];
            return OptionalDouble.of(1 + 5 * RecoveryTest.truth(of));
          };
      ViewingData data = new ViewingData();
      int people = 0;
      for (int size = 0; size < sizes; size++) {
        for (; people < PEOPLE[size]; people++) {
          data.add("p" + people, simulator.log(120, 1000L * room + people));
        }
        Errors errors = all.computeIfAbsent(people, key -> new Errors());
        List<ConsistencyEstimate> found = ConsistencyEstimator.of(data, NO_RATINGS);
        double mean = found.stream().mapToDouble(e -> share(e)).average().orElseThrow();
        for (ConsistencyEstimate each : found) {
          double real = attention[RecoveryTest.index(each.object())];
          double truth = RecoveryTest.truth(real);
          errors.gaze += Math.pow(each.degree() - truth, 2);
          double raw = RecoveryTest.truth(Math.log(Math.max(share(each), 1e-3) / mean));
          errors.naive += Math.pow(raw - truth, 2);
          errors.count++;
          errors.decided += each.type().isPresent() ? 1 : 0;
          ConsistencyType type = each.type().orElse(null);
          errors.wrong +=
              type == ConsistencyType.INCONSISTENT && real <= 0
                      || type == ConsistencyType.CONSISTENT && real >= 0
                  ? 1
                  : 0;
        }
        for (ConsistencyEstimate each : ConsistencyEstimator.of(data, ratings)) {
          double truth = RecoveryTest.truth(attention[RecoveryTest.index(each.object())]);
          errors.rated += Math.pow(each.degree() - truth, 2);
        }
      }
    }
    return all;
  }

  /** Dwell as a share of the time in view, with no correction. */
  private static double share(ConsistencyEstimate each) {
    return each.evidence().dwell() / each.evidence().inView();
  }

  private static String figures(Map<Integer, Errors> errors) {
    StringBuilder text = new StringBuilder("participants,uncorrected,gaze,rated,decided,wrong\n");
    errors.forEach(
        (people, e) ->
            text.append(
                String.format(
                    Locale.ROOT,
                    "%d,%.2f,%.2f,%.2f,%.2f,%.2f%n",
                    people,
                    Math.sqrt(e.naive / e.count),
                    Math.sqrt(e.gaze / e.count),
                    Math.sqrt(e.rated / e.count),
                    e.decided / (double) e.count,
                    e.wrong / (double) e.count)));
    return text.toString().replace(System.lineSeparator(), "\n");
  }

  private static String plot(List<String> figures) {
    String[] names = {"dwell alone", "from gaze", "and from ratings"};
    List<Curve> curves = new ArrayList<>();
    for (int column = 1; column <= names.length; column++) {
      List<Point> points = new ArrayList<>();
      for (String line : figures.subList(1, figures.size())) {
        String[] cells = line.split(",");
        points.add(new Point(Double.parseDouble(cells[0]), Double.parseDouble(cells[column])));
      }
      curves.add(new Curve(names[column - 1], points));
    }
    return new LinePlot(
            "Error of the degree of consistency",
            "root mean square over 144 objects of 6 simulated rooms, 120 s a viewer",
            "participants",
            "error of the degree (0 to 1)",
            curves)
        .svg();
  }
}
