package org.selectiverenderer.app.session;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.study.design.TrialCourse;
import org.selectiverenderer.study.design.TrialPhase;

/**
 * Responds to trials in place of a participant: after 0.3 to 0.9 s, correctly with a probability of
 * 0.8 where a response can be wrong. The same seed gives the same keys and times.
 */
final class SimulatedResponder {
  private static final double QUICKEST = 0.3;
  private static final double SPREAD = 0.6;
  private static final double CORRECT = 0.8;

  /** The time for which an instruction is read. */
  private static final double READING = 0.2;

  private final Random random;
  private final TrialCourse course;
  private @Nullable TrialPhase waiting;
  private double due;
  private boolean decided;

  SimulatedResponder(long seed, TrialCourse course) {
    random = new Random(seed * 0x9E3779B97F4A7C15L);
    this.course = course;
  }

  /** Presses a key if it is time for one. */
  void frame(double time) {
    Optional<TrialPhase> phase = course.phase();
    boolean reads = phase.filter(TrialPhase.Instruction.class::isInstance).isPresent();
    if (!reads && course.keys().isEmpty()) {
      return;
    }
    if (reads) {
      if (waiting != phase.get()) {
        waiting = phase.get();
        due = time + READING;
      }
      if (time >= due) {
        course.key("space", time);
      }
      return;
    }
    if (!decided) {
      decided = true;
      due = time + QUICKEST + SPREAD * random.nextDouble();
    }
    if (time >= due) {
      course.key(choice(course.keys()), time);
    }
  }

  private String choice(List<String> keys) {
    String right = course.correctKey();
    boolean knows = random.nextDouble() < CORRECT;
    if (keys.contains(right) && knows) {
      return right;
    }
    List<String> others =
        keys.size() > 1 ? keys.stream().filter(key -> !key.equals(right)).toList() : keys;
    return others.get(random.nextInt(others.size()));
  }
}
