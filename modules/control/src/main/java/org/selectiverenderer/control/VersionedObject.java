package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ObjDoubleConsumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.schema.SchemaProblem;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.grouping.Switch;

/**
 * An enriched object: a Switch whose children are the object's versions, described by its metadata,
 * and the fields whose values are further qualities of the object.
 */
final class VersionedObject implements ChoosableObject, ControlledChoice {
  /** Receives the choices that somebody else has set. */
  interface ChoiceListener {
    /**
     * Somebody else has set the choice.
     *
     * @param from the choice before
     * @param time stamp in seconds
     */
    void changed(VersionedObject object, int from, double time);
  }

  private final Switch node;
  private final SceneScope scope;
  private final ListenerLock turn;
  private final ControlledField.LevelListener onForeignLevel;
  private final Supplier<String> name;

  /** The name once it was asked for, since it is permanent. */
  private @Nullable String known;

  private final X3DField children;
  private final X3DFieldEventListener onChildren;
  private final X3DField whichChoice;
  private final X3DFieldEventListener onChoice;
  private final MetadataWatcher watch;
  private final SchemaCache cache;

  /** The controller's own writes whose events have not come yet, oldest first. */
  private List<Integer> pending = List.of();

  private List<ControlProblem> problems = List.of();
  private Optional<SwitchSchemas> schemas = Optional.empty();
  private List<FieldQuality> qualities = List.of();
  private List<ControlledField> fields = List.of();
  private List<ControlProblem> fieldProblems = List.of();
  private final int atStart;
  private int shown;
  private int called;
  private double consistency;
  private boolean chosen;

  /**
   * Reads an object in its present state.
   *
   * @param scope the file of the Switch, whose nodes the field qualities name
   * @param cache reads the metadata
   * @param onChange called when the metadata or the number of versions has changed
   */
  VersionedObject(
      Switch node,
      SceneScope scope,
      Supplier<String> name,
      ListenerLock turn,
      SchemaCache cache,
      ObjDoubleConsumer<VersionedObject> onChange,
      ChoiceListener onForeignChoice,
      ControlledField.LevelListener onForeignLevel) {
    this.node = node;
    this.scope = scope;
    this.turn = turn;
    this.onForeignLevel = onForeignLevel;
    this.name = name;
    this.cache = cache;
    this.atStart = node.getWhichChoice();
    this.shown = atStart;
    this.children = node.getField("children");
    this.onChildren = event -> turn.take(() -> onChange.accept(this, event.getTime()));
    this.watch = new MetadataWatcher(node, scope, turn, time -> onChange.accept(this, time));
    this.whichChoice = node.getField("whichChoice");
    this.onChoice = event -> turn.take(() -> choiceChanged(event.getTime(), onForeignChoice));
    children.addX3DEventListener(onChildren);
    whichChoice.addX3DEventListener(onChoice);
    read();
  }

  /**
   * Handles an event of {@code whichChoice}, whose value may already be that of a later write. A
   * browser whose writes take effect late sends the events of the controller's writes one after the
   * other: until the last one has come, the record is ahead of the field.
   */
  private void choiceChanged(double time, ChoiceListener onForeignChoice) {
    int choice = node.getWhichChoice();
    int own = pending.indexOf(choice);
    if (own >= 0 && own < pending.size() - 1) {
      pending = List.copyOf(pending.subList(own + 1, pending.size()));
      return;
    }
    pending = List.of();
    if (choice != shown) {
      int from = shown;
      shown = choice;
      onForeignChoice.changed(this, from, time);
    }
  }

  /** Reads the metadata anew. */
  void read() {
    problems = List.of();
    Consumer<SchemaProblem> warning =
        problem ->
            add(
                ControlProblem.warning(
                    name(), ((SaiMetadata) problem.metadata()).node(), problem.message()));
    Optional<SaiMetadata> metadata = watch.read();
    schemas = metadata.flatMap(m -> cache.object(m, node.getNumChildren(), warning));
    fields.forEach(ControlledField::close);
    fields = List.of();
    qualities = metadata.map(new SchemaReader(warning)::fieldQualities).orElse(List.of());
    findFields();
    calledFor(called);
  }

  /** Returns whether a field that is a quality has not been found. */
  boolean fieldsMissing() {
    return fields.size() < qualities.size();
  }

