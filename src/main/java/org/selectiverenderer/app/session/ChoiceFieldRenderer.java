package org.selectiverenderer.app.session;

import static org.selectiverenderer.app.session.PanelCanvas.FAINT;
import static org.selectiverenderer.app.session.PanelCanvas.LINE;
import static org.selectiverenderer.app.session.PanelCanvas.MARGIN;
import static org.selectiverenderer.app.session.PanelCanvas.PLAIN;
import static org.selectiverenderer.app.session.PanelCanvas.ROOM;
import static org.selectiverenderer.app.session.PanelCanvas.SMALL;

import java.util.List;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController;
import org.selectiverenderer.study.questionnaire.ChoiceOption;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;

/**
 * Draws the options of a choice question on a panel: one below the other, or as a scale in a line.
 */
final class ChoiceFieldRenderer {
  private final PanelCanvas pen;
  private final ParticipantMessages wording;

  ChoiceFieldRenderer(PanelCanvas pen, ParticipantMessages wording) {
    this.pen = pen;
    this.wording = wording;
  }

  void draw(ButtonQuestionnaireController asked, boolean pointing) {
    AnswerField.Choice choice = asked.choice().orElseThrow();
    if (choice.several() || !choice.inLine()) {
      list(asked, choice, pointing);
    } else {
      line(asked, choice);
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
      double width = ROOM / 3;
      double x = MARGIN + ROOM - width;
      pen.box(x, width, 2 * PLAIN, marked == options.size(), asked::forward);
      pen.label(wording.of("next"), x, width, PLAIN);
      pen.skip(2 * PLAIN);
    }
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
