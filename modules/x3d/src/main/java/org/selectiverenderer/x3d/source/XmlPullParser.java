package org.selectiverenderer.x3d.source;

import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.codehaus.stax2.XMLStreamReader2;
import org.codehaus.stax2.typed.TypedValueDecoder;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldParseErrors;
import org.selectiverenderer.x3d.field.FieldParser;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentError.Kind;

/**
 * A pull parser of XML that reads a text up to its end or the first place where it is not
 * well-formed. All XML is parsed by this class. The methods for the element and its attributes
 * refer to the last start tag.
 */
public final class XmlPullParser {
  /** The event at the end of the text or at a fault. */
  public static final int NONE = -1;

  private static final char[] EMPTY = {};
  private static final String CDATA = "<![CDATA[";

  private final TextSource source;
  private final SourceText text;
  private final Decoder decoder = new Decoder();
  private @Nullable XMLStreamReader2 xml;
  private @Nullable DocumentError fault;

  /**
   * Creates a parser.
   *
   * @param text the part of the source to parse
   */
  XmlPullParser(TextSource source, SourceText text) {
    this.source = source;
    this.text = text;
    try {
      xml = text.parser();
    } catch (XMLStreamException e) {
      // thrown only for an invalid XML declaration
      SourceLocation start = new SourceLocation(source.file(), 1, 1);
      fault = new DocumentError(Kind.SYNTAX, start, "the XML declaration is not well formed");
    }
  }

  /** Returns the text being parsed. */
  public TextSource source() {
    return source;
  }

  /** Returns the fault that ended parsing; null if there is none. */
  @Nullable
  public DocumentError fault() {
    return fault;
  }

  /** Returns the next event of {@link XMLStreamConstants}, or {@link #NONE}. */
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
    String reference = XmlErrorMessages.entity(e);
    SourceLocation place = XmlErrorMessages.place(e, source, text.length());
    fault =
        reference.isEmpty()
            ? new DocumentError(Kind.SYNTAX, place, XmlErrorMessages.describe(e))
            : new DocumentError(Kind.ENTITY, place, source.declared().problem(reference, true));
  }

  // The parser reads text lazily and then wraps its exception. Any other exception on hostile text
  // also means that the text is not well-formed.
  private void breakOff(RuntimeException e) {
    if (e.getCause() instanceof XMLStreamException wrapped) {
      breakOff(wrapped);
    } else {
      SourceLocation place = XmlErrorMessages.stop(xml().getLocation(), source);
      String what = "the XML is not well formed from here on";
      fault = new DocumentError(Kind.SYNTAX, place, what);
    }
  }

  /** Returns the current text or comment; empty if it is not well-formed. */
  public String text() {
    try {
      return xml().getText();
    } catch (RuntimeException e) {
      breakOff(e);
      return "";
    }
  }

  /** Returns the offset of the first non-blank character of the current text. */
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

  /** Returns whether the current text is blank. */
  boolean blank() {
    try {
      return xml().isWhiteSpace();
    } catch (RuntimeException e) {
      breakOff(e);
      return true;
    }
  }

  /** Returns the location of the current event. */
  public ElementLocation place() {
    return ElementLocation.of(source, xml());
  }

  /** Returns the offset of the current event. */
  int start() {
    return ElementLocation.offset(source, xml().getLocationInfo().getStartLocation());
  }

  /** Returns the offset after the current event. */
  public int end() {
    try {
      return xml().getLocationInfo().getEndLocation().getCharacterOffset();
    } catch (XMLStreamException e) {
      breakOff(e);
      return text.length();
    }
  }

  /** Returns the current DOCTYPE. */
  XmlDocument.DocumentType type() {
    SourceLocation at = place().location();
    try {
      String identifier = xml().getDTDInfo().getDTDPublicId();
      return new XmlDocument.DocumentType(at, identifier == null ? "" : identifier);
    } catch (XMLStreamException e) {
      breakOff(e);
      return new XmlDocument.DocumentType(at, "");
    }
  }

  /** Returns the reason why the current reference to an entity is not expanded. */
  public String entityProblem() {
    return source.declared().problem(entity(), false);
  }

  /** Returns the name of the current entity. */
  String entity() {
    return xml().getLocalName();
  }

  /**
   * Returns the element's local name; with its prefix for an element of a foreign namespace, such
   * as {@code ds:Transform} of an XML signature, so that it is not taken for a node.
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

  /** Returns the number of attributes of the element. */
  public int attributes() {
    return xml().getAttributeCount();
  }

  /** Returns an attribute's local name; empty if it is of a foreign namespace. */
  public String attributeName(int index) {
    String prefix = xml().getAttributePrefix(index);
    return prefix == null || prefix.isEmpty() ? xml().getAttributeLocalName(index) : "";
  }

  /** Returns the text of an attribute with its references resolved. */
  public String attributeText(int index) {
    return xml().getAttributeValue(index);
  }

  /** Returns the attribute with a local name, or null. */
  @Nullable
  public String attribute(String name) {
    for (int i = 0; i < xml().getAttributeCount(); i++) {
      if (xml().getAttributeLocalName(i).equals(name)) {
        return xml().getAttributeValue(i);
      }
    }
    return null;
  }

  /** Parses an attribute to a value of numbers; null if nothing of it is usable. */
  @Nullable
  public Object numbers(int index, FieldType type, FieldParser parser, FieldParseErrors flaws) {
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
   * Receives the characters of a value in the parser's buffer, so that large values are not copied.
   */
  private static final class Decoder extends TypedValueDecoder {
    private FieldType type = FieldType.SFBool;
    private FieldParser parser = new FieldParser();
    private FieldParseErrors flaws = new FieldParseErrors();
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
