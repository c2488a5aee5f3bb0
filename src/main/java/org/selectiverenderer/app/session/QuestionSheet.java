package org.selectiverenderer.app.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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

  /** Of what is written, that are seen. */
  private static final int LINES = 4;

  private static final int PAPER = 0xF0202632;
  private static final int INK = 0xFFF0F3F8;
  private static final int FAINT = 0xFFAAB4C4;
  private static final int SPOT = 0xFFFFD24A;
  private static final int FIELD = 0xFF11161F;
  private static final int BOX = 0xFF3A4456;
  private static final int MARKED = 0xFF2E6FD8;

  private final TextMesher mesher = new TextMesher();
  private final Wording wording;
  private final PanelKeyboard keyboard;
  private final List<Mark> marks = new ArrayList<>();
  private final List<Target> targets = new ArrayList<>();
  private double y;

  /**
   * Something that can be chosen by pointing at it.
   *
   * @param x of its left side
   * @param y of its upper side
   * @param choose what is done when it is chosen
   */
  record Target(double x, double y, double width, double height, Runnable choose) {
    private static final int LIGHT = 0x30FFFFFF;

    boolean has(double pointX, double pointY) {
      return pointX >= x && pointX <= x + width && pointY >= y && pointY <= y + height;
    }

    /** What is drawn over it while it is pointed at. */
    List<Mark> lit() {
      return List.of(
          Mark.rectangle(x, y, width, height, LIGHT),
          new Mark.Line(x, y, x + width, y, 4, INK),
          new Mark.Line(x, y + height, x + width, y + height, 4, INK),
          new Mark.Line(x, y, x, y + height, 4, INK),
          new Mark.Line(x + width, y, x + width, y + height, 4, INK));
    }
  }

  /**
   * @param marks with the paper first
   * @param height in units
   * @param targets what can be chosen
   */
  record Sheet(List<Mark> marks, double height, List<Target> targets) {
    /** What a point of it can choose. */
    Optional<Target> at(double x, double y) {
      return targets.stream().filter(target -> target.has(x, y)).findFirst();
    }

    /** Whether a point is on it. */
    boolean has(double x, double y) {
      return x >= 0 && x <= WIDTH && y >= 0 && y <= height;
    }
  }

  QuestionSheet(Wording wording) {
    this.wording = wording;
    keyboard = new PanelKeyboard(wording);
  }

  /** A spot on the page where a ray meets it. */
  static Mark spot(double x, double y) {
    double[] corners = new double[24];
    for (int i = 0; i < 12; i++) {
      corners[2 * i] = x + 7 * Math.cos(i * Math.PI / 6);
      corners[2 * i + 1] = y + 7 * Math.sin(i * Math.PI / 6);
    }
    return new Mark.Area(corners, SPOT);
  }

  /** Metres for a unit of the page. */
  static double metres() {
    return PanelPlace.DISTANCE * Math.tan(Math.toRadians(DEGREES)) / SMALL;
  }

  /**
   * What is asked now.
   *
   * @param pointing whether a hand points, so that there are things to choose by that
   */
  Sheet of(ButtonCourse asked, boolean pointing) {
    marks.clear();
    targets.clear();
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
      if (asked.line().isPresent()) {
        writing(asked, pointing);
      } else {
        choice(asked, pointing);
      }
    }
    y += SMALL;
    if (pointing) {
      turns(asked);
    }
    text(hint(asked, pointing), SMALL, FAINT);
    double height = y + MARGIN - SMALL / 2;
    List<Mark> all = new ArrayList<>();
    all.add(Mark.rectangle(0, 0, WIDTH, height, PAPER));
    all.addAll(marks);
    return new Sheet(all, height, List.copyOf(targets));
  }

  /** What turns pages and goes from question to question. */
  private void turns(ButtonCourse asked) {
    double width = (WIDTH - 2 * MARGIN) / 3;
    double height = 2 * PLAIN;
    if (asked.mayGoBack()) {
      button("back", MARGIN, width, asked::back);
    }
    if (asked.mayGoOn()) {
      button("next", WIDTH - MARGIN - width, width, asked::forward);
    }
    y += height + SMALL / 2;
  }

  private void button(String key, double x, double width, Runnable choose) {
    box(x, width, 2 * PLAIN, false, choose);
    label(wording.of(key), x, width, PLAIN);
  }

  /** A line in the middle of a box, made smaller where it would not fit. */
  private void label(String label, double x, double width, double most) {
    double size = Math.min(most, most * (width - SMALL / 2) / Math.max(1, width(label, most)));
    marks.add(
        new Mark.Text(label, x + (width - width(label, size)) / 2, y + 1.35 * PLAIN, size, INK));
  }

  private void head(QuestionnaireCourse course) {
    int pages = course.pages().size();
    if (pages > 1) {
      text(wording.filled("page", course.number() + 1, pages), SMALL, FAINT);
    }
  }

  private String hint(ButtonCourse asked, boolean pointing) {
    QuestionnaireCourse course = asked.course();
    if (asked.question().isEmpty()) {
      return course.refuses()
          ? wording.of("form.refused")
          : wording.of(course.asked().isEmpty() ? "headset.read" : "headset.done");
    }
    String place = wording.filled("headset.question", asked.place(), course.asked().size());
    if (pointing) {
      String what = asked.line().isPresent() ? "headset.keys" : "headset.point";
      return place + "  " + wording.of(what);
    }
    if (asked.line().isPresent()) {
      return place + "  " + wording.of("headset.written");
    }
    List<Option> options = asked.choice().orElseThrow().options();
    return place
        + "  "
        + (asked.oneOfTwo()
            ? wording.filled("headset.two", options.get(0).label(), options.get(1).label())
            : wording.of("headset.several"));
  }

  /** What is written so far, its end where it is long, and the keys for one who points. */
  private void writing(ButtonCourse asked, boolean pointing) {
    List<String> lines = wrapped(asked.written() + "_", PLAIN, WIDTH - 3 * MARGIN);
    List<String> end = lines.subList(Math.max(0, lines.size() - LINES), lines.size());
    double height = end.size() * PLAIN * LINE + PLAIN / 2;
    marks.add(Mark.rectangle(MARGIN, y, WIDTH - 2 * MARGIN, height, FIELD));
    double base = y + PLAIN * 1.15;
    for (String line : end) {
      marks.add(new Mark.Text(line, 1.5 * MARGIN, base, PLAIN, INK));
      base += PLAIN * LINE;
    }
    y += height;
    asked.line().filter(line -> line.range().isPresent()).ifPresent(this::range);
    y += SMALL / 2;
    if (pointing) {
      keys(keyboard.rows(asked));
    }
  }

  /** What number is wanted, below the field. */
  private void range(AnswerField.Line line) {
    String wanted = line.range().orElseThrow().dashed();
    text(line.unit().isEmpty() ? wanted : wanted + " " + line.unit(), SMALL, FAINT);
  }

  private void keys(List<List<PanelKeyboard.Key>> rows) {
    double gap = SMALL / 3;
    double letter = (WIDTH - 2 * MARGIN - 9 * gap) / 10;
    for (List<PanelKeyboard.Key> row : rows) {
      double x = MARGIN;
      for (PanelKeyboard.Key key : row) {
        double width = key.width() * letter + (Math.ceil(key.width()) - 1) * gap;
        box(x, width, 2 * PLAIN, key.held(), key.press());
        label(key.label(), x, width, PLAIN);
        x += width + gap;
      }
      y += 2 * PLAIN + gap;
    }
  }

  private void choice(ButtonCourse asked, boolean pointing) {
    AnswerField.Choice choice = asked.choice().orElseThrow();
    List<Option> options = choice.options();
    int marked = asked.marked().orElse(-1);
    if (choice.several() || !choice.inLine()) {
      for (int i = 0; i < options.size(); i++) {
        List<String> lines = wrapped(options.get(i).label(), PLAIN, WIDTH - 3 * MARGIN);
        double height = lines.size() * PLAIN * LINE + PLAIN / 2;
        int option = i;
        boolean on = choice.several() ? asked.chosen(i) : i == marked;
        box(MARGIN, WIDTH - 2 * MARGIN, height, on, () -> asked.choose(option));
        if (choice.several() && i == marked) {
          marks.add(Mark.rectangle(MARGIN, y, MARGIN / 4, height, SPOT));
        }
        double base = y + PLAIN * 1.15;
        for (String line : lines) {
          marks.add(new Mark.Text(line, 1.5 * MARGIN, base, PLAIN, INK));
          base += PLAIN * LINE;
        }
        y += height + SMALL / 3;
      }
      if (choice.several() && !pointing) {
        double width = (WIDTH - 2 * MARGIN) / 3;
        box(WIDTH - MARGIN - width, width, 2 * PLAIN, marked == options.size(), asked::forward);
        label(wording.of("next"), WIDTH - MARGIN - width, width, PLAIN);
        y += 2 * PLAIN;
      }
      return;
    }
    double gap = SMALL / 2;
    double each = (WIDTH - 2 * MARGIN - gap * (options.size() - 1)) / options.size();
    for (int i = 0; i < options.size(); i++) {
      double x = MARGIN + i * (each + gap);
      int option = i;
      box(x, each, 2 * PLAIN, i == marked, () -> asked.choose(option));
      label(options.get(i).label(), x, each, PLAIN);
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

  private void box(double x, double width, double height, boolean on, Runnable choose) {
    targets.add(new Target(x, y, width, height, choose));
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
