package org.selectiverenderer.browser.script.value;

import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.ScriptableObject;
import org.selectiverenderer.x3d.field.FieldType;

/** The value of a field as a mutable object of a script. */
@SuppressWarnings("serial") // Rhino's objects may be written to files; these never are.
public abstract class FieldValue extends ScriptableObject {
  private final FieldType type;
  private transient @Nullable ValueOwner owner;

  FieldValue(FieldType type) {
    this.type = type;
  }

  /** Returns the type of the field. */
  public final FieldType type() {
    return type;
  }

  /** Sets what the value belongs to; null if it belongs to the script alone. */
  public final void belongsTo(@Nullable ValueOwner field) {
    owner = field;
  }

  /** Asks the owner whether the value may change. */
  final void beforeChange() {
    if (owner != null) {
      owner.beforeChange();
    }
  }

  /** Asks the owner whether an element may be set. */
  final void beforeElement(@Nullable Object element) {
    if (owner != null) {
      owner.beforeElement(element);
    }
  }

  /** Tells the owner of a change. */
  final void changed() {
    if (owner != null) {
      owner.changed(this);
    }
  }

  /**
   * Returns the present value as {@link FieldType} represents it. Later changes do not touch it.
   */
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
