package org.selectiverenderer.x3d;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import org.codehaus.stax2.XMLStreamReader2;
import org.codehaus.stax2.typed.TypedValueDecoder;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.DocumentFault.Kind;

/**
 * Parses a file into a document. Long lists of numbers become values at once, so that a file takes
 * about as much memory as its text and its numbers. Serves one file.
 */
final class DocumentParser {
  private static final char[] EMPTY = {};

  private final String name;
  private final NodeCatalogue catalogue;
  private final ReadLimits limits;
  private final Decoder decoder = new Decoder();
  private @Nullable DocumentElement open;
  private final List<SceneDocument.Comment> comments = new ArrayList<>();
  private int depth;
  private int prototypes;

  DocumentParser(String name, NodeCatalogue catalogue, ReadLimits limits) {
    this.name = name;
    this.catalogue = catalogue;
    this.limits = limits;
  }

  SceneDocument parse(SceneBytes bytes) {
    SourceText text = SourceText.of(bytes.bytes(), bytes.length());
    Location whole = Location.of(name);
    SceneDocument document = new SceneDocument(name, text);
    if (bytes.compressed()) {
      document.compressed();
    }
    if (bytes.refused() != null) {
      document.add(new DocumentFault(Kind.REFUSED, whole, bytes.refused()));
      return document;
    }
    String foreign = bytes.cut() == null ? X3dReader.foreign(text.head(64)) : null;
    if (foreign != null) {
      document.add(new DocumentFault(Kind.REFUSED, whole, foreign));
      return document;
    }
    if (text.complaint() != null) {
      document.add(new DocumentFault(Kind.ENCODING, badByte(bytes), text.complaint()));
    }
    if (bytes.cut() != null) {
      Location end = text.location(name, text.length());
      document.add(new DocumentFault(Kind.COMPRESSION, end, bytes.cut()));
    }
    int flood = text.floodedTag();
    if (flood >= 0) {
      String why = "an element has more than " + SourceText.ATTRIBUTES + " attributes";
      document.add(new DocumentFault(Kind.LIMIT, text.location(name, flood), why));
      text = text.cutAt(flood);
    }
    elements(document, text);
    return document;
  }

  /** The first byte that is no UTF-8; the file's beginning if all are. */
  private Location badByte(SceneBytes bytes) {
    ByteBuffer in = ByteBuffer.wrap(bytes.bytes(), 0, bytes.length());
    CharBuffer good = CharBuffer.allocate(bytes.length());
    CoderResult result = StandardCharsets.UTF_8.newDecoder().decode(in, good, true);
    if (!result.isError()) {
      return new Location(name, 1, 1);
    }
    byte[] before = Arrays.copyOf(bytes.bytes(), in.position());
    SourceText text = SourceText.of(before, before.length);
    return text.location(name, text.length());
  }

  private void elements(SceneDocument document, SourceText text) {
    boolean cut = document.broken();
    XMLStreamReader2 xml;
    try {
      xml = text.parser();
    } catch (XMLStreamException e) {
      // Thrown for a bad XML declaration only, before there is any element.
      document.add(
          new DocumentFault(
              Kind.SYNTAX, new Location(name, 1, 1), "the XML declaration is not well formed"));
      return;
    }
    try {
      while (xml.hasNext() && event(document, xml)) {
        // All is done in event.
      }
    } catch (XMLStreamException e) {
      breakOff(document, cut, e);
    } catch (RuntimeException e) {
      // As in XmlCursor: whatever the parser throws on hostile text means that the text is bad.
      if (e.getCause() instanceof XMLStreamException fault) {
        breakOff(document, cut, fault);
      } else {
        breakOff(
            document,
            cut,
            Kind.SYNTAX,
            "the XML is not well formed from here on",
            xml.getLocation());
      }
    }
  }

  private void breakOff(SceneDocument document, boolean cut, XMLStreamException fault) {
    String what = XmlFaults.describe(fault);
    Kind kind = what.contains("entities of a DOCTYPE") ? Kind.ENTITY : Kind.SYNTAX;
    breakOff(document, cut, kind, what, fault.getLocation());
  }

  private void breakOff(
      SceneDocument document,
      boolean cut,
      Kind kind,
      String what,
      javax.xml.stream.@Nullable Location at) {
    if (!cut) {
      Location location =
          at != null
              ? new Location(name, at.getLineNumber(), at.getColumnNumber())
              : Location.of(name);
      document.add(new DocumentFault(kind, location, what));
    }
  }

  /** Takes in one event; false to stop. */
  private boolean event(SceneDocument document, XMLStreamReader2 xml) throws XMLStreamException {
    switch (xml.next()) {
      case XMLStreamConstants.START_ELEMENT -> {
        return start(document, xml);
      }
      case XMLStreamConstants.END_ELEMENT -> end(document, xml);
      case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> text(xml);
      case XMLStreamConstants.COMMENT -> {
        comments.add(new SceneDocument.Comment(xml.getText(), place(document, xml), null));
      }
      case XMLStreamConstants.ENTITY_REFERENCE ->
          document.add(
              new DocumentFault(
                  Kind.ENTITY,
                  place(document, xml),
                  "the entity &" + xml.getLocalName() + "; of a DOCTYPE is never expanded"));
      case XMLStreamConstants.DTD ->
          document.type(
              new SceneDocument.DocumentType(
                  place(document, xml),
                  given(xml.getDTDInfo().getDTDRootName()),
                  given(xml.getDTDInfo().getDTDPublicId()),
                  given(xml.getDTDInfo().getDTDSystemId())));
      default -> {
        // Processing instructions say nothing about the scene.
      }
    }
    return true;
  }

