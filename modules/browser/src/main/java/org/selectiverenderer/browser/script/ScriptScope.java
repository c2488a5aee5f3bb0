package org.selectiverenderer.browser.script;

import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.Function;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * The global scope of a script: the fields of its node, and what its program declares. inputOnly
 * fields are no variables; functions of their names handle their events.
 */
@SuppressWarnings("serial") // Rhino's objects may be written to files; these never are.
final class ScriptScope extends ScriptableObject {
  /** Access to the values of the node's own fields. */
  interface Fields {
    @Nullable Object get(FieldDefinition field);

    void set(FieldDefinition field, @Nullable Object value);
  }

  private final transient Map<String, FieldDefinition> variables = new HashMap<>();
  private final transient Map<String, Function> answers = new HashMap<>();
  private final transient Fields fields;

  ScriptScope(NodeType type, Fields fields, Scriptable shared) {
    this.fields = fields;
    setPrototype(shared);
    for (FieldDefinition field : type.fields().subList(type.ownFrom(), type.fields().size())) {
      switch (field.access()) {
        case INITIALIZE_ONLY, OUTPUT_ONLY -> variables.put(field.name(), field);
        case INPUT_OUTPUT -> {
          variables.put(field.name(), field);
          variables.putIfAbsent(field.name() + "_changed", field);
        }
        case INPUT_ONLY -> {
          // Only a function has this name.
        }
      }
    }
  }

  /**
   * Returns the function that handles events of a field: the one of its name, for an inputOutput
   * field with {@code set_} before it; null when the program has none.
   */
  @Nullable Function answerTo(FieldDefinition field) {
    Function declared = answers.get(field.name());
    if (declared != null) {
      return declared;
    }
    String set = "set_" + field.name();
    return function(field.access().sendsEvents() || !has(field.name(), this) ? set : field.name());
  }

  /** Returns the global function of a name, or null. */
  @Nullable Function function(String name) {
    return super.get(name, this) instanceof Function function ? function : null;
  }

  @Override
  public String getClassName() {
    return "Script";
  }

  @Override
  public boolean has(String name, Scriptable start) {
    return variables.containsKey(name) || super.has(name, start);
  }

  @Override
  public @Nullable Object get(String name, Scriptable start) {
    FieldDefinition field = variables.get(name);
    return field != null ? fields.get(field) : super.get(name, start);
  }

  @Override
  public void put(String name, Scriptable start, @Nullable Object value) {
    if (!keep(name, value)) {
      super.put(name, start, value);
    }
  }

  /** Called by {@code function} and {@code var} at the top level of a program. */
  @Override
  public void defineProperty(String name, @Nullable Object value, int attributes) {
    if (!keep(name, value)) {
      super.defineProperty(name, value, attributes);
    }
  }

  /** Assigns a value to the field of that name; returns false when there is none. */
  private boolean keep(String name, @Nullable Object value) {
    FieldDefinition field = variables.get(name);
    if (field == null) {
      return false;
    }
    if (value instanceof Function function) {
      answers.put(name, function); // Some write function x for set_x of an inputOutput field.
    } else {
      fields.set(field, value);
    }
    return true;
  }
}
