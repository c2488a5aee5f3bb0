package org.selectiverenderer.control;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ObjDoubleConsumer;
import org.selectiverenderer.schema.SchemaReader;
import org.selectiverenderer.schema.SwitchSchemas;
import org.web3d.x3d.sai.X3DException;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldEventListener;
import org.web3d.x3d.sai.grouping.Switch;

/** A Switch and what its metadata says of its children: the versions of an object. */
final class VersionedObject {
  private final Switch node;
  private final String name;
  private final X3DField children;
  private final X3DFieldEventListener onChildren;
  private final MetadataWatch watch;
  private List<ControlProblem> problems = List.of();
  private Optional<SwitchSchemas> schemas = Optional.empty();
  private int shown;

  /**
   * An object as it is now.
   *
   * @param onChange hears when the metadata or the number of versions is not what it was
   */
  VersionedObject(Switch node, String name, ObjDoubleConsumer<VersionedObject> onChange) {
    this.node = node;
    this.name = name;
    this.shown = node.getWhichChoice();
    this.children = node.getField("children");
    this.onChildren = event -> onChange.accept(this, event.getTime());
    this.watch = new MetadataWatch(node, time -> onChange.accept(this, time));
    children.addX3DEventListener(onChildren);
    read();
  }

  /** Reads the metadata anew. */
  void read() {
    problems = List.of();
    SchemaReader reader =
        new SchemaReader(
            problem ->
                add(
                    new ControlProblem(
                        name, ((SaiMetadata) problem.metadata()).node(), problem.message())));
    schemas = watch.read().flatMap(m -> reader.switchNode(m, node.getNumChildren()));
  }

  String name() {
    return name;
  }

  /** Empty if the metadata has nothing of the vocabulary: the Switch is not ours. */
  Optional<SwitchSchemas> schemas() {
    return schemas;
  }

  /** The choice that was last set, or that the scene came with. */
  int shown() {
    return shown;
  }

  /** Sets {@code whichChoice}, unless it is set already. */
  void show(int choice) {
    if (choice == shown) {
      return;
    }
    shown = choice;
    try {
      node.setWhichChoice(choice);
    } catch (X3DException e) { // one Switch that is gone does not hold up the others
      add(
          new ControlProblem(
              name, node, "whichChoice cannot be set to " + choice + ": " + e.getMessage()));
    }
  }

  private void add(ControlProblem problem) {
    if (problems.isEmpty()) {
      problems = new ArrayList<>(); // few objects have any
    }
    problems.add(problem);
  }

  List<ControlProblem> problems() {
    return problems;
  }

  /** Leaves the Switch without a listener. */
  void close() {
    children.removeX3DEventListener(onChildren);
    watch.close();
  }
}