  private static String given(@Nullable String identifier) {
    return identifier == null ? "" : identifier;
  }

  /** Where the current event starts. In front of the root the parser counts white space to it. */
  private Location place(SceneDocument document, XMLStreamReader2 xml) {
    javax.xml.stream.Location at = xml.getLocationInfo().getStartLocation();
    SourceText text = document.source();
    int line = at.getLineNumber();
    int column = at.getColumnNumber();
    for (int i = at.getCharacterOffset(); i < text.length() && text.charAt(i) <= ' '; i++) {
      char c = text.charAt(i);
      boolean first = c == '\r' && i + 1 < text.length() && text.charAt(i + 1) == '\n';
      column = c == '\n' || c == '\r' ? 1 : column + 1;
      line += (c == '\n' || c == '\r') && !first ? 1 : 0;
    }
    return new Location(name, line, column);
  }

  private boolean start(SceneDocument document, XMLStreamReader2 xml) throws XMLStreamException {
    String element = xml.getLocalName();
    Location location = place(document, xml);
    if (depth >= limits.maxDepth() || document.elements().size() >= limits.maxNodes()) {
      String limit =
          depth >= limits.maxDepth()
              ? "elements are nested more than " + limits.maxDepth() + " deep"
              : "there are more than " + limits.maxNodes() + " elements";
      document.add(new DocumentFault(Kind.LIMIT, location, limit));
      return false;
    }
    int offset = xml.getLocationInfo().getStartLocation().getCharacterOffset();
    DocumentElement made = new DocumentElement(document, open, element, offset, location);
    depth++;
    prototypes += element.equals("ProtoDeclare") ? 1 : 0;
    made.attributes(attributes(xml, made));
    document.add(made);
    flush(document, made);
    open = made;
    return true;
  }

  /** Hands on the comments since the last tag, with the element that they stand before. */
  private void flush(SceneDocument document, @Nullable DocumentElement before) {
    for (SceneDocument.Comment comment : comments) {
      document.add(new SceneDocument.Comment(comment.text(), comment.location(), before));
    }
    comments.clear();
  }

  private void end(SceneDocument document, XMLStreamReader2 xml) {
    flush(document, null);
    DocumentElement ended = open;
    if (ended != null) {
      ended.endAt(
          new Location(
              name, xml.getLocation().getLineNumber(), xml.getLocation().getColumnNumber()));
      depth--;
      prototypes -= ended.name().equals("ProtoDeclare") ? 1 : 0;
      open = ended.parent().orElse(null);
    }
  }

  private void text(XMLStreamReader2 xml) throws XMLStreamException {
    if (!xml.isWhiteSpace() && open != null) {
      open.addText(xml.getText());
    }
  }

  private List<DocumentAttribute> attributes(XMLStreamReader2 xml, DocumentElement element)
      throws XMLStreamException {
    int count = xml.getAttributeCount();
    if (count == 0) {
      return List.of();
    }
    NodeType node = catalogue.find(element.name()).orElse(null);
    List<DocumentAttribute> attributes = new ArrayList<>(count);
    for (int i = 0; i < count; i++) {
      String prefix = xml.getAttributePrefix(i);
      boolean ours = prefix == null || prefix.isEmpty();
      String attributeName = ours ? xml.getAttributeLocalName(i) : "";
      FieldType type = numbers(node, attributeName);
      // The text of a prototype's values is needed again for each of its instances.
      boolean kept = type == null || prototypes > 0;
      DocumentAttribute attribute =
          new DocumentAttribute(element, i, attributeName, kept ? xml.getAttributeValue(i) : null);
      if (!kept) {
        decoder.type = type;
        decoder.flaws = new Flaws();
        xml.getAttributeAs(i, decoder);
        attribute.keep(type, decoder.value, decoder.flaws.list());
      }
      attributes.add(attribute);
    }
    return attributes;
  }

  /** The type of a field that is a list of numbers; null for all else. */
  private static @Nullable FieldType numbers(@Nullable NodeType node, String attribute) {
    FieldDefinition field = node == null ? null : node.field(attribute).orElse(null);
    if (field == null || !field.type().multiple()) {
      return null;
    }
    return switch (field.type().kind()) {
      case BOOLEAN, INT, FLOAT, DOUBLE -> field.type();
      case STRING, NODE -> null;
    };
  }

  /** Takes the characters of a value from the parser's own buffer; a large value is not copied. */
  private static final class Decoder extends TypedValueDecoder {
    private final FieldParser parser = new FieldParser();
    private FieldType type = FieldType.SFBool;
    private @Nullable Object value;
    private Flaws flaws = new Flaws();

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
