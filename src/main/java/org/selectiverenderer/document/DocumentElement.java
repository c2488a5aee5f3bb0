package org.selectiverenderer.document;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * An element of a document. It stays the same object as long as edits leave it in place, whatever
 * they change in it or around it; its offsets follow. After {@link #attached} turns false it stands
 * for nothing any more.
 */
public final class DocumentElement {
  private String name;
  private @Nullable DocumentElement parent;
  private List<DocumentElement> children = List.of();
  private @Nullable String def;
  private @Nullable String use;
  private int start;
  private int tagEnd;
  private int end;
  private long changed;
  private boolean attached = true;

  DocumentElement(
      String name,
      @Nullable String def,
      @Nullable String use,
      int start,
      int tagEnd,
      long changed) {
    this.name = name;
    this.def = def;
    this.use = use;
    this.start = start;
    this.tagEnd = tagEnd;
    this.changed = changed;
  }

  /** The name without prefix. */
  public String name() {
    return name;
  }

  /** The element that it stands in; empty for the root. */
  public Optional<DocumentElement> parent() {
    return Optional.ofNullable(parent);
  }

  /** The elements directly in it, in order. */
  public List<DocumentElement> children() {
    return Collections.unmodifiableList(children);
  }

  /** Its DEF name. */
  public Optional<String> def() {
    return Optional.ofNullable(def);
  }

  /** The name of the node that it stands for by USE. */
  public Optional<String> use() {
    return Optional.ofNullable(use);
  }

  /** The offset of its {@code <}. */
  public int start() {
    return start;
  }

  /** The offset behind the {@code >} of its start tag. */
  public int tagEnd() {
    return tagEnd;
  }

  /** The offset behind its last {@code >}. */
  public int end() {
    return end;
  }

  /** Whether it has an end tag of its own, so that something can stand in it. */
  public boolean open() {
    return tagEnd < end;
  }

  /** The document's revision in which it or something in it changed last. */
  public long changed() {
    return changed;
  }

  /** Whether it is still part of the document. */
  public boolean attached() {
    return attached;
  }

  /** Whether the other one is this one or stands in it. */
  public boolean contains(DocumentElement other) {
    return start <= other.start && other.end <= end;
  }

  /** Visits this element and all in it, in document order. */
  public void visit(Consumer<DocumentElement> visitor) {
    visitor.accept(this);
    for (DocumentElement child : children) {
      child.visit(visitor);
    }
  }

  void add(DocumentElement child) {
    if (children.isEmpty()) {
      children = new ArrayList<>(2);
    }
    children.add(child);
    child.parent = this;
  }

  void endAt(int offset) {
    end = offset;
  }

  void move(Shift shift) {
    if (end <= shift.first()) {
      return;
    }
    start = shift.start(start);
    tagEnd = shift.end(tagEnd);
    end = shift.end(end);
    for (DocumentElement child : children) {
      child.move(shift);
    }
  }

  /** Puts other children in the place of some; the tag is another one's if that is given. */
  void graft(int before, int behind, DocumentElement parsed, boolean withTag, long revision) {
    List<DocumentElement> all = new ArrayList<>(children.subList(0, before));
    for (DocumentElement child : parsed.children) {
      child.parent = this;
      all.add(child);
    }
    all.addAll(children.subList(children.size() - behind, children.size()));
    children = all;
    if (withTag) {
      name = parsed.name;
      def = parsed.def;
      use = parsed.use;
      tagEnd = parsed.tagEnd;
    }
    for (DocumentElement at = this; at != null; at = at.parent) {
      at.changed = revision;
    }
  }

  void detach() {
    visit(element -> element.attached = false);
  }

  @Override
  public String toString() {
    return def == null ? name : name + " " + def;
  }
}
