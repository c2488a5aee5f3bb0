package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.EnumSet;
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
import org.selectiverenderer.schema.Quality;
import org.selectiverenderer.schema.SchemaActivation;
import org.selectiverenderer.schema.SchemaActivation.Change;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.environmentalsensor.ProximitySensor;
import org.web3d.x3d.sai.grouping.Switch;

/** Controls one scene, from the start of its control to the end. */
final class SceneController implements ControlledArea.Listener {
  /** Tells the random seeds of qualities apart. */
  private static final long SPREAD = 1_000_003;

  private final ListenerLock turn;
  private final Settings settings;
  private final Consumer<ControlEvent> events;
  private final Consumer<ControlProblem> problems;
  private final NodeNameRegistry names = new NodeNameRegistry();
  private final SchemaCache cache = new SchemaCache();
  private final @Nullable InlineSceneAccess inlined;
  private final SceneGraphWatcher walk;
  private final SchemaActivation<ControlledArea, ControlledChoice> activation =
      new SchemaActivation<>();
  private final Map<X3DNode, ControlledArea> areas = new LinkedHashMap<>();
  private final Map<X3DNode, VersionedObject> objects = new LinkedHashMap<>();
  private final Map<String, Integer> held;
  private final ChoiceQueue queue;
  private @Nullable List<ChoosableObject> choosable;
  private long consistencyVersion;
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
      SwitchTiming timing,
      Consumer<ControlEvent> events,
      Consumer<ControlProblem> problems) {
    this.turn = turn;
    this.settings = settings;
    held = new HashMap<>(settings.held());
    this.events = events;
    this.problems = problems;
    queue = new ChoiceQueue(timing, events, problems);
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
    setOut(choicesOf(objects.values()), settings.seed(), true);
    objects.values().forEach(this::hold);
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
    choosable = null;
    Set<String> missing = new LinkedHashSet<>(choices.keySet());
    for (VersionedObject object : objects.values()) {
      if (missing.remove(object.name())) {
        hold(object);
      }
    }
    return missing;
  }

  private void hold(VersionedObject object) {
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
      for (VersionedObject object : objects.values()) {
        if (differsInPolygons(object) && !held.containsKey(object.name())) {
          known.add(object);
        }
      }
      known = List.copyOf(known);
      choosable = known;
    }
    return known;
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

  /** Returns whether the versions differ in their polygons, so that a budget can choose. */
  private static boolean differsInPolygons(VersionedObject object) {
    return object.versions() > 0
        && object
            .schemas()
            .map(SwitchSchemas::quality)
            .filter(Quality.POLYGONS::equals)
            .isPresent();
  }

  private void callFor(VersionedObject object, int version) {
    object.calledFor(version);
    consistencyVersion++;
  }

  long consistencyVersion() {
    return consistencyVersion;
  }

  /** Shows the version of an object that a budget has chosen. */
  void choose(ChoosableObject chosen, int version, double time) {
    if (chosen instanceof VersionedObject object && objects.get(object.node()) == object) {
      now = Math.max(now, time);
      if (!object.chosenFirst()) {
        queue.want(object, version, ChoiceCause.BUDGET, now);
      } else if (version != object.shown()) { // The viewer has not seen it yet.
        queue.show(object, version, ChoiceCause.BUDGET, now);
      }
    }
  }

  /** Shows the choices that wait and may be shown now. */
  void showDue(double time) {
    now = Math.max(now, time);
    queue.showDue(now);
  }

  /** Returns the choices that wait, by the names of their Switches. */
  Map<String, Integer> waiting() {
    return queue.waiting();
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
    object.fields().forEach(this::forget);
    object.read();
    choosable = null;
    consistencyVersion++;
    reportNew(before, object.problems());
    List<ControlledChoice> choices = new ArrayList<>(object.fields());
    if (object.schemas().isEmpty()) {
      forget((ControlledChoice) object);
    } else if (!known || settings.follows(object.schemas().get().quality())) {
      choices.add(0, object);
    }
    setOut(choices, settings.seed() + objects.size(), !known);
    hold(object);
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
    queue.forget(object);
    activation.noteShown(object, object.shown());
  }

  /** Records the value of a field that others have set; it stays until the next activation. */
  private void levelChanged(ControlledField field, int from, double time) {
    if (!settings.controls()) {
      now = time;
      events.accept(field.change(time, from, field.shown(), ChoiceCause.SCENE, Optional.empty()));
    }
    queue.forget(field);
    activation.noteShown(field, field.shown());
  }

  private void changed(List<Found> found, List<X3DNode> lost, double time) {
    now = time;
    choosable = null;
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
      setOut(choicesOf(foundObjects), settings.seed() + objects.size(), true);
      foundObjects.forEach(this::hold);
      foundAreas.forEach(this::enterIfInside);
    }
  }

  private void forget(X3DNode node) {
    VersionedObject object = objects.remove(node);
    if (object != null) {
      object.close();
      forget((ControlledChoice) object);
      object.fields().forEach(this::forget);
    }
    ControlledArea area = areas.remove(node);
    if (area != null) {
      area.close();
      apply(activation.removeArea(area));
    }
    names.remove(node);
  }

  private void forget(ControlledChoice choice) {
    queue.forget(choice);
    activation.removeSwitch(choice);
  }

  /** Enters an area if the viewer is in it already, since its sensor will send no entry event. */
  private void enterIfInside(ControlledArea area) {
    if (area.active()) {
      entered(area, Math.max(now, area.lastEntry()));
    }
  }

  /** Returns the objects, each followed by its fields. */
  private static List<ControlledChoice> choicesOf(Collection<VersionedObject> objects) {
    List<ControlledChoice> choices = new ArrayList<>();
    for (VersionedObject object : objects) {
      choices.add(object);
      choices.addAll(object.fields());
    }
    return choices;
  }

  /**
   * Sets new choices as the condition and the rules of qualities require. Each quality has a random
   * seed of its own, so that another one more does not change which versions are drawn.
   *
   * @param fresh whether the viewer has not seen them yet, so that no choice has to wait
   */
  private void setOut(Collection<? extends ControlledChoice> candidates, long seed, boolean fresh) {
    if (!settings.controls()) {
      return;
    }
    Map<Quality, Map<ControlledChoice, SwitchSchemas>> conditional = new EnumMap<>(Quality.class);
    for (ControlledChoice choice : candidates) {
      choice.schemas().ifPresent(schemas -> setOut(choice, schemas, conditional, fresh));
    }
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
      boolean fresh) {
    Quality quality = schemas.quality();
    if (settings.follows(quality)) {
      if (fresh && choice instanceof VersionedObject object) {
        callFor(object, object.shown());
      }
      apply(activation.putSwitch(choice, schemas, choice.shown()).stream().toList(), fresh);
    } else if (settings.rule(quality).isPresent()) {
      show(choice, settings.rule(quality).get().choice(schemas));
    } else {
      conditional.computeIfAbsent(quality, key -> new LinkedHashMap<>()).put(choice, schemas);
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

  /** Shows a choice at once and without an event, whatever waits. */
  private void show(ControlledChoice choice, int wanted) {
    queue.forget(choice);
    Optional<ControlProblem> failure = choice.show(wanted);
    if (started) { // otherwise reported with the others
      failure.ifPresent(problems);
    }
  }

  private void apply(List<Change<ControlledChoice>> changes) {
    apply(changes, false);
  }

  private void apply(List<Change<ControlledChoice>> changes, boolean fresh) {
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
