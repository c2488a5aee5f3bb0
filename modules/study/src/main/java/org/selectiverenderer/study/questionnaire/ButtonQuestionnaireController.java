package org.selectiverenderer.study.questionnaire;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Random;
import java.util.Set;

/**
 * Lets a participant answer a questionnaire with two buttons and a stick, one question at a time.
 * Of two options each button is one; of several, the stick or the second button marks one and the
 * first button chooses it. If several options may be chosen, the first button toggles the marked
 * one, and after the last option it goes on. Options are ranked by choosing them from the first to
 * the last. On a slider the stick moves the thumb far, the second button by a step, and the first
 * button goes on. For a text, the first button goes on and the second deletes a character. At the
 * end of a page, the first button turns the page and the second goes back. No option is marked
 * beforehand, so that no answer is suggested. A participant who points with a controller chooses at
 * once, and points at buttons to go back and on. Belongs to one thread.
 */
public final class ButtonQuestionnaireController {
  private final QuestionnaireProgress course;
  private final ParticipantMessages wording;
  private int at;
  private int field;
  private int marked = -1;
  private final StringBuilder written = new StringBuilder();

  /** The options that have a rank, in order. */
  private final List<ChoiceOption> ranked = new ArrayList<>();

  /** Time of the last move of a slider that is not reported yet. */
  private OptionalLong moved = OptionalLong.empty();

  private boolean over;

  /** Begins at the first question that is not answered. */
  public ButtonQuestionnaireController(QuestionnaireProgress course, ParticipantMessages wording) {
    this.course = course;
    this.wording = wording;
    course.begin();
    toFirstOpen();
  }

  /** Returns the progress: the page, and the answers so far. */
  public QuestionnaireProgress course() {
    return course;
  }

  /** Returns the current question; empty at the end of a page. */
  public Optional<Question> question() {
    List<Question> asked = course.asked();
    return at < asked.size() ? Optional.of(asked.get(at)) : Optional.empty();
  }

  /** Returns the place of the current question on the page, from 1. */
  public int place() {
    return at + 1;
  }

  /** Returns the current field of the question; empty at the end of a page. */
  public Optional<AnswerField> asks() {
    return question().map(asked -> asked.kind().fields(wording).get(field));
  }

  /** Returns the current field if it is a choice; empty if a text is to be written. */
  public Optional<AnswerField.Choice> choice() {
    return asks().filter(AnswerField.Choice.class::isInstance).map(AnswerField.Choice.class::cast);
  }

  /** Returns the current field if it is a line to write on; empty if it is a choice. */
  public Optional<AnswerField.Line> line() {
    return asks().filter(AnswerField.Line.class::isInstance).map(AnswerField.Line.class::cast);
  }

  /** Returns the current field if options are to be put in order. */
  public Optional<RankingField> ranking() {
    return asks().filter(RankingField.class::isInstance).map(RankingField.class::cast);
  }

  /** Returns the options of the current field; none if it has none. */
  public List<ChoiceOption> options() {
    return choice()
        .map(AnswerField.Choice::options)
        .or(() -> ranking().map(RankingField::options))
        .orElse(List.of());
  }

  /** Returns the rank that an option has been given, from 1; empty if it has none yet. */
  public OptionalInt rank(int option) {
    int rank = ranked.indexOf(options().get(option));
    return rank < 0 ? OptionalInt.empty() : OptionalInt.of(rank + 1);
  }

  /** Returns the current field if it is a slider. */
  public Optional<SliderField> slider() {
    return asks().filter(SliderField.class::isInstance).map(SliderField.class::cast);
  }

  /** Returns the position of the slider's thumb; empty before it is touched, unless it is shown. */
  public OptionalInt thumb() {
    SliderField slider = slider().orElseThrow();
    OptionalInt answered = slider.position(course.answer(question().orElseThrow()).value());
    return answered.isPresent() ? answered : slider.start();
  }

  /** Moves the slider's thumb to a position, which is an answer that may still change. */
  public void slide(int position) {
    Question asked = question().orElseThrow();
    long now = System.nanoTime();
    Answer answer = Answer.of(slider().orElseThrow().value(position));
    moved = OptionalLong.of(now);
    course.answer(asked, answer, false, now);
  }

  /** Moves the slider's thumb by some steps. */
  public void slideBy(int steps) {
    slide(slider().orElseThrow().moved(thumb(), steps));
  }

