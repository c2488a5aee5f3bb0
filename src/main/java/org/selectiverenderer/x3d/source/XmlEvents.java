package org.selectiverenderer.x3d.source;

import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.codehaus.stax2.XMLStreamReader2;
import org.codehaus.stax2.typed.TypedValueDecoder;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.field.Flaws;
import org.selectiverenderer.x3d.source.DocumentFault.Kind;

/**
 * What stands in a text, one after the other, up to its end or to where it is not well formed. All
 * parsing of XML goes through here. The element's and attributes' methods answer for the start tag
 * that came last.
 */
public final class XmlEvents {
  /** There is nothing more. */
  public static final int NONE = -1;

  private static final char[] EMPTY = {};
  private static final String CDATA = "<![CDATA[";

  private final TextSource source;
  private final SourceText text;
  private final Decoder decoder = new Decoder();
  private @Nullable XMLStreamReader2 xml;
  private @Nullable DocumentFault fault;

  /**
   * @param text the part of the source that is to be parsed
   */
  XmlEvents(TextSource source, SourceText text) {
    this.source = source;
    this.text = text;
    try {
      xml = text.parser();
    } catch (XMLStreamException e) {
      // Thrown for a bad XML declaration only, before there is any element.
      Location start = new Location(source.file(), 1, 1);
      fault = new DocumentFault(Kind.SYNTAX, start, "the XML declaration is not well formed");
    }
  }

  /** The text that is read. */
  public TextSource source() {
    return source;
  }

  /** Why there is nothing more, if it is not the end; null otherwise. */
  @Nullable
  public DocumentFault fault() {
    return fault;
  }

  /** The next of {@link XMLStreamConstants}, or {@link #NONE}. */
  public int next() {
    if (fault == null) {
      try {
        if (xml().hasNext()) {
          return xml().next();
        }
      } catch (XMLStreamException e) {
        breakOff(e);
      } catch (RuntimeException e) {
        breakOff(e);
      }
    }
    return NONE;
  }

  private XMLStreamReader2 xml() {
    if (xml == null) {
      throw new IllegalStateException("the text has not even begun");
    }
    return xml;
  }

  private void breakOff(XMLStreamException e) {
    String what = XmlFaults.describe(e);
    Kind kind = what.contains("entities of a DOCTYPE") ? Kind.ENTITY : Kind.SYNTAX;
    fault = new DocumentFault(kind, XmlFaults.place(e, source, text.length()), what);
  }

  // Text is parsed when it is asked for, and then the parser wraps its exception. Whatever else it
  // may throw on hostile text means no more than that the text is bad.
  private void breakOff(RuntimeException e) {
    if (e.getCause() instanceof XMLStreamException wrapped) {
      breakOff(wrapped);
    } else {
      javax.xml.stream.Location at = xml().getLocation();
      Location place = new Location(source.file(), at.getLineNumber(), at.getColumnNumber());
      String what = "the XML is not well formed from here on";
      fault = new DocumentFault(Kind.SYNTAX, place, what);
    }
  }

  /** The text or comment that came; empty if it turns out not to be well formed. */
  public String text() {
    try {
      return xml().getText();
    } catch (RuntimeException e) {
      breakOff(e);
      return "";
    }
  }

  /** The offset of the first character of the text that came which is no white space. */
  public int textStart() {
    CharSequence characters = source.characters();
    int at = start();
    if (CDATA.contentEquals(
        characters.subSequence(at, Math.min(at + CDATA.length(), characters.length())))) {
      at += CDATA.length();
    }
    while (at < characters.length() && characters.charAt(at) <= ' ') {
      at++;
    }
    return at;
  }

  /** Whether the text that came is white space. */
  boolean blank() {
    try {
      return xml().isWhiteSpace();
    } catch (RuntimeException e) {
      breakOff(e);
      return true;
    }
  }

  /** Where what came starts. */
  public ElementLocation place() {
    return ElementLocation.of(source, xml());
  }

  /** The offset at which what came starts. */
  int start() {
    return ElementLocation.offset(source, xml().getLocationInfo().getStartLocation());
  }

  /** The offset behind what came. */
  public int end() {
    try {
      return xml().getLocationInfo().getEndLocation().getCharacterOffset();
    } catch (XMLStreamException e) {
      breakOff(e);
      return text.length();
    }
  }

  /** The DOCTYPE that came. */
  XmlDocument.DocumentType type() {
    Location at = place().location();
    try {
      String identifier = xml().getDTDInfo().getDTDPublicId();
      return new XmlDocument.DocumentType(at, identifier == null ? "" : identifier);
    } catch (XMLStreamException e) {
      breakOff(e);
      return new XmlDocument.DocumentType(at, "");
    }
  }

  /** The name of the entity that came. */
  public String entity() {
    return xml().getLocalName();
  }

  /**
   * The element's name without prefix; with it for an element of another language's namespace, such
   * as a signature's {@code ds:Transform}, so that it is not taken for a node.
   */
  public String element() {
    String prefix = xml().getPrefix();
    String namespace = xml().getNamespaceURI();
    boolean foreign =
        prefix != null
            && !prefix.isEmpty()
            && namespace != null
            && !namespace.contains("web3d.org");
    return foreign ? prefix + ":" + xml().getLocalName() : xml().getLocalName();
  }

  /** How many attributes the element has. */
  public int attributes() {
    return xml().getAttributeCount();
  }

  /** An attribute's name without prefix; empty when it belongs to another language's namespace. */
  public String attributeName(int index) {
    String prefix = xml().getAttributePrefix(index);
    return prefix == null || prefix.isEmpty() ? xml().getAttributeLocalName(index) : "";
  }

  /** An attribute as it is written, references replaced. */
  public String attributeText(int index) {
    return xml().getAttributeValue(index);
  }

  /** The attribute of that name, whatever its prefix; null when it is not given. */
  @Nullable
  public String attribute(String name) {
    for (int i = 0; i < xml().getAttributeCount(); i++) {
      if (xml().getAttributeLocalName(i).equals(name)) {
        return xml().getAttributeValue(i);
      }
    }
    return null;
  }

  /** An attribute as a value of numbers; null when nothing can be used. */
  @Nullable
  public Object numbers(int index, FieldType type, FieldParser parser, Flaws flaws) {
    decoder.type = type;
    decoder.parser = parser;
    decoder.flaws = flaws;
    try {
      xml().getAttributeAs(index, decoder);
    } catch (XMLStreamException e) {
      throw new IllegalStateException("a number's own decoder reports no such error", e);
    }
    return decoder.value;
  }

  /**
   * Takes the characters of a value from the parser's own buffer; a large value is never copied.
   */
  private static final class Decoder extends TypedValueDecoder {
    private FieldType type = FieldType.SFBool;
    private FieldParser parser = new FieldParser();
    private Flaws flaws = new Flaws();
    private @Nullable Object value;

    @Override
    public void decode(String input) {
      decode(input.toCharArray(), 0, input.length());
    }

    @Override
    public void decode(char[] buffer, int start, int end) {
      value = parser.parse(type, buffer, start, end, flaws);
    }

    @Override
    public void handleEmptyValue() {
      decode(EMPTY, 0, 0);
    }
  }
}
