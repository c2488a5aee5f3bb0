package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ObjDoubleConsumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.grouping.Switch;

/**
 * An enriched object: a Switch whose children are the object's versions, described by its metadata.
 */
final class VersionedObject {
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
  private final Supplier<String> name;
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
  private final int atStart;
  private int shown;

  /**
   * Reads an object in its present state.
   *
   * @param cache reads the metadata
   * @param onChange called when the metadata or the number of versions has changed
   */
  VersionedObject(
      Switch node,
      Supplier<String> name,
      ListenerLock turn,
      SchemaCache cache,
      ObjDoubleConsumer<VersionedObject> onChange,
      ChoiceListener onForeignChoice) {
    this.node = node;
    this.name = name;
    this.cache = cache;
    this.atStart = node.getWhichChoice();
    this.shown = atStart;
    this.children = node.getField("children");
    this.onChildren = event -> turn.take(() -> onChange.accept(this, event.getTime()));
    this.watch = new MetadataWatcher(node, turn, time -> onChange.accept(this, time));
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
    schemas =
        watch
            .read()
            .flatMap(
                metadata ->
                    cache.object(
                        metadata,
                        node.getNumChildren(),
                        problem ->
                            add(
                                ControlProblem.warning(
                                    name(),
                                    ((SaiMetadata) problem.metadata()).node(),
                                    problem.message()))));
  }

  String name() {
    return name.get();
  }

  /**
   * Returns the schemas of the versions; empty if the metadata does not use the vocabulary, so that
   * the Switch is no enriched object.
   */
  Optional<SwitchSchemas> schemas() {
    return schemas;
  }

  /** Returns the initial choice of the scene. */
  int atStart() {
    return atStart;
  }

  /**
   * Returns the choice that was last set, by the controller or others; initially that of the scene.
   */
  int shown() {
    return shown;
  }

  /**
   * Sets {@code whichChoice}, unless it is set already.
   *
   * @return the problem if it could not be set
   */
  Optional<ControlProblem> show(int choice) {
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

  private void add(ControlProblem problem) {
    if (problems.isEmpty()) {
      problems = new ArrayList<>(); // few objects have problems
    }
    problems.add(problem);
  }

  Switch node() {
    return node;
  }

  List<ControlProblem> problems() {
    return problems;
  }

  /** Removes all listeners from the Switch. */
  void close() {
    FieldListeners.remove(children, onChildren);
    FieldListeners.remove(whichChoice, onChoice);
    watch.close();
  }
}
