package org.selectiverenderer.x3d.read;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.files.ContentBase;

/**
 * A node as a file gives it. A node that is USEd stands as the same object in every place. Values
 * that the file leaves out read as the catalogue's defaults. Written by the reader only; everybody
 * else treats it as immutable.
 */
public final class ParsedNode implements NodeView {
  /**
   * Names that a Script's or shader's fields of its own cannot have. Others of the node type's
   * fields came with later versions of X3D, and scenes of earlier ones have fields of those names;
   * theirs count.
   */
  public static final Set<String> TAKEN_NAMES =
      Set.of("url", "directOutput", "mustEvaluate", "metadata", "sourceCode", "parts", "language");

  private final @Nullable String name;
  private final Location location;
  private final @Nullable ContentBase base;
  private NodeType type;
  private @Nullable Object[] values;
  private @Nullable Location textLocation;

  /** A node with all fields at their defaults. */
  public ParsedNode(NodeType type, @Nullable String name, Location location) {
    this(type, name, location, null);
  }

  /**
   * The same of a prototype's body.
   *
   * @param base where its relative urls start, if that is not where those of its file do
   */
  ParsedNode(NodeType type, @Nullable String name, Location location, @Nullable ContentBase base) {
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
  public Location location() {
    return location;
  }

  @Override
  public @Nullable Object value(int field) {
    Object value = values[field];
    return value != null ? value : type.fields().get(field).defaultValue();
  }

  /**
   * Where the relative urls of the node start: in the folder of the file that it is part of, unless
   * it came with a prototype of another one.
   *
   * @param ofFile that of the file
   */
  public ContentBase base(ContentBase ofFile) {
    return base == null ? ofFile : base.or(ofFile);
  }

  /** Whether the file gives this field a value. */
  public boolean given(int field) {
    return values[field] != null;
  }

  /** Gives a field its value, as {@link FieldType} represents it. For readers. */
  public void put(int field, Object value) {
    values[field] = value;
  }

  /** Gives the node fields of its own. For readers, before anybody else has the node. */
  void declare(List<FieldDefinition> own) {
    type = type.with(own);
    values = Arrays.copyOf(values, type.fields().size());
  }

  /**
   * Where the text of its program begins, if it has one: the characters between its tags, or those
   * in its {@code url}. Else where the node was read.
   */
  public Location textLocation() {
    return textLocation != null ? textLocation : location;
  }

  /** Notes where the text of its program begins. For readers. */
  public void textLocation(Location place) {
    textLocation = place;
  }

  @Override
  public String toString() {
    return name == null ? type.name() : type.name() + " " + name;
  }
}
