package org.selectiverenderer.app.session;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.headset.ControllerCommand;
import org.selectiverenderer.render.window.KeyboardKey;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.NumberKeys;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.QuestionnaireProgress;
import org.selectiverenderer.study.questionnaire.SliderField;
import org.selectiverenderer.study.session.Session;
import org.selectiverenderer.study.session.SessionStep;

/**
 * The questions of a trial, which are asked in the picture and answered by keys or by the buttons
 * of a headset's controllers: arrows mark an option or move a slider, Enter or the space bar gives
 * it, digits choose an option by its value or place, Backspace goes back.
 */
final class TrialQuestions {
  /** How long a digit waits for a second one, in nanoseconds, as in a window. */
  private static final long SECOND_DIGIT = 1_500_000_000L;

  /** Frames between two answers of a simulated participant. */
  private static final int PRESS = 5;

  private final Questionnaire questionnaire;
  private final ParticipantMessages wording;
  private final Session session;
  private final SessionStep.OneTrial step;
  private final AnswerRecorder recorder;
  private final AnswerDevice device;
  private final QuestionPanelRenderer renderer;
  private final Random simulated;
  private @Nullable ButtonQuestionnaireController buttons;
  private Optional<NumberKeys> typed = Optional.empty();
  private long typedAt;
  private int frames;

  /**
   * @param device with which the participant answers
   * @throws IOException with a one-line message if a picture of the questionnaire cannot be read
   */
  TrialQuestions(
      Session session, SessionStep.OneTrial step, Questionnaire questionnaire, AnswerDevice device)
      throws IOException {
    this.session = session;
    this.step = step;
    this.device = device;
    this.questionnaire = questionnaire;
    wording = session.material().wording();
    recorder = new AnswerRecorder(session, step);
    renderer = new QuestionPanelRenderer(wording, PanelImageLoader.of(questionnaire));
    simulated = new Random(session.material().study().seed() + step.id().hashCode());
  }

  /** Returns the recorder of the answers, whose failure is to be checked. */
  AnswerRecorder recorder() {
    return recorder;
  }

  private ButtonQuestionnaireController asking() {
    ButtonQuestionnaireController known = buttons;
    if (known == null) {
      known =
          new ButtonQuestionnaireController(
              new QuestionnaireProgress(
                  questionnaire, wording, session.answers(step), session.lastPage(step), recorder),
              wording);
      buttons = known;
    }
    return known;
  }

  /** Handles a frame: a simulated participant answers now and then. */
  void frame() {
    ButtonQuestionnaireController asking = asking();
    if (typed.isPresent() && System.nanoTime() - typedAt > SECOND_DIGIT) {
      settle(asking);
    }
    if (!session.options().unattended() || asking.over() || ++frames % PRESS != 0) {
      return;
    }
    boolean filled = asking.simulate(simulated);
    if (asking.question().isEmpty() || filled || simulated.nextBoolean()) {
      asking.yes();
    } else {
      asking.no();
    }
  }

  /** Returns whether all questions are answered. */
  boolean over() {
    return asking().over();
  }

  /** Returns the present page. */
  QuestionnairePage page() {
    return asking().course().page();
  }

  /** Returns the sheet of the present question. */
  QuestionPanelRenderer.Sheet sheet() {
    return renderer.of(asking(), device);
  }

  /** Handles a button of a headset's controller. */
  void answered(ControllerCommand answer) {
    ButtonQuestionnaireController asking = asking();
    switch (answer) {
      case YES -> asking.yes();
      case NO -> asking.no();
      case MORE -> asking.more();
      case LESS -> asking.less();
      case CHOOSE -> {
        // Panels of trials follow the head; there is nothing to point at.
      }
    }
  }

