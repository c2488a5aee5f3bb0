package org.selectiverenderer.app.session;

import static org.selectiverenderer.app.session.SheetPen.MARGIN;
import static org.selectiverenderer.app.session.SheetPen.PLAIN;
import static org.selectiverenderer.app.session.SheetPen.ROOM;
import static org.selectiverenderer.app.session.SheetPen.SMALL;

import java.util.List;
import org.selectiverenderer.experiment.questionnaire.AnswerField;
import org.selectiverenderer.experiment.questionnaire.ButtonCourse;
import org.selectiverenderer.experiment.questionnaire.Wording;
import org.selectiverenderer.runtime.camera.Mark;

/** Draws a text field on a panel, with a virtual keyboard for users who point. */
final class WritingPart {
  /** The number of visible lines of the text. */
  private static final int LINES = 4;

  private static final int FIELD = 0xFF11161F;

  private final SheetPen pen;
  private final PanelKeyboard keyboard;

  WritingPart(SheetPen pen, Wording wording) {
    this.pen = pen;
    keyboard = new PanelKeyboard(wording);
  }

  /** Draws the text written so far (its last lines where it is long) and the keyboard. */
  void draw(ButtonCourse asked, boolean pointing) {
    List<String> lines = pen.wrapped(asked.written() + "_", PLAIN, ROOM - MARGIN);
    List<String> end = lines.subList(Math.max(0, lines.size() - LINES), lines.size());
    pen.add(Mark.rectangle(MARGIN, pen.y(), ROOM, SheetPen.heightOf(end), FIELD));
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
    pen.text(line.unit().isEmpty() ? wanted : wanted + " " + line.unit(), SMALL, SheetPen.FAINT);
  }

  private void keys(List<List<PanelKeyboard.Key>> rows) {
    double gap = SMALL / 3;
    double letter = (ROOM - 9 * gap) / 10;
    for (List<PanelKeyboard.Key> row : rows) {
      double x = MARGIN;
      for (PanelKeyboard.Key key : row) {
        double width = key.width() * (letter + gap) - gap;
        pen.box(x, width, 2 * PLAIN, key.held(), key.press());
        pen.label(key.label(), x, width, PLAIN);
        x += width + gap;
      }
      pen.skip(2 * PLAIN + gap);
    }
  }
}
