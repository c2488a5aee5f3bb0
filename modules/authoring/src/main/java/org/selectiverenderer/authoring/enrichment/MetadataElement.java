package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.schema.MetadataNode;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.SourceAttribute;
import org.selectiverenderer.x3d.source.StartTag;

/**
 * Adapts a metadata element of a document to the schema reader. A USE reference is resolved to the
 * original element; {@link #written} is the reference itself.
 */
final class MetadataElement implements MetadataNode {
  private static final String SET = "MetadataSet";

  private final SceneDocument document;
  private final DocumentElement written;
  private final DocumentElement meant;
  private @Nullable StartTag tag;

  private MetadataElement(SceneDocument document, DocumentElement written) {
    this.document = document;
    this.written = written;
    this.meant =
        written
            .use()
            .flatMap(use -> document.tree().flatMap(tree -> tree.named(use, written)))
            .filter(MetadataElement::isMetadata)
            .orElse(written);
  }

  /** Returns the metadata of a node, if it has any. */
  static Optional<MetadataElement> of(SceneDocument document, DocumentElement owner) {
    return owner.children().stream()
        .filter(MetadataElement::isMetadata)
        .findFirst()
        .map(element -> new MetadataElement(document, element));
  }

  /** Returns the view of an element that is metadata. */
  static MetadataElement at(SceneDocument document, DocumentElement element) {
    return new MetadataElement(document, element);
  }

  static boolean isMetadata(DocumentElement element) {
    return switch (element.name()) {
      case SET,
          "MetadataString",
          "MetadataInteger",
          "MetadataFloat",
          "MetadataDouble",
          "MetadataBoolean" ->
          true;
      default -> false;
    };
  }

  /** Returns the child element of the owner, which may be a USE reference. */
  DocumentElement written() {
    return written;
  }

  /** Returns the element with the content: the original of a USE reference. */
  DocumentElement meant() {
    return meant;
  }

  boolean shared() {
    return written.use().isPresent();
  }

  @Override
  public boolean isSet() {
    return meant.name().equals(SET);
  }

  @Override
  public String name() {
    return attribute("name").orElse("");
  }

  /** Returns an attribute of the element with the content; its tag is read once. */
  private Optional<String> attribute(String name) {
    if (tag == null) {
      tag = document.tag(meant);
    }
    return tag.attribute(name).map(SourceAttribute::value);
  }

  @Override
  public List<String> values() {
    if (isSet()) {
      return List.of();
    }
    String value = attribute("value").orElse("");
    return meant.name().equals("MetadataString")
        ? MFStringParser.strings(value)
        : List.of(value.strip().split("[\\s,]+"));
  }

  @Override
  public List<MetadataElement> children() {
    return isSet() ? members("value") : List.of();
  }

  @Override
  public Optional<MetadataElement> metadata() {
    // Without a containerField the child of a set is a member; that of another node describes it.
    return (isSet() ? members("metadata") : childElements()).stream().findFirst();
  }

  private List<MetadataElement> members(String wanted) {
    return childElements().stream().filter(child -> child.field().equals(wanted)).toList();
  }

  private List<MetadataElement> childElements() {
    List<MetadataElement> children = new ArrayList<>();
    for (DocumentElement child : meant.children()) {
      if (isMetadata(child)) {
        children.add(new MetadataElement(document, child));
      }
    }
    return children;
  }

  /** Returns the field of a set that this element is written in: {@code value} or metadata. */
  private String field() {
    Optional<String> field =
        shared() ? document.attribute(written, "containerField") : attribute("containerField");
    return field.orElse("value").equals("metadata") ? "metadata" : "value";
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof MetadataElement metadata && metadata.meant == meant;
  }

  @Override
  public int hashCode() {
    return System.identityHashCode(meant);
  }
}
