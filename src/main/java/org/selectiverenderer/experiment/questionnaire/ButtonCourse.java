package org.selectiverenderer.experiment.questionnaire;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Answers a questionnaire by two buttons and a stick, a question at a time: of two options each
 * button is one, of several the stick or the second button marks one and the first button takes it.
 * Where a page has no more to ask, the first button turns it and the second goes back. Nothing is
 * marked before the participant marks it, so that no answer is suggested. Who points chooses at
 * once, and goes back and on by what is pointed at. Belongs to one thread.
 */
public final class ButtonCourse {
  private final QuestionnaireCourse course;
  private final Wording wording;
  private int at;
  private int field;
  private int marked = -1;
  private boolean over;

  /** Begins, with the first question that is open. */
  public ButtonCourse(QuestionnaireCourse course, Wording wording) {
    this.course = course;
    this.wording = wording;
    course.begin();
    toFirstOpen();
  }

  /**
   * Whether every question can be answered so: by choosing one of some options, on pages without
   * pictures.
   */
  public static boolean fits(Questionnaire questionnaire, Wording wording) {
    return questionnaire.pages().stream().allMatch(page -> page.picture().isEmpty())
        && questionnaire.questions().stream()
            .flatMap(question -> question.kind().fields(wording).stream())
            .allMatch(each -> each instanceof AnswerField.Choice choice && !choice.several());
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

  /** What there is to choose from for the question; its first field before its second. */
  public Optional<AnswerField.Choice> choice() {
    return question().map(asked -> choices(asked).get(field));
  }

  private List<AnswerField.Choice> choices(Question question) {
    return question.kind().fields(wording).stream().map(AnswerField.Choice.class::cast).toList();
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
    return choice().filter(known -> known.options().size() == 2).isPresent();
  }

  /** The first button: yes. */
  public void yes() {
    if (question().isEmpty()) {
      goOn();
    } else if (oneOfTwo()) {
      take(0);
    } else if (marked >= 0) {
      take(marked);
    }
  }

  /** The second button: no. */
  public void no() {
    if (question().isPresent()) {
      if (oneOfTwo()) {
        take(1);
      } else {
        marked = (marked + 1) % choice().orElseThrow().options().size();
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
      int last = choice.get().options().size() - 1;
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
    if (at > 0) {
      ask(at - 1);
    } else if (course.turn(-1)) {
      course.begin();
      ask(course.asked().size());
    }
  }

  /** Whether nothing keeps the participant from going on to the next question or page. */
  public boolean mayGoOn() {
    return question()
        .map(asked -> asked.complete(course.answer(asked), wording))
        .orElse(!course.refuses());
  }

  /** Goes on to the next question, else to the next page, else ends. */
  public void forward() {
    if (question().isEmpty()) {
      goOn();
    } else if (mayGoOn()) {
      ask(at + 1);
    }
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
    Optional<AnswerField.Choice> choice = choice();
    if (choice.isPresent()) {
      Answer known = course.answer(question().orElseThrow());
      String value = field == 0 ? known.value() : Integer.toString(known.confidence());
      List<String> values = choice.get().options().stream().map(Option::value).toList();
      marked = values.indexOf(value);
    }
  }

  private void take(int option) {
    Question question = question().orElseThrow();
    String value = choice().orElseThrow().options().get(option).value();
    Answer known = course.answer(question);
    course.answer(
        question,
        field == 0 ? known.value(value) : known.confidence(Integer.parseInt(value)),
        true,
        System.nanoTime());
    if (field + 1 < choices(question).size()) {
      field++;
      mark();
    } else {
      ask(course.asked().indexOf(question) + 1);
    }
  }
}
