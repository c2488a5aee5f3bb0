package org.selectiverenderer.app.session;

import static org.selectiverenderer.app.session.PanelCanvas.FAINT;
import static org.selectiverenderer.app.session.PanelCanvas.INK;
import static org.selectiverenderer.app.session.PanelCanvas.LARGE;
import static org.selectiverenderer.app.session.PanelCanvas.MARGIN;
import static org.selectiverenderer.app.session.PanelCanvas.PLAIN;
import static org.selectiverenderer.app.session.PanelCanvas.ROOM;
import static org.selectiverenderer.app.session.PanelCanvas.SMALL;
import static org.selectiverenderer.app.session.PanelCanvas.SPOT;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.app.headset.PanelPlacement;
import org.selectiverenderer.browser.camera.ArgbImage;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.QuestionnairePage;
import org.selectiverenderer.study.questionnaire.QuestionnaireProgress;

/**
 * Lays out a question as a panel to be read in a headset, {@value #WIDTH} units wide and as high as
 * its content. A unit is so large that a line of the smallest text is {@value #DEGREES} degrees
 * high; text of the question is nearly twice as large.
 */
final class QuestionPanelRenderer {
  /** The width of every sheet in units. */
  static final double WIDTH = 1000;

  /** The visual angle of a line of the smallest text. */
  static final double DEGREES = 1.25;

  /** The largest height of a picture in units. */
  private static final double TALLEST = 450;

  /** The largest height of a picture above the keyboard in units. */
  private static final double ABOVE_KEYS = 250;

  private static final int PAPER = 0xF0202632;

  private final ParticipantMessages wording;
  private final Map<Path, ArgbImage> pictures;
  private final PanelCanvas pen = new PanelCanvas();
  private final TextFieldRenderer writing;
  private final ChoiceFieldRenderer choice;
  private final SliderFieldRenderer slider;

  /**
   * @param marks the drawn marks, the background first
   * @param height height in units
   * @param targets the buttons and options that can be chosen
   */
  record Sheet(List<Primitive2D> marks, double height, List<PointerTarget> targets) {
    /** Returns the target at a point. */
    Optional<PointerTarget> at(double x, double y) {
      return targets.stream().filter(target -> target.has(x, y)).findFirst();
    }

    /** Returns whether a point is on the sheet. */
    boolean has(double x, double y) {
      return x >= 0 && x <= WIDTH && y >= 0 && y <= height;
    }
  }

  /**
   * @param pictures the pictures of all pages and options by their files
   */
  QuestionPanelRenderer(ParticipantMessages wording, Map<Path, ArgbImage> pictures) {
    this.wording = wording;
    this.pictures = pictures;
    writing = new TextFieldRenderer(pen, wording);
    choice = new ChoiceFieldRenderer(pen, wording, pictures);
    slider = new SliderFieldRenderer(pen);
  }

  /** Returns a spot that marks the point at which the pointing ray meets the page. */
  static Primitive2D spot(double x, double y) {
    double[] corners = new double[24];
    for (int i = 0; i < 12; i++) {
      corners[2 * i] = x + 7 * Math.cos(i * Math.PI / 6);
      corners[2 * i + 1] = y + 7 * Math.sin(i * Math.PI / 6);
    }
    return new Primitive2D.Area(corners, SPOT);
  }

  /** Returns the size of a unit of the page in metres. */
  static double metres() {
    return PanelPlacement.DISTANCE * Math.tan(Math.toRadians(DEGREES)) / SMALL;
  }

