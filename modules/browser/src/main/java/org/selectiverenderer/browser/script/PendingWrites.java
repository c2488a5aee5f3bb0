package org.selectiverenderer.browser.script;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.browser.script.value.FieldValue;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * Buffers what a script's function writes to fields of other nodes, until the function has ended:
 * values, and objects that it changes in place, whose values are taken at the end. Of several
 * values for one field the last counts; of values for an inputOnly field, such as addChildren, all
 * are sent. Each is an event of its own that begins a cascade, so that none is suppressed as part
 * of an event loop.
 */
final class PendingWrites {
  private record Key(Node node, int field) {
    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof Key key && key.node == node && key.field == field;
    }

    @Override
    public int hashCode() {
      return Objects.hash(System.identityHashCode(node), field);
    }
  }

  /** A field in this call: the object that the script has for it, and the last write to it. */
  private static final class Cell {
    @Nullable FieldValue object;
    @Nullable Write last;
  }

  /** One value for a field, or an object whose value it will be. */
  private static final class Write {
    final Node node;
    final FieldDefinition field;
    @Nullable Object value;
    @Nullable FieldValue object;

    Write(Node node, FieldDefinition field) {
      this.node = node;
      this.field = field;
    }

    void set(@Nullable Object newValue) {
      value = newValue;
      object = null;
    }

    @Nullable Object value() {
      return object != null ? object.toField() : value;
    }
  }

  /** A value to be sent. */
  record Sent(Node node, FieldDefinition field, @Nullable Object value) {}

  private final List<Write> all = new ArrayList<>();
  private final Map<Key, Cell> cells = new HashMap<>();

  /** Writes a value. */
  void add(Node node, FieldDefinition field, @Nullable Object value) {
    Cell cell = cell(node, field);
    cell.object = null;
    write(cell, node, field).set(value);
  }

  /** Writes the value that an object will have; does nothing when it is written already. */
  void add(Node node, FieldDefinition field, FieldValue object) {
    Cell cell = cell(node, field);
    if (cell.last == null || cell.last.object != object) {
      cell.object = object;
      write(cell, node, field).object = object;
    }
  }

  private Cell cell(Node node, FieldDefinition field) {
    return cells.computeIfAbsent(new Key(node, field.index()), key -> new Cell());
  }

  private Write write(Cell cell, Node node, FieldDefinition field) {
    Write last = cell.last;
    if (last != null && field.access() != AccessType.INPUT_ONLY) {
      return last;
    }
    if (last != null) {
      last.set(last.value()); // It is an event of its own: what follows does not change it.
    }
    Write next = new Write(node, field);
    all.add(next);
    cell.last = next;
    return next;
  }

  /** Returns the object that the script has for a field in this call, or null. */
  @Nullable FieldValue object(Node node, FieldDefinition field) {
    return cell(node, field).object;
  }

  /** Sets the object that the script has for a field in this call. */
  void object(Node node, FieldDefinition field, FieldValue object) {
    cell(node, field).object = object;
  }

  /**
   * Returns the value of a field: the one written, or else the node's.
   *
   * @param input the field that is written in its place
   */
  @Nullable Object read(Node node, FieldDefinition field, FieldDefinition input) {
    Cell cell = cells.get(new Key(node, input.index()));
    return cell != null && cell.last != null
        ? cell.last.value()
        : PrototypeInstance.value(node, field.index());
  }

  /**
   * Replaces the values of fields that accept no events at once, for nodes that satisfy a
   * condition. Where such a field has an event that replaces it, that is sent in the end, too.
   */
  void replace(Predicate<Node> nodes) {
    for (Write write : all) {
      if (nodes.test(write.node)) {
        fixed(write.node, write.field)
            .ifPresent(
                field -> PrototypeInstance.replace(write.node, field.index(), write.value()));
      }
    }
  }

  /** Returns the initializeOnly field that is written, also by an event such as set_height. */
  private static Optional<FieldDefinition> fixed(Node node, FieldDefinition written) {
    String name = written.name();
    Optional<FieldDefinition> field =
        written.access() == AccessType.INPUT_ONLY && name.startsWith("set_")
            ? node.type().field(name.substring("set_".length()))
            : Optional.of(written);
    return field.filter(found -> found.access() == AccessType.INITIALIZE_ONLY);
  }

  /** Drops all values and objects. */
  void clear() {
    all.clear();
    cells.clear();
  }

  /** Returns what is to be sent, and forgets it and all objects. */
  List<Sent> take() {
    List<Sent> taken = new ArrayList<>(all.size());
    try {
      for (Write write : all) {
        taken.add(new Sent(write.node, write.field, write.value()));
      }
    } finally {
      clear();
    }
    return taken;
  }

  static void send(List<Sent> taken, EventCascade cascade) {
    for (Sent sent : taken) {
      if (sent.field.access() == AccessType.INITIALIZE_ONLY) {
        PrototypeInstance.replace(sent.node, sent.field.index(), sent.value);
      } else {
        cascade.send(sent.node, sent.field.index(), sent.value);
      }
    }
  }
}
