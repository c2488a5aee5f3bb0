package org.selectiverenderer.control;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The one way in which an object gets another choice during a walk. A choice that may not be shown
 * yet waits; the latest one wanted counts, and takes the place of the one that waited. An object
 * that is wanted as it is shown does not change at all.
 */
final class ChoiceQueue {
  /** A choice that is wanted, and what causes it. */
  private record Wanted(int choice, ChoiceCause cause) {}

  private final SwitchTiming timing;
  private final Consumer<ControlEvent> events;
  private final Consumer<ControlProblem> problems;
  private final Map<VersionedObject, Wanted> waiting = new LinkedHashMap<>();

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
  void want(VersionedObject object, int choice, ChoiceCause cause, double time) {
    waiting.remove(object);
    if (choice == object.shown()) {
      return;
    }
    if (timing.mayShow(object.node(), choice)) {
      show(object, choice, cause, time);
    } else {
      waiting.put(object, new Wanted(choice, cause));
    }
  }

  /**
   * Shows the choices that wait and may be shown now, in the order in which they came.
   *
   * @param time time stamp in seconds
   */
  void showDue(double time) {
    Iterator<Map.Entry<VersionedObject, Wanted>> all = waiting.entrySet().iterator();
    Map<VersionedObject, Wanted> due = new LinkedHashMap<>();
    while (all.hasNext()) {
      Map.Entry<VersionedObject, Wanted> one = all.next();
      if (timing.mayShow(one.getKey().node(), one.getValue().choice())) {
        due.put(one.getKey(), one.getValue());
        all.remove();
      }
    }
    due.forEach((object, wanted) -> show(object, wanted.choice(), wanted.cause(), time));
  }

  /** Shows a choice whether it may be seen or not. */
  void show(VersionedObject object, int choice, ChoiceCause cause, double time) {
    int from = object.shown();
    Optional<SwitchVisibility> seen = timing.shows(object.node(), choice);
    object.show(choice).ifPresent(problems);
    events.accept(
        new ControlEvent.SwitchChange(time, object.name(), from, choice, cause, seen));
  }

  /** Drops what waits for an object, because others have set its choice or it is gone. */
  void forget(VersionedObject object) {
    waiting.remove(object);
  }

  /** Returns the choices that wait, by the names of their objects, in the order they came. */
  Map<String, Integer> waiting() {
    Map<String, Integer> choices = new LinkedHashMap<>();
    waiting.forEach((object, wanted) -> choices.put(object.name(), wanted.choice()));
    return choices;
  }
}
