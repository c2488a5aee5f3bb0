package org.selectiverenderer.app.session;

import static org.selectiverenderer.app.session.PanelCanvas.FAINT;
import static org.selectiverenderer.app.session.PanelCanvas.LINE;
import static org.selectiverenderer.app.session.PanelCanvas.MARGIN;
import static org.selectiverenderer.app.session.PanelCanvas.PLAIN;
import static org.selectiverenderer.app.session.PanelCanvas.ROOM;
import static org.selectiverenderer.app.session.PanelCanvas.SMALL;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.browser.camera.ArgbImage;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;

/**
 * Draws the options of a choice question on a panel: one below the other, or as a scale in a line.
 */
final class ChoiceFieldRenderer {
  private static final int ABREAST = 4;
  private static final double PICTURE = 180;

  private final PanelCanvas pen;
  private final ParticipantMessages wording;
  private final Map<Path, ArgbImage> pictures;

  ChoiceFieldRenderer(PanelCanvas pen, ParticipantMessages wording, Map<Path, ArgbImage> pictures) {
    this.pen = pen;
    this.wording = wording;
    this.pictures = pictures;
  }

  /** Draws options to be put in order, with the ranks that they have. */
  void ranking(ButtonQuestionnaireController asked, boolean pointing) {
    List<ChoiceOption> options = asked.options();
    int marked = asked.marked().orElse(-1);
    for (int i = 0; i < options.size(); i++) {
      String rank = asked.rank(i).isPresent() ? asked.rank(i).getAsInt() + ".  " : "";
      List<String> lines = pen.wrapped(rank + options.get(i).label(), PLAIN, ROOM - MARGIN);
      double height = PanelCanvas.heightOf(lines);
      int option = i;
      pen.box(MARGIN, ROOM, height, !rank.isEmpty(), () -> asked.choose(option));
      if (i == marked) {
        pen.add(Primitive2D.rectangle(MARGIN, pen.y(), MARGIN / 4, height, PanelCanvas.SPOT));
      }
      pen.skip(pen.boxed(lines) + SMALL / 3);
    }
    if (!pointing) {
      next(asked, marked == options.size());
    }
  }

  void draw(ButtonQuestionnaireController asked, boolean pointing) {
    AnswerField.Choice choice = asked.choice().orElseThrow();
    if (choice.pictured()) {
      pictures(asked, choice, pointing);
    } else if (choice.several() || !choice.inLine()) {
      list(asked, choice, pointing);
    } else {
      line(asked, choice);
    }
  }

  /** Draws options that are pictures, some in a row. */
  private void pictures(
      ButtonQuestionnaireController asked, AnswerField.Choice choice, boolean pointing) {
    List<ChoiceOption> options = choice.options();
    int marked = asked.marked().orElse(-1);
    double gap = SMALL / 2;
    double width = (ROOM - gap * (ABREAST - 1)) / ABREAST;
    for (int i = 0; i < options.size(); i++) {
      double x = MARGIN + (i % ABREAST) * (width + gap);
      int option = i;
      boolean on = choice.several() ? asked.chosen(i) : i == marked;
      pen.box(x, width, PICTURE, on, () -> asked.choose(option));
      if (choice.several() && i == marked) {
        pen.add(Primitive2D.rectangle(x, pen.y(), MARGIN / 4, PICTURE, PanelCanvas.SPOT));
      }
      ArgbImage picture = pictures.get(options.get(i).picture().orElseThrow());
      if (picture != null) {
        double scale =
            Math.min((width - gap) / picture.width(), (PICTURE - gap) / picture.height());
        double wide = scale * picture.width();
        double high = scale * picture.height();
        pen.add(
            new Primitive2D.Picture(
                picture, x + (width - wide) / 2, pen.y() + (PICTURE - high) / 2, wide, high));
      }
      if (i % ABREAST == ABREAST - 1 || i == options.size() - 1) {
        pen.skip(PICTURE + gap);
      }
    }
    if (choice.several() && !pointing) {
      next(asked, marked == options.size());
    }
  }

  private void list(
      ButtonQuestionnaireController asked, AnswerField.Choice choice, boolean pointing) {
    List<ChoiceOption> options = choice.options();
    int marked = asked.marked().orElse(-1);
    for (int i = 0; i < options.size(); i++) {
      List<String> lines = pen.wrapped(options.get(i).label(), PLAIN, ROOM - MARGIN);
      double height = PanelCanvas.heightOf(lines);
      int option = i;
      boolean on = choice.several() ? asked.chosen(i) : i == marked;
      pen.box(MARGIN, ROOM, height, on, () -> asked.choose(option));
      if (choice.several() && i == marked) {
        pen.add(Primitive2D.rectangle(MARGIN, pen.y(), MARGIN / 4, height, PanelCanvas.SPOT));
      }
      pen.skip(pen.boxed(lines) + SMALL / 3);
    }
    if (choice.several() && !pointing) {
      next(asked, marked == options.size());
    }
  }

  private void next(ButtonQuestionnaireController asked, boolean marked) {
    double width = ROOM / 3;
    double x = MARGIN + ROOM - width;
    pen.box(x, width, 2 * PLAIN, marked, asked::forward);
    pen.label(wording.of("next"), x, width, PLAIN);
    pen.skip(2 * PLAIN);
  }

  private void line(ButtonQuestionnaireController asked, AnswerField.Choice choice) {
    List<ChoiceOption> options = choice.options();
    int marked = asked.marked().orElse(-1);
    double gap = SMALL / 2;
    double each = (ROOM - gap * (options.size() - 1)) / options.size();
    for (int i = 0; i < options.size(); i++) {
      double x = MARGIN + i * (each + gap);
      int option = i;
      pen.box(x, each, 2 * PLAIN, i == marked, () -> asked.choose(option));
      pen.label(options.get(i).label(), x, each, PLAIN);
    }
    pen.skip(2 * PLAIN);
    notes(options, each, gap);
    pen.ends(choice.least(), choice.most());
  }

  /** Draws the notes below the options of a scale. */
  private void notes(List<ChoiceOption> options, double each, double gap) {
    double top = pen.y();
    for (int i = 0; i < options.size(); i++) {
      String note = options.get(i).note();
      if (!note.isBlank()) {
        double below = top;
        for (String line : pen.wrapped(note, SMALL, each)) {
          double size = Math.min(SMALL, SMALL * each / Math.max(1, pen.width(line, SMALL)));
          below += SMALL * LINE;
          double x = MARGIN + i * (each + gap) + (each - pen.width(line, size)) / 2;
          pen.add(new Primitive2D.Text(line, x, below, size, FAINT));
        }
        pen.reach(below);
      }
    }
  }
}
