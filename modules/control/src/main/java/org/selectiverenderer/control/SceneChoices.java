package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SchemaActivation.Change;
import org.selectiverenderer.schema.SensorSchemas;
import org.selectiverenderer.schema.SwitchSchemas;

/**
 * Decides what the objects of one scene show, each of their qualities by itself: what the condition
 * or a rule sets once, what the schemas of the entered areas choose, what a budget chooses, and
 * what is held whatever these say.
 */
final class SceneChoices {
  /** Tells the random seeds of qualities apart. */
  private static final long SPREAD = 1_000_003;

  private final Settings settings;
  private final Consumer<ControlProblem> problems;
  private final Collection<ControlledArea> areas;
  private final Collection<VersionedObject> objects;
  private final SchemaActivation<ControlledArea, ControlledChoice> activation =
      new SchemaActivation<>();
  private final Map<String, Integer> held;
  private final ChoiceQueue queue;
  private @Nullable List<ChoosableObject> choosable;
  private long consistencyVersion;

  /**
   * Makes the choices of a scene.
   *
   * @param areas the scene's areas at any time
   * @param objects the scene's objects at any time, in the order of the scene
   * @param queue shows the choices of a walk
   * @param problems receives what is wrong with choices that are set at once
   */
  SceneChoices(
      Settings settings,
      Collection<ControlledArea> areas,
      Collection<VersionedObject> objects,
      ChoiceQueue queue,
      Consumer<ControlProblem> problems) {
    this.settings = settings;
    this.areas = areas;
    this.objects = objects;
    this.queue = queue;
    this.problems = problems;
    held = new HashMap<>(settings.held());
  }

  /**
   * Sets new choices as the condition and the rules of qualities require. Each quality has a random
   * seed of its own, so that another one more does not change which versions are drawn.
   *
   * @param more added to the random seed
   * @param fresh whether the viewer has not seen them yet, so that no choice has to wait
   * @param now time stamp in seconds
   */
  void setOut(
      Collection<? extends ControlledChoice> candidates, int more, boolean fresh, double now) {
    if (!settings.controls()) {
      return;
    }
    Map<Quality, Map<ControlledChoice, SwitchSchemas>> conditional = new EnumMap<>(Quality.class);
    for (ControlledChoice choice : candidates) {
      choice.schemas().ifPresent(schemas -> setOut(choice, schemas, conditional, fresh, now));
    }
    long seed = settings.seed() + more;
    conditional.forEach(
        (quality, choices) ->
            settings
                .condition()
                .initialChoices(choices, activatedSchemas(), seed + SPREAD * quality.ordinal())
                .forEach(this::show));
  }

  private void setOut(
      ControlledChoice choice,
      SwitchSchemas schemas,
      Map<Quality, Map<ControlledChoice, SwitchSchemas>> conditional,
      boolean fresh,
      double now) {
    Quality quality = schemas.quality();
    if (settings.follows(quality)) {
      if (fresh && choice instanceof VersionedObject object) {
        callFor(object, object.shown());
      }
      apply(activation.putSwitch(choice, schemas, choice.shown()).stream().toList(), fresh, now);
    } else if (settings.rule(quality).isPresent()) {
      show(choice, settings.rule(quality).get().choice(schemas));
    } else {
      conditional.computeIfAbsent(quality, key -> new LinkedHashMap<>()).put(choice, schemas);
    }
  }

  private Set<String> activatedSchemas() {
    Set<String> activated = new HashSet<>();
    for (ControlledArea area : areas) {
      area.schemas()
          .ifPresent(
              schemas -> {
                activated.addAll(schemas.enter());
                activated.addAll(schemas.exit());
              });
    }
    return activated;
  }

  /** Returns whether areas change the versions of an object as the viewer walks. */
  boolean follows(SwitchSchemas versions) {
    return settings.follows(versions.quality());
  }

  /** Adds an area or replaces its schemas. */
  void putArea(ControlledArea area, SensorSchemas schemas) {
    activation.putArea(area, schemas);
  }

  /** Removes an area, as if the viewer had left it without its exit schemas. */
  void removeArea(ControlledArea area, double now) {
    apply(activation.removeArea(area), false, now);
  }