  /**
   * Fills in the current field as a simulated participant does, if it is a line, a slider or a
   * ranking without an answer.
   *
   * @return whether the field is one of these
   */
  public boolean simulate(Random random) {
    if (line().isPresent() && written().isEmpty()) {
      write(line().get().simulated(random));
    }
    if (slider().isPresent() && course.answer(question().orElseThrow()).equals(Answer.NONE)) {
      SliderField slider = slider().get();
      slide(slider.position(slider.simulated(random)).orElseThrow());
    }
    if (ranking().isPresent() && course.answer(question().orElseThrow()).equals(Answer.NONE)) {
      String value = ranking().get().simulated(random);
      course.answer(question().orElseThrow(), Answer.of(value), true, System.nanoTime());
      mark();
    }
    return line().isPresent() || slider().isPresent() || ranking().isPresent();
  }

  /** Returns the text written so far. */
  public String written() {
    return written.toString();
  }

  /** Appends to the text; does nothing if the current field is a choice. */
  public void write(String more) {
    if (line().isPresent() && written.length() + more.length() <= AnswerField.Line.LONGEST) {
      written.append(more);
    }
  }

  /** Deletes the last character. */
  public void erase() {
    if (!written.isEmpty()) {
      written.setLength(written.offsetByCodePoints(written.length(), -1));
    }
  }

  /** Returns whether an option of a multiple choice is chosen. */
  public boolean chosen(int option) {
    return choice()
        .filter(AnswerField.Choice::several)
        .map(choice -> choice.options().get(option).value())
        .filter(AnswerField.Choice.parts(course.answer(question().orElseThrow()).value())::contains)
        .isPresent();
  }

  /**
   * Returns the heading of the current field, such as {@code How confident are you?}; empty for
   * none.
   */
  public String heading() {
    return question()
        .map(asked -> asked.kind().headings(wording))
        .filter(headings -> field < headings.size())
        .map(headings -> headings.get(field))
        .orElse("");
  }

  /** Returns the marked option: the one that was chosen, or would be by the first button. */
  public OptionalInt marked() {
    return marked < 0 ? OptionalInt.empty() : OptionalInt.of(marked);
  }

  /**
   * Returns whether the questionnaire is answered and the participant went on from the last page.
   */
  public boolean over() {
    return over;
  }

  /** Returns whether the question has two options, one for each button. */
  public boolean oneOfTwo() {
    return choice().filter(known -> known.options().size() == 2 && !known.several()).isPresent();
  }

  /**
   * Returns how many places the mark cycles through: the options, and the end of a multiple choice.
   */
  private int places() {
    boolean several = choice().map(AnswerField.Choice::several).orElse(true);
    return options().size() + (several ? 1 : 0);
  }

  /** Handles the first button (yes). */
  public void yes() {
    if (options().isEmpty()) {
      if (slider().isPresent() && thumb().isPresent()) {
        settleThumb();
      }
      forward();
    } else if (oneOfTwo()) {
      take(0);
    } else if (marked == options().size()) {
      forward();
    } else if (marked >= 0) {
      take(marked);
    }
  }

  /** Takes the thumb where it stands as the answer, also where it has not been touched. */
  private void settleThumb() {
    int thumb = thumb().orElseThrow();
    if (course.answer(question().orElseThrow()).equals(Answer.NONE)) {
      slide(thumb);
    }
  }

  /** Handles the second button (no). */
  public void no() {
    if (line().isPresent()) {
      erase();
    } else if (slider().isPresent()) {
      boolean atEnd = thumb().equals(OptionalInt.of(slider().get().last()));
      slide(atEnd ? 0 : slider().get().moved(thumb(), 1));
    } else if (question().isPresent()) {
      if (oneOfTwo()) {
        take(1);
      } else {
        marked = (marked + 1) % places();
      }
    } else if (!course.asked().isEmpty()) {
      ask(0);
    } else {
      back();
    }
  }

  /** Handles the stick pushed away from the user: a greater number, or the option above. */
  public void more() {
    stick(true);
  }

  /** Handles the stick pulled to the user: a smaller number, or the option below. */
  public void less() {
    stick(false);
  }

  private void stick(boolean away) {
    Optional<AnswerField.Choice> choice = choice();
    if (slider().isPresent()) {
      int far = Math.max(1, slider().get().page() / 2);
      slideBy(away ? far : -far);
    } else if (!options().isEmpty() && !oneOfTwo()) {
      boolean on = choice.map(AnswerField.Choice::inLine).orElse(false) == away;
      int last = places() - 1;
      marked = marked < 0 ? (on ? 0 : last) : Math.max(0, Math.min(last, marked + (on ? 1 : -1)));
    } else if (away && at > 0) {
      ask(at - 1);
    } else if (!away && question().isPresent()) {
      forward();
    }
  }

  /** Marks an option, which the first button then chooses. */
  public void mark(int option) {
    marked = option;
  }

  /** Chooses an option that was pointed at. */
  public void choose(int option) {
    take(option);
  }

  /** Returns whether there is a previous question or page. */
  public boolean mayGoBack() {
    return at > 0 || course.number() > 0;
  }

