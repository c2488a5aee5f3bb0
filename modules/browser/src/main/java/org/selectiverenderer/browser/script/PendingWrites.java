package org.selectiverenderer.browser.script;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.browser.scene.PrototypeInstance;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * Buffers the values that a script's function writes to fields of other nodes, until the function
 * has ended. Of several values for one field the last counts; of values for an inputOnly field,
 * such as addChildren, all are sent. Each is an event of its own that begins a cascade, so that
 * none is suppressed as part of an event loop.
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

  private static final class Write {
    final Node node;
    final int field;
    @Nullable Object value;

    Write(Node node, int field, @Nullable Object value) {
      this.node = node;
      this.field = field;
      this.value = value;
    }
  }

  private List<Write> all = new ArrayList<>();
  private final Map<Key, Write> latest = new HashMap<>();

  void add(Node node, FieldDefinition field, @Nullable Object value) {
    Key key = new Key(node, field.index());
    Write known = latest.get(key);
    if (known != null && field.access() != AccessType.INPUT_ONLY) {
      known.value = value;
    } else {
      Write write = new Write(node, field.index(), value);
      all.add(write);
      latest.put(key, write);
    }
  }

  /** Returns the value of a field: the buffered one, or else the node's. */
  @Nullable Object read(Node node, FieldDefinition field) {
    Write waiting = latest.isEmpty() ? null : latest.get(new Key(node, field.index()));
    return waiting != null ? waiting.value : PrototypeInstance.value(node, field.index());
  }

  /** Drops all values. */
  void clear() {
    all = new ArrayList<>();
    latest.clear();
  }

  void send(EventCascade cascade) {
    if (all.isEmpty()) {
      return;
    }
    List<Write> sent = all;
    all = new ArrayList<>();
    latest.clear();
    for (Write write : sent) {
      FieldDefinition field = write.node.type().fields().get(write.field);
      if (field.access() == AccessType.INITIALIZE_ONLY) {
        PrototypeInstance.replace(write.node, write.field, write.value);
      } else {
        cascade.send(write.node, write.field, write.value);
      }
    }
  }
}
