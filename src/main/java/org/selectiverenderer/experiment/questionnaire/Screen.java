package org.selectiverenderer.experiment.questionnaire;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Random;
import org.selectiverenderer.experiment.study.QuestionKind;

/**
 * The questions about one area, in the order in which a participant meets them.
 *
 * @param items at least one
 */
public record Screen(QuestionKind kind, String area, List<QuestionItem> items) {
  public Screen {
    items = List.copyOf(items);
  }

  /** The areas of some items, in their order. */
  public static List<String> areas(List<QuestionItem> items) {
    return List.copyOf(new LinkedHashSet<>(items.stream().map(QuestionItem::area).toList()));
  }

  /**
   * A participant's screen of an area. The order is drawn anew for each participant and area, and
   * is the same whenever it is asked for, on every machine.
   *
   * @param seed of the study
   */
  public static Screen of(
      QuestionKind kind, String area, List<QuestionItem> items, long seed, String participant) {
    List<QuestionItem> order =
        new ArrayList<>(items.stream().filter(item -> item.area().equals(area)).toList());
    long mixed = seed;
    for (char c : (kind.spelling() + '/' + participant + '/' + area).toCharArray()) {
      mixed = (mixed ^ c) * 0x100000001B3L; // FNV-1a, whose low bits Random then spreads.
    }
    Collections.shuffle(order, new Random(mixed));
    return new Screen(kind, area, order);
  }

  /** Whether confidence is asked for too. */
  public boolean withConfidence() {
    return kind == QuestionKind.RECOGNITION;
  }
}
