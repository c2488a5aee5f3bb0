package org.selectiverenderer.x3d.read;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.field.PackedArray;
import org.selectiverenderer.x3d.url.BaseUrl;

/**
 * A node read from a file. A node with USE is the same object in every place. Fields without a
 * value in the file have the catalogue's defaults. Only readers modify nodes; for all others they
 * are immutable, whether a value is packed or not.
 */
public final class ParsedNode implements NodeView {
  /**
   * Names that author-defined fields of a Script or shader cannot have. Other field names of these
   * node types were added by later versions of X3D; since scenes of earlier versions may define
   * fields of those names, these take precedence.
   */
  public static final Set<String> TAKEN_NAMES =
      Set.of("url", "directOutput", "mustEvaluate", "metadata", "sourceCode", "parts", "language");

  private final @Nullable String name;
  private final SourceLocation location;
  private final @Nullable BaseUrl base;
  private NodeType type;
  private @Nullable Object[] values;
  private @Nullable SourceLocation textLocation;

  /** Creates a node with all fields at their defaults. */
  public ParsedNode(NodeType type, @Nullable String name, SourceLocation location) {
    this(type, name, location, null);
  }

  /**
   * Creates a node of a prototype's body.
   *
   * @param base the base of its relative urls, if it differs from that of the file
   */
  ParsedNode(
      NodeType type, @Nullable String name, SourceLocation location, @Nullable BaseUrl base) {
    this.type = type;
    this.name = name;
    this.location = location;
    this.base = base;
    this.values = new Object[type.fields().size()];
  }

  @Override
  public NodeType type() {
    return type;
  }

  @Override
  public @Nullable String name() {
    return name;
  }

  @Override
  public SourceLocation location() {
    return location;
  }

  @Override
  public @Nullable Object value(int field) {
    Object value = PackedArray.read(values[field]);
    return value != null ? value : type.fields().get(field).defaultValue();
  }

  /**
   * Returns the base of the node's relative urls: that of the file, unless the node is of a
   * prototype of another file.
   *
   * @param ofFile the base of the file
   */
  public BaseUrl base(BaseUrl ofFile) {
    return base == null ? ofFile : base.or(ofFile);
  }

  /** Returns whether the file gives the field a value. */
  public boolean given(int field) {
    return values[field] != null;
  }

  /**
   * Returns the values of all fields by their indices, null where the file gives none, large arrays
   * possibly as a {@link PackedArray}; the node's own array, not to be changed.
   */
  public @Nullable Object[] values() {
    return values;
  }

  /** Sets the value of a field, as {@link FieldType} represents it. For readers. */
  public void put(int field, Object value) {
    values[field] = value;
  }

  /**
   * Keeps large arrays in less memory until they are read again, when a mesh has been made of them.
   *
   * @param shared whether an array is also kept elsewhere, so that packing it saves nothing
   */
  public void pack(Predicate<Object> shared) {
    for (int i = 0; i < values.length; i++) {
      Object value = values[i];
      if (value != null && !shared.test(value)) {
        values[i] = PackedArray.of(value);
      }
    }
  }

  /** Adds author-defined fields. For readers, before the node is published. */
  void declare(List<FieldDefinition> own) {
    type = type.with(own);
    values = Arrays.copyOf(values, type.fields().size());
  }

  /**
   * Returns where the text of the node's program begins, between its tags or in its {@code url};
   * without a program, where the node was read.
   */
  public SourceLocation textLocation() {
    return textLocation != null ? textLocation : location;
  }

  /** Sets where the text of the node's program begins. For readers. */
  public void textLocation(SourceLocation place) {
    textLocation = place;
  }

  @Override
  public String toString() {
    return name == null ? type.name() : type.name() + " " + name;
  }
}
