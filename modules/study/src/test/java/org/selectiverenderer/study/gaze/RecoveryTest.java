package org.selectiverenderer.study.gaze;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.apache.commons.math3.stat.correlation.PearsonsCorrelation;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.schema.ConsistencyType;
import org.selectiverenderer.study.gaze.ConsistencyEstimator.RatingLookup;

/** What simulated viewers with known preferences look at tells these preferences. */
class RecoveryTest {
  private static final int OBJECTS = 24;
  private static final double SECONDS = 120;
  private static final RatingLookup NO_RATINGS = (object, area) -> OptionalDouble.empty();

  /** A third each of inconsistent, neutral and consistent objects, in an order by chance. */
  static double[] attention(double strength, long seed) {
    double[] attention = new double[OBJECTS];
    SplittableRandom chance = new SplittableRandom(seed);
    for (int i = 0; i < OBJECTS; i++) {
      attention[i] = strength * (i % 3 - 1);
      int other = chance.nextInt(i + 1);
      double swapped = attention[i];
      attention[i] = attention[other];
      attention[other] = swapped;
    }
    return attention;
  }

  private static ViewingData viewers(int people, double[] attention, long room) {
    GazeSimulator simulator =
        new GazeSimulator(
            "room.x3d", List.of("OfficeSchema"), GazeSimulator.along(attention, room));
    ViewingData data = new ViewingData();
    for (int p = 0; p < people; p++) {
      data.add("p" + p, simulator.log(SECONDS, 1000 * room + p));
    }
    return data;
  }

  static double truth(double attention) {
    return 1 / (1 + Math.exp(ConsistencyEstimate.STEEPNESS * attention));
  }

  static int index(String object) {
    return Integer.parseInt(object.replaceAll("\\D", "")) - 1;
  }

  private static double error(List<ConsistencyEstimate> estimates, double[] attention) {
    return Math.sqrt(
        estimates.stream()
            .mapToDouble(e -> Math.pow(e.degree() - truth(attention[index(e.object())]), 2))
            .average()
            .orElseThrow());
  }

  @Test
  void manyViewersTellWhatBelongsAndWhatDoesNot() {
    double[] attention = attention(0.8, 1);
    List<ConsistencyEstimate> estimates =
        ConsistencyEstimator.of(viewers(24, attention, 1), NO_RATINGS);
    assertThat(estimates).hasSize(OBJECTS);
    assertThat(error(estimates, attention)).isLessThan(0.2);
    List<String> wrong = new ArrayList<>();
    int said = 0;
    for (ConsistencyEstimate each : estimates) {
      double real = attention[index(each.object())];
      Optional<ConsistencyType> type = each.type();
      said += type.isPresent() ? 1 : 0;
      if (type.filter(t -> t == ConsistencyType.CONSISTENT).isPresent() && real > 0
          || type.filter(t -> t == ConsistencyType.INCONSISTENT).isPresent() && real < 0) {
        wrong.add(each.object());
      }
    }
    assertThat(wrong).isEmpty();
    assertThat(said).isGreaterThan(OBJECTS / 5);
    double[] real = estimates.stream().mapToDouble(e -> attention[index(e.object())]).toArray();
    double[] found = estimates.stream().mapToDouble(ConsistencyEstimate::attention).toArray();
    assertThat(new PearsonsCorrelation().correlation(real, found)).isGreaterThan(0.8);
  }

  @Test
  void whereNothingIsPreferredNextToNothingIsSaid() {
    List<ConsistencyEstimate> estimates =
        ConsistencyEstimator.of(viewers(24, new double[OBJECTS], 2), NO_RATINGS);
    assertThat(estimates.stream().filter(each -> each.type().isPresent()).count())
        .isLessThanOrEqualTo(OBJECTS / 10);
  }

  @Test
  void fewViewersAreShrunkTowardsTheRatings() {
    double[] attention = attention(0.6, 3);
    ViewingData data = viewers(2, attention, 3);
    RatingLookup ratings =
        (object, area) -> OptionalDouble.of(1 + 5 * truth(attention[index(object)]));
    assertThat(error(ConsistencyEstimator.of(data, ratings), attention))
        .isLessThan(0.7 * error(ConsistencyEstimator.of(data, NO_RATINGS), attention));
  }

  @Test
  void oneViewersInterestIsNoProposal() {
    assertThat(ConsistencyEstimator.of(viewers(1, attention(1, 4), 4), NO_RATINGS))
        .isNotEmpty()
        .allSatisfy(each -> assertThat(each.type()).isEmpty());
  }

  @Test
  void largeObjectsAreNotTakenForInconsistentOnes() {
    List<ConsistencyEstimate> estimates =
        ConsistencyEstimator.of(viewers(16, new double[OBJECTS], 5), NO_RATINGS);
    List<GazeSimulator.Target> targets = GazeSimulator.along(new double[OBJECTS], 5);
    double[] size = new double[estimates.size()];
    double[] score = new double[estimates.size()];
    for (int i = 0; i < size.length; i++) {
      double[] box = targets.get(index(estimates.get(i).object())).box();
      size[i] = Math.log(box[3] - box[0]);
      score[i] = estimates.get(i).attention();
    }
    assertThat(Math.abs(new PearsonsCorrelation().correlation(size, score))).isLessThan(0.4);
  }

  @Test
  void theSameLogsGiveTheSameEstimates() {
    double[] attention = attention(0.5, 6);
    assertThat(ConsistencyEstimator.of(viewers(3, attention, 6), NO_RATINGS))
        .isEqualTo(ConsistencyEstimator.of(viewers(3, attention, 6), NO_RATINGS));
  }

  @Test
  void nobodyWhoLooksTellsNothing() {
    assertThat(ConsistencyEstimator.of(new ViewingData(), NO_RATINGS)).isEmpty();
  }
}
