package org.selectiverenderer.study.rehearsal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.design.Factor;
import org.selectiverenderer.study.design.Trial;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.design.TrialPhase;
import org.selectiverenderer.study.design.TrialSequencer;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionStep;

/**
 * Estimates how long a session takes: exposures and fades as the study has them, all pages and
 * questions, whether or not a rule skips them.
 *
 * @param seconds of one session
 * @param assumed what was assumed
 */
public record StudyDuration(double seconds, Assumptions assumed) {

  /**
   * What the study does not say.
   *
   * @param wordsPerMinute speed of reading
   * @param question seconds for each question, in addition to reading it
   * @param response seconds until a key is pressed where a key ends a phase, or phases are repeated
   *     until there is a response
   * @param practice seconds in the practice scene
   * @param rest seconds of each rest
   */
  public record Assumptions(
      double wordsPerMinute, double question, double response, double practice, double rest) {
    /** 200 words a minute, 6 s a question, 5 s a response, 2 min practice, 1 min a rest. */
    public static final Assumptions USUAL = new Assumptions(200, 6, 5, 120, 60);

    /** Returns a sentence about them. */
    public String sentence() {
      return String.format(
          Locale.ROOT,
          "%.0f words read per minute, %.1f s for each question, %.1f s for each response,"
              + " %.0f s of practice, %.0f s for each rest",
          wordsPerMinute,
          question,
          response,
          practice,
          rest);
    }
  }

  /** Estimates the session of a participant in the first group of the study. */
  public static StudyDuration of(LoadedStudy material, Assumptions assumed) {
    double seconds = 0;
    for (SessionStep step : material.steps()) {
      seconds += new Estimate(material, assumed).of(step);
    }
    return new StudyDuration(seconds, assumed);
  }

  /** Returns the duration in minutes, rounded up. */
  public long minutes() {
    return (long) Math.ceil(seconds / 60);
  }

  private record Estimate(LoadedStudy material, Assumptions assumed) {
    double of(SessionStep step) {
      if (step instanceof SessionStep.Practice) {
        return assumed.practice();
      }
      if (step instanceof SessionStep.Exposure exposure) {
        return exposure.area().seconds() + 2 * material.study().fade();
      }
      if (step instanceof SessionStep.Block block) {
        return block(block.block());
      }
      return asked(material.questionnaire(step, "001"));
    }

    private double block(TrialBlock block) {
      List<Trial> trials =
          new TrialSequencer(
                  block, material.study().design().groups().get(0), material.study().seed())
              .trials(0, 1)
              .orElse(List.of());
      if (trials.isEmpty()) {
        return 0;
      }
      double all = trials.stream().mapToDouble(this::trial).sum();
      if (block.staircase().isPresent()) {
        // A staircase takes as many trials as it may, for each combination of the other factors.
        int levels =
            block.factors().stream()
                .filter(factor -> factor.name().equals(block.staircase().get().factor()))
                .map(Factor::levels)
                .mapToInt(List::size)
                .findFirst()
                .orElse(1);
        double staircases = (double) trials.size() / levels / block.repetitions();
        return all / trials.size() * staircases * block.staircase().get().most();
      }
      int rests = block.rest() > 0 ? (trials.size() - 1) / block.rest() : 0;
      return all + rests * assumed.rest();
    }

    private double trial(Trial trial) {
      return trial.phases().stream().mapToDouble(phase -> phase(trial, phase)).sum();
    }

    private double phase(Trial trial, TrialPhase phase) {
      Study study = material.study();
      if (phase instanceof TrialPhase.Instruction text) {
        return read(text.text());
      } else if (phase instanceof TrialPhase.Fixation fixation) {
        return fixation.seconds();
      } else if (phase instanceof TrialPhase.Blank blank) {
        return blank.seconds().orElse(assumed.response());
      } else if (phase instanceof TrialPhase.Exposure exposure) {
        double most = study.seconds(trial, exposure).orElse(assumed.response());
        return exposure.response().keys().isEmpty() ? most : Math.min(most, assumed.response());
      } else if (phase instanceof TrialPhase.Questions questions) {
        Optional<Questionnaire> asked = material.inTrials(questions.questionnaire());
        return asked.map(this::asked).orElse(0.0);
      } else if (phase instanceof TrialPhase.Feedback feedback) {
        return feedback.seconds();
      }
      TrialPhase.Repeat repeat = (TrialPhase.Repeat) phase;
      double round = repeat.phases().stream().mapToDouble(each -> phase(trial, each)).sum();
      return Math.min(repeat.most() * round, Math.max(round, assumed.response()));
    }

    private double asked(Questionnaire questionnaire) {
      double seconds = 0;
      for (QuestionnairePage page : questionnaire.pages()) {
        seconds += read(page.title() + " " + page.text());
        seconds +=
            page.questions().stream()
                .mapToDouble(question -> read(question.text()) + assumed.question())
                .sum();
      }
      return seconds;
    }

    private double read(String text) {
      long words = text.strip().split("\\s+").length;
      return text.isBlank() ? 0 : words * 60 / assumed.wordsPerMinute();
    }
  }
}
