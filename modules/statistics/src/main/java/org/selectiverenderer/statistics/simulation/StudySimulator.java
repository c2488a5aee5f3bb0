package org.selectiverenderer.statistics.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.statistics.detection.Response;

/**
 * Simulates the answers of participants by equal-variance signal detection. Evidence for an object
 * is normal around d'/2 if it is present, -d'/2 if not; above c the answer is yes; the farther from
 * c, the more certain.
 */
public final class StudySimulator {
  private static final NormalDistribution NORMAL = new NormalDistribution(null, 0, 1);

  /**
   * The distances from c at which the confidence becomes 2, 3, 4 and 5; about two answers in five
   * then have a confidence of 5.
   */
  private static final double[] CERTAINTY = {0.15, 0.35, 0.6, 0.9};

  private static final SourceLocation PLACE = SourceLocation.of("simulated");

  private final SimulationModel model;
  private final List<List<String>> objects;
  private final SplittableRandom random;

  private StudySimulator(SimulationModel model, List<List<String>> objects, long seed) {
    this.model = model;
    this.objects = objects;
    random = new SplittableRandom(seed);
  }

  /**
   * Returns the answers of a study. A larger study with the same seed begins with the participants
   * of a smaller one.
   */
  public static List<Response> responses(SimulationModel model, int participants, long seed) {
    List<Response> responses = new ArrayList<>();
    List<List<String>> objects = model.lists().stream().map(StudySimulator::objects).toList();
    for (int i = 0; i < participants; i++) {
      new StudySimulator(model, objects, SeedSequence.of(seed, i)).participant(i, responses);
    }
    return responses;
  }

  /**
   * Returns the names of the objects of a list; they are formatted once because that takes longer
   * than simulating answers.
   */
  private static List<String> objects(RecognitionListSpec list) {
    return IntStream.rangeClosed(1, list.questions())
        .mapToObj(
            object -> String.format(Locale.ROOT, "%s %s %02d", list.area(), list.type(), object))
        .toList();
  }

  private void participant(int index, List<Response> responses) {
    int condition = index % model.conditions().size();
    double sensitivity =
        model.sensitivities().get(condition) + model.sensitivitySpread() * normal();
    double criterion = model.criteria().get(condition) + model.criterionSpread() * normal();
    String participant = String.format(Locale.ROOT, "sim-%03d", index + 1);
    for (int i = 0; i < objects.size(); i++) {
      RecognitionListSpec list = model.lists().get(i);
      boolean inconsistent = list.type().equals("inconsistent");
      double d = sensitivity + (inconsistent ? model.typeSensitivity() : 0);
      double c = criterion + (inconsistent ? model.typeCriterion() : 0);
      for (int object = 0; object < list.questions(); object++) {
        boolean present = object % 2 == 0;
        double distance = (present ? d : -d) / 2 + normal() - c;
        responses.add(
            new Response(
                participant,
                model.conditions().get(condition),
                list.area(),
                objects.get(i).get(object),
                list.type(),
                present,
                distance > 0,
                confidence(Math.abs(distance)),
                PLACE));
      }
    }
  }

  private static int confidence(double distance) {
    int confidence = Response.LEAST_CONFIDENCE;
    for (double from : CERTAINTY) {
      confidence += distance >= from ? 1 : 0;
    }
    return confidence;
  }

  /** Returns a normal variate by inversion, which is the same on every Java version. */
  private double normal() {
    double uniform = (random.nextLong() >>> 11) * 0x1.0p-53 + 0x1.0p-54;
    return NORMAL.inverseCumulativeProbability(uniform);
  }
}
