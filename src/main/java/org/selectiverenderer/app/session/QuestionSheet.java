package org.selectiverenderer.app.session;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.app.headset.PanelPlace;
import org.selectiverenderer.experiment.questionnaire.AnswerField;
import org.selectiverenderer.experiment.questionnaire.ButtonCourse;
import org.selectiverenderer.experiment.questionnaire.Option;
import org.selectiverenderer.experiment.questionnaire.Page;
import org.selectiverenderer.experiment.questionnaire.QuestionnaireCourse;
import org.selectiverenderer.experiment.questionnaire.Wording;
import org.selectiverenderer.geometry.font.FontFamily;
import org.selectiverenderer.geometry.font.FontStyle;
import org.selectiverenderer.geometry.tessellate.TextMesher;
import org.selectiverenderer.runtime.camera.Mark;

/**
 * A question as a page of marks, to be read in a headset: {@value #WIDTH} units wide, as high as it
 * needs. A unit is so large that the smallest letters are {@value #DEGREES} degrees high, letters
 * of the question nearly twice that.
 */
final class QuestionSheet {
  /** Of every sheet. */
  static final double WIDTH = 1000;

  /** How large the smallest letters are seen, from one line to what would fit the next. */
  static final double DEGREES = 1.25;

  private static final double SMALL = 27;
  private static final double PLAIN = 36;
  private static final double LARGE = 46;
  private static final double MARGIN = 50;
  private static final double LINE = 1.35;
  private static final int PAPER = 0xF0202632;
  private static final int INK = 0xFFF0F3F8;
  private static final int FAINT = 0xFFAAB4C4;
  private static final int BOX = 0xFF3A4456;
  private static final int MARKED = 0xFF2E6FD8;

  private final TextMesher mesher = new TextMesher();
  private final Wording wording;
  private final List<Mark> marks = new ArrayList<>();
  private double y;

  /**
   * @param marks with the paper first
   * @param height in units
   */
  record Sheet(List<Mark> marks, double height) {}

  QuestionSheet(Wording wording) {
    this.wording = wording;
  }

  /** Metres for a unit of the page. */
  static double metres() {
    return PanelPlace.DISTANCE * Math.tan(Math.toRadians(DEGREES)) / SMALL;
  }

  /** What is asked now. */
  Sheet of(ButtonCourse asked) {
    marks.clear();
    y = MARGIN;
    QuestionnaireCourse course = asked.course();
    Page page = course.page();
    head(course);
    text(page.title(), PLAIN, INK);
    for (String paragraph : page.text().split("\n")) {
      text(paragraph, page.questions().isEmpty() ? PLAIN : SMALL, INK);
    }
    y += SMALL / 2;
    if (asked.question().isPresent()) {
      text(asked.question().get().text(), LARGE, INK);
      text(asked.heading(), SMALL, FAINT);
      y += SMALL / 2;
      choice(asked);
    }
    y += SMALL;
    text(hint(asked), SMALL, FAINT);
    double height = y + MARGIN - SMALL / 2;
    List<Mark> all = new ArrayList<>();
    all.add(Mark.rectangle(0, 0, WIDTH, height, PAPER));
    all.addAll(marks);
    return new Sheet(all, height);
  }

  private void head(QuestionnaireCourse course) {
    int pages = course.pages().size();
    if (pages > 1) {
      text(wording.filled("page", course.number() + 1, pages), SMALL, FAINT);
    }
  }

  private String hint(ButtonCourse asked) {
    QuestionnaireCourse course = asked.course();
    if (asked.question().isEmpty()) {
      return course.refuses()
          ? wording.of("form.refused")
          : wording.of(course.asked().isEmpty() ? "headset.read" : "headset.done");
    }
    String place = wording.filled("headset.question", asked.place(), course.asked().size());
    List<Option> options = asked.choice().orElseThrow().options();
    return place
        + "  "
        + (asked.oneOfTwo()
            ? wording.filled("headset.two", options.get(0).label(), options.get(1).label())
            : wording.of("headset.several"));
  }

