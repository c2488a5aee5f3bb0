package org.selectiverenderer.x3d.source;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldParseErrors;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentError.Kind;

/**
 * Builds a document of a text in an encoding other than XML: the parser of the encoding calls it
 * with the equivalent elements of the XML encoding and their offsets. Long lists of numbers are
 * parsed to values at once, as in XML. For one file.
 */
public final class ElementTreeBuilder {
  private final NonXmlSource source;
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
   * Creates a builder.
   *
   * @param document the document, to which the faults of the preflight have been added
   */
  ElementTreeBuilder(
      Preflight preflight,
      XmlDocument document,
      NodeCatalogue catalogue,
      ReadLimits limits,
      ValueCommentStripper cleaner) {
    this.text = preflight.text();
    this.source = new NonXmlSource(preflight.source(), text, cleaner);
    this.document = document;
    this.catalogue = catalogue;
    this.limits = limits;
  }

  /** Returns the limits of the document. */
  public ReadLimits limits() {
    return limits;
  }

  /**
   * Adds a warning about a part of the text that X3D cannot express or that is not read.
   *
   * @param what one sentence without a full stop
   */
  public void leftOut(int at, String what) {
    document.add(new DocumentError(Kind.MODEL, source.location(at), what));
  }

  /** Returns the text to parse. */
  public SourceText text() {
    return text;
  }

  /**
   * Begins an element.
   *
   * @param start the offset at which it begins
   * @param tagEnd the offset at which its content begins
   * @throws XmlParseException if there are too many elements or they are nested too deeply
   */
  public DocumentElement open(
      String name, @Nullable String def, @Nullable String use, int start, int tagEnd)
      throws XmlParseException {
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

  /** Returns the error of a text that exceeds a limit, to throw. */
  public XmlParseException limit(int at, String why) {
    return new XmlParseException(new DocumentError(Kind.LIMIT, source.location(at), why));
  }

  /**
   * Ends the current element.
   *
   * @param end the offset after it
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

  /** Returns the current element, the innermost open one. */
  public DocumentElement element() {
    return current();
  }

  /** Returns whether an element is open. */
  public boolean isOpen() {
    return open != null;
  }

  /**
   * Adds an attribute to the current element.
   *
   * @param value the value in the syntax of the XML encoding, without references
   * @param at the offset of its name
   * @param from the offset of its value
   * @param to the offset after its value
   */
  public void attribute(String name, String value, int at, int from, int to) {
    source.note(current().start(), at, from, to);
    attributes.add(new DocumentAttribute(current(), attributes.size(), name, value));
  }

  /** Adds an attribute that is implied by the structure of the text. */
  public void attribute(String name, String value, int at) {
    attribute(name, value, at, at, at);
  }

  /** Sets the DEF or USE of the current element, for encodings that name it after its content. */
  public void named(@Nullable String def, @Nullable String use) {
    current().named(def, use);
  }

  /**
   * Adds an attribute whose text has the syntax of an XML attribute. Long numeric values are stored
   * parsed, without a copy of their text.
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
    FieldParseErrors flaws = new FieldParseErrors();
    Object value = source.parser().parse(type, buffer, 0, length, flaws);
    source.note(current().start(), at, from, to);
    DocumentAttribute attribute = new DocumentAttribute(current(), attributes.size(), name, null);
    attribute.keep(type, value, flaws.list());
    attributes.add(attribute);
  }

  private @Nullable NodeType node() {
    return catalogue.find(current().name()).orElse(null);
  }

  /** Returns a part of the text, cleaned of comments and the like. */
  public String value(int from, int to) {
    return source.value(from, to);
  }

  /**
   * Sets the containerField of the current node, unless the field is its default.
   *
   * @param at the offset of the field's name
   */
  public void container(String field, int at) {
    NodeType parent =
        current().parent().flatMap(around -> catalogue.find(around.name())).orElse(null);
    NodeType child = node();
    boolean usual =
        parent != null && child != null
            ? ContainerFieldRules.wanted(parent, child, null)
                .filter(found -> found.name().equals(field))
                .isPresent()
            : parent != null && field.equals("children");
    if (!usual) {
      attribute("containerField", field, at);
    }
  }

  /** Adds text directly within the current element. */
  public void text(String characters, int at) {
    current().addText(characters, at);
  }

  /** Adds a comment at an offset. */
  public void comment(String words, int at) {
    comments.add(new XmlDocument.Comment(words, source.location(at), at, null));
  }

  /** Adds the comments since the last start or end of an element, which precede an element. */
  private void flush(@Nullable DocumentElement before) {
    for (XmlDocument.Comment comment : comments) {
      document.add(comment.before(before));
    }
    comments.clear();
  }

  /** Returns a syntax error to throw. */
  public XmlParseException fault(int at, String what) {
    return new XmlParseException(new DocumentError(Kind.SYNTAX, source.location(at), what));
  }

  /** Tells an error after which parsing went on. */
  public void tell(XmlParseException error) {
    document.add(error.fault());
  }

  /** Adds the comments at the end. */
  void flush() {
    flush(null);
  }

  /** A parser of one encoding. */
  public interface Parser {
    /** Returns the cleaner of values in this encoding. */
    ValueCommentStripper cleaner();

    /**
     * Parses the builder's text.
     *
     * @throws XmlParseException at the first syntax error
     */
    void parse(ElementTreeBuilder into) throws XmlParseException;
  }
}
