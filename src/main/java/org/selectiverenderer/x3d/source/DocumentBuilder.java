package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.Containment;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.field.Flaws;
import org.selectiverenderer.x3d.source.DocumentFault.Kind;

/**
 * Makes a document of a text in another encoding than XML: its parser says which elements of the
 * XML encoding the text stands for, and where each was found. Long lists of numbers become values
 * at once, as those of XML do. Serves one file.
 */
public final class DocumentBuilder {
  private final TreeSource source;
  private final SourceText text;
  private final NodeCatalogue catalogue;
  private final ReadLimits limits;
  private final XmlDocument document;
  private final List<XmlDocument.Comment> comments = new ArrayList<>();
  private char[] buffer = new char[1024];
  private @Nullable DocumentElement open;
  private List<DocumentAttribute> attributes = new ArrayList<>();
  private final List<List<DocumentAttribute>> outer = new ArrayList<>();
  private int count;
  private int prototypes;

  /**
   * @param document that has been told what the preflight says of the file
   */
  DocumentBuilder(
      Preflight preflight,
      XmlDocument document,
      NodeCatalogue catalogue,
      ReadLimits limits,
      ValueCleaner cleaner) {
    this.text = preflight.text();
    this.source = new TreeSource(preflight.source(), text, cleaner);
    this.document = document;
    this.catalogue = catalogue;
    this.limits = limits;
  }

  /** The characters that are to be parsed. */
  public SourceText text() {
    return text;
  }

  /**
   * Begins an element.
   *
   * @param start offset of what stands for it
   * @param tagEnd offset from which on things may stand in it
   * @throws XmlFault if there are more elements, or they are nested deeper, than a scene may have
   */
  public DocumentElement open(
      String name, @Nullable String def, @Nullable String use, int start, int tagEnd)
      throws XmlFault {
    if (outer.size() >= limits.maxDepth()) {
      throw limit(start, "elements are nested more than " + limits.maxDepth() + " deep");
    }
    if (count >= limits.maxNodes()) {
      throw limit(start, "there are more than " + limits.maxNodes() + " elements");
    }
    count++;
    prototypes += name.equals("ProtoDeclare") ? 1 : 0;
    DocumentElement element = new DocumentElement(source, name, def, use, start, tagEnd, 0);
    if (open != null) {
      open.add(element);
    }
    open = element;
    outer.add(attributes);
    attributes = new ArrayList<>(4);
    element.attributes(attributes);
    document.add(element);
    flush(element);
    return element;
  }

  private XmlFault limit(int at, String why) {
    return new XmlFault(new DocumentFault(Kind.LIMIT, source.location(at), why));
  }

  /**
   * Ends the element begun last.
   *
   * @param end the offset behind it
   */
  public void close(int end) {
    flush(null);
    DocumentElement ended = current();
    ended.endAt(end);
    prototypes -= ended.name().equals("ProtoDeclare") ? 1 : 0;
    open = ended.parent().orElse(null);
    attributes = outer.remove(outer.size() - 1);
  }

  private DocumentElement current() {
    if (open == null) {
      throw new IllegalStateException("no element is open");
    }
    return open;
  }

  /** The element begun last of those that have not ended. */
  public DocumentElement element() {
    return current();
  }

  /** Whether any element is open. */
  public boolean isOpen() {
    return open != null;
  }

  /**
   * An attribute of the element begun last.
   *
   * @param value as an XML attribute would have it, references replaced
   * @param at offset of its name
   * @param from offset of its value's first character
   * @param to offset behind its value
   */
  public void attribute(String name, String value, int at, int from, int to) {
    source.note(current().start(), at, from, to);
    attributes.add(new DocumentAttribute(current(), attributes.size(), name, value));
  }

  /** An attribute that the text says by where something stands. */
  public void attribute(String name, String value, int at) {
    attribute(name, value, at, at, at);
  }

  /** The DEF or USE of the element begun last, for texts that name an element after its content. */
  public void named(@Nullable String def, @Nullable String use) {
    current().named(def, use);
  }

  /**
   * An attribute whose value stands in the text as an XML attribute would have it. Long numbers
   * become values; their text stays where it is.
   */
  public void attribute(String name, int at, int from, int to) {
    FieldType type = prototypes > 0 ? null : DocumentParser.numbers(node(), name);
    if (type == null || type.kind() == FieldType.Kind.BOOLEAN) {
      attribute(name, source.value(from, to), at, from, to);
      return;
    }
    int length = to - from;
    if (length > buffer.length) {
      buffer = new char[Math.max(length, 2 * buffer.length)];
    }
    source.copy(from, to, buffer);
    Flaws flaws = new Flaws();
    Object value = source.parser().parse(type, buffer, 0, length, flaws);
    source.note(current().start(), at, from, to);
    DocumentAttribute attribute = new DocumentAttribute(current(), attributes.size(), name, null);
    attribute.keep(type, value, flaws.list());
    attributes.add(attribute);
  }

  private @Nullable NodeType node() {
    return catalogue.find(current().name()).orElse(null);
  }

  /** The characters of a part of the text, without comments and the like. */
  public String value(int from, int to) {
    return source.value(from, to);
  }

  /**
   * Says the field of the node around it that the node begun last is in, if it would not get there
   * by itself.
   *
   * @param at offset of the field's name
   */
  public void container(String field, int at) {
    NodeType parent =
        current().parent().flatMap(around -> catalogue.find(around.name())).orElse(null);
    NodeType child = node();
    boolean usual =
        parent != null && child != null
            ? Containment.wanted(parent, child, null)
                .filter(found -> found.name().equals(field))
                .isPresent()
            : parent != null && field.equals("children");
    if (!usual) {
      attribute("containerField", field, at);
    }
  }

  /** Text directly within the element begun last. */
  public void text(String characters, int at) {
    current().addText(characters, at);
  }

  /** Adds a comment that begins at a place of the text. */
  public void comment(String words, int at) {
    comments.add(new XmlDocument.Comment(words, source.location(at), at, null));
  }

  /** Hands on the comments since the last beginning or end, with what they stand before. */
  private void flush(@Nullable DocumentElement before) {
    for (XmlDocument.Comment comment : comments) {
      document.add(comment.before(before));
    }
    comments.clear();
  }

  /** Something that ends the reading. */
  public XmlFault fault(int at, String what) {
    return new XmlFault(new DocumentFault(Kind.SYNTAX, source.location(at), what));
  }

  /** Hands on the comments at the end. */
  void flush() {
    flush(null);
  }

  /** What reads one encoding. */
  public interface Parser {
    /** What it allows within values. */
    ValueCleaner cleaner();

    /**
     * Says all that the builder's text says.
     *
     * @throws XmlFault at the first place that makes no sense
     */
    void parse(DocumentBuilder into) throws XmlFault;
  }
}
