package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.ObjDoubleConsumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.grouping.Switch;

/** A Switch and what its metadata says of its children: the versions of an object. */
final class VersionedObject {
  private final Switch node;
  private final Supplier<String> name;
  private final X3DField children;
  private final X3DFieldEventListener onChildren;
  private final X3DField whichChoice;
  private final X3DFieldEventListener onChoice;
  private final MetadataWatch watch;

  /** Own writes of which no event has come yet, oldest first. */
  private List<Integer> pending = List.of();

  private List<ControlProblem> problems = List.of();
  private Optional<SwitchSchemas> schemas = Optional.empty();
  private final int atStart;
  private int shown;

  /**
   * An object as it is now.
   *
   * @param onChange hears when the metadata or the number of versions is not what it was
   * @param onForeignChoice hears when somebody else has made the Switch show what it shows
   */
  VersionedObject(
      Switch node,
      Supplier<String> name,
      Turn turn,
      ObjDoubleConsumer<VersionedObject> onChange,
      Consumer<VersionedObject> onForeignChoice) {
    this.node = node;
    this.name = name;
    this.atStart = node.getWhichChoice();
    this.shown = atStart;
    this.children = node.getField("children");
    this.onChildren = event -> turn.take(() -> onChange.accept(this, event.getTime()));
    this.watch = new MetadataWatch(node, turn, time -> onChange.accept(this, time));
    this.whichChoice = node.getField("whichChoice");
    this.onChoice = event -> turn.take(() -> choiceChanged(onForeignChoice));
    children.addX3DEventListener(onChildren);
    whichChoice.addX3DEventListener(onChoice);
    read();
  }

  /**
   * An event says that the field has changed; its value may be that of a later write already. A
   * browser whose writes take effect late sends the events of own writes one after the other: until
   * the last has come the record stays ahead of the field.
   */
  private void choiceChanged(Consumer<VersionedObject> onForeignChoice) {
    int choice = node.getWhichChoice();
    int own = pending.indexOf(choice);
    if (own >= 0 && own < pending.size() - 1) {
      pending = List.copyOf(pending.subList(own + 1, pending.size()));
      return;
    }
    pending = List.of();
    if (choice != shown) {
      shown = choice;
      onForeignChoice.accept(this);
    }
  }

  /** Reads the metadata anew. */
  void read() {
    problems = List.of();
    SchemaReader reader =
        new SchemaReader(
            problem ->
                add(
                    ControlProblem.warning(
                        name(), ((SaiMetadata) problem.metadata()).node(), problem.message())));
    schemas = watch.read().flatMap(m -> reader.switchNode(m, node.getNumChildren()));
  }

  String name() {
    return name.get();
  }

  /** Empty if the metadata has nothing of the vocabulary: the Switch is not ours. */
  Optional<SwitchSchemas> schemas() {
    return schemas;
  }

  /** The choice that the scene came with. */
  int atStart() {
    return atStart;
  }

  /** The choice that was last set, by whomever, or that the scene came with. */
  int shown() {
    return shown;
  }

  /**
   * Sets {@code whichChoice}, unless it is set already.
   *
   * @return why it could not be set
   */
  Optional<ControlProblem> show(int choice) {
    if (choice == shown) {
      return Optional.empty();
    }
    shown = choice;
    List<Integer> before = pending;
    pending = Stream.concat(before.stream(), Stream.of(choice)).toList();
    try {
      node.setWhichChoice(choice);
      return Optional.empty();
    } catch (X3DException e) { // one Switch that is gone does not hold up the others
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
      problems = new ArrayList<>(); // few objects have any
    }
    problems.add(problem);
  }

  Switch node() {
    return node;
  }

  List<ControlProblem> problems() {
    return problems;
  }

  /** Leaves the Switch without a listener. */
  void close() {
    FieldRelease.remove(children, onChildren);
    FieldRelease.remove(whichChoice, onChoice);
    watch.close();
  }
}
