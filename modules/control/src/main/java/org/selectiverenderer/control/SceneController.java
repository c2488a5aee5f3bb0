package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.control.ControlProblem.Severity;
import org.selectiverenderer.control.SceneGraphWatcher.Found;
import org.selectiverenderer.control.SelectiveController.Settings;
import org.selectiverenderer.sai.InlineSceneAccess;
import org.selectiverenderer.sai.NodeNameAccess;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SchemaActivation.Change;
import org.selectiverenderer.schema.SchemaUsage;
import org.selectiverenderer.schema.SchemaUsage.Unmatched;
import org.selectiverenderer.schema.SwitchSchemas;
import org.selectiverenderer.schema.VersionMetadata;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.environmentalsensor.ProximitySensor;
import org.web3d.x3d.sai.grouping.Switch;

/** Controls one scene, from the start of its control to the end. */
final class SceneController implements ControlledArea.Listener {
  private final ListenerLock turn;
  private final Settings settings;
  private final Consumer<ControlEvent> events;
  private final Consumer<ControlProblem> problems;
  private final NodeNameRegistry names = new NodeNameRegistry();
  private final SchemaCache cache = new SchemaCache();
  private final @Nullable InlineSceneAccess inlined;
  private final SceneGraphWatcher walk;
  private final SchemaActivation<ControlledArea, VersionedObject> activation =
      new SchemaActivation<>();
  private final Map<X3DNode, ControlledArea> areas = new LinkedHashMap<>();
  private final Map<X3DNode, VersionedObject> objects = new LinkedHashMap<>();
  private final Map<String, Integer> held;
  private boolean started;
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
      Consumer<ControlEvent> events,
      Consumer<ControlProblem> problems) {
    this.turn = turn;
    this.settings = settings;
    held = new HashMap<>(settings.held());
    this.events = events;
    this.problems = problems;
    this.inlined = inlined;
    this.walk =
        new SceneGraphWatcher(
            scene,
            inlined,
            bodies,
            namesAccess,
            Set.of("Switch", "ProximitySensor"),
            turn,
            this::changed);
  }

  /** Reads the scene, sets the choices of the condition, and reports the start. */
  void start() {
    walk.rescan(now);
    setOut(objects.values(), settings.seed());
    started = true;
    problems().forEach(problems);
    UnmatchedSchemaCheck.of(areas.values(), objects.values()).forEach(problems);
    if (inlined == null) {
      closedInlines().ifPresent(problems);
    }
    events.accept(new ControlEvent.Start(now, choices()));
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
  }

  /** Removes all listeners from the scene. */
  void close() {
    turn.end();
    walk.close();
    areas.values().forEach(ControlledArea::close);
    objects.values().forEach(VersionedObject::close);
  }

  /** Holds the choices of Switches; returns the names that no Switch has. */
  Set<String> hold(Map<String, Integer> choices) {
    held.putAll(choices);
    Set<String> missing = new LinkedHashSet<>(choices.keySet());
    for (VersionedObject object : objects.values()) {
      if (missing.remove(object.name())) {
        hold(object);
      }
    }
    return missing;
  }

  private void hold(VersionedObject object) {
    Integer choice = held.get(object.name());
    if (choice != null) {
      show(object, choice);
    }
  }

  List<ControlProblem> problems() {
    List<ControlProblem> all = new ArrayList<>();
    areas.values().forEach(area -> all.addAll(area.problems()));
    objects.values().forEach(object -> all.addAll(object.problems()));
    return all;
  }

  List<String> enteredAreas() {
    return activation.enteredAreas().stream().map(ControlledArea::name).toList();
  }

  List<String> activeSchemas() {
    return activation.activeSchemas();
  }

  Map<String, Integer> choices() {
    Map<String, Integer> choices = new LinkedHashMap<>();
    for (VersionedObject object : objects.values()) {
      if (object.schemas().isPresent()) {
        choices.put(object.name(), object.shown());
      }
    }
    return choices;
  }

  @Override
  public void entered(ControlledArea area, double time) {
    now = time;
    // A browser that delivers events late may still send the event of an entry that was already
    // read from the sensor.
    if (area.schemas().isPresent() && !activation.isEntered(area)) {
      events.accept(new ControlEvent.Enter(time, area.name(), area.schemas().get().enter()));
      apply(activation.enter(area));
    }
  }

  @Override
  public void left(ControlledArea area, double time) {
    now = time;
    if (area.schemas().isPresent() && activation.isEntered(area)) {
      events.accept(new ControlEvent.Exit(time, area.name(), area.schemas().get().exit()));
      apply(activation.exit(area));
    }
  }

  @Override
  public void metadataChanged(ControlledArea area, double time) {
    now = time;
    boolean known = area.schemas().isPresent();
    List<ControlProblem> before = area.problems();
    area.read();
    reportNew(before, area.problems());
    if (area.schemas().isEmpty()) {
      apply(activation.removeArea(area));
      return;
    }
    activation.putArea(area, area.schemas().get());
    if (!known) {
      enterIfInside(area);
    }
  }

  private void objectChanged(VersionedObject object, double time) {
    now = time;
    boolean known = object.schemas().isPresent();
    List<ControlProblem> before = object.problems();
    object.read();
    reportNew(before, object.problems());
    if (object.schemas().isEmpty()) {
      activation.removeSwitch(object);
    } else if (!known || settings.condition().switches()) {
      setOut(List.of(object), settings.seed() + objects.size());
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
    activation.noteShown(object, object.shown());
  }

  private void changed(List<Found> found, List<X3DNode> lost, double time) {
    now = time;
    found.forEach(one -> names.add(one.node(), one.scope()));
    List<ControlledArea> foundAreas = new ArrayList<>();
    List<VersionedObject> foundObjects = new ArrayList<>();
    for (Found one : found) {
      X3DNode node = one.node();
      if (node instanceof ProximitySensor sensor) {
        ControlledArea area = new ControlledArea(sensor, () -> names.of(node), turn, cache, this);
        areas.put(node, area);
        area.schemas().ifPresent(schemas -> activation.putArea(area, schemas));
        foundAreas.add(area);
      } else if (node instanceof Switch versions) {
        VersionedObject object =
            new VersionedObject(
                versions,
                () -> names.of(node),
                turn,
                cache,
                this::objectChanged,
                this::choiceChanged);
        objects.put(node, object);
        foundObjects.add(object);
      }
    }
    lost.forEach(this::forget);
    if (started) {
      foundAreas.forEach(area -> reportNew(List.of(), area.problems()));
      foundObjects.forEach(object -> reportNew(List.of(), object.problems()));
      setOut(foundObjects, settings.seed() + objects.size());
      foundAreas.forEach(this::enterIfInside);
    }
  }

  private void forget(X3DNode node) {
    VersionedObject object = objects.remove(node);
    if (object != null) {
      object.close();
      activation.removeSwitch(object);
    }
    ControlledArea area = areas.remove(node);
    if (area != null) {
      area.close();
      apply(activation.removeArea(area));
    }
    names.remove(node);
  }

  /** Enters an area if the viewer is in it already, since its sensor will send no entry event. */
  private void enterIfInside(ControlledArea area) {
    if (area.active()) {
      entered(area, Math.max(now, area.lastEntry()));
    }
  }

  /** Sets new objects to the choices that the condition requires. */
  private void setOut(Collection<VersionedObject> candidates, long seed) {
    if (!settings.controls()) {
      return;
    }
    Map<VersionedObject, SwitchSchemas> enriched = new LinkedHashMap<>();
    for (VersionedObject object : candidates) {
      object.schemas().ifPresent(schemas -> enriched.put(object, schemas));
    }
    if (settings.condition().switches()) {
      enriched.forEach(
          (object, schemas) ->
              apply(activation.putSwitch(object, schemas, object.shown()).stream().toList()));
    } else {
      settings.condition().initialChoices(enriched, activatedSchemas(), seed).forEach(this::show);
    }
    if (!held.isEmpty()) {
      candidates.forEach(this::hold);
    }
  }

  private Set<String> activatedSchemas() {
    Set<String> activated = new HashSet<>();
    for (ControlledArea area : areas.values()) {
      area.schemas()
          .ifPresent(
              schemas -> {
                activated.addAll(schemas.enter());
                activated.addAll(schemas.exit());
              });
    }
    return activated;
  }

  private void show(VersionedObject object, int choice) {
    Optional<ControlProblem> failure = object.show(choice);
    if (started) { // otherwise reported with the others
      failure.ifPresent(problems);
    }
  }

  private void apply(List<Change<VersionedObject>> changes) {
    if (!settings.controls()) {
      return;
    }
    for (Change<VersionedObject> change : changes) {
      VersionedObject object = change.switchKey();
      if (held.containsKey(object.name())) {
        continue;
      }
      show(object, change.to());
      events.accept(
          new ControlEvent.SwitchChange(
              now, object.name(), change.from(), change.to(), change.schema()));
    }
  }

  /**
   * Finds schemas without effect: those that only areas or only objects name. They may be intended,
   * so they are reported as remarks, or as warnings if the other side has a nearly equal name.
   */
  private static final class UnmatchedSchemaCheck {
    private record Namer(String name, X3DNode node) {}

    private UnmatchedSchemaCheck() {}

    /** Returns one problem for each such schema, at the first node that names it. */
    static List<ControlProblem> of(
        Collection<ControlledArea> areas, Collection<VersionedObject> objects) {
      SchemaUsage<Namer> use = new SchemaUsage<>();
      for (ControlledArea area : areas) {
        Namer namer = new Namer(area.name(), area.sensor());
        area.schemas().ifPresent(schemas -> use.area(namer, schemas));
      }
      for (VersionedObject object : objects) {
        Namer namer = new Namer(object.name(), object.node());
        List<List<String>> schemas =
            object.schemas().stream()
                .flatMap(all -> all.choices().stream())
                .map(VersionMetadata::schemas)
                .toList();
        use.object(namer, schemas, object.atStart());
      }
      return use.unmatched().stream().map(UnmatchedSchemaCheck::problem).toList();
    }

    private static ControlProblem problem(Unmatched<Namer> unmatched) {
      Namer namer = unmatched.node();
      return unmatched.meant().isPresent()
          ? ControlProblem.warning(namer.name(), namer.node(), unmatched.message())
          : new ControlProblem(namer.name(), namer.node(), Severity.INFO, unmatched.message());
    }
  }
}
