package org.selectiverenderer.browser.script.value;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.mozilla.javascript.ScriptRuntime;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.mozilla.javascript.Undefined;
import org.mozilla.javascript.Wrapper;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;

/**
 * An SFNode object: a node whose fields are properties, under the names of their events too. Two
 * objects of one node are equal in scripts.
 */
@SuppressWarnings("serial") // See FieldValue.
public final class NodeValue extends ScriptableObject implements Wrapper {
  private static final String SET = "set_";

  private final transient Node node;
  private final transient FieldValueConverter values;
  private final transient NodeAccess access;

  NodeValue(Node node, FieldValueConverter values, NodeAccess access) {
    this.node = node;
    this.values = values;
    this.access = access;
  }

  public Node node() {
    return node;
  }

  @Override
  public Object unwrap() {
    return node;
  }

  @Override
  public String getClassName() {
    return "SFNode";
  }

  @Override
  public Object getDefaultValue(@Nullable Class<?> hint) {
    String name = node.name();
    return node.type().name() + (name == null ? "" : " " + name);
  }

  private Optional<FieldDefinition> readable(String name) {
    return node.type()
        .field(name)
        .or(() -> node.type().output(name))
        .filter(field -> field.access().initialisable() || field.access().sendsEvents())
        .or(() -> set(name));
  }

  /** Returns the field whose value is read by a name such as set_coordIndex. */
  private Optional<FieldDefinition> set(String name) {
    return name.startsWith(SET)
        ? node.type().field(name.substring(SET.length())).filter(f -> f.access().initialisable())
        : Optional.empty();
  }

  @Override
  public boolean has(String name, Scriptable start) {
    return node.type().field(name).or(() -> node.type().output(name)).isPresent()
        || super.has(name, start);
  }

  @Override
  public @Nullable Object get(String name, Scriptable start) {
    FieldDefinition field = readable(name).orElse(null);
    if (field != null) {
      return value(field);
    }
    return node.type().field(name).isPresent() ? Undefined.instance : super.get(name, start);
  }

  private @Nullable Object value(FieldDefinition field) {
    return access.read(node, field, input(field));
  }

  /**
   * Returns the field that is written in place of one: an event replaces what is initializeOnly.
   */
  private FieldDefinition input(FieldDefinition field) {
    return field.access() == AccessType.INITIALIZE_ONLY
        ? node.type().field(SET + field.name()).orElse(field)
        : field;
  }

  @Override
  public void put(String name, Scriptable start, @Nullable Object value) {
    FieldDefinition field = node.type().field(name).or(() -> node.type().input(name)).orElse(null);
    if (field == null) {
      List<String> names = node.type().fields().stream().map(FieldDefinition::name).toList();
      throw ScriptRuntime.typeError(
          node.type()
              + " has no field "
              + name
              + SpellingSuggester.nearest(name, names)
                  .map(n -> " (did you mean " + n + "?)")
                  .orElse(""));
    }
    access.write(node, input(field), values.toField(field.type(), value));
  }

  @Override
  public Object[] getIds() {
    return node.type().fields().stream().map(FieldDefinition::name).toArray();
  }
}