  /** Returns whether a node may have come, or been replaced, whose field is a quality. */
  boolean fieldsMayDiffer() {
    return fieldsMissing() || fields.stream().anyMatch(field -> field.replaced(scope));
  }

  /** Looks for the nodes whose fields are qualities; keeps the fields whose nodes are the same. */
  void findFields() {
    if (qualities.isEmpty()) { // as most objects have none
      fieldProblems = List.of();
      return;
    }
    List<ControlProblem> wrong = new ArrayList<>();
    List<ControlledField> found = new ArrayList<>();
    for (FieldQuality quality : qualities) {
      Optional<ControlledField> known =
          fields.stream()
              .filter(field -> field.quality() == quality && !field.replaced(scope))
              .findFirst();
      known
          .or(
              () ->
                  ControlledField.find(
                      this,
                      scope,
                      quality,
                      turn,
                      onForeignLevel,
                      message -> wrong.add(ControlProblem.warning(name(), node, message))))
          .ifPresent(found::add);
    }
    fields.stream().filter(field -> !found.contains(field)).forEach(ControlledField::close);
    fields = List.copyOf(found);
    fieldProblems = List.copyOf(wrong);
  }

  /** Returns the fields whose values are qualities of the object. */
  List<ControlledField> fields() {
    return fields;
  }

  String name() {
    String now = known;
    if (now == null) {
      now = name.get();
      known = now;
    }
    return now;
  }

  /**
   * Returns the schemas of the versions; empty if the metadata does not use the vocabulary, so that
   * the Switch is no enriched object.
   */
  @Override
  public Optional<SwitchSchemas> schemas() {
    return schemas;
  }

  /** Returns the initial choice of the scene. */
  int atStart() {
    return atStart;
  }

  /**
   * Returns the choice that was last set, by the controller or others; initially that of the scene.
   */
  @Override
  public int shown() {
    return shown;
  }

  /**
   * Sets {@code whichChoice}, unless it is set already.
   *
   * @return the problem if it could not be set
   */
  @Override
  public Optional<ControlProblem> show(int choice) {
    if (choice == shown) {
      return Optional.empty();
    }
    shown = choice;
    List<Integer> before = pending;
    pending =
        before.isEmpty()
            ? List.of(choice)
            : Stream.concat(before.stream(), Stream.of(choice)).toList();
    try {
      node.setWhichChoice(choice);
      return Optional.empty();
    } catch (X3DException e) { // one disposed Switch must not stop the others
      pending = before;
      ControlProblem problem =
          ControlProblem.warning(
              name(), node, "whichChoice cannot be set to " + choice + ": " + e.getMessage());
      add(problem);
      return Optional.of(problem);
    }
  }

  @Override
  public int child(int choice) {
    return choice;
  }

  @Override
  public ControlEvent change(
      double time, int from, int to, ChoiceCause cause, Optional<SwitchVisibility> seen) {
    return new ControlEvent.SwitchChange(time, name(), from, to, cause, seen);
  }

  private void add(ControlProblem problem) {
    if (problems.isEmpty()) {
      problems = new ArrayList<>(); // few objects have problems
    }
    problems.add(problem);
  }

  @Override
  public Switch node() {
    return node;
  }

  @Override
  public int versions() {
    return schemas.isPresent() ? schemas.get().choices().size() : 0;
  }

  @Override
  public double consistency() {
    return consistency;
  }

  /** Notes the version that the areas call for, whose degree is the object's consistency now. */
  void calledFor(int version) {
    called = version;
    consistency =
        called >= 0 && called < versions()
            ? schemas.orElseThrow().choices().get(called).consistency()
            : 0;
  }

  /** Notes that a budget has chosen for the object, and returns whether it had not before. */
  boolean chosenFirst() {
    boolean first = !chosen;
    chosen = true;
    return first;
  }

  List<ControlProblem> problems() {
    return fieldProblems.isEmpty()
        ? problems
        : Stream.concat(problems.stream(), fieldProblems.stream()).toList();
  }

  /** Removes all listeners from the Switch. */
  void close() {
    FieldListeners.remove(children, onChildren);
    FieldListeners.remove(whichChoice, onChoice);
    fields.forEach(ControlledField::close);
    watch.close();
  }
}
