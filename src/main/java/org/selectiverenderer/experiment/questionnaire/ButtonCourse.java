package org.selectiverenderer.experiment.questionnaire;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Answers a questionnaire by two buttons and a stick, a question at a time: of two options each
 * button is one, of several the stick or the second button marks one and the first button takes it.
 * Where several may be chosen, the first button takes them one by one, and behind the last one goes
 * on. Where something is to be written, the first button goes on and the second takes a letter
 * back. Where a page has no more to ask, the first button turns it and the second goes back.
 * Nothing is marked before the participant marks it, so that no answer is suggested. Who points
 * chooses at once, and goes back and on by what is pointed at. Belongs to one thread.
 */
public final class ButtonCourse {
  private final QuestionnaireCourse course;
  private final Wording wording;
  private int at;
  private int field;
  private int marked = -1;
  private final StringBuilder written = new StringBuilder();
  private boolean over;

  /** Begins, with the first question that is open. */
  public ButtonCourse(QuestionnaireCourse course, Wording wording) {
    this.course = course;
    this.wording = wording;
    course.begin();
    toFirstOpen();
  }

  /** The page, with what is answered on it. */
  public QuestionnaireCourse course() {
    return course;
  }

  /** The question that is asked; empty where the page has no more. */
  public Optional<Question> question() {
    List<Question> asked = course.asked();
    return at < asked.size() ? Optional.of(asked.get(at)) : Optional.empty();
  }

  /** Its place among the questions of the page, from 1. */
  public int place() {
    return at + 1;
  }

  /** What is to be filled in for the question; its first field before its second. */
  private Optional<AnswerField> asks() {
    return question().map(asked -> asked.kind().fields(wording).get(field));
  }

  /** What there is to choose from; empty where something is to be written. */
  public Optional<AnswerField.Choice> choice() {
    return asks().filter(AnswerField.Choice.class::isInstance).map(AnswerField.Choice.class::cast);
  }

  /** What is to be written; empty where there are options to choose from. */
  public Optional<AnswerField.Line> line() {
    return asks().filter(AnswerField.Line.class::isInstance).map(AnswerField.Line.class::cast);
  }

  /** What is written so far. */
  public String written() {
    return written.toString();
  }

  /** Writes something behind that; where nothing is to be written, it does nothing. */
  public void write(String more) {
    if (line().isPresent() && written.length() + more.length() <= AnswerField.Line.LONGEST) {
      written.append(more);
    }
  }

  /** Takes the last letter back. */
  public void erase() {
    if (!written.isEmpty()) {
      written.setLength(written.offsetByCodePoints(written.length(), -1));
    }
  }

  /** Whether several options may be chosen, and this is one of them. */
  public boolean chosen(int option) {
    return choice()
        .filter(AnswerField.Choice::several)
        .map(choice -> choice.options().get(option).value())
        .filter(AnswerField.Choice.parts(course.answer(question().orElseThrow()).value())::contains)
        .isPresent();
  }

  /** The heading of that field, as {@code How sure are you?}; empty where it has none. */
  public String heading() {
    return question()
        .map(asked -> asked.kind().headings(wording))
        .filter(headings -> field < headings.size())
        .map(headings -> headings.get(field))
        .orElse("");
  }

  /** The option that is marked: what was answered, or what would be by the first button. */
  public OptionalInt marked() {
    return marked < 0 ? OptionalInt.empty() : OptionalInt.of(marked);
  }

  /** Whether all is answered and the participant went on from the last page. */
  public boolean over() {
    return over;
  }

  /** Whether each button is an option. */
  public boolean oneOfTwo() {
    return choice().filter(known -> known.options().size() == 2 && !known.several()).isPresent();
  }

  /** How many things the second button goes through: where several are chosen, an end of it. */
  private int places() {
    AnswerField.Choice choice = choice().orElseThrow();
    return choice.options().size() + (choice.several() ? 1 : 0);
  }

  /** The first button: yes. */
  public void yes() {
    if (choice().isEmpty()) {
      forward();
    } else if (oneOfTwo()) {
      take(0);
    } else if (marked == choice().orElseThrow().options().size()) {
      forward();
    } else if (marked >= 0) {
      take(marked);
    }
  }

  /** The second button: no. */
  public void no() {
    if (line().isPresent()) {
      erase();
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

  /** The stick was pushed away: more, or what is above. */
  public void more() {
    stick(true);
  }

  /** The stick was pulled: less, or what is below. */
  public void less() {
    stick(false);
  }

  private void stick(boolean away) {
    Optional<AnswerField.Choice> choice = choice();
    if (choice.isPresent() && !oneOfTwo()) {
      boolean on = choice.get().inLine() == away;
      int last = places() - 1;
      marked = marked < 0 ? (on ? 0 : last) : Math.max(0, Math.min(last, marked + (on ? 1 : -1)));
    } else if (away && at > 0) {
      ask(at - 1);
    } else if (!away && question().isPresent()) {
      forward();
    }
  }

  /** An option of the question was pointed at and chosen. */
  public void choose(int option) {
    take(option);
  }

  /** Whether there is something to go back to: a question or a page before. */
  public boolean mayGoBack() {
    return at > 0 || course.number() > 0;
  }

  /** Goes back to the question before, else to the page before. */
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

  /** Whether nothing keeps the participant from going on to the next question or page. */
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

  /** What is written becomes the answer, unless it is already. */
  private void keep() {
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
    question().ifPresent(course::saw);
    mark();
  }

  /** Marks what was answered before. */
  private void mark() {
    marked = -1;
    written.setLength(0);
    line().ifPresent(known -> written.append(course.answer(question().orElseThrow()).value()));
    Optional<AnswerField.Choice> choice = choice();
    if (choice.isPresent() && !choice.get().several()) {
      Answer known = course.answer(question().orElseThrow());
      String value = field == 0 ? known.value() : Integer.toString(known.confidence());
      List<String> values = choice.get().options().stream().map(Option::value).toList();
      marked = values.indexOf(value);
    }
  }

  private void take(int option) {
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
