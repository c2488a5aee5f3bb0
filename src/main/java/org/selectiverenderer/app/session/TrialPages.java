package org.selectiverenderer.app.session;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.browser.camera.HeadFixedPage;
import org.selectiverenderer.browser.camera.Primitive2D;

/** Draws the pages that the phases of trials show: texts and the fixation cross. */
final class TrialPages {
  private static final double WIDTH = QuestionPanelRenderer.WIDTH;

  /** The height of a page without a picture: that of a view of 4:3. */
  private static final double HEIGHT = 750;

  /** Half the length of the fixation cross, and the width of its lines. */
  private static final double ARM = 28;

  private static final double STROKE = 6;

  private final PanelCanvas pen = new PanelCanvas();

  /** Returns a cross in the middle. */
  HeadFixedPage fixation() {
    double x = WIDTH / 2;
    double y = HEIGHT / 2;
    return new HeadFixedPage(
        List.of(
            new Primitive2D.Line(x - ARM, y, x + ARM, y, STROKE, PanelCanvas.INK),
            new Primitive2D.Line(x, y - ARM, x, y + ARM, STROKE, PanelCanvas.INK)),
        WIDTH,
        HEIGHT);
  }

  /** Returns a text in the middle of the height, with a hint below; an empty hint is left out. */
  HeadFixedPage text(String text, String hint) {
    pen.begin();
    for (String paragraph : text.split("\n")) {
      pen.text(paragraph, PanelCanvas.PLAIN, PanelCanvas.INK);
      pen.skip(PanelCanvas.SMALL / 2);
    }
    if (!hint.isEmpty()) {
      pen.skip(PanelCanvas.SMALL);
      pen.text(hint, PanelCanvas.SMALL, PanelCanvas.FAINT);
    }
    double needed = pen.y() + PanelCanvas.MARGIN;
    return moved(pen.marks(), needed);
  }

  /** Returns a short text, centred. */
  HeadFixedPage line(String text) {
    pen.begin();
    double size = PanelCanvas.PLAIN;
    List<String> lines = pen.wrapped(text, size, PanelCanvas.ROOM);
    List<Primitive2D> marks = new ArrayList<>();
    double y = 0;
    for (String line : lines) {
      y += size * PanelCanvas.LINE;
      marks.add(
          new Primitive2D.Text(
              line, (WIDTH - pen.width(line, size)) / 2, y, size, PanelCanvas.INK));
    }
    return moved(marks, y);
  }

  /** Returns a sheet of a question in the middle of a page. */
  HeadFixedPage sheet(QuestionPanelRenderer.Sheet sheet) {
    return moved(sheet.marks(), sheet.height());
  }

  /** Returns marks of some height in the middle of a page, which grows where they need more. */
  private static HeadFixedPage moved(List<Primitive2D> marks, double needed) {
    double height = Math.max(HEIGHT, needed);
    double down = (height - needed) / 2;
    List<Primitive2D> moved = new ArrayList<>();
    marks.forEach(mark -> moved.add(mark.moved(0, down)));
    return new HeadFixedPage(moved, WIDTH, height);
  }
}
