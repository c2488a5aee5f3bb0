package org.selectiverenderer.browser.script.value;

import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.ScriptableObject;
import org.selectiverenderer.x3d.field.FieldType;

/** The value of a field as a mutable object of a script. */
@SuppressWarnings("serial") // Rhino's objects may be written to files; these never are.
abstract class FieldValue extends ScriptableObject {
  private final FieldType type;
  private transient @Nullable Runnable holder;

  FieldValue(FieldType type) {
    this.type = type;
  }

  public FieldType type() {
    return type;
  }

  /** Sets the listener that is told of changes in place; null for none. */
  void heldBy(@Nullable Runnable hearer) {
    holder = hearer;
  }

  /** Tells the listener of a change. */
  final void changed() {
    if (holder != null) {
      holder.run();
    }
  }

  /** Returns the value as {@link FieldType} represents it. */
  public abstract Object toField();

  /** Returns the value as scripts print it. */
  abstract String text();

  @Override
  public String getClassName() {
    return type.name();
  }

  @Override
  public Object getDefaultValue(@Nullable Class<?> hint) {
    return text();
  }
}
