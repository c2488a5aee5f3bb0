package org.selectiverenderer.study.gaze;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import org.selectiverenderer.study.gaze.ConsistencyEstimate.Evidence;
import org.selectiverenderer.study.gaze.CrossedEffectsModel.Fit;
import org.selectiverenderer.study.gaze.CrossedEffectsModel.Observation;

/**
 * Estimates the consistency of objects from the attention that they drew, by an empirical Bayes
 * estimate: the attention that each participant gave each object, relative to what its time in view
 * and its size let expect, is the sum of an effect of the object, one of the participant, an
 * intercept of the area, and an error. Effects of objects are shrunk towards what ratings let
 * expect, else towards the mean of the area, the more the less was seen of them.
 */
public final class ConsistencyEstimator {
  /** Exponent of the solid angle from which the search for the logs' own begins. */
  private static final double FIRST_EXPONENT = 0.5;

  private static final double LARGEST_EXPONENT = 1.5;
  private static final int ROUNDS = 4;

  /** Standard deviation between participants in the logarithm of attention to an object. */
  private static final double INTEREST = 0.5;

  /**
   * Standard deviation of what the place of an object does to the logarithm of its attention, such
   * as what hides it and which others are beside it: what is left in simulated rooms without
   * preferences, however many look. It is no sign of consistency.
   */
  private static final double PLACE = 0.15;

  /** Tells ratings of objects. */
  @FunctionalInterface
  public interface RatingLookup {
    /** Returns the mean rating of an object in an area, 1 to 6; empty for none. */
    OptionalDouble of(String object, GazeArea area);
  }

  private record Key(GazeArea area, String object) {}

  private final List<ParticipantAttention> all;
  private final RatingLookup ratings;
  private final Map<Key, Integer> objects = new LinkedHashMap<>();
  private final Map<GazeArea, Integer> areas = new LinkedHashMap<>();
  private final Map<String, Integer> participants = new LinkedHashMap<>();

  private ConsistencyEstimator(ViewingData data, RatingLookup ratings) {
    this.ratings = ratings;
    all =
        data.all().stream()
            .filter(seen -> seen.objects().values().stream().anyMatch(one -> one.looks() > 0))
            .toList();
    for (ParticipantAttention seen : all) {
      areas.putIfAbsent(seen.area(), areas.size());
      participants.putIfAbsent(seen.participant(), participants.size());
      for (String object : seen.objects().keySet()) {
        objects.putIfAbsent(new Key(seen.area(), object), objects.size());
      }
    }
  }

  /**
   * Estimates the consistency of all objects that were in view.
   *
   * @return by area, then the most inconsistent first; none if nobody looked at an object
   */
  public static List<ConsistencyEstimate> of(ViewingData data, RatingLookup ratings) {
    ConsistencyEstimator estimator = new ConsistencyEstimator(data, ratings);
    return estimator.objects.isEmpty() ? List.of() : estimator.estimate();
  }

  private List<ConsistencyEstimate> estimate() {
    double exponent = FIRST_EXPONENT;
    Fit fit = CrossedEffectsModel.fit(observations(exponent));
    for (int round = 1; round < ROUNDS; round++) {
      // The slope is over the logarithm of the visual angle, the square root of the solid angle.
      exponent = Math.max(0, Math.min(LARGEST_EXPONENT, exponent + fit.slope() / 2));
      fit = CrossedEffectsModel.fit(observations(exponent));
    }
    double share = Math.max(0, 1 - Math.pow(PLACE / fit.spread(), 2));
    Map<Key, Evidence> evidence = evidence();
    List<ConsistencyEstimate> estimates = new ArrayList<>();
    for (Map.Entry<Key, Integer> each : objects.entrySet()) {
      Key key = each.getKey();
      OptionalDouble rating = ratings.of(key.object(), key.area());
      estimates.add(
          new ConsistencyEstimate(
              key.object(),
              key.area(),
              expected(rating) + share * fit.objects()[each.getValue()],
              Math.hypot(Math.sqrt(share) * PLACE, share * fit.deviations()[each.getValue()]),
              rating,
              Objects.requireNonNull(evidence.get(key))));
    }
    estimates.sort(
        Comparator.comparing((ConsistencyEstimate each) -> areas.get(each.area()))
            .thenComparing(each -> -each.attention())
            .thenComparing(ConsistencyEstimate::object));
    return estimates;
  }

  private List<Observation> observations(double exponent) {
    double size = meanSize();
    List<Observation> observations = new ArrayList<>();
    for (ParticipantAttention seen : all) {
      ParticipantAttention.Totals totals = seen.totals(exponent);
      int participant = participants.getOrDefault(seen.participant(), 0);
      int area = areas.getOrDefault(seen.area(), 0);
      seen.objects()
          .forEach(
              (name, object) -> {
                double expected = expected(ratings.of(name, seen.area()));
                observations.add(
                    new Observation(
                        objects.getOrDefault(new Key(seen.area(), name), 0),
                        participant,
                        area,
                        size(object) - size,
                        seen.relativeAttention(object, totals) - expected,
                        1 / errorVariance(seen.expectedLooks(object, totals))));
              });
    }
    return observations;
  }

  /**
   * Returns the variance that the logarithm of a rate is expected to have: that of counts, and that
   * of what people are interested in.
   */
  private static double errorVariance(double expectedLooks) {
    return 1 / (expectedLooks + 0.5) + INTEREST * INTEREST;
  }

  private double meanSize() {
    return all.stream()
        .flatMap(seen -> seen.objects().values().stream())
        .mapToDouble(ConsistencyEstimator::size)
        .average()
        .orElse(0);
  }

  /** Returns the logarithm of the mean visual angle. */
  private static double size(ObjectAttention attention) {
    return Math.log(attention.meanSolidAngle()) / 2;
  }

  private static double expected(OptionalDouble rating) {
    return rating.isPresent() ? ConsistencyEstimate.expectedAttention(rating.getAsDouble()) : 0;
  }

  /** Adds up what each object's estimate rests on. */
  private Map<Key, Evidence> evidence() {
    Map<Key, Evidence> evidence = new HashMap<>();
    for (ParticipantAttention seen : all) {
      seen.objects()
          .forEach(
              (name, object) ->
                  evidence.merge(
                      new Key(seen.area(), name),
                      new Evidence(1, object.inView(), object.dwell(), object.fixations()),
                      (one, other) ->
                          new Evidence(
                              one.participants() + other.participants(),
                              one.inView() + other.inView(),
                              one.dwell() + other.dwell(),
                              one.fixations() + other.fixations())));
    }
    return evidence;
  }
}
