package org.selectiverenderer.app.session;

import static org.selectiverenderer.app.session.PanelCanvas.MARGIN;
import static org.selectiverenderer.app.session.PanelCanvas.PLAIN;
import static org.selectiverenderer.app.session.PanelCanvas.ROOM;
import static org.selectiverenderer.app.session.PanelCanvas.SMALL;

import java.util.List;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.study.questionnaire.AnswerField;
import org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;

/** Draws a text field on a panel, with a virtual keyboard for users who point. */
final class TextFieldRenderer {
  /** The number of visible lines of the text. */
  private static final int LINES = 4;

  private static final int FIELD = 0xFF11161F;

  private final PanelCanvas pen;
  private final VirtualKeyboard keyboard;

  TextFieldRenderer(PanelCanvas pen, ParticipantMessages wording) {
    this.pen = pen;
    keyboard = new VirtualKeyboard(wording);
  }

  /** Draws the text written so far (its last lines where it is long) and the keyboard. */
  void draw(ButtonQuestionnaireController asked, boolean pointing) {
    List<String> lines = pen.wrapped(asked.written() + "_", PLAIN, ROOM - MARGIN);
    List<String> end = lines.subList(Math.max(0, lines.size() - LINES), lines.size());
    pen.add(Primitive2D.rectangle(MARGIN, pen.y(), ROOM, PanelCanvas.heightOf(end), FIELD));
    pen.skip(pen.boxed(end));
    asked.line().filter(line -> line.range().isPresent()).ifPresent(this::range);
    pen.skip(SMALL / 2);
    if (pointing) {
      keys(keyboard.rows(asked));
    }
  }

  /** Draws the range and unit of a number below the field. */
  private void range(AnswerField.Line line) {
    String wanted = line.range().orElseThrow().dashed();
    pen.text(line.unit().isEmpty() ? wanted : wanted + " " + line.unit(), SMALL, PanelCanvas.FAINT);
  }

  private void keys(List<List<VirtualKeyboard.Key>> rows) {
    double gap = SMALL / 3;
    double letter = (ROOM - 9 * gap) / 10;
    for (List<VirtualKeyboard.Key> row : rows) {
      double x = MARGIN;
      for (VirtualKeyboard.Key key : row) {
        double width = key.width() * (letter + gap) - gap;
        pen.box(x, width, 2 * PLAIN, key.held(), key.press());
        pen.label(key.label(), x, width, PLAIN);
        x += width + gap;
      }
      pen.skip(2 * PLAIN + gap);
    }
  }
}
