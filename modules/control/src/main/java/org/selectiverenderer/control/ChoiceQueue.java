package org.selectiverenderer.control;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The one way in which a version or a level is chosen during a walk. A choice that may not be shown
 * yet waits; the latest one wanted counts, and takes the place of the one that waited. An object
 * that is wanted as it is shown does not change at all.
 */
final class ChoiceQueue {
  /** A choice that is wanted, and what causes it. */
  private record Wanted(int choice, ChoiceCause cause) {}

  private final SwitchTiming timing;
  private final Consumer<ControlEvent> events;
  private final Consumer<ControlProblem> problems;
  private final Map<ControlledChoice, Wanted> waiting = new LinkedHashMap<>();

  ChoiceQueue(
      SwitchTiming timing, Consumer<ControlEvent> events, Consumer<ControlProblem> problems) {
    this.timing = timing;
    this.events = events;
    this.problems = problems;
  }

  /**
   * Shows a choice, now or as soon as it may be shown.
   *
   * @param time time stamp in seconds
   */
  void want(ControlledChoice one, int choice, ChoiceCause cause, double time) {
    waiting.remove(one);
    if (choice == one.shown()) {
      return;
    }
    if (timing.mayShow(one.node(), one.child(choice))) {
      show(one, choice, cause, time);
    } else {
      waiting.put(one, new Wanted(choice, cause));
    }
  }

  /**
   * Shows the choices that wait and may be shown now, in the order in which they came.
   *
   * @param time time stamp in seconds
   * @return whether there were any
   */
  boolean showDue(double time) {
    if (waiting.isEmpty()) {
      return false;
    }
    Iterator<Map.Entry<ControlledChoice, Wanted>> all = waiting.entrySet().iterator();
    Map<ControlledChoice, Wanted> due = new LinkedHashMap<>();
    while (all.hasNext()) {
      Map.Entry<ControlledChoice, Wanted> next = all.next();
      ControlledChoice one = next.getKey();
      if (timing.mayShow(one.node(), one.child(next.getValue().choice()))) {
        due.put(one, next.getValue());
        all.remove();
      }
    }
    due.forEach((one, wanted) -> show(one, wanted.choice(), wanted.cause(), time));
    return !due.isEmpty();
  }

  /** Shows a choice whether it may be seen or not. */
  void show(ControlledChoice one, int choice, ChoiceCause cause, double time) {
    int from = one.shown();
    Optional<SwitchVisibility> seen = timing.shows(one.node(), one.child(choice));
    one.show(choice).ifPresent(problems);
    events.accept(one.change(time, from, choice, cause, seen));
  }

  /** Drops what waits for an object, because others have set its choice or it is gone. */
  void forget(ControlledChoice one) {
    waiting.remove(one);
  }

  /**
   * Returns the choices that wait, in the order they came: versions by the names of their objects,
   * levels by those of their fields, such as {@code Wood.url}.
   */
  Map<String, Integer> waiting() {
    Map<String, Integer> choices = new LinkedHashMap<>();
    waiting.forEach(
        (one, wanted) -> {
          if (one instanceof VersionedObject object) {
            choices.put(object.name(), wanted.choice());
          } else if (one instanceof ControlledField field) {
            choices.put(field.target().toString(), wanted.choice());
          }
        });
    return choices;
  }
}
