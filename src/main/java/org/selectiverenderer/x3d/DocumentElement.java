package org.selectiverenderer.x3d;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/** An element of a document, whether X3D knows it or not. Complete once the document is read. */
public final class DocumentElement {
  private final SceneDocument document;
  private final @Nullable DocumentElement parent;
  private final String name;
  private final int start;
  private final Location location;
  private final List<DocumentElement> children = new ArrayList<>(2);
  private List<DocumentAttribute> attributes = List.of();
  private @Nullable StringBuilder text;
  private @Nullable Location end;

  DocumentElement(
      SceneDocument document,
      @Nullable DocumentElement parent,
      String name,
      int start,
      Location location) {
    this.document = document;
    this.parent = parent;
    this.name = name;
    this.start = start;
    this.location = location;
    if (parent != null) {
      parent.children.add(this);
    }
  }

  void attributes(List<DocumentAttribute> all) {
    attributes = all;
  }

  void endAt(Location place) {
    end = place;
  }

  void addText(String more) {
    if (text == null) {
      text = new StringBuilder();
    }
    text.append(more);
  }

  public SceneDocument document() {
    return document;
  }

  /** The element around; empty for the root. */
  public Optional<DocumentElement> parent() {
    return Optional.ofNullable(parent);
  }

  /** The name without prefix. */
  public String name() {
    return name;
  }

  /** Where the tag starts. */
  public Location location() {
    return location;
  }

  /** Where it ends, or about so; empty when the file breaks off before. */
  public Optional<Location> end() {
    return Optional.ofNullable(end);
  }

  public List<DocumentElement> children() {
    return Collections.unmodifiableList(children);
  }

  public List<DocumentAttribute> attributes() {
    return attributes;
  }

  /** The attribute of that name without prefix. */
  public Optional<DocumentAttribute> attribute(String attributeName) {
    for (DocumentAttribute attribute : attributes) {
      if (attribute.name().equals(attributeName)) {
        return Optional.of(attribute);
      }
    }
    return Optional.empty();
  }

  /** The text of that attribute, if there is one. */
  public Optional<String> text(String attributeName) {
    return attribute(attributeName).map(DocumentAttribute::text);
  }

  /** The text directly within the element; empty where there is white space only. */
  public String text() {
    return text == null ? "" : text.toString();
  }

  Place place() {
    return new Place(document.source(), start, location);
  }

  @Override
  public String toString() {
    return name + " at " + location;
  }
}