  private void choice(ButtonCourse asked) {
    AnswerField.Choice choice = asked.choice().orElseThrow();
    List<Option> options = choice.options();
    int marked = asked.marked().orElse(-1);
    if (!choice.inLine()) {
      for (int i = 0; i < options.size(); i++) {
        List<String> lines = wrapped(options.get(i).label(), PLAIN, WIDTH - 3 * MARGIN);
        double height = lines.size() * PLAIN * LINE + PLAIN / 2;
        box(MARGIN, WIDTH - 2 * MARGIN, height, i == marked);
        double base = y + PLAIN * 1.15;
        for (String line : lines) {
          marks.add(new Mark.Text(line, 1.5 * MARGIN, base, PLAIN, INK));
          base += PLAIN * LINE;
        }
        y += height + SMALL / 3;
      }
      return;
    }
    double gap = SMALL / 2;
    double each = (WIDTH - 2 * MARGIN - gap * (options.size() - 1)) / options.size();
    for (int i = 0; i < options.size(); i++) {
      double x = MARGIN + i * (each + gap);
      box(x, each, 2 * PLAIN, i == marked);
      String label = options.get(i).label();
      double size = Math.min(PLAIN, PLAIN * (each - gap) / Math.max(1, width(label, PLAIN)));
      marks.add(
          new Mark.Text(label, x + (each - width(label, size)) / 2, y + 1.35 * PLAIN, size, INK));
    }
    y += 2 * PLAIN;
    notes(options, each, gap);
    ends(choice.least(), choice.most());
  }

  /** What options mean, below each. */
  private void notes(List<Option> options, double each, double gap) {
    double top = y;
    for (int i = 0; i < options.size(); i++) {
      String note = options.get(i).note();
      if (!note.isBlank()) {
        double below = top;
        for (String line : wrapped(note, SMALL, each)) {
          double size = Math.min(SMALL, SMALL * each / Math.max(1, width(line, SMALL)));
          below += SMALL * LINE;
          double x = MARGIN + i * (each + gap) + (each - width(line, size)) / 2;
          marks.add(new Mark.Text(line, x, below, size, FAINT));
        }
        y = Math.max(y, below);
      }
    }
  }

  /** What stands at the ends of a scale, below them. */
  private void ends(String least, String most) {
    if (least.isEmpty() && most.isEmpty()) {
      return;
    }
    double half = WIDTH / 2 - 1.5 * MARGIN;
    double top = y;
    List<String> left = wrapped(least, SMALL, half);
    List<String> right = wrapped(most, SMALL, half);
    for (int i = 0; i < Math.max(left.size(), right.size()); i++) {
      y = top + (i + 1) * SMALL * LINE;
      if (i < left.size()) {
        marks.add(new Mark.Text(left.get(i), MARGIN, y, SMALL, FAINT));
      }
      if (i < right.size()) {
        double x = WIDTH - MARGIN - width(right.get(i), SMALL);
        marks.add(new Mark.Text(right.get(i), x, y, SMALL, FAINT));
      }
    }
  }

  private void box(double x, double width, double height, boolean on) {
    marks.add(Mark.rectangle(x, y, width, height, on ? MARKED : BOX));
  }

  private void text(String text, double size, int color) {
    if (text.isBlank()) {
      return;
    }
    for (String line : wrapped(text, size, WIDTH - 2 * MARGIN)) {
      y += size * LINE;
      marks.add(new Mark.Text(line, MARGIN, y - size * (LINE - 1), size, color));
    }
  }

  private double width(String text, double size) {
    return mesher.metrics(text, FontFamily.SANS, FontStyle.PLAIN, (float) size).width();
  }

  private List<String> wrapped(String text, double size, double room) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : text.strip().split("\\s+")) {
      String longer = line.isEmpty() ? word : line + " " + word;
      if (!line.isEmpty() && width(longer, size) > room) {
        lines.add(line.toString());
        line.setLength(0);
        line.append(word);
      } else {
        line.setLength(0);
        line.append(longer);
      }
    }
    lines.add(line.toString());
    return lines;
  }
}
