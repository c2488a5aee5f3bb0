package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;

/**
 * An element of an XML text with where it stands, whether X3D knows it or not. Offsets count
 * characters of its text.
 *
 * <p>In a text that is edited it stays the same object as long as edits leave it in place, whatever
 * they change in it or around it; its offsets follow. After {@link #attached} turns false it stands
 * for nothing any more.
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
   * What is known of an element whose text does not change. Apart from the element: an edit shifts
   * tens of thousands of them, and the smaller they are the sooner.
   */
  private static final class Content {
    private @Nullable ElementLocation place;
    private @Nullable List<DocumentAttribute> attributes;
    private @Nullable StringBuilder text;
    private int textStart;
  }

  /**
   * @param start the offset of its {@code <}
   * @param tagEnd the offset behind the {@code >} of its start tag
   * @param changed the text's revision
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

  /** The name without prefix; with it where the element is of another language's namespace. */
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

  /** The offset behind its last {@code >}; -1 when the text breaks off before. */
  public int end() {
    return end;
  }

  /** Whether it has an end tag of its own, so that something can stand in it. */
  public boolean open() {
    return tagEnd < end;
  }

  /** Where the tag starts. */
  public Location location() {
    return content == null || content.place == null
        ? source.location(start)
        : content.place.location();
  }

  /** Where its last character stands; empty when the text breaks off before. */
  public Optional<Location> last() {
    return end < 0 ? Optional.empty() : Optional.of(source.location(end - 1));
  }

  /** The attributes as they are written now. */
  public StartTag tag() {
    return source.tag(start);
  }

  /** The attributes as values, in order; those of a text that is edited are read each time. */
  public List<DocumentAttribute> attributes() {
    if (content != null && content.attributes != null) {
      return content.attributes;
    }
    List<DocumentAttribute> read = new ArrayList<>();
    for (WrittenAttribute written : tag().attributes()) {
      if (!written.declaration()) {
        boolean ours = written.name().indexOf(':') < 0;
        read.add(
            new DocumentAttribute(this, read.size(), ours ? written.name() : "", written.value()));
      }
    }
    return read;
  }

  /** The attribute of that name without prefix. */
  public Optional<DocumentAttribute> attribute(String attributeName) {
    for (DocumentAttribute attribute : attributes()) {
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

  /** The text directly within the element; empty where it is white space only or not kept. */
  public String text() {
    return content == null || content.text == null ? "" : content.text.toString();
  }

  /** Where that text begins; where the tag starts if there is none. */
  public Location textLocation() {
    return content == null || content.text == null
        ? location()
        : source.location(content.textStart);
  }

  /** The offset of where that text begins; of the element if there is none. */
  public int textStart() {
    return content == null || content.text == null ? start : content.textStart;
  }

  /** The text's revision in which it or something in it changed last. */
  public long changed() {
    return changed;
  }

  /**
   * Whether it is a reference to an entity of the DOCTYPE, which stands for elements that are
   * declared there; {@link #name} is the reference then.
   */
  public boolean isReference() {
    return name.startsWith("&");
  }

  /** Whether it is still part of its text. */
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

  ElementSource source() {
    return source;
  }

  /** Where it stands. */
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

  /** Names it, for a text that says the name after what is in it. */
  void named(@Nullable String newDef, @Nullable String newUse) {
    def = newDef;
    use = newUse;
  }

  /** Keeps where it starts in a text that does not change, so that its lines need not be found. */
  void place(ElementLocation found) {
    content().place = found;
  }

  /** Adds a child behind the others. */
  public void add(DocumentElement child) {
    if (children.isEmpty()) {
      children = new ArrayList<>(2);
    }
    children.add(child);
    child.parent = this;
  }

  /** Gives it its attributes. */
  public void attributes(List<DocumentAttribute> all) {
    content().attributes = all;
  }

  /** Adds text that begins at a place of the file. */
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

  void move(OffsetShift shift) {
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

  /** Most elements stand behind the last change. */
  private void moveBy(int growth) {
    start += growth;
    tagEnd += growth;
    end += growth;
    for (int i = 0; i < children.size(); i++) {
      children.get(i).moveBy(growth);
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

  /** It and all in it stand for nothing from now on. */
  void detach() {
    visit(element -> element.attached = false);
  }

  @Override
  public String toString() {
    return def == null ? name : name + " " + def;
  }
}
