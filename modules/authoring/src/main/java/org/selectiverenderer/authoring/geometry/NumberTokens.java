package org.selectiverenderer.authoring.geometry;

import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.TextEdit;

/** The numbers of an attribute's value with their places in the text. */
final class NumberTokens {
  private final CharSequence text;
  private final List<int[]> places;

  private NumberTokens(CharSequence text, List<int[]> places) {
    this.text = text;
    this.places = places;
  }

  /**
   * Finds the numbers of an attribute; none if the element does not have it.
   *
   * @throws EditRejectedException if the value has references or comments, so that its numbers are
   *     not where they seem
   */
  static NumberTokens of(CharSequence text, DocumentElement element, String attribute) {
    SourceAttribute value = element.tag().attribute(attribute).orElse(null);
    List<int[]> places = new ArrayList<>();
    int start = -1;
    for (int at = value == null ? 0 : value.valueFrom();
        value != null && at <= value.valueTo();
        at++) {
      char c = at == value.valueTo() ? ' ' : text.charAt(at);
      if (c == '&' || c == '#') {
        throw new EditRejectedException(
            "The value of "
                + attribute
                + " of "
                + element
                + " has references or comments; change it in the source");
      }
      boolean between = c <= ' ' || c == ',';
      if (!between && start < 0) {
        start = at;
      } else if (between && start >= 0) {
        places.add(new int[] {start, at});
        start = -1;
      }
    }
    return new NumberTokens(text, places);
  }

  int size() {
    return places.size();
  }

  /** Returns a number; not a number where the text is none. */
  double number(int index) {
    int[] place = places.get(index);
    try {
      return Double.parseDouble(text.subSequence(place[0], place[1]).toString());
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** Returns the numbers as indices; -2 for what is not a whole number. */
  int[] indices() {
    int[] indices = new int[places.size()];
    for (int i = 0; i < indices.length; i++) {
      double value = number(i);
      indices[i] = value == Math.rint(value) && Math.abs(value) < 1 << 30 ? (int) value : -2;
    }
    return indices;
  }

  float[] floats() {
    float[] floats = new float[places.size()];
    for (int i = 0; i < floats.length; i++) {
      floats[i] = (float) number(i);
    }
    return floats;
  }

  TextEdit replace(int index, String number) {
    int[] place = places.get(index);
    return new TextEdit(place[0], place[1], number);
  }

  /** Removes numbers with the separators behind them; the last ones with those before them. */
  TextEdit remove(int from, int to) {
    if (to < places.size()) {
      return TextEdit.remove(places.get(from)[0], places.get(to)[0]);
    }
    int start = from == 0 ? places.get(0)[0] : places.get(from - 1)[1];
    return TextEdit.remove(start, places.get(to - 1)[1]);
  }
}
