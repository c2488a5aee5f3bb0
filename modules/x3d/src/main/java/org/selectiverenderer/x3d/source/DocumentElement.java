package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;

/**
 * An element of an XML text with its location, whether or not it is an X3D element. Offsets count
 * characters of the text.
 *
 * <p>In an edited text it remains the same object as long as the element exists, with updated
 * offsets. When the element is removed, {@link #attached} becomes false.
 */
public final class DocumentElement {
  private final ElementSource source;
  private String name;
  private @Nullable DocumentElement parent;
  private List<DocumentElement> children = List.of();
  private @Nullable String def;
  private @Nullable String use;
  private @Nullable Content content;
  private int start;
  private int tagEnd;
  private int end = -1;
  private long changed;
  private boolean attached = true;

  /**
   * Cached data of an element whose text does not change. A separate object keeps elements small,
   * of which an edit shifts tens of thousands.
   */
  private static final class Content {
    private @Nullable ElementLocation place;
    private @Nullable List<DocumentAttribute> attributes;
    private @Nullable StringBuilder text;
    private int textStart;
  }

  /**
   * Creates an element.
   *
   * @param start the offset of its {@code <}
   * @param tagEnd the offset after the {@code >} of its start tag
   * @param changed the revision of the text
   */
  public DocumentElement(
      ElementSource source,
      String name,
      @Nullable String def,
      @Nullable String use,
      int start,
      int tagEnd,
      long changed) {
    this.source = source;
    this.name = name;
    this.def = def;
    this.use = use;
    this.start = start;
    this.tagEnd = tagEnd;
    this.changed = changed;
  }

  /** Returns the local name; with its prefix if the element is of a foreign namespace. */
  public String name() {
    return name;
  }

  /** Returns the parent element; empty for the root. */
  public Optional<DocumentElement> parent() {
    return Optional.ofNullable(parent);
  }

  /** Returns the child elements in order. */
  public List<DocumentElement> children() {
    return Collections.unmodifiableList(children);
  }

  /** Returns the DEF name. */
  public Optional<String> def() {
    return Optional.ofNullable(def);
  }

  /** Returns the name in USE. */
  public Optional<String> use() {
    return Optional.ofNullable(use);
  }

  /** Returns the offset of its {@code <}. */
  public int start() {
    return start;
  }

  /** Returns the offset after the {@code >} of its start tag. */
  public int tagEnd() {
    return tagEnd;
  }

  /** Returns the offset after the element; -1 if the text is truncated before. */
  public int end() {
    return end;
  }

  /** Returns whether it has an end tag, so that it can have content. */
  public boolean open() {
    return tagEnd < end;
  }

  /** Returns the location of its start tag. */
  public SourceLocation location() {
    return content == null || content.place == null
        ? source.location(start)
        : content.place.location();
  }

  /** Returns the location of its last character; empty if the text is truncated before. */
  public Optional<SourceLocation> last() {
    return end < 0 ? Optional.empty() : Optional.of(source.location(end - 1));
  }

  /** Returns the start tag as it is written now. */
  public StartTag tag() {
    return source.tag(start);
  }

  /** Returns the attributes in order; those of an edited text are parsed each time. */
  public List<DocumentAttribute> attributes() {
    if (content != null && content.attributes != null) {
      return content.attributes;
    }
    List<DocumentAttribute> read = new ArrayList<>();
    for (SourceAttribute written : tag().attributes()) {
      if (!written.declaration()) {
        boolean ours = written.name().indexOf(':') < 0;
        read.add(
            new DocumentAttribute(this, read.size(), ours ? written.name() : "", written.value()));
      }
    }
    return read;
  }

  /** Returns the attribute with a local name. */
  public Optional<DocumentAttribute> attribute(String attributeName) {
    for (DocumentAttribute attribute : attributes()) {
      if (attribute.name().equals(attributeName)) {
        return Optional.of(attribute);
      }
    }
    return Optional.empty();
  }

  /** Returns the text of the attribute with a name, if there is one. */
  public Optional<String> text(String attributeName) {
    return attribute(attributeName).map(DocumentAttribute::text);
  }

  /** Returns the text directly within the element; empty if it is blank or not stored. */
  public String text() {
    return content == null || content.text == null ? "" : content.text.toString();
  }

  /** Returns the location of that text, or of the start tag if there is none. */
  public SourceLocation textLocation() {
    return content == null || content.text == null
        ? location()
        : source.location(content.textStart);
  }

  /** Returns the offset of that text, or of the element if there is none. */
  public int textStart() {
    return content == null || content.text == null ? start : content.textStart;
  }

  /** Returns the revision of the text in which the element or its content changed last. */
  public long changed() {
    return changed;
  }

  /**
   * Returns whether this represents a reference to an entity that is declared in the DOCTYPE and
   * contains elements; {@link #name} is then the reference.
   */
  public boolean isReference() {
    return name.startsWith("&");
  }

  /** Returns whether the element is still part of its text. */
  public boolean attached() {
    return attached;
  }

  /** Returns whether the other element is this one or a descendant. */
  public boolean contains(DocumentElement other) {
    return start <= other.start && other.end <= end;
  }

  /** Visits this element and its descendants in document order. */
  public void visit(Consumer<DocumentElement> visitor) {
    visitor.accept(this);
    for (DocumentElement child : children) {
      child.visit(visitor);
    }
  }

  ElementSource source() {
    return source;
  }

  /** Returns the location of the element, from which those of its attributes are found. */
  public ElementLocation place() {
    return content == null || content.place == null
        ? new ElementLocation(source, start, location())
        : content.place;
  }

  private Content content() {
    Content known = content;
    if (known == null) {
      known = new Content();
      content = known;
    }
    return known;
  }

  /** Sets DEF and USE, for encodings that name an element after its content. */
  void named(@Nullable String newDef, @Nullable String newUse) {
    def = newDef;
    use = newUse;
  }

  /** Caches the location in a text that does not change, to save searching its line. */
  void place(ElementLocation found) {
    content().place = found;
  }

  /** Appends a child. */
  public void add(DocumentElement child) {
    if (children.isEmpty()) {
      children = new ArrayList<>(2);
    }
    children.add(child);
    child.parent = this;
  }

  /** Sets the attributes. */
  public void attributes(List<DocumentAttribute> all) {
    content().attributes = all;
  }

  /** Adds text that begins at an offset. */
  public void addText(String more, int at) {
    Content into = content();
    if (into.text == null) {
      into.text = new StringBuilder(more.length());
      into.textStart = at;
    }
    into.text.append(more);
  }

  void endAt(int offset) {
    end = offset;
  }

  void move(OffsetMapping shift) {
    if (end <= shift.first()) {
      return;
    }
    if (start >= shift.last()) {
      moveBy(shift.total());
      return;
    }
    start = shift.start(start);
    tagEnd = shift.end(tagEnd);
    end = shift.end(end);
    for (DocumentElement child : children) {
      child.move(shift);
    }
  }

  /** Shifts an element after the last change, as most elements are. */
  private void moveBy(int growth) {
    start += growth;
    tagEnd += growth;
    end += growth;
    for (int i = 0; i < children.size(); i++) {
      children.get(i).moveBy(growth);
    }
  }

  /** Replaces some children by those of a parsed element, and its tag, too, if requested. */
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

  /** Marks the element and its descendants as removed from the text. */
  void detach() {
    visit(element -> element.attached = false);
  }

  /** Marks the element and its descendants as part of the text again. */
  void attach() {
    visit(element -> element.attached = true);
  }

  @Override
  public String toString() {
    return def == null ? name : name + " " + def;
  }
}
