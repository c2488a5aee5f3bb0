package org.selectiverenderer.x3d;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** An element of a scene's text, with where it stands. Offsets count characters of the text. */
public final class SceneElement {
  private final String name;
  private final @Nullable SceneElement parent;
  private final Location location;
  private final int start;
  private final List<SceneElement> children = new ArrayList<>();
  private final List<String[]> attributes;
  private int end;

  SceneElement(
      String name,
      @Nullable SceneElement parent,
      Location location,
      int start,
      List<String[]> attributes) {
    this.name = name;
    this.parent = parent;
    this.location = location;
    this.start = start;
    this.attributes = attributes;
    if (parent != null) {
      parent.children.add(this);
    }
  }

  void endAt(int offset) {
    end = offset;
  }

  public String name() {
    return name;
  }

  /** The element that it stands in; empty for the root. */
  public Optional<SceneElement> parent() {
    return Optional.ofNullable(parent);
  }

  public Location location() {
    return location;
  }

  /** The offset of its {@code <}. */
  public int start() {
    return start;
  }

  /** The offset behind its last {@code >}. */
  public int end() {
    return end;
  }

  public List<SceneElement> children() {
    return children;
  }

  /** The value of an attribute, entities replaced; empty when it is not given. */
  public Optional<String> attribute(String wanted) {
    return attributes.stream()
        .filter(attribute -> attribute[0].equals(wanted))
        .map(attribute -> attribute[1])
        .findFirst();
  }

  /** Whether the other one is this one or stands in it. */
  public boolean contains(SceneElement other) {
    return start <= other.start && other.end <= end;
  }

  /** Visits this element and all in it, in document order. */
  public void visit(Consumer<SceneElement> visitor) {
    visitor.accept(this);
    children.forEach(child -> child.visit(visitor));
  }
}
