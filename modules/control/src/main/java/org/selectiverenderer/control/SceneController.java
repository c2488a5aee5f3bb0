package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.control.ControlProblem.Severity;
import org.selectiverenderer.control.SceneGraphWatcher.Found;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.selectiverenderer.sai.NodeNameAccess;
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.environmentalsensor.ProximitySensor;
import org.web3d.x3d.sai.grouping.Switch;

/**
 * Follows one scene, from the start of its control to the end: finds its areas and objects, listens
 * to them, and tells {@link SceneChoices}, which decides what the objects show.
 */
final class SceneController implements ControlledArea.Listener {
  private final ListenerLock turn;
  private final Settings settings;
  private final Consumer<ControlEvent> events;
  private final Consumer<ControlProblem> problems;
  private final NodeNameRegistry names = new NodeNameRegistry();
  private final SchemaCache cache = new SchemaCache();
  private final @Nullable InlineSceneAccess inlined;
  private final SceneGraphWatcher walk;
  private final Map<X3DNode, ControlledArea> areas = new LinkedHashMap<>();
  private final Map<X3DNode, VersionedObject> objects = new LinkedHashMap<>();
  private final SceneChoices choices;
  private boolean started;
  private long levelsVersion;
  private boolean nodesChanged;
  private boolean fieldsMissing;
  private double now;

  /**
   * @param turn the lock of all listeners
   * @param inlined gives access to the scenes of Inlines; null where the browser does not
   * @param bodies maps prototype instances to the first nodes of their bodies, and other nodes to
   *     themselves
   * @param namesAccess tells the names of nodes; null where the browser does not
   */
  SceneController(
      X3DExecutionContext scene,
      ListenerLock turn,
      @Nullable InlineSceneAccess inlined,
      UnaryOperator<X3DNode> bodies,
      @Nullable NodeNameAccess namesAccess,
      Settings settings,
      SwitchTiming timing,
      Consumer<ControlEvent> events,
      Consumer<ControlProblem> problems) {
    this.turn = turn;
    this.settings = settings;
    this.events = events;
    this.problems = problems;
    choices =
        new SceneChoices(
            settings,
            Collections.unmodifiableCollection(areas.values()),
            Collections.unmodifiableCollection(objects.values()),
            new ChoiceQueue(timing, events, problems),
            this::reportOnceStarted);
    this.inlined = inlined;
    this.walk =
        new SceneGraphWatcher(
            scene,
            inlined,
            bodies,
            namesAccess,
            Set.of("Switch", "ProximitySensor"),
            turn,
            new SceneGraphWatcher.Listener() {
              @Override
              public void changed(List<Found> found, List<X3DNode> lost, double time) {
                SceneController.this.changed(found, lost, time);
              }

              @Override
              public void nodesChanged() {
                nodesChanged = true;
              }
            });
  }

  /** Reads the scene, sets the choices of the condition, and reports the start. */
  void start() {
    walk.rescan(now);
    choices.setOut(choicesOf(objects.values()), 0, true, now);
    objects.values().forEach(choices::showHeld);
    started = true;
    problems().forEach(problems);
    UnmatchedSchemaCheck.of(areas.values(), objects.values()).forEach(problems);
    if (inlined == null) {
      closedInlines().ifPresent(problems);
    }
    events.accept(new ControlEvent.Start(now, choices(), levels()));
    areas.values().forEach(this::enterIfInside);
  }

  /**
   * Returns a remark about Inlines whose scenes cannot be controlled. Inlines that are versions of
   * an enriched object do not count, because they usually contain no enriched objects themselves.
   */
  private Optional<ControlProblem> closedInlines() {
    List<X3DNode> closed =
        walk.inlinesOutside(
            node -> objects.containsKey(node) && objects.get(node).schemas().isPresent());
    return closed.stream()
        .findFirst()
        .map(
            first ->
                new ControlProblem(
                    closed.size() == 1 ? "Inline" : closed.size() + " Inlines",
                    first,
                    Severity.INFO,
                    "this browser does not show nodes inside Inlines: enriched ones do not change "
                        + "and their areas are not sensed"));
  }

  /** Looks for changes of the scene's root nodes. */
  void rescan() {
    walk.rescan(now);
    lookForFields();
  }

  /**
   * Looks again for the nodes whose fields are qualities, if there may be others. It does so once a
   * frame at most, since thousands of files may come one after the other.
   */
  private void lookForFields() {
    if (!nodesChanged) {
      return;
    }
    nodesChanged = false;
    fieldsMissing = false;
    List<ControlledField> found = new ArrayList<>();
    for (VersionedObject object : objects.values()) {
      if (object.fieldsMayDiffer()) {
        List<ControlledField> before = object.fields();
        List<ControlProblem> known = object.problems();
        object.findFields();
        before.stream().filter(f -> !object.fields().contains(f)).forEach(choices::forget);
        object.fields().stream().filter(f -> !before.contains(f)).forEach(found::add);
        reportNew(known, object.problems());
        fieldsMissing |= object.fieldsMissing();
      }
    }
    levelsVersion++;
    choices.setOut(found, objects.size(), true, now);
  }

