package org.selectiverenderer.browser.script;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.nodes.script.ScriptNode;
import org.selectiverenderer.browser.scene.EventCascade;
import org.selectiverenderer.browser.script.value.FieldValue;
import org.selectiverenderer.browser.script.value.FieldValueConverter;
import org.selectiverenderer.browser.script.value.ValueOwner;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * The values of a Script node's own fields as its program sees them. Assigned values and values
 * changed in place are sent as events when the function has ended, once per field, in the order of
 * the first change.
 */
final class ScriptFieldValues implements ScriptScope.Fields {
  private final ScriptNode node;
  private final FieldValueConverter values;
  private final @Nullable Object[] cells;
  private final boolean[] known;
  private Set<FieldDefinition> changed = new LinkedHashSet<>();

  ScriptFieldValues(ScriptNode node, FieldValueConverter values) {
    this.node = node;
    this.values = values;
    cells = new Object[node.type().fields().size()];
    known = new boolean[cells.length];
  }

  @Override
  public @Nullable Object get(FieldDefinition field) {
    int index = field.index();
    if (!known[index]) {
      keep(field, values.toScript(field.type(), node.value(index), owner(field)));
    }
    return cells[index];
  }

  @Override
  public void set(FieldDefinition field, @Nullable Object value) {
    Object kept = values.adopt(field.type(), value, owner(field));
    release(field);
    keep(field, kept);
    changed.add(field);
  }

  private ValueOwner owner(FieldDefinition field) {
    return value -> changed.add(field);
  }

  private void keep(FieldDefinition field, @Nullable Object value) {
    cells[field.index()] = value;
    known[field.index()] = true;
  }

  /** Leaves an object that was the field's value to the script. */
  private void release(FieldDefinition field) {
    if (cells[field.index()] instanceof FieldValue before) {
      before.belongsTo(null);
    }
  }

  /** Drops the cached value, after the field got its value from elsewhere. */
  void forget(FieldDefinition field) {
    release(field);
    known[field.index()] = false;
    cells[field.index()] = null;
    changed.remove(field);
  }

  /** Returns the values that have changed, as fields have them, to send them with {@link #send}. */
  Map<FieldDefinition, @Nullable Object> take() {
    Map<FieldDefinition, @Nullable Object> taken = new LinkedHashMap<>();
    List<FieldDefinition> sent = List.copyOf(changed);
    changed = new LinkedHashSet<>();
    for (FieldDefinition field : sent) {
      taken.put(field, values.toField(field.type(), cells[field.index()]));
    }
    return taken;
  }

  /** Sends values. */
  void send(Map<FieldDefinition, @Nullable Object> taken, EventCascade cascade) {
    taken.forEach(
        (field, value) -> {
          if (field.access() == AccessType.INITIALIZE_ONLY) {
            node.init(field.index(), value);
          } else {
            node.emit(field.index(), value, cascade);
          }
        });
  }

  /** Drops all values, so that none takes memory. */
  void clear() {
    Arrays.fill(cells, null);
    Arrays.fill(known, false);
    changed = new LinkedHashSet<>();
  }
}