  /** Handles a key. */
  void pressed(KeyboardKey key, String character) {
    ButtonQuestionnaireController asking = asking();
    if (asking.over() || number(asking, character)) {
      return;
    }
    typed = Optional.empty();
    if (asking.slider().isPresent() && slid(asking, key)) {
      return;
    }
    boolean writing = asking.line().isPresent();
    switch (key) {
      case ENTER -> asking.yes();
      case UP, RIGHT -> step(asking, key == KeyboardKey.RIGHT);
      case DOWN, LEFT -> step(asking, key == KeyboardKey.DOWN);
      case PAGE_UP -> asking.back();
      case BACKSPACE -> {
        if (writing) {
          asking.erase();
        } else {
          asking.back();
        }
      }
      default -> {
        if (writing) {
          asking.write(character);
        } else if (key == KeyboardKey.SPACE) {
          asking.yes();
        } else {
          choose(asking, character);
        }
      }
    }
  }

  /** Moves a slider's thumb; returns whether the key does. */
  private static boolean slid(ButtonQuestionnaireController asking, KeyboardKey key) {
    SliderField slider = asking.slider().orElseThrow();
    switch (key) {
      case RIGHT, UP -> asking.slideBy(1);
      case LEFT, DOWN -> asking.slideBy(-1);
      case PAGE_UP -> asking.slideBy(slider.page());
      case PAGE_DOWN -> asking.slideBy(-slider.page());
      case HOME -> asking.slide(0);
      case END -> asking.slide(slider.last());
      default -> {
        return false;
      }
    }
    return true;
  }

  /**
   * Handles a key of a number: shows the number so far, which is the answer when no further digit
   * can follow, or none has come in time.
   *
   * @return whether the present field takes numbers and the key is one of a number
   */
  private boolean number(ButtonQuestionnaireController asking, String character) {
    Optional<NumberKeys> keys = asking.asks().flatMap(NumberKeys::of);
    if (keys.isEmpty() || !character.matches("[-.,0-9]")) {
      return false;
    }
    NumberKeys before = typed.orElse(keys.get());
    char key = character.equals(",") ? '.' : character.charAt(0);
    if (!before.takes(key)) {
      return true; // A key that the scale has not must not choose by place.
    }
    NumberKeys now = before.and(key);
    typed = Optional.of(now);
    typedAt = System.nanoTime();
    now.value()
        .ifPresent(
            value -> {
              if (asking.slider().isPresent()) {
                asking.slide(asking.slider().get().position(value).orElseThrow());
              } else {
                asking.mark(values(asking).indexOf(value));
              }
            });
    if (!now.waits()) {
      settle(asking);
    }
    return true;
  }

  /** Gives the number that was typed as the answer; a slider's may still be moved. */
  private void settle(ButtonQuestionnaireController asking) {
    Optional<String> value = typed.flatMap(NumberKeys::value);
    typed = Optional.empty();
    if (value.isPresent() && asking.choice().isPresent()) {
      asking.choose(values(asking).indexOf(value.get()));
    }
  }

  private static List<String> values(ButtonQuestionnaireController asking) {
    return asking.options().stream().map(ChoiceOption::value).toList();
  }

  /** Moves the mark to the next or the previous option. */
  private static void step(ButtonQuestionnaireController asking, boolean forward) {
    if (asking.options().isEmpty()) {
      return;
    }
    boolean inLine = asking.choice().map(AnswerField.Choice::inLine).orElse(false);
    if (forward == inLine) {
      asking.more();
    } else {
      asking.less();
    }
  }

  /** Chooses an option by its value, or else by its place. */
  private static void choose(ButtonQuestionnaireController asking, String character) {
    if (asking.options().isEmpty() || character.isBlank()) {
      return;
    }
    List<String> values = values(asking);
    int at = values.indexOf(character);
    if (at < 0) {
      for (int option = 0; option < values.size() && at < 0; option++) {
        boolean initial = values.get(option).regionMatches(true, 0, character, 0, 1);
        at = initial && Character.isLetter(character.charAt(0)) ? option : -1;
      }
    }
    if (at < 0 && character.matches("[1-9]")) {
      at = Integer.parseInt(character) - 1;
    }
    if (at >= 0 && at < values.size()) {
      asking.choose(at);
    }
  }
}