  /** Removes all listeners from the scene. */
  void close() {
    turn.end();
    walk.close();
    areas.values().forEach(ControlledArea::close);
    objects.values().forEach(VersionedObject::close);
  }

  /** Holds the choices of Switches; returns the names that no Switch has. */
  Set<String> hold(Map<String, Integer> wanted) {
    choices.hold(wanted);
    Set<String> missing = new LinkedHashSet<>(wanted.keySet());
    for (VersionedObject object : objects.values()) {
      if (missing.remove(object.name())) {
        choices.showHeld(object);
      }
    }
    return missing;
  }

  /** Returns the objects whose versions may be chosen; the same list until others may be. */
  List<ChoosableObject> choosable() {
    return choices.choosable();
  }

  /** Returns the qualities in which versions and fields of the scene's objects differ. */
  Set<Quality> qualities() {
    Set<Quality> found = EnumSet.noneOf(Quality.class);
    choicesOf(objects.values()).stream()
        .flatMap(choice -> choice.schemas().stream())
        .map(SwitchSchemas::quality)
        .forEach(found::add);
    return found;
  }

  long consistencyVersion() {
    return choices.consistencyVersion();
  }

  /** Shows the version of an object that a budget has chosen. */
  void choose(ChoosableObject chosen, int version, double time) {
    if (chosen instanceof VersionedObject object && objects.get(object.node()) == object) {
      now = Math.max(now, time);
      choices.choose(object, version, now);
    }
  }

  /** Shows the choices that wait and may be shown now. */
  void showDue(double time) {
    now = Math.max(now, time);
    lookForFields();
    if (choices.showDue(now)) {
      levelsVersion++;
    }
  }

  /** Returns the choices that wait, by the names of their Switches. */
  Map<String, Integer> waiting() {
    return choices.waiting();
  }

  List<ControlProblem> problems() {
    List<ControlProblem> all = new ArrayList<>();
    areas.values().forEach(area -> all.addAll(area.problems()));
    objects.values().forEach(object -> all.addAll(object.problems()));
    return all;
  }

  List<String> enteredAreas() {
    return choices.enteredAreas();
  }

  List<String> activeSchemas() {
    return choices.activeSchemas();
  }

  Map<String, Integer> choices() {
    Map<String, Integer> shown = new LinkedHashMap<>();
    for (VersionedObject object : objects.values()) {
      if (object.schemas().isPresent()) {
        shown.put(object.name(), object.shown());
      }
    }
    return shown;
  }

  /** Returns the levels of the objects' fields, by the names of objects and fields. */
  private Map<String, Map<String, Integer>> levels() {
    Map<String, Map<String, Integer>> levels = new LinkedHashMap<>();
    for (VersionedObject object : objects.values()) {
      for (ControlledField field : object.fields()) {
        levels
            .computeIfAbsent(object.name(), name -> new LinkedHashMap<>())
            .put(field.target().toString(), field.shown());
      }
    }
    return levels;
  }

  /** Returns the number of fields that have each level, by quality. */
  Map<Quality, Map<Integer, Integer>> levelCounts() {
    Map<Quality, Map<Integer, Integer>> counts = new EnumMap<>(Quality.class);
    for (VersionedObject object : objects.values()) {
      for (ControlledField field : object.fields()) {
        counts
            .computeIfAbsent(field.quality().quality(), quality -> new TreeMap<>())
            .merge(field.shown(), 1, Integer::sum);
      }
    }
    return counts;
  }

  long levelsVersion() {
    return levelsVersion;
  }

  @Override
  public void entered(ControlledArea area, double time) {
    now = time;
    levelsVersion++;
    // A browser that delivers events late may still send the event of an entry that was already
    // read from the sensor.
    if (area.schemas().isPresent() && !choices.isEntered(area)) {
      nodesChanged |= fieldsMissing; // Names are given to nodes without an event.
      lookForFields();
      events.accept(new ControlEvent.Enter(time, area.name(), area.schemas().get().enter()));
      choices.enter(area, now);
    }
  }

  @Override
  public void left(ControlledArea area, double time) {
    now = time;
    levelsVersion++;
    if (area.schemas().isPresent() && choices.isEntered(area)) {
      nodesChanged |= fieldsMissing; // Names are given to nodes without an event.
      lookForFields();
      events.accept(new ControlEvent.Exit(time, area.name(), area.schemas().get().exit()));
      choices.exit(area, now);
    }
  }

