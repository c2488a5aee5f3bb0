package org.selectiverenderer.app.session;

import static org.selectiverenderer.app.session.PanelCanvas.FAINT;
import static org.selectiverenderer.app.session.PanelCanvas.INK;
import static org.selectiverenderer.app.session.PanelCanvas.LARGE;
import static org.selectiverenderer.app.session.PanelCanvas.LINE;
import static org.selectiverenderer.app.session.PanelCanvas.MARGIN;
import static org.selectiverenderer.app.session.PanelCanvas.PLAIN;
import static org.selectiverenderer.app.session.PanelCanvas.ROOM;
import static org.selectiverenderer.app.session.PanelCanvas.SMALL;
import static org.selectiverenderer.app.session.PanelCanvas.SPOT;

import java.util.OptionalInt;
import org.selectiverenderer.browser.camera.Primitive2D;
import org.selectiverenderer.study.questionnaire.ButtonQuestionnaireController;
import org.selectiverenderer.study.questionnaire.SliderField;

/** Draws a slider on a panel: the line with its marks, the thumb, the number and the ends. */
final class SliderFieldRenderer {
  /** Largest number of parts of the line that can be pointed at; finer than a hand is steady. */
  private static final int MOST_PARTS = 200;

  private static final double HEIGHT = 2 * PLAIN;
  private static final double THUMB = 18;

  private final PanelCanvas pen;

  SliderFieldRenderer(PanelCanvas pen) {
    this.pen = pen;
  }

  void draw(ButtonQuestionnaireController asked) {
    SliderField slider = asked.slider().orElseThrow();
    OptionalInt thumb = asked.thumb();
    if (slider.number()) {
      String number = thumb.isPresent() ? slider.value(thumb.getAsInt()) : " ";
      double width = pen.width(number, LARGE);
      pen.skip(LARGE * LINE);
      if (thumb.isPresent()) {
        pen.add(
            new Primitive2D.Text(
                number, (QuestionPanelRenderer.WIDTH - width) / 2, pen.y(), LARGE, INK));
      }
    }
    double middle = pen.y() + HEIGHT / 2;
    targets(asked, slider);
    pen.add(new Primitive2D.Line(MARGIN, middle, MARGIN + ROOM, middle, 5, FAINT));
    for (int position : slider.marked()) {
      double x = at(slider, position);
      pen.add(new Primitive2D.Line(x, middle - SMALL / 2, x, middle + SMALL / 2, 3, FAINT));
    }
    if (thumb.isPresent()) {
      double x = at(slider, thumb.getAsInt());
      pen.add(Primitive2D.rectangle(x - THUMB / 2, middle - PLAIN * 0.8, THUMB, PLAIN * 1.6, SPOT));
    }
    pen.skip(HEIGHT);
    labels(slider);
    pen.ends(slider.least(), slider.most());
  }

  /** Adds the parts of the line that can be pointed at, which choose the nearest position. */
  private void targets(ButtonQuestionnaireController asked, SliderField slider) {
    int last = slider.last();
    int parts = Math.min(last, MOST_PARTS);
    for (int part = 0; part <= parts; part++) {
      int position = (int) Math.round(part * (double) last / parts);
      double x = at(slider, position);
      double half = ROOM / parts / 2;
      pen.target(x - half, 2 * half, HEIGHT, () -> asked.slide(position));
    }
  }

  private void labels(SliderField slider) {
    double top = pen.y();
    for (int position : slider.labelled()) {
      String label = slider.value(position);
      double x = at(slider, position) - pen.width(label, SMALL) / 2;
      pen.add(new Primitive2D.Text(label, x, top + SMALL, SMALL, FAINT));
      pen.reach(top + SMALL * LINE);
    }
  }

  private static double at(SliderField slider, int position) {
    return MARGIN + ROOM * position / slider.last();
  }
}
