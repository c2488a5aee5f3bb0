package org.selectiverenderer.browser.script.value;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.scriptengine.ScriptMeter;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * An MF value: a typed array that grows when a script assigns beyond its end and has the methods of
 * ECMAScript arrays. Elements are converted to objects when they are first accessed.
 */
@SuppressWarnings("serial") // See FieldValue.
final class ArrayValue extends FieldValue {
  /**
   * The most elements, far more than scenes have; a larger index is an error instead of a large
   * allocation.
   */
  private static final int MAX_LENGTH = 1 << 24;

  private final transient FieldValueConverter values;
  private final FieldType element;
  private transient @Nullable Object given;
  private transient @Nullable Object[] made;
  private transient boolean[] known;
  private int length;

  /**
   * @param given the value as {@link FieldType} represents it; not modified
   */
  ArrayValue(FieldValueConverter values, FieldType type, Object given) {
    super(type);
    this.values = values;
    element = ArrayElements.single(type);
    this.given = given;
    length = ArrayElements.count(type, given);
    made = new Object[length];
    known = new boolean[length];
  }

  /** Replaces the elements by those of another value or of a script's array. */
  void assign(@Nullable Object value) {
    Object taken = values.toField(type(), value);
    given = taken;
    length = ArrayElements.count(type(), taken);
    made = new Object[length];
    known = new boolean[length];
    changed();
  }

  @Override
  public boolean has(int index, Scriptable start) {
    return index >= 0 && index < length;
  }

  @Override
  public @Nullable Object get(int index, Scriptable start) {
    if (!has(index, start)) {
      return Undefined.instance;
    }
    if (!known[index]) {
      made[index] = values.toScript(element, ArrayElements.at(type(), given, index), this::changed);
      known[index] = true;
    }
    return made[index];
  }

  @Override
  public void put(int index, Scriptable start, @Nullable Object value) {
    if (index < 0) {
      super.put(index, start, value);
      return;
    }
    Object kept = values.adopt(element, value, this::changed);
    if (index >= length) {
      resize(index + 1L);
    }
    made[index] = kept;
    known[index] = true;
    changed();
  }

  private void resize(double wanted) {
    if (!(wanted >= 0 && wanted <= MAX_LENGTH)) {
      throw ScriptRuntime.rangeError(
          "%s cannot have %s elements; the limit is %s".formatted(type(), wanted, MAX_LENGTH));
    }
    int count = (int) wanted;
    if (count > made.length) {
      int room = Math.max(count, Math.min(MAX_LENGTH, 2 * made.length));
      ScriptMeter.allocateReferences(room);
      made = Arrays.copyOf(made, room);
      known = Arrays.copyOf(known, room);
    }
    for (int i = length; i < count; i++) {
      ScriptMeter.tick();
      made[i] = values.toScript(element, element.zero(), this::changed);
      known[i] = true;
    }
    length = count;
  }

  @Override
  public void delete(int index) {
    if (has(index, this)) {
      made[index] = values.toScript(element, element.zero(), this::changed);
      known[index] = true;
      changed();
    }
  }

  @Override
  public boolean has(String name, Scriptable start) {
    return name.equals("length") || super.has(name, start);
  }

  @Override
  public Object get(String name, Scriptable start) {
    return name.equals("length") ? (Object) length : super.get(name, start);
  }

  @Override
  public void put(String name, Scriptable start, Object value) {
    if (name.equals("length")) {
      resize(ScriptRuntime.toInteger(value));
      changed();
    } else {
      super.put(name, start, value);
    }
  }

  @Override
  public Object[] getIds() {
    Object[] own = super.getIds();
    ScriptMeter.allocateReferences(length + own.length);
    Object[] ids = new Object[length + own.length];
    for (int i = 0; i < length; i++) {
      ids[i] = i;
    }
    System.arraycopy(own, 0, ids, length, own.length);
    return ids;
  }

  int length() {
    return length;
  }

  @Override
  public Object toField() {
    return ArrayElements.gather(
        type(),
        length,
        i -> known[i] ? values.toField(element, made[i]) : ArrayElements.at(type(), given, i));
  }

  @Override
  String text() {
    StringBuilder text = new StringBuilder("[");
    for (int i = 0; i < length; i++) {
      ScriptMeter.tick();
      text.append(i == 0 ? "" : ", ").append(values.text(element, get(i, this)));
    }
    return text.append(']').toString();
  }
}
