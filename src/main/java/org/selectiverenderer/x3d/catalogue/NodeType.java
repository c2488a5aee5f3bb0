package org.selectiverenderer.x3d.catalogue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A concrete node type of the catalogue, one with fields of a single node's own besides (see {@link
 * #with}), or that of a prototype's instances ({@link #ofPrototype}). Immutable. Those of the
 * catalogue may be compared by identity, all by {@link #name()} and {@link #is}.
 */
public final class NodeType {
  private static final String INSTANCE = "X3DPrototypeInstance";

  private final String name;
  private final String component;
  private final int level;
  private final String containerField;
  private final Set<String> ancestors;
  private final List<FieldDefinition> fields;
  private final int ownFrom;
  private final Map<String, FieldDefinition> fieldsByName;

  NodeType(
      String name,
      String component,
      int level,
      String containerField,
      Set<String> ancestors,
      List<FieldDefinition> fields) {
    this(name, component, level, containerField, ancestors, fields, fields.size());
  }

  private NodeType(
      String name,
      String component,
      int level,
      String containerField,
      Set<String> ancestors,
      List<FieldDefinition> fields,
      int ownFrom) {
    this.ownFrom = ownFrom;
    this.name = name;
    this.component = component;
    this.level = level;
    this.containerField = containerField;
    this.ancestors = Set.copyOf(ancestors);
    this.fields = List.copyOf(fields);
    this.fieldsByName = new HashMap<>(fields.size() * 2);
    for (FieldDefinition field : fields) {
      fieldsByName.put(field.name(), field);
    }
  }

  /**
   * The type of a node with fields of its own, as the author of a Script or a shader declares them
   * (X3D 4.0, 29.2.2): name, component and ancestors are this type's, and its fields keep their
   * indices.
   *
   * @param own the further fields, whose indices go on where this type's end
   */
  public NodeType with(List<FieldDefinition> own) {
    List<FieldDefinition> all = new ArrayList<>(fields.size() + own.size());
    all.addAll(fields);
    all.addAll(own);
    return new NodeType(name, component, level, containerField, ancestors, all, ownFrom);
  }

  /**
   * The type of the instances of a prototype as the rest of the scene sees them: what the prototype
   * calls itself and the fields of its interface, and the abstract types of the first node of its
   * body, in whose places an instance may stand (X3D 4.0, 4.4.4.3).
   *
   * @param first of the body
   */
  public static NodeType ofPrototype(String name, NodeType first, List<FieldDefinition> fields) {
    Set<String> ancestors = new HashSet<>(first.ancestors);
    ancestors.add(INSTANCE);
    return new NodeType(name, "Core", 1, first.containerField, ancestors, fields, 0);
  }

  /** Whether it is the type of a prototype's instances. */
  public boolean isPrototype() {
    return ancestors.contains(INSTANCE);
  }

  /** The index from which fields are a node's own; how many there are if it has none. */
  public int ownFrom() {
    return ownFrom;
  }

  /** The standard's name, such as {@code Box}. */
  public String name() {
    return name;
  }

  /** The component that defines the node, for example {@code Grouping}. */
  public String component() {
    return component;
  }

  /** The level of that component from which the node is supported. */
  public int level() {
    return level;
  }

  /** The field of a parent that takes such a node when the file does not say. */
  public String containerField() {
    return containerField;
  }

  /** Whether the node is of that concrete or abstract type, for example {@code X3DGroupingNode}. */
  public boolean is(String typeName) {
    return name.equals(typeName) || ancestors.contains(typeName);
  }

  /** The abstract types that the node descends from. */
  public Set<String> ancestors() {
    return ancestors;
  }

  /** Its fields, in the standard's order. */
  public List<FieldDefinition> fields() {
    return fields;
  }

  /** The field of exactly that name. */
  public Optional<FieldDefinition> field(String fieldName) {
    return Optional.ofNullable(fieldsByName.get(fieldName));
  }

  /** The field that takes an event sent to that name: {@code size} or {@code set_size}. */
  public Optional<FieldDefinition> input(String fieldName) {
    return eventField(fieldName, fieldName.startsWith("set_") ? fieldName.substring(4) : null)
        .filter(field -> field.access().acceptsEvents());
  }

  /** The field that sends events under that name: {@code size} or {@code size_changed}. */
  public Optional<FieldDefinition> output(String fieldName) {
    return eventField(
            fieldName,
            fieldName.endsWith("_changed")
                ? fieldName.substring(0, fieldName.length() - "_changed".length())
                : null)
        .filter(field -> field.access().sendsEvents());
  }

  private Optional<FieldDefinition> eventField(String fieldName, String stripped) {
    FieldDefinition field = fieldsByName.get(fieldName);
    if (field == null && stripped != null) {
      field = fieldsByName.get(stripped);
    }
    return Optional.ofNullable(field);
  }

  /**
   * The index of a field that is known to exist; for code that names the standard's own fields.
   *
   * @throws IllegalArgumentException if the node type has no such field
   */
  public int indexOf(String fieldName) {
    FieldDefinition field = fieldsByName.get(fieldName);
    if (field == null) {
      throw new IllegalArgumentException(name + " has no field " + fieldName);
    }
    return field.index();
  }

  @Override
  public String toString() {
    return name;
  }
}
