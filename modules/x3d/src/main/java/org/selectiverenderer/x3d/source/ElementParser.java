package org.selectiverenderer.x3d.source;

import javax.xml.stream.XMLStreamConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.source.DocumentError.Kind;

/** Parses a text to a tree of elements of any namespace. For one text. */
class ElementParser {
  private final XmlPullParser xml;
  private final ElementSource source;
  private final int shift;
  private final long revision;
  private final ReadLimits limits;
  private @Nullable DocumentElement root;
  private @Nullable DocumentElement open;
  private int depth;
  private int count;

  /**
   * Creates a parser.
   *
   * @param source the source of the elements
   * @param shift a number that is added to every offset
   */
  ElementParser(
      XmlPullParser xml, ElementSource source, int shift, long revision, ReadLimits limits) {
    this.xml = xml;
    this.source = source;
    this.shift = shift;
    this.revision = revision;
    this.limits = limits;
  }

  /**
   * Parses a well-formed text and returns its root element. Attributes are not stored.
   *
   * @param shift a number that converts offsets in the text to those in the source
   * @throws XmlParseException at the first place where the text is not well-formed, is nested too
   *     deeply, or has a tag with too many attributes
   */
  static DocumentElement root(SourceText text, ElementSource source, int shift, long revision)
      throws XmlParseException {
    String name = source.file();
    Preflight preflight = Preflight.unexpanded(name, text);
    ReadLimits standard = ReadLimits.standard();
    ReadLimits limits =
        new ReadLimits(
            standard.maxBytes(), standard.maxRatio(), standard.maxDepth(), Integer.MAX_VALUE);
    if (preflight.encoding() != SceneEncoding.XML) {
      String why =
          "this is a scene in "
              + preflight.encoding().title()
              + ", and only X3D XML can be changed; convert it first";
      throw new XmlParseException(new DocumentError(Kind.REFUSED, SourceLocation.of(name), why));
    }
    EntityTable entities = source.entities();
    XmlPullParser xml =
        entities.none()
            ? preflight.events()
            : new XmlPullParser(preflight.source(), EntityMasker.of(text, entities, source, shift));
    ElementParser parser = new ElementParser(xml, source, shift, revision, limits);
    DocumentError cut = preflight.cut();
    DocumentError fault = cut == null ? parser.parse() : cut;
    if (fault != null) {
      throw new XmlParseException(fault);
    }
    if (parser.root == null) {
      String none = "the text has no element";
      throw new XmlParseException(new DocumentError(Kind.SYNTAX, SourceLocation.of(name), none));
    }
    return parser.root;
  }

  /** Parses the text; returns the fault that ends it early, if any. */
  final @Nullable DocumentError parse() {
    for (int event = xml.next(); event != XmlPullParser.NONE; event = xml.next()) {
      if (event == XMLStreamConstants.START_ELEMENT) {
        if (depth >= limits.maxDepth()) {
          return limit("elements are nested more than " + limits.maxDepth() + " deep");
        }
        if (count >= limits.maxNodes()) {
          return limit("there are more than " + limits.maxNodes() + " elements");
        }
        start();
      } else if (event == XMLStreamConstants.END_ELEMENT) {
        end();
      } else {
        other(event, open);
      }
    }
    return xml.fault();
  }

  private DocumentError limit(String why) {
    return new DocumentError(Kind.LIMIT, xml.place().location(), why);
  }

  private void start() {
    DocumentElement parent = open;
    ElementLocation place = xml.place();
    DocumentElement element =
        new DocumentElement(
            source,
            xml.element(),
            name("DEF", place),
            name("USE", place),
            place.offset() + shift,
            xml.end() + shift,
            revision);
    if (parent == null) {
      root = element;
    } else {
      parent.add(element);
    }
    started(element, place);
    open = element;
    depth++;
    count++;
  }

  private @Nullable String name(String attribute, ElementLocation place) {
    String parsed = xml.attribute(attribute);
    boolean masked = parsed != null && !source.entities().none();
    return masked
        ? source
            .tag(place.offset() + shift)
            .attribute(attribute)
            .map(SourceAttribute::value)
            .orElse(parsed)
        : parsed;
  }

  private void end() {
    DocumentElement ended = open;
    if (ended != null) {
      ended.endAt(xml.end() + shift);
      ended(ended);
      depth--;
      open = ended.parent().orElse(null);
    }
  }

  /**
   * Called at the start of an element, whose attributes the parser provides.
   *
   * @param place the location in the parsed text
   */
  void started(DocumentElement element, ElementLocation place) {}

  void ended(DocumentElement element) {}

  /**
   * Called for an event other than the start or end of an element. A reference to an entity with
   * elements is represented by an element without attributes.
   */
  void other(int event, @Nullable DocumentElement in) {
    if (event == XMLStreamConstants.ENTITY_REFERENCE && in != null) {
      int start = xml.place().offset() + shift;
      String name = "&" + xml.entity() + ";";
      int end = start + name.length();
      DocumentElement reference =
          new DocumentElement(source, name, null, null, start, end, revision);
      reference.endAt(end);
      in.add(reference);
      count++;
    }
  }
}
