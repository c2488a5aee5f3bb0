package org.selectiverenderer.browser.script.value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.Undefined;
import org.selectiverenderer.scriptengine.ScriptMeter;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * An MF value: a typed array that grows when a script assigns beyond its end and has the methods of
 * ECMAScript arrays. To read or write one element takes the same time whatever the length is.
 *
 * <p>Elements that are vectors, images and the like become objects when a script first asks for
 * them; what it changes in such an object is copied into the array when the array's value is
 * needed. An object keeps its value and belongs to the script alone when another element takes its
 * place, so that scripts can swap and sort.
 */
@SuppressWarnings("serial") // See FieldValue.
final class ArrayValue extends FieldValue {
  private final transient FieldValueConverter values;
  private final transient boolean ofObjects;
  private transient ElementStorage elements;

  /** The objects of elements, also of such beyond the end, which are no elements until changed. */
  private final transient Map<Integer, FieldValue> objects = new HashMap<>();

  /** The objects that scripts have changed since their values were copied into the array. */
  private final transient List<Place> changes = new ArrayList<>();

  ArrayValue(FieldValueConverter values, FieldType type, ElementStorage elements) {
    super(type);
    this.values = values;
    this.elements = elements;
    FieldType element = elements.element();
    ofObjects = element.components() > 1 || element == FieldType.SFImage;
  }

  /** Replaces the elements by those of another value or of a script's array. */
  void assign(@Nullable Object value) {
    beforeChange();
    Object taken = values.toField(type(), value);
    objects.values().forEach(object -> object.belongsTo(null));
    objects.clear();
    changes.clear();
    elements = new ElementStorage(type(), taken);
    changed();
  }

  @Override
  public boolean has(int index, Scriptable start) {
    return index >= 0 && index < elements.length();
  }

  /** Returns an element; beyond the end, a default object that becomes an element when changed. */
  @Override
  public @Nullable Object get(int index, Scriptable start) {
    if (index < 0 || index >= (ofObjects ? ElementStorage.MAX_LENGTH : elements.length())) {
      return Undefined.instance;
    }
    if (!ofObjects) {
      return values.toScript(elements.element(), elements.at(index), null);
    }
    FieldValue known = objects.get(index);
    if (known == null) {
      known = made(index, new Place(index));
      objects.put(index, known);
    }
    return known;
  }

  private FieldValue made(int index, @Nullable ValueOwner owner) {
    FieldType type = elements.element();
    Object value = index < elements.length() ? elements.at(index) : type.zero();
    return (FieldValue) java.util.Objects.requireNonNull(values.toScript(type, value, owner));
  }

  /** Returns an element for a moment: a change in it is not seen. */
  @Nullable Object peek(int index) {
    FieldValue known = objects.get(index);
    return known != null ? known : ofObjects ? made(index, null) : get(index, this);
  }

  @Override
  public void put(int index, Scriptable start, @Nullable Object value) {
    if (index < 0) {
      super.put(index, start, value);
      return;
    }
    beforeChange();
    Object kept = values.toField(elements.element(), value);
    beforeElement(kept);
    if (index >= elements.length()) {
      elements.resize(index + 1L);
    }
    release(index);
    elements.set(index, kept);
    changed();
  }

  /** Leaves the object of an element, if there is one, to the script. */
  private void release(int index) {
    FieldValue known = objects.remove(index);
    if (known != null) {
      known.belongsTo(null);
    }
  }

  private void resize(double wanted) {
    int before = elements.length();
    elements.resize(wanted);
    int now = elements.length();
    if (before - now <= objects.size()) {
      for (int i = now; i < before; i++) {
        release(i);
      }
    } else {
      for (Iterator<Map.Entry<Integer, FieldValue>> all = objects.entrySet().iterator();
          all.hasNext(); ) {
        Map.Entry<Integer, FieldValue> entry = all.next();
        if (entry.getKey() >= now) {
          entry.getValue().belongsTo(null);
          all.remove();
        }
      }
    }
  }

  @Override
  public void delete(int index) {
    if (has(index, this)) {
      beforeChange();
      release(index);
      elements.set(index, elements.element().zero());
      changed();
    }
  }

  @Override
  public boolean has(String name, Scriptable start) {
    return name.equals("length") || super.has(name, start);
  }

  @Override
  public Object get(String name, Scriptable start) {
    return name.equals("length") ? (Object) elements.length() : super.get(name, start);
  }

  @Override
  public void put(String name, Scriptable start, Object value) {
    if (name.equals("length")) {
      beforeChange();
      resize(ScriptRuntime.toInteger(value));
      changed();
    } else {
      super.put(name, start, value);
    }
  }

  @Override
  public Object[] getIds() {
    Object[] own = super.getIds();
    int length = elements.length();
    ScriptMeter.allocateReferences(length + own.length);
    Object[] ids = new Object[length + own.length];
    for (int i = 0; i < length; i++) {
      ids[i] = i;
    }
    System.arraycopy(own, 0, ids, length, own.length);
    return ids;
  }

  int length() {
    return elements.length();
  }

  @Override
  public Object toField() {
    for (Place place : changes) {
      ScriptMeter.tick();
      place.store();
    }
    changes.clear();
    return elements.value();
  }

  @Override
  String text() {
    StringBuilder text = new StringBuilder("[");
    for (int i = 0; i < elements.length(); i++) {
      ScriptMeter.tick();
      text.append(i == 0 ? "" : ", ").append(values.text(elements.element(), peek(i)));
    }
    return text.append(']').toString();
  }

  /** The place of an object among the elements. */
  private final class Place implements ValueOwner {
    private final int index;
    private boolean waiting;

    Place(int index) {
      this.index = index;
    }

    @Override
    public void beforeChange() {
      ArrayValue.this.beforeChange();
    }

    @Override
    public void changed(FieldValue object) {
      if (index >= elements.length()) {
        elements.resize(index + 1L);
      }
      if (!waiting) {
        waiting = true;
        changes.add(this);
      }
      ArrayValue.this.changed();
    }

    /** Copies the object's value into the array, unless another has taken its place. */
    void store() {
      waiting = false;
      FieldValue object = objects.get(index);
      if (object != null && index < elements.length()) {
        elements.set(index, object.toField());
      }
    }
  }
}