  /** Goes back to the previous question, else to the previous page. */
  public void back() {
    if (mayGoOn()) {
      keep();
    }
    if (at > 0) {
      ask(at - 1);
    } else if (course.turn(-1)) {
      course.begin();
      ask(course.asked().size());
    }
  }

  /** Returns whether the participant may go on to the next question or page. */
  public boolean mayGoOn() {
    if (question().isEmpty()) {
      return !course.refuses();
    }
    Question asked = question().get();
    return line()
        .map(
            line ->
                written.toString().isBlank()
                    ? asked.complete(Answer.NONE, wording)
                    : line.typed(written.toString()).isPresent())
        .orElseGet(() -> asked.complete(course.answer(asked), wording));
  }

  /** Goes on to the next question, else to the next page, else ends. */
  public void forward() {
    if (question().isEmpty()) {
      goOn();
    } else if (mayGoOn()) {
      keep();
      ask(at + 1);
    }
  }

  /** Records the written text or the slider's value, unless it is recorded already. */
  private void keep() {
    if (slider().isPresent() && moved.isPresent()) {
      Question asked = question().orElseThrow();
      course.answer(asked, course.answer(asked), true, moved.getAsLong());
      moved = OptionalLong.empty();
    }
    line()
        .ifPresent(
            line -> {
              Question asked = question().orElseThrow();
              String text = written.toString();
              String value = text.isBlank() ? "" : line.typed(text).orElseThrow();
              if (!course.answer(asked).value().equals(value)) {
                Answer answer = value.isEmpty() ? Answer.NONE : course.answer(asked).value(value);
                course.answer(asked, answer, true, System.nanoTime());
              }
            });
  }

  private void goOn() {
    if (course.refuses()) {
      return;
    }
    if (course.open() > 0) {
      toFirstOpen();
    } else if (course.turn(1)) {
      course.begin();
      toFirstOpen();
    } else {
      over = true;
    }
  }

  private void toFirstOpen() {
    List<Question> asked = course.asked();
    int open = 0;
    while (open < asked.size()
        && !course.answer(asked.get(open)).equals(Answer.NONE)
        && asked.get(open).complete(course.answer(asked.get(open)), wording)) {
      open++;
    }
    ask(open);
  }

  private void ask(int which) {
    at = which;
    field = 0;
    moved = OptionalLong.empty();
    question().ifPresent(course::saw);
    mark();
  }

  /** Marks the option that was chosen before. */
  private void mark() {
    marked = -1;
    written.setLength(0);
    line().ifPresent(known -> written.append(course.answer(question().orElseThrow()).value()));
    ranked.clear();
    ranking()
        .ifPresent(
            ranking -> {
              String known = course.answer(question().orElseThrow()).value();
              if (!known.isEmpty()) {
                ranked.addAll(ranking.ordered(known));
                marked = ranking.options().size();
              }
            });
    Optional<AnswerField.Choice> choice = choice();
    if (choice.isPresent() && !choice.get().several()) {
      Answer known = course.answer(question().orElseThrow());
      String value = field == 0 ? known.value() : Integer.toString(known.confidence());
      List<String> values = choice.get().options().stream().map(ChoiceOption::value).toList();
      marked = values.indexOf(value);
    }
  }

  /** Gives an option the next rank, or takes back its own. */
  private void rankNext(int option) {
    Question question = question().orElseThrow();
    ChoiceOption chosen = options().get(option);
    if (!ranked.remove(chosen)) {
      ranked.add(chosen);
    }
    boolean all = ranked.size() == options().size();
    Answer answer = all ? Answer.of(RankingField.value(ranked)) : Answer.NONE;
    if (!course.answer(question).equals(answer)) {
      course.answer(question, answer, true, System.nanoTime());
    }
    marked = all ? options().size() : option;
  }

  private void take(int option) {
    if (ranking().isPresent()) {
      rankNext(option);
      return;
    }
    Question question = question().orElseThrow();
    AnswerField.Choice choice = choice().orElseThrow();
    String value = choice.options().get(option).value();
    Answer known = course.answer(question);
    if (choice.several()) {
      Set<String> all = new HashSet<>(AnswerField.Choice.parts(known.value()));
      if (!all.remove(value)) {
        all.add(value);
      }
      String joined = choice.joined(all);
      Answer answer = joined.isEmpty() ? Answer.NONE : known.value(joined);
      course.answer(question, answer, true, System.nanoTime());
      return;
    }
    course.answer(
        question,
        field == 0 ? known.value(value) : known.confidence(Integer.parseInt(value)),
        true,
        System.nanoTime());
    if (field + 1 < question.kind().fields(wording).size()) {
      field++;
      mark();
    } else {
      ask(course.asked().indexOf(question) + 1);
    }
  }
}
