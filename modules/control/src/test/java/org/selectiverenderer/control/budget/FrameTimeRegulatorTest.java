package org.selectiverenderer.control.budget;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

/** Triangles are found whose frames take the time wanted, on machines of several kinds. */
class FrameTimeRegulatorTest {
  private static final long LEAST = 1_000;
  private static final long MOST = 1_000_000;
  private static final double GOAL = 10;
  private static final long SMALL = 20_000;
  private static final long LARGE = 40_000;

  private final Random random = new Random(3);

  @Test
  void aMachineThatIsTooSlowForAllTrianglesGetsFewer() {
    assertThat(settled(triangles -> 2 + triangles * 4e-5)).isBetween(170_000L, 205_000L);
    assertThat(settled(triangles -> triangles * 1e-4)).isBetween(85_000L, 103_000L);
    assertThat(settled(triangles -> 1e-9 * triangles * triangles)).isBetween(90_000L, 103_000L);
  }

  @Test
  void aMachineThatIsFastEnoughShowsAll() {
    assertThat(settled(triangles -> 1 + triangles * 5e-6)).isEqualTo(MOST);
  }

  @Test
  void aTimeThatCannotBeReachedShowsTheLeast() {
    assertThat(settled(triangles -> 25 + triangles * 5e-6)).isEqualTo(LEAST);
  }

  @Test
  void trianglesComeBackWhenTheMachineIsFree() {
    FrameTimeRegulator regulator = new FrameTimeRegulator(GOAL);
    run(regulator, 600, triangles -> 25 + triangles * 1e-5);
    run(regulator, 3000, triangles -> 1 + triangles * 1e-5);

    assertThat(regulator.triangles(LEAST, MOST)).isBetween(780_000L, 930_000L);
  }

  @Test
  void aSettledBudgetStaysThroughNoiseAndASingleSlowFrame() {
    FrameTimeRegulator regulator = new FrameTimeRegulator(GOAL);
    run(regulator, 1000, triangles -> 2 + triangles * 4e-5);
    long settled = regulator.triangles(LEAST, MOST);

    run(regulator, 200, triangles -> 2 + triangles * 4e-5 + 0.02 * random.nextGaussian());
    assertThat(regulator.triangles(LEAST, MOST)).isEqualTo(settled);
    regulator.frame(5000, settled);
    run(regulator, 600, triangles -> 2 + triangles * 4e-5);
    assertThat(regulator.triangles(LEAST, MOST)).isBetween(settled * 85 / 100, settled * 11 / 10);
  }

  /** Such as one in which a file arrives, or in which new objects are measured. */
  @Test
  void aSingleSlowFrameChangesNothing() {
    FrameTimeRegulator regulator = new FrameTimeRegulator(GOAL);
    run(regulator, 1000, triangles -> 2 + triangles * 4e-5);
    long settled = regulator.triangles(LEAST, MOST);
    for (int hitch = 0; hitch < 20; hitch++) {
      regulator.frame(5000, settled);
      run(regulator, 7, triangles -> 2 + triangles * 4e-5);
    }
    assertThat(regulator.triangles(LEAST, MOST)).isEqualTo(settled);
  }

  @Test
  void aLargeVersionComesBackWhenItFits() {
    FrameTimeRegulator regulator = new FrameTimeRegulator(GOAL);
    assertThat(shown(regulator, 300, 1.5e-3)).isEqualTo(SMALL);
    assertThat(shown(regulator, 600, 1e-4)).isEqualTo(LARGE);
  }

  @Test
  void aLargeVersionThatDoesNotFitIsNotTriedAgainAndAgain() {
    FrameTimeRegulator regulator = new FrameTimeRegulator(GOAL);
    shown(regulator, 600, 3e-4);
    for (int frame = 0; frame < 300; frame++) {
      assertThat(shown(regulator, 1, 3e-4)).isEqualTo(SMALL);
    }
  }

  /** Returns the triangles of the last frame of an object of two versions. */
  private static long shown(FrameTimeRegulator regulator, int frames, double msPerTriangle) {
    long shown = 0;
    for (int frame = 0; frame < frames; frame++) {
      shown = regulator.triangles(LEAST, MOST) < LARGE ? SMALL : LARGE;
      regulator.frame(shown * msPerTriangle, shown);
    }
    return shown;
  }

  private long settled(DoubleUnaryOperator machine) {
    FrameTimeRegulator regulator = new FrameTimeRegulator(GOAL);
    run(regulator, 1500, machine);
    long before = regulator.triangles(LEAST, MOST);
    run(regulator, 300, machine);
    assertThat(regulator.triangles(LEAST, MOST)).as("it has settled").isEqualTo(before);
    return before;
  }

  private static void run(FrameTimeRegulator regulator, int frames, DoubleUnaryOperator machine) {
    for (int frame = 0; frame < frames; frame++) {
      long shown = regulator.triangles(LEAST, MOST);
      regulator.frame(machine.applyAsDouble(shown), shown);
    }
  }
}