  @Override
  public void metadataChanged(ControlledArea area, double time) {
    now = time;
    levelsVersion++;
    boolean known = area.schemas().isPresent();
    List<ControlProblem> before = area.problems();
    area.read();
    reportNew(before, area.problems());
    if (area.schemas().isEmpty()) {
      choices.removeArea(area, now);
      return;
    }
    choices.putArea(area, area.schemas().get());
    if (!known) {
      enterIfInside(area);
    }
  }

  private void objectChanged(VersionedObject object, double time) {
    now = time;
    levelsVersion++;
    boolean known = object.schemas().isPresent();
    List<ControlProblem> before = object.problems();
    object.fields().forEach(choices::forget);
    object.read();
    choices.objectsChanged();
    choices.consistencyChanged();
    reportNew(before, object.problems());
    List<ControlledChoice> anew = new ArrayList<>(object.fields());
    if (object.schemas().isEmpty()) {
      choices.forget(object);
    } else if (!known || choices.follows(object.schemas().get())) {
      anew.add(0, object);
    }
    choices.setOut(anew, objects.size(), !known, now);
    choices.showHeld(object);
  }

  /** Reports a problem; one before the start is reported with the others. */
  private void reportOnceStarted(ControlProblem problem) {
    if (started) {
      problems.accept(problem);
    }
  }

  private void reportNew(List<ControlProblem> before, List<ControlProblem> now) {
    now.stream().filter(problem -> !before.contains(problem)).forEach(problems);
  }

  /**
   * Records a choice that a ROUTE, an application or a script has set; it stays until the next
   * activation.
   */
  private void choiceChanged(VersionedObject object, int from, double time) {
    if (!settings.controls() && object.schemas().isPresent()) {
      now = time;
      events.accept(new ControlEvent.SwitchChange(time, object.name(), from, object.shown(), ""));
    }
    choices.noteShown(object);
  }

  /** Records the value of a field that others have set; it stays until the next activation. */
  private void levelChanged(ControlledField field, int from, double time) {
    levelsVersion++;
    if (!settings.controls()) {
      now = time;
      events.accept(field.change(time, from, field.shown(), ChoiceCause.SCENE, Optional.empty()));
    }
    choices.noteShown(field);
  }

  private void changed(List<Found> found, List<X3DNode> lost, double time) {
    now = time;
    levelsVersion++;
    choices.objectsChanged();
    found.forEach(one -> names.add(one.node(), one.scope()));
    List<ControlledArea> foundAreas = new ArrayList<>();
    List<VersionedObject> foundObjects = new ArrayList<>();
    for (Found one : found) {
      X3DNode node = one.node();
      if (node instanceof ProximitySensor sensor) {
        ControlledArea area = new ControlledArea(sensor, () -> names.of(node), turn, cache, this);
        areas.put(node, area);
        area.schemas().ifPresent(schemas -> choices.putArea(area, schemas));
        foundAreas.add(area);
      } else if (node instanceof Switch versions) {
        VersionedObject object =
            new VersionedObject(
                versions,
                one.scope(),
                () -> names.of(node),
                turn,
                cache,
                this::objectChanged,
                this::choiceChanged,
                this::levelChanged);
        objects.put(node, object);
        foundObjects.add(object);
      }
    }
    lost.forEach(this::forget);
    if (started) {
      foundAreas.forEach(area -> reportNew(List.of(), area.problems()));
      foundObjects.forEach(object -> reportNew(List.of(), object.problems()));
      choices.setOut(choicesOf(foundObjects), objects.size(), true, now);
      foundObjects.forEach(choices::showHeld);
      foundAreas.forEach(this::enterIfInside);
    }
  }

  private void forget(X3DNode node) {
    VersionedObject object = objects.remove(node);
    if (object != null) {
      object.close();
      choices.forget(object);
      object.fields().forEach(choices::forget);
    }
    ControlledArea area = areas.remove(node);
    if (area != null) {
      area.close();
      choices.removeArea(area, now);
    }
    names.remove(node);
  }

  /** Enters an area if the viewer is in it already, since its sensor will send no entry event. */
  private void enterIfInside(ControlledArea area) {
    if (area.active()) {
      entered(area, Math.max(now, area.lastEntry()));
    }
  }

  /** Returns the objects, each followed by its fields. */
  private static List<ControlledChoice> choicesOf(Collection<VersionedObject> objects) {
    List<ControlledChoice> all = new ArrayList<>();
    for (VersionedObject object : objects) {
      all.add(object);
      all.addAll(object.fields());
    }
    return all;
  }
}
