package org.selectiverenderer.x3d.source;

import javax.xml.stream.XMLStreamConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.source.DocumentFault.Kind;

/** Makes elements of a text, whatever language they are of. Serves one text. */
class ElementParser {
  private final XmlEvents xml;
  private final ElementSource source;
  private final int shift;
  private final long revision;
  private final ReadLimits limits;
  private @Nullable DocumentElement root;
  private @Nullable DocumentElement open;
  private int depth;
  private int count;

  /**
   * @param source what the elements are to stand in
   * @param shift what is added to every offset
   */
  ElementParser(XmlEvents xml, ElementSource source, int shift, long revision, ReadLimits limits) {
    this.xml = xml;
    this.source = source;
    this.shift = shift;
    this.revision = revision;
    this.limits = limits;
  }

  /**
   * The root element of a text that has one and is well formed. Attributes are left in the text.
   *
   * @param shift what is added to every offset to make it one of the source
   * @throws XmlFault at the first place where the text is not well formed, is nested deeper than a
   *     scene may be, or has a tag of more attributes than any node
   */
  static DocumentElement root(SourceText text, ElementSource source, int shift, long revision)
      throws XmlFault {
    String name = source.file();
    Preflight preflight = Preflight.of(name, text);
    ReadLimits standard = ReadLimits.standard();
    ReadLimits limits =
        new ReadLimits(
            standard.maxBytes(), standard.maxRatio(), standard.maxDepth(), Integer.MAX_VALUE);
    if (preflight.encoding() != Encoding.XML) {
      String why =
          "this is a scene in "
              + preflight.encoding().title()
              + ", and only X3D XML can be changed; convert it first";
      throw new XmlFault(new DocumentFault(Kind.REFUSED, Location.of(name), why));
    }
    Entities entities = source.entities();
    XmlEvents xml =
        entities.none()
            ? preflight.events()
            : new XmlEvents(preflight.source(), EntityMask.of(text, entities, source, shift));
    ElementParser parser = new ElementParser(xml, source, shift, revision, limits);
    DocumentFault cut = preflight.cut();
    DocumentFault fault = cut == null ? parser.parse() : cut;
    if (fault != null) {
      throw new XmlFault(fault);
    }
    if (parser.root == null) {
      String none = "there is no element in it";
      throw new XmlFault(new DocumentFault(Kind.SYNTAX, Location.of(name), none));
    }
    return parser.root;
  }

  /** Takes in all of the text; returns what ends it too early, if anything does. */
  final @Nullable DocumentFault parse() {
    for (int event = xml.next(); event != XmlEvents.NONE; event = xml.next()) {
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

  private DocumentFault limit(String why) {
    return new DocumentFault(Kind.LIMIT, xml.place().location(), why);
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
            .map(WrittenAttribute::value)
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
   * An element has begun; the parser knows its attributes.
   *
   * @param place where, in the text that is parsed
   */
  void started(DocumentElement element, ElementLocation place) {}

  void ended(DocumentElement element) {}

  /**
   * Something else has come than the beginning or end of an element. A reference to an entity
   * stands for elements that are not in the text at its place: it counts as one without attributes.
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