  /**
   * Lays out the current question.
   *
   * @param device with which the answer is given; buttons are drawn for a ray only
   */
  Sheet of(ButtonQuestionnaireController asked, AnswerDevice device) {
    boolean pointing = device == AnswerDevice.RAY;
    pen.begin();
    QuestionnaireProgress course = asked.course();
    QuestionnairePage page = course.page();
    head(course);
    pen.text(page.title(), PLAIN, INK);
    for (String paragraph : page.text().split("\n")) {
      pen.text(paragraph, page.questions().isEmpty() ? PLAIN : SMALL, INK);
    }
    page.picture()
        .map(pictures::get)
        .ifPresent(picture -> picture(picture, asked.line().isPresent() && pointing));
    pen.skip(SMALL / 2);
    if (asked.question().isPresent()) {
      pen.text(asked.question().get().kind().stem(), PLAIN, FAINT);
      pen.text(asked.question().get().text(), LARGE, INK);
      pen.text(asked.heading(), SMALL, FAINT);
      pen.skip(SMALL / 2);
      if (asked.line().isPresent()) {
        writing.draw(asked, pointing);
      } else if (asked.slider().isPresent()) {
        slider.draw(asked);
      } else if (asked.ranking().isPresent()) {
        choice.ranking(asked, pointing);
      } else {
        choice.draw(asked, pointing);
      }
    }
    pen.skip(SMALL);
    if (pointing) {
      turns(asked);
    }
    pen.text(hint(asked, device), SMALL, FAINT);
    double height = pen.y() + MARGIN - SMALL / 2;
    List<Primitive2D> all = new ArrayList<>();
    all.add(Primitive2D.rectangle(0, 0, WIDTH, height, PAPER));
    all.addAll(pen.marks());
    return new Sheet(all, height, List.copyOf(pen.targets()));
  }

  /** Draws the buttons that turn pages and go from question to question. */
  private void turns(ButtonQuestionnaireController asked) {
    double width = ROOM / 3;
    double height = 2 * PLAIN;
    if (asked.mayGoBack()) {
      button("back", MARGIN, width, asked::back);
    }
    if (asked.mayGoOn()) {
      button("next", WIDTH - MARGIN - width, width, asked::forward);
    }
    pen.skip(height + SMALL / 2);
  }

  private void button(String key, double x, double width, Runnable choose) {
    pen.box(x, width, 2 * PLAIN, false, choose);
    pen.label(wording.of(key), x, width, PLAIN);
  }

  private void head(QuestionnaireProgress course) {
    int pages = course.pages().size();
    if (pages > 1) {
      pen.text(wording.filled("page", course.number() + 1, pages), SMALL, FAINT);
    }
  }

  private String hint(ButtonQuestionnaireController asked, AnswerDevice device) {
    QuestionnaireProgress course = asked.course();
    String means = device == AnswerDevice.KEYBOARD ? "keyboard." : "headset.";
    if (asked.question().isEmpty()) {
      return course.refuses()
          ? wording.of("form.refused")
          : wording.of(means + (course.asked().isEmpty() ? "read" : "done"));
    }
    String place = wording.filled("headset.question", asked.place(), course.asked().size()) + "  ";
    if (device == AnswerDevice.RAY && asked.ranking().isEmpty()) {
      return place + wording.of(asked.line().isPresent() ? "headset.keys" : "headset.point");
    }
    if (asked.line().isPresent()) {
      return place + wording.of(means + "written");
    }
    if (asked.ranking().isPresent()) {
      return place + wording.of(means + "ranking");
    }
    if (asked.slider().isPresent()) {
      return place + wording.of(means + "slider");
    }
    List<ChoiceOption> options = asked.choice().orElseThrow().options();
    return place
        + (asked.oneOfTwo() && device != AnswerDevice.KEYBOARD
            ? wording.filled("headset.two", options.get(0).label(), options.get(1).label())
            : wording.of(means + "several"));
  }

  /** Draws a centred picture as large as the space allows. */
  private void picture(ArgbImage picture, boolean aboveKeys) {
    double tallest = aboveKeys ? ABOVE_KEYS : TALLEST;
    double scale = Math.min(ROOM / picture.width(), tallest / picture.height());
    double width = scale * picture.width();
    double height = scale * picture.height();
    pen.skip(SMALL / 2);
    pen.add(new Primitive2D.Picture(picture, (WIDTH - width) / 2, pen.y(), width, height));
    pen.skip(height);
  }
}
