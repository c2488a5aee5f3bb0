package org.selectiverenderer.x3d.catalogue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * A node type: a concrete one of the catalogue, one extended by a single node's author-defined
 * fields ({@link #with}), or that of a prototype's instances ({@link #ofPrototype}). Immutable.
 * Types of the catalogue may be compared by identity, all types by {@link #name()} and {@link #is}.
 */
public final class NodeType {
  private static final String INSTANCE = "X3DPrototypeInstance";

  private final String name;
  private final String component;
  private final int level;
  private final String containerField;
  private final Set<String> ancestors;
  private final List<FieldDefinition> fields;
  private final List<FieldDefinition> nodeFields;
  private final @Nullable Object[] defaults;
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
    this.defaults = this.fields.stream().map(FieldDefinition::defaultValue).toArray();
    this.nodeFields = this.fields.stream().filter(NodeType::holdsNodes).toList();
    this.fieldsByName = new HashMap<>(fields.size() * 2);
    for (FieldDefinition field : fields) {
      fieldsByName.put(field.name(), field);
    }
  }

  private static boolean holdsNodes(FieldDefinition field) {
    return (field.type() == FieldType.SFNode || field.type() == FieldType.MFNode)
        && !field.name().equals("metadata");
  }

  /**
   * Returns this type extended by the fields that the author of a Script or shader node declares
   * (X3D 4.0, 29.2.2). Name, component, ancestors and the indices of the other fields are
   * unchanged.
   *
   * @param own the author-defined fields, whose indices follow those of this type's fields
   */
  public NodeType with(List<FieldDefinition> own) {
    List<FieldDefinition> all = new ArrayList<>(fields.size() + own.size());
    all.addAll(fields);
    all.addAll(own);
    return new NodeType(name, component, level, containerField, ancestors, all, ownFrom);
  }

  /**
   * Returns the type of a prototype's instances as the rest of the scene sees them: the prototype's
   * name, the fields of its interface, and the abstract types of the first node of its body, in
   * whose place an instance may be used (X3D 4.0, 4.4.4.3).
   *
   * @param first the type of the first node of the body
   */
  public static NodeType ofPrototype(String name, NodeType first, List<FieldDefinition> fields) {
    Set<String> ancestors = new HashSet<>(first.ancestors);
    ancestors.add(INSTANCE);
    return new NodeType(name, "Core", 1, first.containerField, ancestors, fields, 0);
  }

  /** Returns whether this is the type of a prototype's instances. */
  public boolean isPrototype() {
    return ancestors.contains(INSTANCE);
  }

  /** Returns the index of the first author-defined field, or the number of fields if none. */
  public int ownFrom() {
    return ownFrom;
  }

  /** Returns the name in the standard, such as {@code Box}. */
  public String name() {
    return name;
  }

  /** Returns the component that defines the node, for example {@code Grouping}. */
  public String component() {
    return component;
  }

  /** Returns the level of the component from which on the node is supported. */
  public int level() {
    return level;
  }

  /** Returns the default containerField. */
  public String containerField() {
    return containerField;
  }

  /** Returns whether this is, or derives from, a type, for example {@code X3DGroupingNode}. */
  public boolean is(String typeName) {
    return name.equals(typeName) || ancestors.contains(typeName);
  }

  /** Returns the abstract types from which the node derives. */
  public Set<String> ancestors() {
    return ancestors;
  }

  /** Returns the fields in the order of the standard. */
  public List<FieldDefinition> fields() {
    return fields;
  }

  /** Returns the default value of a field. */
  public @Nullable Object defaultValue(int field) {
    return defaults[field];
  }

  /** Returns the fields that hold nodes, without {@code metadata}, in the order of the standard. */
  public List<FieldDefinition> nodeFields() {
    return nodeFields;
  }

  /** Returns the field of exactly this name. */
  public Optional<FieldDefinition> field(String fieldName) {
    return Optional.ofNullable(fieldsByName.get(fieldName));
  }

  /**
   * Returns the field that receives events sent to a name, such as {@code size}, {@code set_size}.
   */
  public Optional<FieldDefinition> input(String fieldName) {
    return eventField(fieldName, fieldName.startsWith("set_") ? fieldName.substring(4) : null)
        .filter(field -> field.access().acceptsEvents());
  }

  /** Returns the field that sends events of a name, such as {@code size}, {@code size_changed}. */
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
   * Returns the index of a field that is known to exist, for code that names fields of the
   * standard.
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
