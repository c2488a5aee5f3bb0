package org.selectiverenderer.study.design;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.study.design.TrialPhase.Blank;
import org.selectiverenderer.study.design.TrialPhase.Exposure;
import org.selectiverenderer.study.design.TrialPhase.Feedback;
import org.selectiverenderer.study.design.TrialPhase.Fixation;
import org.selectiverenderer.study.design.TrialPhase.Instruction;
import org.selectiverenderer.study.design.TrialPhase.Questions;
import org.selectiverenderer.study.design.TrialPhase.Repeat;
import org.selectiverenderer.study.design.TrialPhase.ResponseKeys;

class TrialCourseTest {
  private static final double FRAME = 1 / 60.0;

  private final List<String> shown = new ArrayList<>();
  private TrialCourse course = course(List.of());
  private int frame;

  private TrialCourse course(List<TrialPhase> phases) {
    Trial trial =
        new Trial("main", 1, 1, Map.of(), Map.of("answer", "f"), 2, TrialSettings.NONE, phases);
    return new TrialCourse(
        trial,
        exposure -> exposure.seconds().orElse(Double.POSITIVE_INFINITY),
        new TrialCourse.Listener() {
          @Override
          public void began(TrialPhase phase, double time) {
            shown.add("+" + phase.getClass().getSimpleName() + "@" + Math.round(time * 60));
          }

          @Override
          public void ended(TrialPhase phase, double began, double time) {
            shown.add("-" + Math.round((time - began) * 60));
          }
        });
  }

  private static Exposure exposure(double seconds, ResponseKeys keys) {
    return new Exposure(
        seconds > 0 ? OptionalDouble.of(seconds) : OptionalDouble.empty(), Map.of(), keys, false);
  }

  private static ResponseKeys keys(String correct) {
    return new ResponseKeys(List.of("f", "j"), correct);
  }

  private void frames(int count) {
    for (int i = 0; i < count; i++) {
      course.frame(frame++ * FRAME);
    }
  }

  @Test
  void phasesLastTheNearestNumberOfFrames() {
    course =
        course(
            List.of(
                new Fixation(0.5),
                exposure(0.24, ResponseKeys.NONE),
                new Blank(OptionalDouble.of(0.08), ResponseKeys.NONE)));
    frames(60);
    assertThat(course.over()).isTrue();
    assertThat(shown)
        .containsExactly("+Fixation@0", "-30", "+Exposure@30", "-14", "+Blank@44", "-5");
    assertThat(course.result().milliseconds()).isEmpty();
    assertThat(course.result().correct()).isEmpty();
  }

  @Test
  void aPhaseShorterThanAFrameIsShownForOne() {
    course = course(List.of(exposure(0.001, ResponseKeys.NONE), new Fixation(0)));
    frames(3);
    assertThat(shown).startsWith("+Exposure@0", "-1", "+Fixation@1");
    assertThat(course.over()).isTrue();
  }

  @Test
  void aResponseIsTimedFromThePhaseWithKeysToTheKeysOwnTime() {
    course = course(List.of(new Fixation(0.5), exposure(2, keys("{answer}"))));
    frames(40);
    assertThat(course.key("f", 0.5 + 0.1234)).isTrue();
    frames(1);
    assertThat(course.over()).isTrue();
    TrialResult result = course.result();
    assertThat(result.response()).isEqualTo("f");
    assertThat(result.correct()).contains(true);
    assertThat(result.milliseconds().orElseThrow()).isCloseTo(123.4, within(1e-6));
  }

  @Test
  void keysBeforeTheirPhaseAndOtherKeysMeanNothing() {
    course = course(List.of(new Fixation(0.5), exposure(1, keys("f"))));
    frames(10);
    assertThat(course.key("f", 0.1)).isFalse();
    frames(25);
    assertThat(course.key("k", 0.55)).isFalse();
    frames(60);
    assertThat(course.over()).isTrue();
    assertThat(course.result().response()).isEmpty();
    assertThat(course.result().correct()).as("a missing response is wrong").contains(false);
  }

  @Test
  void onlyTheFirstResponseCounts() {
    course = course(List.of(exposure(1, keys("f")), new Blank(OptionalDouble.empty(), keys("f"))));
    frames(5);
    assertThat(course.key("j", 0.05)).isTrue();
    frames(1);
    assertThat(course.over()).as("the blank waits for a response that is there").isTrue();
    assertThat(course.result().response()).isEqualTo("j");
    assertThat(course.result().correct()).contains(false);
  }

  @Test
  void aBlankWaitsForAResponseThatAnExposureDidNotGet() {
    course =
        course(List.of(exposure(0.1, keys("f")), new Blank(OptionalDouble.empty(), keys("f"))));
    frames(200);
    assertThat(course.phase()).containsInstanceOf(Blank.class);
    course.key("f", 3.0);
    frames(1);
    assertThat(course.over()).isTrue();
    assertThat(course.result().milliseconds().orElseThrow()).isCloseTo(3000, within(1e-6));
  }

  @Test
  void aRepetitionEndsWithTheResponseOrItsLastRound() {
    List<TrialPhase> flicker =
        List.of(exposure(0.1, keys("f")), new Blank(OptionalDouble.of(0.05), keys("f")));
    course = course(List.of(new Repeat(flicker, 3), new Fixation(0.1)));
    frames(60);
    assertThat(shown.stream().filter(line -> line.startsWith("+Exposure"))).hasSize(3);
    assertThat(shown.stream().filter(line -> line.startsWith("+Fixation"))).hasSize(1);
    shown.clear();
    frame = 0;
    course = course(List.of(new Repeat(flicker, 3), new Fixation(0.1)));
    frames(11);
    course.key("f", 0.17);
    frames(20);
    assertThat(shown.stream().filter(line -> line.startsWith("+Exposure"))).hasSize(2);
    assertThat(course.over()).isTrue();
    assertThat(course.result().milliseconds().orElseThrow()).isCloseTo(170, within(1e-6));
  }

  @Test
  void instructionsWaitForTheSpaceBarAndQuestionsForTheirAnswers() {
    course = course(List.of(new Instruction("Look"), new Questions("sure")));
    frames(100);
    assertThat(course.key("f", 1)).isFalse();
    assertThat(course.phase()).containsInstanceOf(Instruction.class);
    assertThat(course.key("space", 1)).isTrue();
    frames(100);
    assertThat(course.phase()).containsInstanceOf(Questions.class);
    course.questionsAnswered();
    frames(1);
    assertThat(course.over()).isTrue();
  }

  @Test
  void theSceneEndsOnlyTheExposuresThatLetIt() {
    course =
        course(
            List.of(
                exposure(0.5, ResponseKeys.NONE),
                new Exposure(OptionalDouble.empty(), Map.of(), ResponseKeys.NONE, true)));
    frames(5);
    course.sceneEnds();
    frames(20);
    assertThat(shown).containsExactly("+Exposure@0");
    frames(30);
    course.sceneEnds();
    frames(1);
    assertThat(course.over()).isTrue();
  }

  @Test
  void feedbackDependsOnTheResponse() {
    Feedback feedback = new Feedback("Right", "Wrong", "Too late", 1);
    for (Map.Entry<String, String> each :
        Map.of("f", "Right", "j", "Wrong", "", "Too late").entrySet()) {
      frame = 0;
      course = course(List.of(exposure(0.5, keys("f")), feedback));
      frames(5);
      course.key(each.getKey(), 0.1);
      frames(40);
      assertThat(course.phase()).isEqualTo(Optional.of(feedback));
      assertThat(course.feedback(feedback)).isEqualTo(each.getValue());
    }
  }
}