  void enter(ControlledArea area, double now) {
    apply(activation.enter(area), false, now);
  }

  void exit(ControlledArea area, double now) {
    apply(activation.exit(area), false, now);
  }

  boolean isEntered(ControlledArea area) {
    return activation.isEntered(area);
  }

  List<String> enteredAreas() {
    return activation.enteredAreas().stream().map(ControlledArea::name).toList();
  }

  List<String> activeSchemas() {
    return activation.activeSchemas();
  }

  /** Records a choice that others have set; it stays until the next activation. */
  void noteShown(ControlledChoice choice) {
    queue.forget(choice);
    activation.noteShown(choice, choice.shown());
  }

  /** Drops a choice that the scene no longer has. */
  void forget(ControlledChoice choice) {
    queue.forget(choice);
    activation.removeSwitch(choice);
  }

  /** Notes that the scene has other objects, or an object other metadata. */
  void objectsChanged() {
    choosable = null;
  }

  /** Notes that the consistency of objects may have changed. */
  void consistencyChanged() {
    consistencyVersion++;
  }

  long consistencyVersion() {
    return consistencyVersion;
  }

  /** Holds the choices of Switches from now on, whether the scene has them yet or not. */
  void hold(Map<String, Integer> choices) {
    held.putAll(choices);
    choosable = null;
  }

  /** Shows the held choice of an object, if it has one. */
  void showHeld(VersionedObject object) {
    Integer choice = held.isEmpty() ? null : held.get(object.name());
    if (choice != null) {
      show(object, choice);
    }
  }

  /** Returns the objects whose versions may be chosen; the same list until others may be. */
  List<ChoosableObject> choosable() {
    List<ChoosableObject> known = choosable;
    if (known == null) {
      known = new ArrayList<>();
      for (VersionedObject object : objects) {
        if (differsInPolygons(object) && !held.containsKey(object.name())) {
          known.add(object);
        }
      }
      known = List.copyOf(known);
      choosable = known;
    }
    return known;
  }

  /** Returns whether the versions differ in their polygons, so that a budget can choose. */
  private static boolean differsInPolygons(VersionedObject object) {
    return object.versions() > 0
        && object
            .schemas()
            .map(SwitchSchemas::quality)
            .filter(Quality.POLYGONS::equals)
            .isPresent();
  }

  /** Shows the version of an object that a budget has chosen. */
  void choose(VersionedObject object, int version, double now) {
    if (!object.chosenFirst()) {
      queue.want(object, version, ChoiceCause.BUDGET, now);
    } else if (version != object.shown()) { // The viewer has not seen it yet.
      queue.show(object, version, ChoiceCause.BUDGET, now);
    }
  }

  /** Shows the choices that wait and may be shown now; returns whether there were any. */
  boolean showDue(double now) {
    return queue.showDue(now);
  }

  /** Returns the choices that wait, by the names of their Switches. */
  Map<String, Integer> waiting() {
    return queue.waiting();
  }

  /** Shows a choice at once and without an event, whatever waits. */
  private void show(ControlledChoice choice, int wanted) {
    queue.forget(choice);
    choice.show(wanted).ifPresent(problems);
  }

  private void callFor(VersionedObject object, int version) {
    object.calledFor(version);
    consistencyVersion++;
  }

  private void apply(List<Change<ControlledChoice>> changes, boolean fresh, double now) {
    if (!settings.controls()) {
      return;
    }
    for (Change<ControlledChoice> change : changes) {
      ControlledChoice choice = change.switchKey();
      if (choice instanceof VersionedObject object) {
        callFor(object, change.to());
        boolean budgeted = settings.budget().isPresent() && differsInPolygons(object);
        if (budgeted || held.containsKey(object.name())) {
          continue; // With a budget areas only tell what is consistent, and the budget chooses.
        }
      }
      if (fresh) {
        queue.show(choice, change.to(), ChoiceCause.of(change.schema()), now);
      } else {
        queue.want(choice, change.to(), ChoiceCause.of(change.schema()), now);
      }
    }
  }
}
